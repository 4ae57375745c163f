// SPDX-License-Identifier: GPL-3.0-or-later
// Values of command-line options, validated like files.
#ifndef KINEX_EXPERIMENTS_VERBS_OPTION_VALUES_H
#define KINEX_EXPERIMENTS_VERBS_OPTION_VALUES_H

#include <cstdint>
#include <string>
#include <vector>

#include "core/numbers/rational.h"

namespace CLI {
class App;
class Option;
}

namespace kinex::verbs {

// An exact number as in a scene. Throws InputError that names the option.
Rational rational_option(const char* option, const std::string& text);

// An option that is a list: several words, or words with commas between them. An empty word between commas is refused.
// `words` outlives the verb.
CLI::Option* add_list_option(CLI::App& verb, const std::string& name,
                             std::vector<std::string>& words, const std::string& help);

// An integer from 0 to 2^64 - 1, in decimal. Throws InputError that names the option.
std::uint64_t seed_option(const char* option, const std::string& text);

// Throws InputError that names the option and the allowed numbers.
void check_range(const char* option, int value, int low, int high);
// Of a limit: throws InputError that names option and value if it is below 0 or no number; `or_zero` is
// false: also if it is 0.
void check_limit(const char* option, double value, bool or_zero, const char* remedy);

// A name for a scene. Throws InputError if it is not UTF-8.
const std::string& name_option(const std::string& text);

// Writes a result to `path`, or to standard output if it is empty or "-".
void write_result(const std::string& path, bool force, const std::string& text);

// Refuses an output that is the input itself, under any name: --force is for earlier results.
// "-" and devices are no files to be kept. Throws InputError that names the option.
void keep_input(const char* option, const std::string& output, const std::string& input);

// Refuses an output that is another one of the command, under any name: they would overwrite each other. `what` names that
// one, as "the file of --events". A device (/dev/null) takes both. Throws InputError that names the option.
void keep_apart(const char* option, const std::string& output, const std::string& other,
                const std::string& what);

// An argument of the command line that names a file to read, as "LOG" or "--scene".
struct InputArgument {
  const char* argument;
  std::string file;
};
// Standard input can be read once: throws InputError that names the arguments if "-" is given twice.
void check_standard_input(const std::vector<InputArgument>& inputs);

// Prints to standard output; throws InputError if that fails (a closed pipe, a full disk).
void print(const std::string& text);

// Adds --maintain, as set_maintain reads it. The option can be given several times.
void add_maintain_option(CLI::App& verb, std::vector<std::string>& entries, const char* what);

// The structure of examples in help texts: the usual one for points of this dimension.
std::string example_structure(int dimension);

}  // namespace kinex::verbs

#endif

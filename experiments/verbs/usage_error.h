// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a command line, and what to write instead.
#ifndef KINEX_EXPERIMENTS_VERBS_USAGE_ERROR_H
#define KINEX_EXPERIMENTS_VERBS_USAGE_ERROR_H

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace kinex::verbs {

// The verb, or the verb of a verb, that a command line has named; the program itself if none.
const CLI::App& innermost(const CLI::App& app);

// The message for a command line that could not be parsed: the verb or option, the problem, a remedy;
// for an unknown verb or option also the names that are near.
// The reason why a word is no value of an option that takes a whole number, and what to write.
std::string whole_number_problem(const std::string& option, const std::string& word);

std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace kinex::verbs

#endif

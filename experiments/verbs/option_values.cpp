// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/option_values.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/number_defect.h"
#include "experiments/formats/utf8.h"
#include "experiments/lab/family.h"

namespace kinex::verbs {

Rational rational_option(const char* option, const std::string& text) {
  std::optional<Rational> value = Rational::parse(text);
  if (!value) {
    const formats::NumberDefect defect =
        formats::number_defect(text, "write an integer, a fraction 1/3 or a decimal");
    throw formats::InputError(option, "", show_text(text) + " " + defect.problem, defect.remedy);
  }
  return *std::move(value);
}

CLI::Option* add_list_option(CLI::App& verb, const std::string& name,
                             std::vector<std::string>& words, const std::string& help) {
  const auto take = [&words, name](const std::vector<std::string>& given) {
    words.clear();
    for (const std::string& list : given) {
      for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        if (end == begin) {
          throw CLI::ValidationError(
              name, show_text(list) + " has an empty word; write one, or leave its comma out");
        }
        words.push_back(list.substr(begin, end - begin));
        begin = end + 1;
      }
    }
  };
  return verb.add_option_function<std::vector<std::string>>(name, take, help);
}

std::uint64_t seed_option(const char* option, const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data(), end, value);
  if (read.ec == std::errc() && read.ptr == end) return value;
  throw formats::InputError(option, "", show_text(text) + " is not a seed",
                   "write an integer from 0 to 18446744073709551615");
}

void check_range(const char* option, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw formats::InputError(option, "", std::to_string(value) + " is out of range",
                            formats::write_between(low, high));
}

void check_limit(const char* option, double value, bool or_zero, const char* remedy) {
  if (std::isfinite(value) && (or_zero ? value >= 0 : value > 0)) return;
  const char* const problem = std::isnan(value)   ? " is not a number"
                              : std::isinf(value) ? " is not finite"
                              : or_zero           ? " is below 0"
                                                  : " is not above 0";
  throw formats::InputError(option, "", fmt::format("{}", value) + problem, remedy);
}

const std::string& name_option(const std::string& text) {
  if (formats::is_utf8(text)) return text;
  throw formats::InputError("--name", "", show_text(text) + " is not UTF-8", "give a name in UTF-8");
}

void write_result(const std::string& path, bool force, const std::string& text) {
  if (path.empty() || path == "-") {
    print(text);
    return;
  }
  formats::OutputFile file(path, force);
  file.write(text);
  file.commit();
}

void keep_input(const char* option, const std::string& output, const std::string& input) {
  if (output.empty() || output == "-" || input == "-") return;
  std::error_code error;
  const auto kept = std::filesystem::weakly_canonical(input, error);
  if (error || std::filesystem::weakly_canonical(output, error) != kept || error) return;
  if (!std::filesystem::is_regular_file(kept, error)) return;
  throw formats::InputError(option, "", show_text(output) + " is the input itself",
                   "give the output another name");
}

void keep_apart(const char* option, const std::string& output, const std::string& other,
                const std::string& what) {
  namespace fs = std::filesystem;
  if (output.empty() || other.empty() || output == "-" || other == "-") return;
  std::error_code error;
  // Relative names of files that do not exist are not made absolute by weakly_canonical.
  const fs::path file = fs::weakly_canonical(fs::absolute(output), error);
  if (error || fs::weakly_canonical(fs::absolute(other), error) != file || error) return;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return;
  throw formats::InputError(option, "", show_text(output) + " is " + what + " too",
                            "give two names");
}

void check_standard_input(const std::vector<InputArgument>& inputs) {
  const InputArgument* first = nullptr;
  for (const InputArgument& input : inputs) {
    if (input.file != "-") continue;
    if (first == nullptr) {
      first = &input;
      continue;
    }
    const std::string one = first->argument, other = input.argument;
    throw formats::InputError(one == other ? one : one + " and " + other, "",
                              "standard input is named twice",
                              "give one of the two the name of a file");
  }
}

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw formats::InputError("standard output", "",
                     std::string("cannot be written: ") + std::strerror(errno),
                     "check the target of its redirection");
  }
}

void add_maintain_option(CLI::App& verb, std::vector<std::string>& entries, const char* what) {
  verb.add_option("--maintain", entries,
                  std::string(what) +
                      ": NAME, NAME:AXIS or a JSON object as in scenes, with commas between them; "
                      "can be given several times; kinex list structures has the names")
      ->allow_extra_args(false);
}

std::string example_structure(int dimension) { return lab::usual_structure(false, dimension); }

}  // namespace kinex::verbs

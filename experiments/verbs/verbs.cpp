// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>
#include <vector>

#include "experiments/formats/input_error.h"
#include "experiments/verbs/usage_error.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

// An empty word, as a shell gives for a variable that is not set, is no name and no number. As if the option
// were left out it would cost a whole run, whose result is nowhere.
std::string refuse_empty(const std::string& word) {
  return word.empty() ? "the word \"\" is empty; write one, or leave the option out" : std::string();
}

// Whole numbers are decimal, whatever they begin with, and are never cut to what fits. Returns false for other words.
template <class Integer>
bool make_decimal(std::string& word) {
  Integer value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || rest != end) return false;
  word = std::to_string(value);
  return true;
}

void check_word(CLI::Option& option) {
  option.check(CLI::Validator(refuse_empty, ""));
  const std::string type = option.get_type_name();
  if (type != "INT" && type != "UINT") return;
  option.transform(CLI::Validator(
      [name = option.get_name(), is_signed = type == "INT"](std::string& word) {
        if (word.empty()) return refuse_empty(word);
        const bool is_whole =
            is_signed ? make_decimal<std::int64_t>(word) : make_decimal<std::uint64_t>(word);
        return is_whole ? std::string() : whole_number_problem(name, word);
      },
      ""));
}

// Before a word in square brackets, which the parser would take apart as a list.
constexpr char kWhole = '\x01';

std::string drop_mark(std::string& word) {
  if (!word.empty() && word.front() == kWhole) word.erase(0, 1);
  return "";
}

void check_words(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() == 0) continue;
    check_word(*option);
    option->transform(
        CLI::Validator(drop_mark, ""));  // the last one added is the first to see the word
  }
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    check_words(*verb);
  }
}

}  // namespace

std::vector<std::string> command_words(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const auto end = std::find(words.begin(), words.end(), "--");
  for (auto word = words.begin(); word != end; ++word) {
    if (!word->starts_with("--") || word->find('=') != word->size() - 1) continue;
    throw formats::InputError(
        word->substr(0, word->size() - 1), "",
        "there is nothing behind the =", "write a value there, or leave the option out");
  }
  for (std::string& word : words) {
    if (word.starts_with('[') && word.ends_with(']')) word.insert(word.begin(), kWhole);
  }
  return words;
}

void add_verbs(CLI::App& app, int& exit_code) {
  add_run_verb(app, exit_code);
  add_check_verb(app, exit_code);
  add_diff_verb(app, exit_code);
  add_gen_verb(app, exit_code);
  add_import_verb(app, exit_code);
  add_export_verb(app, exit_code);
  add_thin_verb(app, exit_code);
  add_roots_verb(app, exit_code);
  add_verify_verb(app, exit_code);
  add_trade_verb(app, exit_code);
  add_reproduce_verb(app, exit_code);
  add_sweep_verb(app, exit_code);
  add_view_verb(app, exit_code);
  add_ccd_verb(app, exit_code);
  add_log_verb(app, exit_code);
  add_list_verb(app, exit_code);
  add_explain_verb(app, exit_code);
  add_completion_verb(app, exit_code);
  add_help_verb(app, exit_code);
  add_voice_options(app);
  check_words(app);
}

}  // namespace kinex::verbs

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/verbs.h"

#include <CLI/CLI.hpp>

#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

// An empty word, as a shell gives for a variable that is not set, is no name and no number. As if the option
// were left out it would cost a whole run, whose result is nowhere.
void refuse_empty_words(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() == 0) continue;
    option->check(CLI::Validator(
        [](const std::string& word) {
          return word.empty() ? "the word \"\" is empty; write one, or leave the option out"
                              : std::string();
        },
        ""));
  }
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    refuse_empty_words(*verb);
  }
}

}  // namespace

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
  refuse_empty_words(app);
}

}  // namespace kinex::verbs

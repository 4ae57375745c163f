// SPDX-License-Identifier: GPL-3.0-or-later
// The verbs of the program: one file each. A verb registers itself with add_NAME_verb, which adds a
// subcommand (options, help with an example, callback); its callback runs after the command line
// has been parsed, prints, and sets `exit_code`. To add a verb: write its file, declare it here,
// and call it in add_verbs (verbs.cpp).
#ifndef KINEX_EXPERIMENTS_VERBS_VERBS_H
#define KINEX_EXPERIMENTS_VERBS_VERBS_H

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace kinex::verbs {

// Exit codes of the program.
inline constexpr int kExitFine = 0;
inline constexpr int kExitFailed = 1;    // a claim, bound or audit failed; two logs differ
inline constexpr int kExitBadInput = 2;  // bad input or usage
inline constexpr int kExitGaveUp = 3;    // at a stated limit, or interrupted

void add_run_verb(CLI::App& app, int& exit_code);
void add_check_verb(CLI::App& app, int& exit_code);
void add_diff_verb(CLI::App& app, int& exit_code);
void add_gen_verb(CLI::App& app, int& exit_code);
void add_import_verb(CLI::App& app, int& exit_code);
void add_export_verb(CLI::App& app, int& exit_code);
void add_thin_verb(CLI::App& app, int& exit_code);
void add_roots_verb(CLI::App& app, int& exit_code);
void add_verify_verb(CLI::App& app, int& exit_code);
void add_trade_verb(CLI::App& app, int& exit_code);
void add_reproduce_verb(CLI::App& app, int& exit_code);
void add_sweep_verb(CLI::App& app, int& exit_code);
void add_view_verb(CLI::App& app, int& exit_code);
void add_ccd_verb(CLI::App& app, int& exit_code);
void add_log_verb(CLI::App& app, int& exit_code);
void add_list_verb(CLI::App& app, int& exit_code);
void add_explain_verb(CLI::App& app, int& exit_code);
void add_help_verb(CLI::App& app, int& exit_code);
void add_completion_verb(CLI::App& app, int& exit_code);

// The words of the command line, for the parser. Throws InputError for an option with an = and nothing behind it, whose value
// the parser would take from the next word. Names in square brackets, which it would take apart as lists, are marked; add_verbs
// has the marks taken away.
std::vector<std::string> command_words(int argc, char** argv);

// Adds all verbs, and the options that all of them have.
void add_verbs(CLI::App& app, int& exit_code);

}  // namespace kinex::verbs

#endif

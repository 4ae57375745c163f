// SPDX-License-Identifier: GPL-3.0-or-later
// kinex completion: prints the completion script for a shell, or the names of the verbs. Not in the help: for
// those who package the program.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "core/numbers/show_text.h"
#include "experiments/formats/input_error.h"
#include "experiments/verbs/command_tree.h"
#include "experiments/verbs/completion_scripts.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"

namespace kinex::verbs {

namespace {

// A verb a line: "run", "sweep run".
std::string verb_list(const Command& program) {
  std::string text;
  for (const Command* command : all_commands(program)) {
    if (command->path.empty()) continue;
    for (std::size_t i = 0; i < command->path.size(); ++i) {
      text += (i == 0 ? "" : " ") + command->path[i];
    }
    text += "\n";
  }
  return text;
}

std::string script(const Command& program, const std::string& shell) {
  if (shell == "bash") return bash_completion(program);
  if (shell == "zsh") return zsh_completion(program);
  if (shell == "fish") return fish_completion(program);
  if (shell == "verbs") return verb_list(program);
  throw formats::InputError("completion", "", show_text(shell) + " is not a shell that kinex knows",
                            "write bash, zsh or fish; or verbs, for their names");
}

}  // namespace

void add_completion_verb(CLI::App& app, int&) {
  auto shell = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("completion", "Prints the completion script for a shell");
  verb->group("");
  verb->add_option("SHELL", *shell, "bash, zsh or fish; or verbs: the verbs, one a line")
      ->required();
  verb->footer(
      "Example:\n  kinex completion bash > ~/.local/share/bash-completion/completions/kinex");
  verb->callback([&app, shell] { print(script(command_tree(app), *shell)); });
}

}  // namespace kinex::verbs

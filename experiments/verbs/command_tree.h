// SPDX-License-Identifier: GPL-3.0-or-later
// The verbs and options of the program as data, for shells.
#ifndef KINEX_EXPERIMENTS_VERBS_COMMAND_TREE_H
#define KINEX_EXPERIMENTS_VERBS_COMMAND_TREE_H

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace kinex::verbs {

// What may stand for an option's value, or for a word without an option.
struct CommandValue {
  std::vector<std::string> words;  // names that the program knows
  bool files = false;              // or a file
  bool list = false;               // several of the words, with commas between them
  // Behind one of these words, those in place of `words`.
  std::map<std::string, std::vector<std::string>> after = {};
};

struct CommandOption {
  std::vector<std::string> names;  // "-o", "--output"
  std::string text;                // of the help, its first sentence
  bool takes_value = false;
  CommandValue value;
};

struct Command {
  std::vector<std::string> path;  // "sweep", "run"; empty: the program itself
  std::string text;
  std::vector<CommandOption> options;
  CommandValue words;  // without an option
  std::vector<Command> commands;
};

// Verbs and options that are hidden from the help are left out.
Command command_tree(const CLI::App& app);

// The command and all below it, the first one first.
std::vector<const Command*> all_commands(const Command& command);

}  // namespace kinex::verbs

#endif

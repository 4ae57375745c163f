// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string_view>

#include "experiments/lab/arithmetics.h"
#include "experiments/lab/workload.h"
#include "experiments/reproduce/papers.h"
#include "experiments/verbs/experiments.h"
#include "experiments/verify/catalogue.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

template <class Things, class Name>
void add_names(std::vector<std::string>& words, const Things& things, const Name& name) {
  for (const auto& thing : things) words.emplace_back(name(thing));
}

std::vector<std::string> structures() {
  std::vector<std::string> words;
  add_names(words, structure_infos(), [](const StructureInfo& info) { return info.name; });
  return words;
}

// Structures, and words for several of them.
std::vector<std::string> structures_and(bool groups, bool families) {
  std::vector<std::string> words = structures();
  for (const std::string_view group : structure_groups()) {
    if (groups && !group.empty()) words.emplace_back(group);
  }
  for (const std::string_view family : verify::family_names()) {
    if (families) words.emplace_back(family);
  }
  return words;
}

std::vector<std::string> papers() {
  std::vector<std::string> words;
  add_names(words, reproduce::papers(), [](const lab::Paper& paper) { return paper.name; });
  return words;
}

// What kinex explain knows.
std::vector<std::string> explained() {
  std::vector<std::string> words = structures_and(true, true);
  add_names(words, lab::workloads(), [](const lab::Workload& w) { return w.name; });
  add_names(words, reproduce::papers(), [](const lab::Paper& paper) { return paper.name; });
  add_names(words, lab::arithmetic_infos(), [](const auto& info) { return info.name; });
  return words;
}

using Path = std::vector<std::string>;

// Of a word without an option, by its name in the help. nullopt: not one of those.
std::optional<CommandValue> value_of_word(const Path& path, std::string_view name) {
  const std::string verb = path.empty() ? "" : path.front();
  if (name == "WHAT" && verb == "list") {
    return CommandValue{{"arithmetics", "papers", "structures", "workloads"}};
  }
  if (name == "NAME" && verb == "explain") return CommandValue{explained()};
  CommandValue value;
  if (name == "STRUCTURE" || name == "WHAT") {
    value = {structures_and(true, name == "STRUCTURE"), name == "WHAT"};
    value.words.emplace_back("all");
  } else if (name == "WORKLOAD") {
    add_names(value.words, lab::workloads(), [](const lab::Workload& w) { return w.name; });
  } else if (name == "PAPER") {
    value.words = papers();
  } else if (name == "PART") {
    for (const lab::Paper& paper : reproduce::papers()) {
      add_names(value.after[std::string(paper.name)], paper.parts,
                [](const lab::PaperPart& part) { return part.name; });
    }
  } else if (name == "PLAN") {
    add_names(value.words, experiments().all, [](const sweep::Experiment& e) { return e.name; });
    value.files = true;
  } else {
    return std::nullopt;
  }
  return value;
}

// Of an option, or of a word that has no names of its own.
CommandValue value_of(const Path& path, std::string_view name, std::string_view type) {
  const std::string verb = path.empty() ? "" : path.front();
  if (name == "--maintain") return {structures(), false, true};
  if (name == "--arithmetic" || name == "--with") {
    return {{"double", "exact", "gsl", "mpfr:53", "sturm"}, name == "--with"};
  }
  if (name == "--audit") return {{"end", "events", "none"}};
  if (name == "--scheduling") return {{"eager", "lazy"}};
  if (name == "--instants") return {{"intervals", "names", "none"}};
  if (name == "--kind") return {{"edge-edge", "vertex-face"}};
  if (name == "--color") return {{"always", "auto", "never"}};
  if (name == "--separator") return {{"comma", "semicolon", "tab"}};
  if (name == "--overlapping-starts") return {{"contact", "refused"}};
  if (name == "--family" && verb == "list") {
    CommandValue value;
    add_names(value.words, verify::family_names(), [](std::string_view family) { return family; });
    return value;
  }
  return {{}, type.starts_with("TEXT")};
}

void sort_out(std::vector<std::string>& words) {
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
}

// Up to the first line break or parenthesis: lists of shells are narrow.
std::string short_text(const std::string& text) {
  std::string line = text.substr(0, text.find_first_of("\n("));
  while (!line.empty() && (line.back() == ' ' || line.back() == ':')) line.pop_back();
  return line;
}

CommandOption option_of(const Path& path, const CLI::Option& option) {
  CommandOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  result.text = short_text(option.get_description());
  result.takes_value = option.get_items_expected_max() > 0;
  if (result.takes_value)
    result.value = value_of(path, result.names.back(), option.get_type_name());
  sort_out(result.value.words);
  return result;
}

Command command_of(const CLI::App& app, const Path& path) {
  Command command;
  command.path = path;
  command.text = short_text(app.get_description());
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) {
      const std::string name = option->get_name(true);
      const CommandValue value =
          value_of_word(path, name).value_or(value_of(path, name, option->get_type_name()));
      command.words.files = command.words.files || value.files;
      for (const std::string& word : value.words) command.words.words.push_back(word);
      for (const auto& [word, words] : value.after) command.words.after.emplace(word, words);
    } else if (!option->get_group().empty()) {
      command.options.push_back(option_of(path, *option));
    }
  }
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_group().empty()) continue;
    Path below = path;
    below.push_back(verb->get_name());
    command.commands.push_back(command_of(*verb, below));
  }
  // `kinex help` completes the verbs, and the verbs of those.
  for (Command& help : command.commands) {
    if (!path.empty() || help.path.back() != "help") continue;
    help.words = {};
    for (const Command& verb : command.commands) {
      help.words.words.push_back(verb.path.back());
      for (const Command& below : verb.commands) {
        help.words.after[verb.path.back()].push_back(below.path.back());
      }
    }
    sort_out(help.words.words);
  }
  sort_out(command.words.words);
  return command;
}

}  // namespace

Command command_tree(const CLI::App& app) { return command_of(app, {}); }

std::vector<const Command*> all_commands(const Command& command) {
  std::vector<const Command*> all{&command};
  for (const Command& below : command.commands) {
    for (const Command* one : all_commands(below)) all.push_back(one);
  }
  return all;
}

}  // namespace kinex::verbs

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

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

// By the name of an option, or of a word that stands without one.
CommandValue value_of(std::string_view name, std::string_view type) {
  CommandValue value;
  if (name == "--maintain") {
    value.words = structures();
  } else if (name == "STRUCTURE" || name == "WHAT") {
    value = {structures(), name == "WHAT"};
    for (const std::string_view group : structure_groups()) {
      if (!group.empty()) value.words.emplace_back(group);
    }
    if (name == "STRUCTURE") {
      for (const std::string_view family : verify::family_names()) value.words.emplace_back(family);
    }
    value.words.emplace_back("all");
  } else if (name == "WORKLOAD") {
    add_names(value.words, lab::workloads(), [](const lab::Workload& w) { return w.name; });
  } else if (name == "PAPER") {
    add_names(value.words, reproduce::papers(), [](const lab::Paper& paper) { return paper.name; });
  } else if (name == "PART") {
    for (const lab::Paper& paper : reproduce::papers()) {
      add_names(value.words, paper.parts, [](const lab::PaperPart& part) { return part.name; });
    }
  } else if (name == "PLAN") {
    add_names(value.words, experiments().all, [](const sweep::Experiment& e) { return e.name; });
    value.files = true;
  } else if (name == "--arithmetic" || name == "--with") {
    value = {{"exact", "sturm", "double", "gsl", "mpfr:53"}, name == "--with"};
  } else if (name == "--audit") {
    value.words = {"end", "events", "none"};
  } else if (name == "--scheduling") {
    value.words = {"lazy", "eager"};
  } else if (name == "--instants") {
    value.words = {"names", "intervals", "none"};
  } else if (name == "--kind") {
    value.words = {"vertex-face", "edge-edge"};
  } else if (name == "--color") {
    value.words = {"auto", "always", "never"};
  } else {
    value.files = type.starts_with("TEXT");
  }
  std::sort(value.words.begin(), value.words.end());
  value.words.erase(std::unique(value.words.begin(), value.words.end()), value.words.end());
  return value;
}

// Up to the first line break or parenthesis: lists of shells are narrow.
std::string short_text(const std::string& text) {
  std::string line = text.substr(0, text.find_first_of("\n("));
  while (!line.empty() && (line.back() == ' ' || line.back() == ':')) line.pop_back();
  return line;
}

CommandOption option_of(const CLI::Option& option) {
  CommandOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  result.text = short_text(option.get_description());
  result.takes_value = option.get_items_expected_max() > 0;
  if (result.takes_value) result.value = value_of(result.names.back(), option.get_type_name());
  return result;
}

Command command_of(const CLI::App& app, const std::vector<std::string>& path) {
  Command command;
  command.path = path;
  command.text = short_text(app.get_description());
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) {
      const CommandValue value = value_of(option->get_name(true), option->get_type_name());
      command.words.files = command.words.files || value.files;
      for (const std::string& word : value.words) command.words.words.push_back(word);
    } else if (!option->get_group().empty()) {
      command.options.push_back(option_of(*option));
    }
  }
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_group().empty()) continue;
    std::vector<std::string> below = path;
    below.push_back(verb->get_name());
    command.commands.push_back(command_of(*verb, below));
  }
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

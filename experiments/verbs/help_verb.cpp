// SPDX-License-Identifier: GPL-3.0-or-later
// kinex help: the help of the program or of a verb, as --help prints it.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

const CLI::App& verb_named(const CLI::App& app, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_name() == name) return *verb;
    known.push_back(verb->get_name());
  }
  throw formats::InputError("help", "", show_text(name) + " is not a verb",
                            did_you_mean(name, known, "kinex help lists them"));
}

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::string help_of(const CLI::App& verb, const std::string& before, const Voice& voice) {
  if (voice.quiet) {
    std::string names;
    for (const CLI::App* one : verbs_of(verb)) names += one->get_name() + "\n";
    return names.empty() ? verb.get_description() + "\n" : names;
  }
  // CLI::App::help() would print that of the verb in the command line, which is this one.
  std::string text = before.empty() ? verb.get_formatter()->make_help(&verb, verb.get_name(),
                                                                      CLI::AppFormatMode::Normal)
                                    : verb.help(before);
  if (!voice.verbose) return text;
  const std::string path = (before.empty() ? "" : before + " ") + verb.get_name();
  for (const CLI::App* one : verbs_of(verb)) text += "\n" + help_of(*one, path, voice);
  return text;
}

std::string help_of(const CLI::App& app, const std::vector<std::string>& words,
                    const Voice& voice) {
  const CLI::App* at = &app;
  std::string before;
  for (const std::string& word : words) {
    before += (before.empty() ? "" : " ") + at->get_name();
    at = &verb_named(*at, word);
  }
  return help_of(*at, before, voice);
}

}  // namespace

void add_help_verb(CLI::App& app, int&) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = app.add_subcommand("help", "Prints the help of the program or of a verb");
  verb->add_option("VERB", *words, "A verb, or a verb and its subcommand, as in: sweep run");
  add_voice(*verb, "Print the names of verbs alone", "Print the help of all verbs below, too");
  verb->footer("Example:\n  kinex help run");
  verb->callback([words, verb, &app] { print(help_of(app, *words, voice_of(*verb))); });
}

}  // namespace kinex::verbs

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/usage_error.h"

#include <CLI/CLI.hpp>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numbers/near_names.h"
#include "core/numbers/show_text.h"
#include "experiments/lab/workload.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

// "kinex sweep run"; "kinex" for no verb.
std::string command_of(const CLI::App& verb) {
  if (verb.get_parent() == nullptr) return verb.get_name();
  return command_of(*verb.get_parent()) + " " + verb.get_name();
}

// "kinex help sweep run".
std::string help_of(const CLI::App& verb) {
  return verb.get_parent() == nullptr
             ? "kinex help"
             : "kinex help " + command_of(verb).substr(std::string_view("kinex ").size());
}

// "run: "; empty for no verb.
std::string place_of(const CLI::App& verb) {
  return verb.get_parent() == nullptr
             ? ""
             : command_of(verb).substr(std::string_view("kinex ").size()) + ": ";
}

std::vector<std::string> names_of_verbs(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb :
       app.get_subcommands([](const CLI::App* a) { return !a->get_group().empty(); })) {
    names.push_back(verb->get_name());
  }
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// `near`: "did you mean a?" or another remedy.
std::string with_help(const std::string& near, const CLI::App& verb, const std::string& what) {
  const std::string help = help_of(verb) + " lists " + what;
  return "; " + near + (near.back() == '?' ? " " + help : " (" + help + ")");
}

// What other programs call our verbs.
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kOtherWords{
    {{"compare", "diff"},
     {"show", "view"},
     {"open", "view"},
     {"draw", "view"},
     {"generate", "gen"},
     {"create", "gen"},
     {"make", "gen"},
     {"version", "--version"},
     {"simulate", "run"},
     {"query", "run --query"},
     {"validate", "check"},
     {"convert", "import"},
     {"describe", "explain"},
     {"events", "log"},
     {"ls", "list"}}};

std::string unknown_verb(const CLI::App& app, const std::string& name) {
  const std::vector<std::string> known = names_of_verbs(app);
  if (app.get_parent() == nullptr) {
    for (const auto& [word, verb] : kOtherWords) {
      if (name != word) continue;
      return show_text(name) + " is not a verb" +
             with_help("did you mean " + std::string(verb) + "?", app, "them");
    }
  }
  return place_of(app) + show_text(name) + " is not a verb" +
         with_help(did_you_mean(name, known, "write one of " + joined(known)), app,
                   "them");
}

// The remedy for a word too many: where a structure stands for the file, its list lacks a comma.
std::string list_of_structures(const CLI::App& verb) {
  const CLI::Option* const maintain = verb.get_option_no_throw("--maintain");
  if (maintain == nullptr || maintain->count() == 0) return "leave it out";
  for (const CLI::Option* option : verb.get_options()) {
    if (!option->get_positional() || option->count() == 0) continue;
    const std::string word = option->results().front();
    if (find_structure_info(word) == nullptr) continue;
    return "write --maintain " + maintain->results().front() + "," + word +
           ", with commas between the structures";
  }
  return "leave it out";
}

std::string unknown_argument(const CLI::App& app, const std::vector<std::string>& extras) {
  const CLI::App& verb = innermost(app);
  for (const std::string& extra : extras) {
    if (extra.size() < 2 || extra[0] != '-') continue;
    const std::string name = extra.substr(0, extra.find('='));
    if (verb.get_name() == "run" && (name == "-o" || name == "--output")) {
      return place_of(verb) + show_text(name) +
             " is not an option; write --events FILE for the event log, --summary FILE for the summary (" +
             help_of(verb) + " lists all options)";
    }
    return place_of(verb) + show_text(name) + " is not an option" +
           with_help(did_you_mean(name, names_of_options(verb), "leave it out"), verb,
                     "all options");
  }
  const std::string name = extras.empty() ? "" : extras.front();
  if (!names_of_verbs(verb).empty()) return unknown_verb(verb, name);
  return place_of(verb) + show_text(name) + " is more than it takes" +
         with_help(list_of_structures(verb), verb, "what it takes");
}

// What a verb cannot do without: " LOG OTHER", " FILE --output ..".
std::string arguments_of(const CLI::App& verb, const std::string& missing) {
  std::string text, options;
  bool is_named = false;
  for (const CLI::Option* option : verb.get_options()) {
    if (!option->get_required()) continue;
    if (!option->get_positional()) {
      options += " " + option->get_name() + " ..";
      continue;
    }
    is_named = is_named || option->get_name() == missing;
    text += " " + option->get_name() + (option->get_items_expected_max() > 1 ? " .." : "");
  }
  return (is_named ? text : " " + missing) + options;
}

// What --help says of it: ": structures, workloads, papers or arithmetics"; empty if that is no short phrase.
std::string meaning_of(const CLI::App& verb, const std::string& name) {
  constexpr std::size_t kLongest = 70;
  for (const CLI::Option* option : verb.get_options()) {
    if (!option->get_positional() || option->get_name() != name) continue;
    std::string text = option->get_description();
    if (text.size() < 2 || text.size() > kLongest || text.find_first_of("();") != text.npos) return "";
    if (std::islower(static_cast<unsigned char>(text[1])) != 0 || text[1] == ' ') {
      text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    }
    return ": " + text;
  }
  return "";
}

// The first example of a help text with this option: "kinex view square.json -o square.html"; empty if there is none.
std::string example_with(const CLI::App& verb, const std::string& option) {
  const std::string footer = verb.get_footer();
  for (std::size_t at = 0; at != std::string::npos; at = footer.find('\n', at)) {
    at = footer.find_first_not_of(" \n", at);
    if (at == std::string::npos) break;
    const std::string line = footer.substr(at, footer.find('\n', at) - at);
    if (line.starts_with(command_of(verb)) && line.find(" " + option + " ") != std::string::npos)
      return line;
  }
  return "";
}

// What stands behind an option, by an example: "FILE.html" for "kinex view square.json -o square.html".
std::string value_in(const std::string& example, const CLI::Option& option,
                     const std::string& shown) {
  const std::size_t at = example.find(" " + shown + " ");
  if (at != std::string::npos) {
    const std::size_t begin = at + shown.size() + 2;
    const std::string value = example.substr(begin, example.find(' ', begin) - begin);
    const std::size_t dot = value.rfind('.');
    if (dot != std::string::npos && dot > 0) return "FILE" + value.substr(dot);
  }
  return option.get_description().find("folder") == std::string::npos ? "FILE" : "FOLDER";
}

// "--output is missing; write -o FILE.html, as in kinex view square.json -o square.html"
std::string missing_option(const CLI::App& verb, const std::string& name) {
  const CLI::Option* const option = verb.get_option_no_throw(name);
  std::string text = place_of(verb) + name + " is missing";
  if (option == nullptr) return text + "; give it (" + help_of(verb) + " tells what it is)";
  const std::vector<std::string>& letters = option->get_snames();
  const std::string shown = letters.empty() ? name : "-" + letters.front();
  const std::string example = example_with(verb, shown);
  text += "; write " + shown + " " + value_in(example, *option, shown);
  if (!example.empty()) text += ", as in " + example;
  return text + " (" + help_of(verb) + " tells what it is)";
}

// "SCENE is required"
std::string missing_argument(const CLI::App& app, const std::string& message) {
  const CLI::App& verb = innermost(app);
  const std::vector<std::string> extras = app.remaining(true);
  if (message.find("ubcommand") != std::string::npos) {
    if (!extras.empty()) return unknown_argument(app, extras);
    return place_of(verb) + "no verb is given; write one of " + joined(names_of_verbs(verb)) +
           " (" + help_of(verb) + " tells what they do)";
  }
  const std::string name = message.substr(0, message.find(' '));
  if (name.starts_with("--")) return missing_option(verb, name);
  return place_of(verb) + name + " is missing" + meaning_of(verb, name) + "; write " + command_of(verb) + arguments_of(verb, name) +
         " (" + help_of(verb) + " tells what it is)";
}

// "Could not convert: OPTION = TEXT"
std::string conversion_problem(const CLI::App& app, const std::string& message) {
  const std::size_t colon = message.find(": "), equals = message.find(" = ");
  const CLI::App& verb = innermost(app);
  if (colon == std::string::npos || equals == std::string::npos || equals < colon)
    return place_of(verb) + message;
  const std::string name = message.substr(colon + 2, equals - colon - 2);
  const CLI::Option* const option = verb.get_option_no_throw(name);
  const bool real = option != nullptr && option->get_type_name() == "FLOAT";
  const std::string word = message.substr(equals + 3);
  return name + ": " + (real ? show_text(word) + " is not a number; write one, as 2.5"
                             : whole_number_problem(name, word));
}

// "NAME: At Most 1 required but received 2"
std::string given_again(const CLI::App& verb, const std::string& message) {
  const std::string name = message.substr(0, message.find(": "));
  std::string values;
  if (const CLI::Option* const option = verb.get_option_no_throw(name)) {
    for (const std::string& value : option->results()) {
      values += (values.empty() ? ", as " : " and ") + show_text(value);
    }
  }
  return place_of(verb) + name + " is given more than once" + values + "; leave one (" +
         help_of(verb) + " tells what it takes)";
}

// "NAME: 1 required TYPE missing"
std::string missing_value(const CLI::App& verb, const std::string& message) {
  const std::string name = message.substr(0, message.find(": "));
  return place_of(verb) + name + " has no value; write " + name + " VALUE (" + help_of(verb) +
         " tells which)";
}

}  // namespace

const CLI::App& innermost(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().back();
  return *at;
}

std::string whole_number_problem(const std::string& option, const std::string& word) {
  const bool size = option == "--n" || option == "--m";
  return show_text(word) + " is not a whole number that fits; write one" +
         (size ? " from 1 to " + std::to_string(lab::kMaxWorkloadSize) : ", as 100");
}

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const std::string kind = error.get_name(), message = error.what();
  const CLI::App& verb = innermost(app);
  // Its name is that of the verb.
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return unknown_argument(app, app.remaining(true));
  if (kind == "RequiredError") return missing_argument(app, message);
  if (kind == "ValidationError") return message;  // in words of ours
  if (kind == "ConversionError") return conversion_problem(app, message);
  if (kind == "ArgumentMismatch" && message.find(" missing") != std::string::npos) {
    return missing_value(verb, message);
  }
  if (kind == "ArgumentMismatch" && message.find(": At Most 1 ") != std::string::npos) {
    return given_again(verb, message);
  }
  const std::size_t excludes = message.find(" excludes ");
  if (kind == "ExcludesError" && excludes != std::string::npos) {
    return place_of(verb) + message.substr(0, excludes) + " does not go with " +
           message.substr(excludes + 10) + "; leave one of them out";
  }
  return place_of(verb) + message + "; " + help_of(verb) + " tells what it takes";
}

}  // namespace kinex::verbs

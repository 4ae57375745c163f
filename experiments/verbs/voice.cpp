// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/voice.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/numbers/show_text.h"
#include "experiments/formats/plain_text.h"
#include "experiments/verbs/option_values.h"

namespace kinex::verbs {

namespace {

constexpr const char* kGroup = "Messages";
constexpr const char* kQuiet = "--quiet";
constexpr const char* kVerbose = "--verbose";
constexpr const char* kColour = "--color";

// The reason why a value of --color is refused; empty if it is valid.
std::string colour_problem(const std::string& choice) {
  if (choice == "auto" || choice == "always" || choice == "never") return "";
  return show_text(choice) + " is not a choice; write auto, always or never";
}

// The value of --color that applies to the verb; "auto" if the option was not given.
std::string colour_of(const CLI::App& verb) {
  for (const CLI::App* app = &verb; app != nullptr; app = app->get_parent()) {
    const CLI::Option* option = app->get_option_no_throw(kColour);
    if (option == nullptr || option->count() == 0) continue;
    const std::string& choice = option->results().front();
    if (choice == "always" || choice == "never") return choice;
  }
  return "auto";
}

bool is_given(const CLI::App& verb, const char* name) {
  for (const CLI::App* app = &verb; app != nullptr; app = app->get_parent()) {
    const CLI::Option* option = app->get_option_no_throw(name);
    if (option != nullptr && option->count() > 0) return option->as<bool>();  // --quiet=false
  }
  return false;
}

bool colours(const std::string& choice, int descriptor) {
  if (choice != "auto") return choice == "always";
  const char* const terminal = std::getenv("TERM");
  return std::getenv("NO_COLOR") == nullptr && ::isatty(descriptor) == 1 && terminal != nullptr &&
         std::string_view(terminal) != "dumb";
}

}  // namespace

void Voice::report(const std::string& text) const {
  if (!quiet) print(text);
}

void Voice::note(const std::string& text) const {
  if (!quiet) std::fprintf(stderr, "kinex: %s\n", formats::plain(text, '\n').c_str());
}

void Voice::detail(const std::string& text) const {
  if (verbose) std::fprintf(stderr, "kinex: %s\n", formats::plain(text, '\n').c_str());
}

void Voice::error(const std::string& text) const {
  std::fprintf(stderr, colour_err ? "\x1b[1;31mkinex:\x1b[0m %s\n" : "kinex: %s\n", formats::plain(text, '\n').c_str());
}

std::string Voice::heading(const std::string& text) const {
  return colour_out ? "\x1b[1m" + text + "\x1b[0m" : text;
}

void add_voice(CLI::App& verb, const std::string& quiet, const std::string& verbose) {
  CLI::Option* const less = verb.add_flag("-q,--quiet", quiet)->group(kGroup);
  verb.add_flag("-v,--verbose", verbose)->group(kGroup)->excludes(less);
}

void add_voice_options(CLI::App& app) {
  if (app.get_option_no_throw(kQuiet) == nullptr) {
    add_voice(app, "Print errors and what was asked for, nothing else",
              "Say more, on standard error");
  }
  app.add_option("--color", "auto (default: on terminals), always or never")
      ->check(CLI::Validator(colour_problem, "", "colour"))
      ->type_name("WHEN")
      ->group(kGroup);
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    add_voice_options(*verb);
  }
}

Voice voice_of(const CLI::App& verb) {
  Voice voice;
  voice.quiet = is_given(verb, kQuiet);
  voice.verbose = is_given(verb, kVerbose) && !voice.quiet;
  const std::string choice = colour_of(verb);
  voice.colour_out = colours(choice, STDOUT_FILENO);
  voice.colour_err = colours(choice, STDERR_FILENO);
  return voice;
}

}  // namespace kinex::verbs

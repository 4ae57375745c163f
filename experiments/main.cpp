// SPDX-License-Identifier: GPL-3.0-or-later
// The program `kinex`: parses the command line, runs one verb, and turns errors into exit codes.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>

#include "core/numbers/stop.h"
#include "experiments/formats/input_error.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/machine.h"
#include "experiments/verbs/verbs.h"

namespace {

// The message says "Could not convert: OPTION = TEXT".
std::string conversion_problem(const CLI::App& app, const std::string& message) {
  const std::size_t colon = message.find(": "), equals = message.find(" = ");
  if (colon == std::string::npos || equals == std::string::npos || equals < colon) return message;
  const std::string name = message.substr(colon + 2, equals - colon - 2);
  std::string type;
  for (const CLI::App* verb : app.get_subcommands()) {
    const CLI::Option* option = verb->get_option_no_throw(name);
    if (option != nullptr) type = option->get_type_name();
  }
  return name + ": " + kinex::show_text(message.substr(equals + 3)) +
         (type == "FLOAT" ? " is not a number; write one, as 2.5"
                          : " is not a whole number that fits; write one, as 100");
}

int run(int argc, char** argv) {
  CLI::App app(
      "kinex: kinetic data structures in exact arithmetic.\n"
      "Exit codes: 0 fine; 1 a claim, bound or audit failed; 2 bad input or usage; 3 gave up at a "
      "stated limit.",
      "kinex");
  app.set_version_flag("--version", kinex::lab::version_text);
  app.require_subcommand(1);
  app.footer(
      "Example: a scene, its run, and how floating point differs (kinex VERB --help has more)\n"
      "  kinex gen uniform-square --n 100 --seed 7 -o square.json\n"
      "  kinex run square.json --events exact.jsonl\n"
      "  kinex run square.json --arithmetic double --events double.jsonl\n"
      "  kinex diff exact.jsonl double.jsonl");
  int exit_code = kinex::verbs::kExitFine;
  kinex::verbs::add_verbs(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ConversionError& error) {
    std::fprintf(stderr, "kinex: %s\n", conversion_problem(app, error.what()).c_str());
    return kinex::verbs::kExitBadInput;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kinex::verbs::kExitFine : kinex::verbs::kExitBadInput;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  kinex::lab::install_gmp_memory();
  const kinex::lab::GmpGuard guard;
  try {
    return run(argc, argv);
  } catch (const kinex::formats::InputError& error) {
    std::fprintf(stderr, "kinex: %s\n", error.what());
    return kinex::verbs::kExitBadInput;
  } catch (const kinex::Stopped&) {
    std::fprintf(stderr, "kinex: stopped before there was anything to write\n");
    return kinex::verbs::kExitGaveUp;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "kinex: gave up: there is not enough memory\n");
    return kinex::verbs::kExitGaveUp;
  } catch (const std::invalid_argument& error) {
    // A run detects errors that no reader can, such as bodies that turn against each other.
    std::fprintf(stderr, "kinex: %s\n", error.what());
    return kinex::verbs::kExitBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kinex: internal error: %s; please report it with the input\n",
                 error.what());
    return kinex::verbs::kExitFailed;
  }
}

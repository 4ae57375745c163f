// SPDX-License-Identifier: GPL-3.0-or-later
// The program `kinex`: parses the command line, runs one verb, and turns errors into exit codes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/stop.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/plain_text.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/machine.h"
#include "experiments/lab/standard_streams.h"
#include "experiments/verbs/help_format.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/usage_error.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"
#include "experiments/view/recorder.h"

namespace {

namespace verbs = kinex::verbs;

void describe(CLI::App& app) {
  app.set_version_flag("-V,--version", kinex::lab::version_text);
  app.require_subcommand(1);
  app.footer(
      "Example: a scene, its run, how floating point differs (kinex help VERB has more)\n"
      "  kinex gen uniform-square --n 100 --seed 7 -o square.json\n"
      "  kinex run square.json --events exact.jsonl\n"
      "  kinex run square.json --arithmetic double --events double.jsonl\n"
      "  kinex diff exact.jsonl double.jsonl");
}

// The exit code of the command line that `app` has been given.
int run(CLI::App& app, int argc, char** argv, int& exit_code) {
  try {
    std::vector<std::string> words = verbs::command_words(argc, argv);
    std::reverse(words.begin(), words.end());  // as the parser wants them
    app.parse(std::move(words));
  } catch (const CLI::Success& success) {
    std::ostringstream text;  // of --help, --version
    app.exit(success, text, text);
    verbs::print(text.str());
  } catch (const CLI::ParseError& error) {
    verbs::voice_of(verbs::innermost(app)).error(verbs::usage_message(app, error));
    return verbs::kExitBadInput;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  kinex::lab::hold_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing, with a message
  kinex::lab::install_gmp_memory();
  const kinex::lab::GmpGuard guard;
  CLI::App app(
      "kinex: kinetic data structures in exact arithmetic.\n"
      "Exit codes: 0 fine; 1 a claim, bound or audit failed; 2 bad input or usage;\n"
      "3 gave up at a stated limit.",
      "kinex");
  int exit_code = verbs::kExitFine;
  describe(app);
  verbs::set_help_format(app);
  verbs::add_verbs(app, exit_code);
  const auto tell = [&app](const std::string& text) {
    verbs::voice_of(verbs::innermost(app)).error(text);
  };
  try {
    return run(app, argc, argv, exit_code);
  } catch (const kinex::formats::InputError& error) {
    tell(kinex::formats::plain(error.what()));
    return verbs::kExitBadInput;
  } catch (const kinex::Stopped&) {
    tell(
        "stopped before there was anything to write; run it again, with a larger limit if it had "
        "one");
    return verbs::kExitGaveUp;
  } catch (const std::bad_alloc&) {
    tell(
        "gave up: there is not enough memory; make the scene smaller, or run it on a larger "
        "machine");
    return verbs::kExitGaveUp;
  } catch (const std::invalid_argument& error) {
    // A run detects errors that no reader can, such as bodies that turn against each other.
    tell(kinex::formats::plain(error.what()));
    return verbs::kExitBadInput;
  } catch (const kinex::view::MisreportedEvents& error) {
    tell(error.what());
    return verbs::kExitFailed;
  } catch (const std::exception& error) {
    tell(std::string("internal error: ") + error.what() + "; please report it with the input");
    return verbs::kExitFailed;
  }
}

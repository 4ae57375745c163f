// SPDX-License-Identifier: GPL-3.0-or-later
// kinex trade: what less exact arithmetics gain and lose.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/lab/progress.h"
#include "experiments/lab/scene_run.h"
#include "experiments/trade/database.h"
#include "experiments/trade/markdown.h"
#include "experiments/trade/page.h"
#include "experiments/trade/plots.h"
#include "experiments/trade/report.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/resumed_work.h"
#include "experiments/verbs/verbs.h"

namespace kinex {

namespace {

constexpr int kMostJobs = 256;

struct Options {
  std::vector<std::string> what, arithmetics;
  std::string folder = ".";
  std::string markdown;
  double max_seconds = 120;
  int jobs = 1;
  bool quick = false;
  bool force = false;
  bool fresh = false;
  bool json = false;
};

std::string command_of(const Options& options) {
  std::string command = "kinex trade";
  for (const std::string& what : options.what) command += " " + what;
  if (options.quick) command += " --quick";
  if (!options.arithmetics.empty()) {
    command += " --arithmetic ";
    for (std::size_t i = 0; i < options.arithmetics.size(); ++i) {
      command += (i == 0 ? "" : ",") + options.arithmetics[i];
    }
  }
  if (options.jobs != 1) command += " --jobs " + std::to_string(options.jobs);
  return command;
}

// A wrong name is reported now, not after the first run.
void check_arithmetics(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const Scene nothing;
    arithmetic_option(name, nothing);
  }
}

void check(const Options& options) {
  check_range("--jobs", options.jobs, 1, kMostJobs);
  if (std::isnan(options.max_seconds)) {
    throw InputError("--max-seconds", "", "it is not a number",
                     "write a number above 0, or leave it out for 120");
  }
  if (!(options.max_seconds > 0)) {
    throw InputError("--max-seconds", "", "a limit that is not above 0", "leave it out for 120");
  }
  check_arithmetics(options.arithmetics);
  if (options.markdown == "-") {
    throw InputError("--markdown", "", "\"-\": standard output has the tables",
                     "give the name of a file");
  }
  for (const std::string& scene : options.what) {
    keep_input("--markdown", options.markdown, scene);
    keep_input("--output", options.folder + "/trade.sqlite", scene);
    keep_input("--output", options.folder + "/trade.html", scene);
  }
}

TradeResult run(const TradeCatalogue& catalogue, const Options& options, FinishedWork& finished,
                const InterruptGuard& interrupt) {
  std::vector<double> costs;
  for (const TradeCase& one : catalogue.cases) costs.push_back(one.cost);
  for (const BitsCase& one : catalogue.bits) costs.push_back(one.cost);
  Progress progress;
  PiecesDone pieces(std::move(costs));
  TradeOptions running;
  running.jobs = options.jobs;
  running.max_seconds = options.max_seconds;
  running.finished = &finished;
  if (!options.arithmetics.empty()) running.arithmetics = options.arithmetics;
  running.go_on = [&] { return !interrupt.interrupted(); };
  running.interrupt = &interrupt.flag();
  bool first_bits = true;
  const auto show = [&](const std::string& text) {
    progress.wipe();
    print(text);
  };
  TradeWatch watch;
  watch.on_work = [&](std::size_t index, const std::string& what) {
    progress.show([&](double seconds) { return pieces.text(index, what, seconds); });
  };
  watch.on_finished = [&](std::size_t index) { pieces.finished(index); };
  watch.on_case = [&](const CaseResult& one) {
    show(options.json ? json_row(one) : table_of(one));
  };
  watch.on_bits = [&](const BitsResult& one) {
    if (first_bits && !options.json) show(bits_header());
    first_bits = false;
    show(options.json ? json_row(one) : table_row(one));
  };
  TradeResult result = run_trade(catalogue, running, watch);
  for (const BitsGrowth& growth : result.growths) {
    show(options.json ? json_row(growth) : table_row(growth));
  }
  if (!options.json) show("\n" + closing_lines(result));
  return result;
}

void trade(const Options& options, int& exit_code) {
  const auto began = std::chrono::steady_clock::now();
  check(options);
  const TradeCatalogue catalogue =
      make_trade_catalogue(options.what, options.quick ? Extent::kQuick : Extent::kFull);
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);  // errors are reported below
  FinishedWork finished(options.folder + "/trade.unfinished", program_identity(), options.fresh);
  const ResultFile database(options.folder + "/trade.sqlite", options.force, finished);
  const ResultFile page(options.folder + "/trade.html", options.force, finished);
  std::optional<ResultFile> markdown;
  if (!options.markdown.empty()) markdown.emplace(options.markdown, options.force, finished);
  tell_what_is_found(finished, "scene", "scenes");

  InterruptGuard interrupt;
  const TradeResult result = run(catalogue, options, finished, interrupt);
  PageFacts facts;
  facts.build = build_facts();
  facts.machine = machine_facts();
  facts.command = command_of(options);
  database.write(trade_database(result, facts.build, facts.machine));
  const std::vector<Figure> figures = trade_figures(result);
  const Drawings drawings = draw(figures, "gnuplot", interrupt.go_on_a_while());
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  page.write(trade_page(result, figures, drawings, facts));
  if (markdown) markdown->write(trade_markdown(result, facts));
  if (!result.interrupted) finished.remove();
  if (!drawings.problem.empty()) {
    std::fprintf(stderr, "kinex: no plots: %s\n", drawings.problem.c_str());
  }
  std::fprintf(stderr, "kinex: %s and %s are written%s\n", database.path().c_str(),
               page.path().c_str(),
               result.interrupted ? "; interrupted: they hold what was finished, and the same "
                                    "command goes on from there"
                                  : "");
  if (!result.faults().empty()) {
    exit_code = kExitFailed;
  } else if (result.interrupted || result.gave_up()) {
    exit_code = kExitGaveUp;
  }
}

}  // namespace

void add_trade_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand(
      "trade", "Speed against accuracy over the arithmetics: writes trade.sqlite and trade.html");
  verb->add_option("WHAT", options->what, "Structures, scene files, or all (default)");
  verb->add_flag("--quick", options->quick, "Smaller scenes: less than a minute");
  verb->add_option("-o,--output", options->folder, "Write the results into this folder (here)");
  verb->add_option("--markdown", options->markdown, "Write the tables to this file as Markdown");
  verb->add_flag("--force", options->force, "Replace results that exist");
  verb->add_flag("--fresh", options->fresh, "Run again what an interrupted run has finished");
  verb->add_option("--arithmetic", options->arithmetics,
                   "Only these, beside exact and double: A, .. (sturm, gsl, mpfr:P too)")
      ->delimiter(',');
  verb->add_option("--max-seconds", options->max_seconds, "Give up a run after this time (120)");
  verb->add_option("--jobs", options->jobs, "Scenes at a time (1: more make time ratios noisy)");
  verb->add_flag("--json", options->json, "Print a JSON object per scene instead of the tables");
  verb->footer(
      "Every run is compared with the exact one, event by event, and its states are audited\n"
      "exactly. That an inexact arithmetic goes wrong is a result, not an error.\n"
      "What is finished is kept in trade.unfinished until all is: after an interruption (Ctrl-C, "
      "a\n"
      "power cut) the same command goes on from there.\n"
      "Exit codes: 1 an exact arithmetic was wrong, or any threw; 3 interrupted, or an exact\n"
      "run was stopped at the limit.\n"
      "Example:\n  kinex trade --quick -o results\n"
      "  kinex trade square.json --arithmetic gsl,mpfr:80,mpfr:120");
  verb->callback([options, &exit_code] { trade(*options, exit_code); });
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// kinex trade: what less exact arithmetics gain and lose.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
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
#include "experiments/trade/planned.h"
#include "experiments/trade/plots.h"
#include "experiments/trade/report.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/resumed_work.h"
#include "experiments/verbs/swept_work.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

constexpr int kMostJobs = 256;

struct Options {
  std::vector<std::string> what, arithmetics, from;
  std::string folder = ".";
  std::string markdown;
  double max_seconds = 120;
  int jobs = 1;
  bool quick = false;
  bool force = false;
  bool fresh = false;
  bool json = false;
  Voice voice;
  bool table = false;
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
    lab::arithmetic_option(name, nothing);
  }
}

void check(const Options& options) {
  check_range("--jobs", options.jobs, 1, kMostJobs);
  if (std::isnan(options.max_seconds)) {
    throw formats::InputError("--max-seconds", "", "it is not a number",
                     "write a number above 0, or leave it out for 120");
  }
  if (!(options.max_seconds > 0)) {
    throw formats::InputError("--max-seconds", "", "a limit that is not above 0", "leave it out for 120");
  }
  check_arithmetics(options.arithmetics);
  if (options.markdown == "-") {
    throw formats::InputError("--markdown", "", "\"-\": standard output has the tables",
                     "give the name of a file");
  }
  for (const std::string& scene : options.what) {
    keep_input("--markdown", options.markdown, scene);
    keep_input("--output", options.folder + "/trade.sqlite", scene);
    keep_input("--output", options.folder + "/trade.html", scene);
    keep_input("--output", options.folder + "/trade.txt", scene);
  }
}

// What decides the results.
trade::TradeOptions limits_of(const Options& options) {
  trade::TradeOptions limits;
  limits.max_seconds = options.max_seconds;
  if (!options.arithmetics.empty()) limits.arithmetics = options.arithmetics;
  return limits;
}

// Adds what is written to the table's file to `text`.
trade::TradeResult run(const trade::TradeCatalogue& catalogue, const Options& options,
                       sweep::Journal& journal, const InterruptGuard& interrupt,
                       std::string& text) {
  std::vector<double> costs;
  for (const trade::TradeCase& one : catalogue.cases) costs.push_back(one.cost);
  for (const trade::BitsCase& one : catalogue.bits) costs.push_back(one.cost);
  lab::Progress progress;
  lab::PiecesDone pieces(std::move(costs));
  trade::TradeOptions running = limits_of(options);
  running.jobs = options.jobs;
  running.journal = &journal;
  running.go_on = [&] { return !interrupt.interrupted(); };
  running.interrupt = &interrupt.flag();
  bool first_bits = true;
  // One scene has one short table, which is what was asked for.
  const bool tables = options.table || (catalogue.cases.size() == 1 && catalogue.bits.empty());
  const auto show = [&](const std::string& row, const std::string& json) {
    text += row;
    if (!options.json && !tables) return;
    progress.wipe();
    if (options.json || !options.voice.quiet) print(options.json ? json : row);
  };
  trade::TradeWatch watch;
  watch.on_work = [&](std::size_t index, const std::string& what) {
    progress.show([&](double seconds) { return pieces.text(index, what, seconds); });
  };
  watch.on_finished = [&](std::size_t index) { pieces.finished(index); };
  watch.on_case = [&](const trade::CaseResult& one) {
    show(trade::table_of(one), trade::json_row(one));
  };
  watch.on_bits = [&](const trade::BitsResult& one) {
    if (first_bits) show(trade::bits_header(), "");
    first_bits = false;
    show(trade::table_row(one), trade::json_row(one));
  };
  trade::TradeResult result = trade::run_trade(catalogue, running, watch);
  for (const trade::BitsGrowth& growth : result.growths) {
    show(trade::table_row(growth), trade::json_row(growth));
  }
  show("\n" + trade::closing_lines(result), "");
  return result;
}

void trade(const Options& options, int& exit_code) {
  const auto began = std::chrono::steady_clock::now();
  check(options);
  const trade::TradeCatalogue catalogue =
      trade::make_trade_catalogue(options.what, options.quick ? lab::Extent::kQuick : lab::Extent::kFull);
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);  // errors are reported below
  sweep::Journal journal = journal_of(
      options.from, options.folder + "/trade.unfinished",
      trade::selection_of(options.what, options.quick, limits_of(options)), options.fresh);
  const ResultFile database(options.folder + "/trade.sqlite", options.force, journal);
  const ResultFile page(options.folder + "/trade.html", options.force, journal);
  const ResultFile table(options.folder + "/trade.txt", options.force, journal);
  std::optional<ResultFile> markdown;
  if (!options.markdown.empty()) markdown.emplace(options.markdown, options.force, journal);
  tell_what_is_found(journal, "scene", "scenes", options.voice);

  InterruptGuard interrupt;
  std::string rows;
  const trade::TradeResult result = run(catalogue, options, journal, interrupt, rows);
  lab::PageFacts facts;
  facts.build = lab::build_facts();
  facts.machine = lab::machine_facts();
  facts.command = command_of(options);
  database.write(trade::trade_database(result, facts.build, facts.machine));
  const std::vector<lab::Figure> figures = trade::trade_figures(result);
  const lab::Drawings drawings = lab::draw(figures, "gnuplot", interrupt.go_on_a_while());
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  page.write(trade::trade_page(result, figures, drawings, facts));
  if (markdown) markdown->write(trade::trade_markdown(result, facts));
  std::string verdict = trade::verdict_line(result, facts.seconds) + "\n";
  for (const std::string& fault : result.faults()) verdict += "FAIL " + fault + "\n";
  table.write(rows + verdict);
  if (!result.interrupted) journal.remove();
  if (!drawings.problem.empty()) {
    options.voice.note("no plots: " + drawings.problem);
  }
  if (result.interrupted) {
    options.voice.note("interrupted: the finished part is written, and the same command resumes");
  }
  const std::string files =
      "page: " + page.path() + "; table: " + table.path() + "; database: " + database.path();
  if (options.json) {  // its lines stay alone on standard output
    options.voice.note(verdict + files);
  } else {
    options.voice.report(verdict + files + "\n");
  }
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
      "trade",
      "Speed against accuracy over the arithmetics: writes trade.html, trade.txt and trade.sqlite");
  verb->add_option("WHAT", options->what, "Structures, scene files, or all (default)");
  verb->add_flag("--quick", options->quick, "Smaller scenes: less than a minute");
  verb->add_option("-o,--output", options->folder, "Write the results into this folder (here)");
  verb->add_option("--markdown", options->markdown, "Write the tables to this file as Markdown");
  verb->add_flag("--force", options->force, "Replace results that exist");
  verb->add_flag("--fresh", options->fresh, "Repeat also the finished part of an interrupted run");
  verb->add_option("--arithmetic", options->arithmetics,
                   "Only these, beside exact and double: A, .. (sturm, gsl, mpfr:P too)")
      ->delimiter(',');
  verb->add_option("--from", options->from,
                   "Report what a sweep has run (kinex sweep run trade ..), from its folders");
  verb->add_option("--max-seconds", options->max_seconds, "Give up a run after this time (120)");
  verb->add_option("--jobs", options->jobs, "Simultaneous scenes (1; more make time ratios noisy)");
  verb->add_flag(
      "--table", options->table,
      "Print all tables, not only the verdict (those of a single scene are printed anyway)");
  verb->add_flag("--json", options->json, "Print a JSON object per scene instead");
  verb->footer(
      "Every run is compared with the exact one, event by event, and its states are audited\n"
      "exactly. An error of an inexact arithmetic is a result, not a failure of the command.\n"
      "What is finished is kept in trade.unfinished until all is: after an interruption (Ctrl-C, "
      "a\n"
      "power cut) the same command goes on from there.\n"
      "Exit codes: 1 an exact arithmetic was wrong, or any threw; 3 interrupted, or an exact\n"
      "run was stopped at the limit.\n"
      "Example:\n  kinex trade --quick -o results\n"
      "  kinex trade square.json --arithmetic gsl,mpfr:80,mpfr:120");
  verb->callback([options, verb, &exit_code] {
    options->voice = voice_of(*verb);
    trade(*options, exit_code);
  });
}

}  // namespace kinex::verbs

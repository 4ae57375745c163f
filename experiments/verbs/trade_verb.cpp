// SPDX-License-Identifier: GPL-3.0-or-later
// kinex trade: what less exact arithmetics gain and lose.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/plain_text.h"
#include "experiments/lab/progress.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/time_taken.h"
#include "experiments/trade/database.h"
#include "experiments/trade/markdown.h"
#include "experiments/trade/planned.h"
#include "experiments/trade/report.h"
#include "experiments/trade/report_text.h"
#include "experiments/verbs/experiment_files.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/swept_work.h"
#include "experiments/verbs/verbs.h"

namespace kinex::verbs {

namespace {

struct TradeOptions : ExperimentOptions {
  std::vector<std::string> what, arithmetics;
  std::string markdown;
  double max_seconds = 120;
  bool table = false;
};

std::string command_of(const TradeOptions& options) {
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

void check(const TradeOptions& options) {
  check_jobs(options);
  check_limit("--max-seconds", options.max_seconds, false, "write a number above 0, or leave it out for 120");
  check_arithmetics(options.arithmetics);
  if (options.markdown == "-") {
    throw formats::InputError("--markdown", "", "\"-\": standard output has the tables",
                     "give the name of a file");
  }
  std::vector<InputArgument> inputs;
  for (const std::string& scene : options.what) inputs.push_back({"WHAT", scene});
  check_standard_input(inputs);
  for (const std::string& scene : options.what) keep_input("--markdown", options.markdown, scene);
  keep_attempts("--markdown", options.markdown, options.from);
  for (const char* name : {"trade.sqlite", "trade.html", "trade.txt", "trade.unfinished"}) {
    const std::string file = options.folder + "/" + name;
    for (const std::string& scene : options.what) keep_input("--output", file, scene);
    keep_apart("--markdown", options.markdown, file, std::string("the ") + name + " of --output");
  }
}

// What decides the results.
trade::TradeOptions limits_of(const TradeOptions& options) {
  trade::TradeOptions limits;
  limits.max_seconds = options.max_seconds;
  if (!options.arithmetics.empty()) limits.arithmetics = options.arithmetics;
  return limits;
}

// Adds what is written to the table's file to `text`.
trade::TradeResult run(const trade::TradeCatalogue& catalogue, const TradeOptions& options,
                       sweep::CellSource source, const InterruptGuard& interrupt, std::string& text) {
  std::vector<double> costs;
  for (const trade::TradeCase& one : catalogue.cases) costs.push_back(one.cost);
  for (const trade::BitsCase& one : catalogue.bits) costs.push_back(one.cost);
  lab::Progress progress(!options.voice.quiet);
  lab::PiecesDone pieces(std::move(costs));
  trade::TradeOptions running = limits_of(options);
  running.jobs = options.jobs;
  running.source = std::move(source);
  running.interrupt = &interrupt.flag();
  bool first_bits = true;
  const auto tell = [&](const std::string& finished) {
    if (options.voice.verbose) progress.wipe();
    options.voice.detail(finished);
  };
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
    pieces.started(index);  // of a case with several runs, at the first one
    progress.show([&](double) { return pieces.text(index, formats::plain(what)); });
  };
  watch.on_finished = [&](std::size_t index) { pieces.finished(index); };
  watch.on_case = [&](const trade::CaseResult& one) {
    tell(formats::plain(one.scene_name + ", " + one.which.structure) + ": " +
         formats::counted(one.runs.size(), "run", "runs") + ", " + lab::duration_text(one.seconds));
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

void trade(const TradeOptions& options, int& exit_code) {
  check(options);
  const trade::TradeCatalogue catalogue = trade::make_trade_catalogue(
      options.what, options.quick ? lab::Extent::kQuick : lab::Extent::kFull);
  sweep::Journal journal = experiment_journal(
      options, trade::selection_of(options.what, options.quick, limits_of(options)));
  const ReportFiles files(options, "trade", journal);
  std::optional<ResultFile> markdown;
  if (!options.markdown.empty()) markdown.emplace(options.markdown, options.force, journal);
  InterruptGuard interrupt;
  sweep::CellSource source = experiment_source(options, journal, interrupt, "scene", "scenes");
  std::string rows;
  const trade::TradeResult result = run(catalogue, options, std::move(source), interrupt, rows);
  const lab::PageFacts facts = facts_of(command_of(options));
  if (markdown) markdown->write(trade::trade_markdown(result, facts));
  std::string faults;
  for (const std::string& fault : result.faults()) faults += "FAIL " + formats::plain(fault) + "\n";
  files.write({trade::trade_database(result, facts.build, facts.machine), rows,
               trade::trade_report(result, facts), facts, "",
               [&](const lab::TimeTaken& taken) { return trade::verdict_line(result, taken); }, faults},
              interrupt);
  if (!result.faults().empty()) {
    exit_code = kExitFailed;
  } else if (result.interrupted || result.gave_up()) {
    exit_code = kExitGaveUp;
  }
}

}  // namespace

void add_trade_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TradeOptions>();
  CLI::App* verb = app.add_subcommand(
      "trade", "Speed against accuracy of the arithmetics: trade.html, trade.txt, trade.sqlite");
  verb->add_option("WHAT", options->what, "Structures, scene files, or all (default)");
  add_experiment_options(*verb, *options,
                         {"trade", "Smaller scenes: minutes on one core",
                          "Write the results into this folder (here)",
                          "Simultaneous scenes (1; more make time ratios noisy)",
                          "Print a JSON object per scene instead"});
  verb->add_option("--markdown", options->markdown, "Write the tables to this file as Markdown");
  add_list_option(*verb, "--arithmetic", options->arithmetics,
                  "Only these, beside exact and double: A, .. (sturm, gsl, mpfr:P too)")
      ->allow_extra_args(false);
  verb->add_option("--max-seconds", options->max_seconds, "Give up a run after this time (120)");
  verb->add_flag(
      "--table", options->table,
      "Print all tables, not only the verdict (those of a single scene are printed anyway)");
  add_voice(*verb, "Print errors, and with --json its lines",
            "Name every scene that is finished, with its time, on standard error");
  verb->footer(
      "Every run is compared with the exact one, event by event, and its states are\n"
      "audited exactly. An error of an inexact arithmetic is a result, not a failure of\n"
      "the command. Each scene of a structure runs in a process of its own: a crash is\n"
      "a result. What is finished is kept in trade.unfinished until all is: after an\n"
      "interruption (Ctrl-C, a power cut) the same command goes on from there.\n"
      "Exit codes: 1 an exact arithmetic was wrong, or any threw; 3 interrupted, or an\n"
      "exact run was stopped at the limit.\n"
      "Example:\n"
      "  kinex trade --quick -o results\n"
      "  kinex trade square.json --arithmetic gsl,mpfr:80,mpfr:120");
  verb->callback([options, verb, &exit_code] {
    options->voice = voice_of(*verb);
    trade(*options, exit_code);
  });
}

}  // namespace kinex::verbs

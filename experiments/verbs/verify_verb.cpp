// SPDX-License-Identifier: GPL-3.0-or-later
// kinex verify: the bound-verification experiments.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/counted.h"
#include "experiments/lab/progress.h"
#include "experiments/lab/verdict.h"
#include "experiments/verbs/experiment_files.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verify/catalogue.h"
#include "experiments/verify/database.h"
#include "experiments/verify/planned.h"
#include "experiments/verify/plots.h"
#include "experiments/verify/report.h"
#include "experiments/verify/report_text.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

constexpr int kMostSeeds = 1000000;

struct VerifyOptions : ExperimentOptions {
  std::string structure = "all";
  std::string plots;  // a folder; empty: none
  std::optional<int> seeds;
  bool table = false;
};

std::string command_of(const VerifyOptions& options) {
  std::string command = "kinex verify " + options.structure;
  if (options.quick) command += " --quick";
  if (options.seeds) command += " --seeds " + std::to_string(*options.seeds);
  if (options.jobs != 1) command += " --jobs " + std::to_string(options.jobs);
  return command;
}

int exit_code_of(const verify::VerifyResult& result) {
  if (result.verdict() == lab::Verdict::kRefuted) return kExitFailed;
  if (result.interrupted || result.verdict() > lab::Verdict::kAgrees) return kExitGaveUp;
  return kExitFine;
}

// Of the long table the terminal has what did not pass, or all if requested.
class LongTable {
 public:
  LongTable(const VerifyOptions& options, bool bounds)
      : options_(options),
        bounds_(bounds),
        headed_(options.table),
        text_(verify::table_legend(bounds) + verify::table_header(bounds)) {
    if (options.table && !options.json) options.voice.report(text_);
  }
  // As lines of the table, and as JSON.
  void add(const std::string& row, lab::Verdict verdict, const std::string& json) {
    text_ += row;
    if (options_.json) {
      print(json);
    } else if (options_.table || verdict > lab::Verdict::kAgrees) {
      if (!headed_) options_.voice.report("did not pass:\n" + verify::table_header(bounds_));
      headed_ = true;
      options_.voice.report(row);
    }
  }
  void add_tables(const std::string& tables) {
    text_ += tables + "\n";
    if (options_.table && !options_.json) options_.voice.report(tables);
  }
  const std::string& text() const { return text_; }

 private:
  const VerifyOptions& options_;
  bool bounds_, headed_;
  std::string text_;
};

verify::VerifyResult run(const lab::Catalogue& catalogue, const VerifyOptions& options,
                         sweep::CellSource source, const InterruptGuard& interrupt, LongTable& table) {
  const bool bounds = verify::shows_bounds(catalogue.cells);
  std::vector<double> costs;
  for (const lab::Cell& cell : catalogue.cells) costs.push_back(cell.cost);
  lab::Progress progress(!options.voice.quiet);
  lab::PiecesDone pieces(std::move(costs));
  verify::VerifyOptions running;
  running.jobs = options.jobs;
  running.seeds = options.seeds;
  running.keep_folder = options.folder;
  running.source = std::move(source);
  running.interrupt = &interrupt.flag();
  running.on_start = [&](std::size_t index) {
    const lab::Cell& cell = catalogue.cells[index];
    const std::string what = cell.structure + ", " + cell.workload_text() +
                             ", n = " + std::to_string(cell.parameters.n);
    pieces.started(index);
    progress.show([&](double) { return pieces.text(index, what); });
  };
  running.on_cell = [&](std::size_t index, const lab::CellResult& cell) {
    pieces.finished(index);
    progress.wipe();
    options.voice.detail(cell.cell.structure + ", " + cell.cell.workload_text() +
                         ", n = " + std::to_string(cell.cell.parameters.n) + ": " +
                         std::string(lab::check_word(cell.verdict())) + ", " +
                         formats::counted(cell.trials.size(), "scene", "scenes"));
    table.add(verify::table_row(cell, bounds), cell.verdict(), verify::json_row(cell));
  };
  return verify::run_catalogue(catalogue, running);
}

void verify(const VerifyOptions& options, int& exit_code) {
  check_jobs(options);
  if (options.seeds) check_range("--seeds", *options.seeds, 1, kMostSeeds);
  const lab::Catalogue catalogue = verify::make_catalogue(
      options.structure, options.quick ? lab::Extent::kQuick : lab::Extent::kFull);
  if (!options.plots.empty()) make_folder("--plots", options.plots);
  sweep::Journal journal = experiment_journal(
      options, verify::selection_of(options.structure, options.quick, options.seeds));
  const ReportFiles files(options, "verify", journal);
  const PlotFiles plots(options.plots, options.force, verify::possible_titles(catalogue), journal);
  InterruptGuard interrupt;
  sweep::CellSource source =
      experiment_source(options, journal, interrupt, "experiment", "experiments");
  LongTable table(options, verify::shows_bounds(catalogue.cells));
  const verify::VerifyResult result = run(catalogue, options, std::move(source), interrupt, table);
  for (const lab::GrowthResult& growth : result.growths) {
    table.add(verify::table_row(growth), growth.check.verdict, verify::json_row(growth));
  }
  for (const lab::StudyResult& study : result.studies) {
    table.add(verify::table_row(study), study.verdict(), verify::json_row(study));
  }
  std::string tables;
  for (const lab::Table& one : verify::more_tables(result)) tables += lab::markdown(one);
  for (const lab::StudyResult& study : result.studies) tables += lab::markdown(study.table);
  table.add_tables(tables);
  const lab::PageFacts facts = facts_of(command_of(options));
  files.write({verify::verify_database(result, facts.build, facts.machine), table.text(),
               verify::verify_report(result, facts), facts, verify::seeds_line(result),
               [&](const lab::TimeTaken& taken) { return verify::verdict_line(result, taken); },
               verify::work_line(result) + "\n", &plots},
              interrupt);
  exit_code = exit_code_of(result);
}

}  // namespace

void add_verify_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* verb = app.add_subcommand(
      "verify", "The bound-verification experiments: verify.html, verify.txt, verify.sqlite");
  std::string groups, families;
  for (const std::string_view group : structure_groups()) groups += std::string(group) + ", ";
  for (const std::string_view family : verify::family_names()) {
    families += std::string(family) + ", ";
  }
  verb->add_option("STRUCTURE", options->structure,
                   "A structure; " + groups + "each all structures for it; " + families +
                       "each the whole family; or all (default)");
  add_experiment_options(*verb, *options,
                         {"verify", "Smaller sizes: minutes on one core",
                          "Write the results into this folder (here)",
                          "Simultaneous experiments (1; more make time ratios noisy)",
                          "Print a JSON object per row instead"});
  verb->add_option("--plots", options->plots, "Write the plots as SVG files into this folder, too");
  verb->add_option("--seeds", options->seeds,
                   "Number of scenes of every random experiment (default: as many as it needs)");
  verb->add_flag("--table", options->table, "Print the whole table, not only what did not pass");
  add_voice(*verb, "Print errors, and with --json its lines",
            "Name every experiment that is finished, with its verdict, on standard error");
  verb->footer(
      "Each experiment runs in a process of its own: a crash is a failed check. What is\n"
      "finished is kept in verify.unfinished until all is: after an interruption\n"
      "(Ctrl-C, a power cut) the same command goes on from there.\n"
      "Exit codes: 1 an expectation, bound or audit failed (the scene is kept beside\n"
      "the results); 3 interrupted, stopped at a limit, or not enough seeds to tell.\n"
      "Example:\n"
      "  kinex verify " +
      example_structure(2) +
      " --quick -o results\n"
      "  kinex sweep run verify all --jobs 2 -o out\n"
      "  kinex verify all --from out -o results");
  verb->callback([options, verb, &exit_code] {
    options->voice = voice_of(*verb);
    verify(*options, exit_code);
  });
}

}  // namespace kinex::verbs

// SPDX-License-Identifier: GPL-3.0-or-later
// kinex verify: the bound-verification experiments.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/file_io.h"
#include "experiments/lab/html_page.h"
#include "experiments/lab/measures.h"
#include "experiments/lab/progress.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/resumed_work.h"
#include "experiments/verbs/swept_work.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"
#include "experiments/verify/catalogue.h"
#include "experiments/verify/database.h"
#include "experiments/verify/page.h"
#include "experiments/verify/planned.h"
#include "experiments/verify/plots.h"
#include "experiments/verify/report_text.h"
#include "experiments/verify/tables.h"
#include "experiments/verify/verdict_lines.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

constexpr int kMostJobs = 256;
constexpr int kMostSeeds = 1000000;

struct Options {
  std::string structure = "all";
  std::string folder = ".";
  std::string plots;  // a folder; empty: none
  std::vector<std::string> from;
  int jobs = 1;
  std::optional<int> seeds;
  bool quick = false;
  bool force = false;
  bool fresh = false;
  bool json = false;
  Voice voice;
  bool table = false;
};

std::string command_of(const Options& options) {
  std::string command = "kinex verify " + options.structure;
  if (options.quick) command += " --quick";
  if (options.seeds) command += " --seeds " + std::to_string(*options.seeds);
  if (options.jobs != 1) command += " --jobs " + std::to_string(options.jobs);
  return command;
}

int exit_code_of(const verify::VerifyResult& result) {
  if (result.verdict() == lab::Verdict::kRefuted) return kExitFailed;
  if (result.interrupted || result.verdict() != lab::Verdict::kConfirmed) return kExitGaveUp;
  return kExitFine;
}

// The plots as files of their own, named after their titles.
void write_plots(const Options& options, const std::vector<lab::Figure>& figures,
                 const lab::Drawings& drawings) {
  if (options.plots.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(options.plots, error);  // errors are reported below
  std::string last;
  int panel = 0;
  for (std::size_t i = 0; i < figures.size() && i < drawings.svg.size(); ++i) {
    if (drawings.svg[i].empty()) continue;
    const std::string name = lab::anchor_of(figures[i].title);
    panel = name == last ? panel + 1 : 1;
    last = name;
    formats::OutputFile file(
        options.plots + "/" + name + (panel > 1 ? "-" + std::to_string(panel) : "") + ".svg",
        options.force);
    file.write(drawings.svg[i]);
    file.commit();
  }
}

void verify(const Options& options, int& exit_code) {
  const auto began = std::chrono::steady_clock::now();
  check_range("--jobs", options.jobs, 1, kMostJobs);
  if (options.seeds) check_range("--seeds", *options.seeds, 1, kMostSeeds);
  const lab::Catalogue catalogue =
      verify::make_catalogue(options.structure, options.quick ? lab::Extent::kQuick : lab::Extent::kFull);
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);  // errors are reported below
  sweep::Journal journal = journal_of(
      options.from, options.folder + "/verify.unfinished",
      verify::selection_of(options.structure, options.quick, options.seeds), options.fresh);
  const ResultFile database(options.folder + "/verify.sqlite", options.force, journal);
  const ResultFile page(options.folder + "/verify.html", options.force, journal);
  const ResultFile table(options.folder + "/verify.txt", options.force, journal);
  tell_what_is_found(journal, "experiment", "experiments", options.voice);

  const bool bounds = verify::shows_bounds(catalogue.cells);
  std::string rows = verify::table_header(bounds);  // of the long table
  // Of it the terminal has what did not pass, or all if requested.
  bool headed = options.table;
  const auto tell = [&](const std::string& row, lab::Verdict verdict, const std::string& json) {
    rows += row;
    if (options.json) {
      print(json);
    } else if (options.table || verdict != lab::Verdict::kConfirmed) {
      if (!headed) options.voice.report("did not pass:\n" + verify::table_header(bounds));
      headed = true;
      options.voice.report(row);
    }
  };
  InterruptGuard interrupt;
  verify::VerifyResult result;
  {
    std::vector<double> costs;
    for (const lab::Cell& cell : catalogue.cells) costs.push_back(cell.cost);
    lab::Progress progress;
    lab::PiecesDone pieces(std::move(costs));
    verify::VerifyOptions running;
    running.jobs = options.jobs;
    if (options.seeds) running.seeds = *options.seeds;
    running.keep_folder = options.folder;
    running.journal = &journal;
    running.go_on = [&] { return !interrupt.interrupted(); };
    running.interrupt = &interrupt.flag();
    running.on_scene = [&](std::size_t index, int seed) {
      const lab::Cell& cell = catalogue.cells[index];
      std::string what = cell.structure + ", " + cell.workload_text() +
                         ", n = " + std::to_string(cell.parameters.n);
      if (cell.random) what += ", scene " + std::to_string(seed + 1);
      progress.show([&](double seconds) { return pieces.text(index, what, seconds); });
    };
    running.on_cell = [&](std::size_t index, const lab::CellResult& cell) {
      pieces.finished(index);
      progress.wipe();
      tell(verify::table_row(cell, bounds), cell.verdict(), verify::json_row(cell));
    };
    if (options.table && !options.json) print(rows);
    result = verify::run_catalogue(catalogue, running);
  }
  for (const lab::GrowthResult& growth : result.growths) {
    tell(verify::table_row(growth), growth.check.verdict, verify::json_row(growth));
  }
  for (const lab::StudyResult& study : result.studies) {
    tell(verify::table_row(study), study.verdict(), verify::json_row(study));
  }
  std::string tables;
  for (const lab::Table& one : verify::neighbours_tables(result.growths))
    tables += lab::markdown(one);
  for (const lab::Table& one : verify::measures_tables(result.cells)) tables += lab::markdown(one);
  for (const lab::StudyResult& study : result.studies) tables += lab::markdown(study.table);
  if (options.table && !options.json) print(tables);

  lab::PageFacts facts;
  facts.build = lab::build_facts();
  facts.machine = lab::machine_facts();
  facts.command = command_of(options);
  database.write(verify::verify_database(result, facts.build, facts.machine));
  const std::vector<lab::Figure> figures = verify::verify_figures(result);
  const lab::Drawings drawings = lab::draw(figures, "gnuplot", interrupt.go_on_a_while());
  write_plots(options, figures, drawings);
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  page.write(verify::verify_page(result, figures, drawings, facts));
  const std::string verdict =
      verify::verdict_line(result, facts.seconds) + "\n" + verify::work_line(result) + "\n";
  table.write(rows + tables + "\n" + verify::seeds_line(result) + verdict);
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
    options.voice.report(verify::seeds_line(result) + verdict + files + "\n");
  }
  exit_code = exit_code_of(result);
}

}  // namespace

void add_verify_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand(
      "verify",
      "The bound-verification experiments: writes verify.html, verify.txt and verify.sqlite");
  std::string groups;
  for (const std::string_view group : structure_groups()) groups += std::string(group) + ", ";
  verb->add_option("STRUCTURE", options->structure,
                   "A structure; " + groups + "each all structures for it; or all (default)");
  verb->add_flag("--quick", options->quick, "Smaller sizes: a few minutes on one core");
  verb->add_option("-o,--output", options->folder, "Write the results into this folder (here)");
  verb->add_option("--plots", options->plots, "Write the plots as SVG files into this folder, too");
  verb->add_flag("--force", options->force, "Replace results that exist");
  verb->add_flag("--fresh", options->fresh, "Repeat also the finished part of an interrupted run");
  verb->add_option("--jobs", options->jobs,
                   "Simultaneous experiments (1; more make time ratios noisy)");
  verb->add_option("--seeds", options->seeds,
                   "Number of scenes of every random experiment (default: as many as it needs)");
  verb->add_option("--from", options->from,
                   "Report what a sweep has run (kinex sweep run verify ..), from its folders");
  verb->add_flag("--table", options->table, "Print the whole table, not only what did not pass");
  verb->add_flag("--json", options->json, "Print a JSON object per row instead");
  verb->footer(
      "What is finished is kept in verify.unfinished until all is: after an interruption (Ctrl-C, "
      "a\n"
      "power cut) the same command goes on from there.\n"
      "Exit codes: 1 an expectation, bound or audit failed (the scene is kept beside the "
      "results);\n"
      "3 interrupted, stopped at a limit, or not enough seeds to tell.\n"
      "Example:\n  kinex verify delaunay_2 --quick -o results\n  kinex verify maximum --quick\n"
      "  kinex sweep run verify all --jobs 2 -o out && kinex verify all --from out -o results");
  verb->callback([options, verb, &exit_code] {
    options->voice = voice_of(*verb);
    verify(*options, exit_code);
  });
}

}  // namespace kinex::verbs

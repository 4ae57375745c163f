// SPDX-License-Identifier: GPL-3.0-or-later
// kinex verify: the bound-verification experiments.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/file_io.h"
#include "experiments/lab/measures.h"
#include "experiments/lab/progress.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/resumed_work.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verify/catalogue.h"
#include "experiments/verify/database.h"
#include "experiments/verify/page.h"
#include "experiments/verify/plots.h"
#include "experiments/verify/report_text.h"
#include "experiments/verify/tables.h"
#include "structures/registry.h"

namespace kinex {

namespace {

constexpr int kMostJobs = 256;
constexpr int kMostSeeds = 1000000;

struct Options {
  std::string structure = "all";
  std::string folder = ".";
  int jobs = 1;
  std::optional<int> seeds;
  bool quick = false;
  bool force = false;
  bool fresh = false;
  bool json = false;
};

std::string command_of(const Options& options) {
  std::string command = "kinex verify " + options.structure;
  if (options.quick) command += " --quick";
  if (options.seeds) command += " --seeds " + std::to_string(*options.seeds);
  if (options.jobs != 1) command += " --jobs " + std::to_string(options.jobs);
  return command;
}

int exit_code_of(const VerifyResult& result) {
  if (result.verdict() == Verdict::kRefuted) return kExitFailed;
  if (result.interrupted || result.verdict() != Verdict::kConfirmed) return kExitGaveUp;
  return kExitFine;
}

void verify(const Options& options, int& exit_code) {
  const auto began = std::chrono::steady_clock::now();
  check_range("--jobs", options.jobs, 1, kMostJobs);
  if (options.seeds) check_range("--seeds", *options.seeds, 1, kMostSeeds);
  const Catalogue catalogue =
      make_catalogue(options.structure, options.quick ? Extent::kQuick : Extent::kFull);
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);  // errors are reported below
  FinishedWork finished(options.folder + "/verify.unfinished", program_identity(), options.fresh);
  const ResultFile database(options.folder + "/verify.sqlite", options.force, finished);
  const ResultFile page(options.folder + "/verify.html", options.force, finished);
  tell_what_is_found(finished, "experiment", "experiments");

  const bool bounds = shows_bounds(catalogue.cells);
  InterruptGuard interrupt;
  VerifyResult result;
  {
    std::vector<double> costs;
    for (const Cell& cell : catalogue.cells) costs.push_back(cell.cost);
    Progress progress;
    PiecesDone pieces(std::move(costs));
    VerifyOptions running;
    running.jobs = options.jobs;
    if (options.seeds) running.seeds = *options.seeds;
    running.keep_folder = options.folder;
    running.finished = &finished;
    running.go_on = [&] { return !interrupt.interrupted(); };
    running.interrupt = &interrupt.flag();
    running.on_scene = [&](std::size_t index, int seed) {
      const Cell& cell = catalogue.cells[index];
      std::string what = cell.structure + ", " + cell.workload_text() +
                         ", n = " + std::to_string(cell.parameters.n);
      if (cell.random) what += ", scene " + std::to_string(seed + 1);
      progress.show([&](double seconds) { return pieces.text(index, what, seconds); });
    };
    running.on_cell = [&](std::size_t index, const CellResult& cell) {
      pieces.finished(index);
      progress.wipe();
      print(options.json ? json_row(cell) : table_row(cell, bounds));
    };
    if (!options.json) print(table_header(bounds));
    result = run_catalogue(catalogue, running);
  }
  for (const GrowthResult& growth : result.growths) {
    print(options.json ? json_row(growth) : table_row(growth));
  }
  for (const StudyResult& study : result.studies) {
    print(options.json ? json_row(study) : table_row(study));
  }
  if (!options.json) {
    print(closing_line(result));
    for (const Table& table : measures_tables(result.cells)) print(markdown(table));
    for (const StudyResult& study : result.studies) print(markdown(study.table));
  }

  PageFacts facts;
  facts.build = build_facts();
  facts.machine = machine_facts();
  facts.command = command_of(options);
  database.write(verify_database(result, facts.build, facts.machine));
  const std::vector<Figure> figures = verify_figures(result);
  const Drawings drawings = draw(figures, "gnuplot", interrupt.go_on_a_while());
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  page.write(verify_page(result, figures, drawings, facts));
  if (!result.interrupted) finished.remove();
  if (!drawings.problem.empty()) {
    std::fprintf(stderr, "kinex: no plots: %s\n", drawings.problem.c_str());
  }
  std::fprintf(stderr, "kinex: %s and %s are written%s\n", database.path().c_str(),
               page.path().c_str(),
               result.interrupted ? "; interrupted: they hold what was finished, and the same "
                                    "command goes on from there"
                                  : "");
  exit_code = exit_code_of(result);
}

}  // namespace

void add_verify_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand(
      "verify", "The bound-verification experiments: writes verify.sqlite and verify.html");
  std::string groups;
  for (const std::string_view group : structure_groups()) groups += std::string(group) + ", ";
  verb->add_option("STRUCTURE", options->structure,
                   "A structure; " + groups + "each all structures for it; or all (default)");
  verb->add_flag("--quick", options->quick, "Smaller sizes: a few minutes on one core");
  verb->add_option("-o,--output", options->folder, "Write the results into this folder (here)");
  verb->add_flag("--force", options->force, "Replace results that exist");
  verb->add_flag("--fresh", options->fresh, "Run again what an interrupted run has finished");
  verb->add_option("--jobs", options->jobs,
                   "Experiments at a time (1: more make time ratios noisy)");
  verb->add_option("--seeds", options->seeds,
                   "So many scenes for every random experiment, not as many as it needs");
  verb->add_flag("--json", options->json, "Print a JSON object per row instead of the table");
  verb->footer(
      "What is finished is kept in verify.unfinished until all is: after an interruption (Ctrl-C, "
      "a\n"
      "power cut) the same command goes on from there.\n"
      "Exit codes: 1 an expectation, bound or audit failed (the scene is kept beside the "
      "results);\n"
      "3 interrupted, stopped at a limit, or not enough seeds to tell.\n"
      "Example:\n  kinex verify delaunay_2 --quick -o results\n  kinex verify maximum --quick");
  verb->callback([options, &exit_code] { verify(*options, exit_code); });
}

}  // namespace kinex

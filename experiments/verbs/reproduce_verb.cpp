// SPDX-License-Identifier: GPL-3.0-or-later
// kinex reproduce: the figures and claims of a paper, run again.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "experiments/lab/progress.h"
#include "experiments/reproduce/planned.h"
#include "experiments/reproduce/runner.h"
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
  std::string paper;
  std::vector<std::string> parts;
  std::string folder;
  std::vector<std::string> from;
  int jobs = 1;
  std::string logcheck;  // empty: the one that is found
  bool quick = false;
  bool force = false;
  bool fresh = false;
  bool json = false;
  Voice voice;
};

std::string command_of(const Options& options, std::string_view part) {
  std::string command = "kinex reproduce " + options.paper;
  if (!part.empty()) command += " " + std::string(part);
  return command + (options.quick ? " --quick" : "");
}

reproduce::ReproducedPart run_part(const lab::PaperPart& part, const Options& options,
                                   sweep::Journal& journal, const InterruptGuard& interrupt) {
  std::vector<double> costs;
  for (const lab::SeriesPoint& point : part.points(options.quick)) costs.push_back(point.cost);
  lab::Progress progress;
  lab::PiecesDone pieces(std::move(costs));
  reproduce::RunnerOptions running;
  running.jobs = options.jobs;
  running.quick = options.quick;
  running.command = command_of(options, part.name);
  running.go_on = [&] { return !interrupt.interrupted(); };
  running.interrupt = &interrupt.flag();
  running.on_run = [&](std::size_t i, const std::string& what) {
    progress.show([&](double seconds) { return pieces.text(i, what, seconds); });
  };
  running.on_point = [&](std::size_t i) { pieces.finished(i); };
  const lab::SecondProgram program(options.logcheck, running.go_on, running.interrupt);
  running.on_check = [&](const lab::RunKey& small) {
    progress.show([&](double) { return program.name() + ", " + small.text(); });
  };
  reproduce::ReproducedPart done = reproduce::run_part(part, journal, program, running);
  progress.wipe();
  return done;
}

void tell(const reproduce::ReproducedPart& done) {
  std::string text = "== " + std::string(done.part->name) + ": " + std::string(done.part->summary) +
                     "\n" + done.report.tables + "\n";
  for (const std::string& trouble : done.troubles) text += "FAILED  " + trouble + "\n";
  for (const lab::PaperClaim& claim : done.report.claims) {
    text += std::string(lab::claim_word(claim.verdict)) + "  " + claim.id + ": " + claim.statement +
            "\n           expected " + claim.expected + "\n           observed " + claim.observed +
            (claim.counterexample.empty()
                 ? ""
                 : "\n           known counterexample: " + claim.counterexample) +
            "\n           checked by a second program: " + claim.checked_by.text() + "\n";
  }
  print(text);
}

void reproduce(Options options, int& exit_code) {
  check_range("--jobs", options.jobs, 1, kMostJobs);
  const lab::Paper& paper = reproduce::paper_named(options.paper);
  const std::vector<const lab::PaperPart*> parts = reproduce::parts_named(paper, options.parts);
  if (options.folder.empty()) options.folder = options.paper + (options.quick ? "-quick" : "");
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);  // errors are reported below
  sweep::Journal journal =
      journal_of(options.from, options.folder + "/reproduce.unfinished",
                 reproduce::selection_of(options.paper, options.parts, options.quick), options.fresh);
  const ResultFile claims(options.folder + "/claims.json", options.force, journal);
  const ResultFile readme(options.folder + "/README.md", options.force, journal);
  tell_what_is_found(journal, "experiment", "experiments", options.voice);
  reproduce::ReproductionFacts facts;
  facts.build = lab::build_facts();
  facts.machine = lab::machine_facts();
  facts.command = command_of(options, "");
  for (const std::string& name : options.parts) facts.command += " " + name;

  InterruptGuard interrupt;
  std::vector<reproduce::ReproducedPart> done;
  std::vector<lab::Figure> figures;
  bool interrupted = false, failed = false, surprised = false;
  for (const lab::PaperPart* part : parts) {
    done.push_back(run_part(*part, options, journal, interrupt));
    const reproduce::ReproducedPart& one = done.back();
    if (!options.json && !options.voice.quiet) tell(one);
    figures.insert(figures.end(), one.report.figures.begin(), one.report.figures.end());
    interrupted = interrupted || one.interrupted;
    failed = failed || !one.troubles.empty();
    for (const lab::PaperClaim& claim : one.report.claims) {
      surprised = surprised || claim.is_surprising();
    }
    if (interrupted) break;
  }
  const lab::Drawings drawings = lab::draw(figures, "gnuplot", interrupt.go_on_a_while());
  std::size_t drawn = 0;
  for (const reproduce::ReproducedPart& one : done) {
    for (const std::string& name : one.report.figure_names) {
      const std::size_t i = drawn++;
      if (i >= drawings.svg.size() || drawings.svg[i].empty()) continue;
      const ResultFile picture(options.folder + "/" + name + ".svg", options.force, journal);
      picture.write(drawings.svg[i]);
    }
  }
  const std::string json = reproduce::claims_json(paper, done, facts);
  if (options.json) print(json);
  claims.write(json);
  readme.write(reproduce::paper_readme(paper, done, facts, drawings.problem.empty()));
  if (!interrupted) journal.remove();
  if (!drawings.problem.empty()) {
    options.voice.note("no figures: " + drawings.problem);
  }
  options.voice.note("claims.json and README.md are in " + options.folder +
                     (interrupted ? "; interrupted: the same command resumes" : ""));
  if (failed || surprised) {
    exit_code = kExitFailed;
  } else if (interrupted) {
    exit_code = kExitGaveUp;
  }
}

}  // namespace

void add_reproduce_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand(
      "reproduce", "Repeats a paper's experiments: claims with their verdicts, and figures");
  verb->add_option("PAPER", options->paper, "kds-report-1998 or separation-sensitive-1999")
      ->required();
  verb->add_option("PART", options->parts,
                   "A part of it, such as figure-3 or rigid (default: all)");
  verb->add_flag("--quick", options->quick, "Smaller sizes: minutes");
  verb->add_option("-o,--output", options->folder, "Write into this folder (PAPER, PAPER-quick)");
  verb->add_flag("--force", options->force, "Replace results that exist");
  verb->add_flag("--fresh", options->fresh, "Repeat also the finished part of an interrupted run");
  verb->add_option("--jobs", options->jobs, "Simultaneous runs (1; more disturb the times)");
  verb->add_option(
      "--logcheck", options->logcheck,
      "The second program, which checks one small run of every claim (kinex-logcheck)");
  verb->add_option("--from", options->from,
                   "Report what a sweep has run (kinex sweep run reproduce ..), from its folders");
  verb->add_flag("--json", options->json, "Print claims.json instead of the tables");
  verb->footer(
      "Every run is exact and audited. What is finished is kept in reproduce.unfinished until all "
      "is:\n"
      "after an interruption the same command goes on from there.\n"
      "Exit codes: 1 a claim is refuted that has no known counterexample, an audit or a bound failed,\n"
      "the log of a small run is refused;\n"
      "3 interrupted.\n"
      "Example:\n  kinex reproduce kds-report-1998 figure-3 --quick -o figure\n"
      "  kinex sweep run reproduce kds-report-1998 --jobs 2 -o out && kinex reproduce "
      "kds-report-1998 --from out");
  verb->callback([options, verb, &exit_code] {
    options->voice = voice_of(*verb);
    reproduce(*options, exit_code);
  });
}

}  // namespace kinex::verbs

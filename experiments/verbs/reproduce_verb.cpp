// SPDX-License-Identifier: GPL-3.0-or-later
// kinex reproduce: the figures and claims of a paper, run again.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/show_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/lab/progress.h"
#include "experiments/lab/second_program.h"
#include "experiments/reproduce/papers.h"
#include "experiments/reproduce/planned.h"
#include "experiments/reproduce/runner.h"
#include "experiments/verbs/experiment_files.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"

namespace kinex::verbs {

namespace {

struct ReproduceOptions : ExperimentOptions {
  ReproduceOptions() { folder.clear(); }  // named after the paper
  std::string paper;
  std::vector<std::string> parts;
  std::string logcheck;  // empty: the one that is found
};

std::string command_of(const ReproduceOptions& options, std::string_view part) {
  std::string command = "kinex reproduce " + options.paper;
  if (!part.empty()) command += " " + std::string(part);
  return command + (options.quick ? " --quick" : "");
}

reproduce::ReproducedPart run_part(const lab::PaperPart& part, const ReproduceOptions& options,
                                   const sweep::CellSource& source,
                                   const lab::SecondProgram& program,
                                   const InterruptGuard& interrupt) {
  std::vector<double> costs;
  for (const lab::SeriesPoint& point : part.points(options.quick)) costs.push_back(point.cost);
  lab::Progress progress(!options.voice.quiet);
  lab::PiecesDone pieces(std::move(costs));
  reproduce::RunnerOptions running;
  running.jobs = options.jobs;
  running.quick = options.quick;
  running.command = command_of(options, part.name);
  running.source = source;
  running.interrupt = &interrupt.flag();
  running.on_start = [&](std::size_t i, const lab::SeriesPoint& point) {
    const std::string what = point.key.text();
    if (options.voice.verbose) progress.wipe();
    options.voice.detail(std::string(part.name) + ": " + what);
    pieces.started(i);
    progress.show([&](double) { return pieces.text(i, what); });
  };
  running.on_point = [&](std::size_t i) { pieces.finished(i); };
  running.on_check = [&](const lab::RunKey& small) {
    progress.show([&](double) { return program.name() + ", " + small.text(); });
  };
  reproduce::ReproducedPart done = reproduce::run_part(part, program, running);
  progress.wipe();
  return done;
}

// The claims whose small run was not checked by the second program, and the reason of the first of them.
struct Unchecked {
  std::size_t claims = 0;
  std::string reason;
};
Unchecked unchecked_of(const std::vector<reproduce::ReproducedPart>& parts) {
  Unchecked unchecked;
  for (const reproduce::ReproducedPart& part : parts) {
    for (const lab::PaperClaim& claim : part.report.claims) {
      const lab::CheckedBy& check = claim.checked_by;
      if (check.run.structure.empty() || check.finding != lab::CheckedBy::Finding::kNotChecked) continue;
      if (unchecked.claims++ == 0) unchecked.reason = check.message;
    }
  }
  return unchecked;
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

void reproduce(ReproduceOptions options, int& exit_code) {
  check_jobs(options);
  if (!options.logcheck.empty() && !lab::SecondProgram(options.logcheck, {}, nullptr).exists()) {
    throw formats::InputError(
        "--logcheck", "", "there is no program " + show_text(options.logcheck),
        "write its path, or its name if it is in PATH, without arguments, or the path of a folder "
        "with a __main__.py");
  }
  const lab::Paper& paper = reproduce::paper_named(options.paper);
  const std::vector<const lab::PaperPart*> parts = reproduce::parts_named(paper, options.parts);
  if (options.folder.empty()) options.folder = options.paper + (options.quick ? "-quick" : "");
  sweep::Journal journal = experiment_journal(
      options, reproduce::selection_of(options.paper, options.parts, options.quick));
  const ResultFile claims(options.folder + "/claims.json", options.force, journal);
  const ResultFile readme(options.folder + "/README.md", options.force, journal);
  if (!options.force) {
    std::vector<std::string> names;
    for (const lab::PaperPart* part : parts) names.emplace_back(part->name);
    keep_figures(options.folder, names, journal);
  }
  reproduce::ReproductionFacts facts;
  facts.build = lab::build_facts();
  facts.machine = lab::machine_facts();
  facts.command = command_of(options, "");
  for (const std::string& name : options.parts) facts.command += " " + name;

  InterruptGuard interrupt;
  const sweep::CellSource source =
      experiment_source(options, journal, interrupt, "experiment", "experiments");
  const lab::SecondProgram program(options.logcheck, source.go_on, &interrupt.flag());
  std::vector<reproduce::ReproducedPart> done;
  std::vector<lab::Figure> figures;
  bool interrupted = false, failed = false, surprised = false;
  for (const lab::PaperPart* part : parts) {
    done.push_back(run_part(*part, options, source, program, interrupt));
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
  if (!drawings.problem.empty()) options.voice.note("no figures: " + drawings.problem);
  options.voice.note("claims.json and README.md are in " + options.folder +
                     (interrupted ? "; interrupted: the same command resumes" : ""));
  const Unchecked unchecked = interrupted ? Unchecked() : unchecked_of(done);
  if (unchecked.claims > 0) {
    options.voice.note("the second program did not check " +
                       formats::counted(unchecked.claims, "claim", "claims") + ": " + unchecked.reason);
  }
  if (failed || surprised) {
    exit_code = kExitFailed;
  } else if (interrupted || (unchecked.claims > 0 && !options.logcheck.empty())) {
    exit_code = kExitGaveUp;
  }
}

}  // namespace

void add_reproduce_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ReproduceOptions>();
  CLI::App* verb = app.add_subcommand(
      "reproduce", "Repeats a paper's experiments: claims with their verdicts, and figures");
  std::string papers;
  for (const lab::Paper& paper : reproduce::papers()) {
    papers += (papers.empty() ? "" : " or ") + std::string(paper.name);
  }
  verb->add_option("PAPER", options->paper, papers)->required();
  verb->add_option("PART", options->parts,
                   "A part of it, such as figure-3 or rigid (default: all)");
  add_experiment_options(*verb, *options,
                         {"reproduce", "Smaller sizes: minutes", "Write into this folder (PAPER, PAPER-quick)",
                          "Simultaneous runs (1; more disturb the times)",
                          "Print claims.json instead of the tables"});
  verb->add_option(
      "--logcheck", options->logcheck,
      "The second program, which checks one small run of every claim (kinex-logcheck)");
  add_voice(*verb, "Print errors, and with --json claims.json",
            "Name every run when it starts, on standard error");
  verb->footer(
      "Every run is exact, and audited where no note says otherwise. What is finished is\n"
      "kept in reproduce.unfinished until all is: after an interruption the same command\n"
      "goes on from there.\n"
      "Exit codes: 1 a claim is refuted that has no known counterexample, an audit or a\n"
      "bound failed, the log of a small run is refused; 3 interrupted, or the program\n"
      "of --logcheck did not check a claim.\n"
      "Example:\n"
      "  kinex reproduce kds-report-1998 figure-3 --quick -o figure\n"
      "  kinex sweep run reproduce kds-report-1998 --jobs 2 -o out\n"
      "  kinex reproduce kds-report-1998 --from out");
  verb->callback([options, verb, &exit_code] {
    options->voice = voice_of(*verb);
    reproduce(*options, exit_code);
  });
}

}  // namespace kinex::verbs

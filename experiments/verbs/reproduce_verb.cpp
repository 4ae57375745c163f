// SPDX-License-Identifier: GPL-3.0-or-later
// kinex reproduce: the figures and claims of a paper, run again.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/near_names.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/progress.h"
#include "experiments/reproduce/paper_files.h"
#include "experiments/reproduce/papers.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

constexpr int kMostJobs = 256;

struct Options {
  std::string paper;
  std::vector<std::string> parts;
  std::string folder;
  int jobs = 1;
  std::string logcheck;  // empty: the one that is found
  bool quick = false;
  bool force = false;
  bool fresh = false;
  bool json = false;
  Voice voice;
};

const lab::Paper& paper_named(const std::string& name) {
  std::string names;
  std::vector<std::string> known;
  for (const lab::Paper& paper : reproduce::papers()) {
    if (paper.name == name) return paper;
    known.emplace_back(paper.name);
    names += (names.empty() ? "" : ", ") + std::string(paper.name);
  }
  throw formats::InputError("PAPER", "", "\"" + name + "\": there is no such paper",
                            formats::did_you_mean(name, known, "write " + names));
}

std::vector<const lab::PaperPart*> parts_named(const lab::Paper& paper,
                                          const std::vector<std::string>& names) {
  std::vector<const lab::PaperPart*> parts;
  std::string known;
  std::vector<std::string> part_names;
  for (const lab::PaperPart& part : paper.parts) {
    known += (known.empty() ? "" : ", ") + std::string(part.name);
    part_names.emplace_back(part.name);
    if (names.empty()) parts.push_back(&part);
  }
  for (const std::string& name : names) {
    const std::size_t before = parts.size();
    for (const lab::PaperPart& part : paper.parts) {
      if (part.name == name) parts.push_back(&part);
    }
    if (parts.size() == before) {
      throw formats::InputError(
          "PART", "", "\"" + name + "\": the paper has no such part",
          formats::did_you_mean(name, part_names,
                                "write " + known + ", or nothing for all of them"));
    }
  }
  return parts;
}

std::string command_of(const Options& options, std::string_view part) {
  std::string command = "kinex reproduce " + options.paper;
  if (!part.empty()) command += " " + std::string(part);
  return command + (options.quick ? " --quick" : "");
}

reproduce::ReproducedPart run_part(const lab::PaperPart& part, const Options& options, lab::RecordStore& store,
                        const InterruptGuard& interrupt) {
  const std::vector<lab::SeriesPoint> points = part.points(options.quick);
  std::vector<double> costs;
  for (const lab::SeriesPoint& point : points) costs.push_back(point.cost);
  lab::Progress progress;
  lab::PiecesDone pieces(std::move(costs));
  lab::SeriesOptions running;
  running.jobs = options.jobs;
  running.go_on = [&] { return !interrupt.interrupted(); };
  running.interrupt = &interrupt.flag();
  running.on_run = [&](std::size_t i, const std::string& what) {
    progress.show([&](double seconds) { return pieces.text(i, what, seconds); });
  };
  running.on_point = [&](std::size_t i, const lab::SeriesResult&) { pieces.finished(i); };
  lab::SeriesRun run = lab::run_series(points, store, running);
  progress.wipe();
  reproduce::ReproducedPart done;
  done.part = &part;
  const std::string command = command_of(options, part.name);
  done.report = part.study == nullptr ? part.report(run.results, command)
                                      : part.study(command, running.go_on);
  done.interrupted = run.interrupted || (part.study != nullptr && interrupt.interrupted());
  done.troubles = std::move(run.troubles);
  if (done.interrupted) {
    for (lab::PaperClaim& claim : done.report.claims) {
      claim.verdict = lab::Verdict::kOpen;
      claim.observed += "; interrupted: not all runs were made";
    }
  }
  const lab::SecondProgram program(options.logcheck, running.go_on, running.interrupt);
  lab::Progress checking;
  for (std::string& refusal :
       lab::check_claims(done.report.claims, program, store, [&](const lab::RunKey& small) {
         checking.show([&](double) { return program.name() + ", " + small.text(); });
       })) {
    done.troubles.push_back(std::move(refusal));
  }
  checking.wipe();
  done.interrupted = done.interrupted || interrupt.interrupted();
  return done;
}

void tell(const reproduce::ReproducedPart& done) {
  std::string text = "== " + std::string(done.part->name) + ": " + std::string(done.part->summary) +
                     "\n" + done.report.tables + "\n";
  for (const std::string& trouble : done.troubles) text += "FAILED  " + trouble + "\n";
  for (const lab::PaperClaim& claim : done.report.claims) {
    text += std::string(lab::claim_word(claim.verdict)) + "  " + claim.id + ": " + claim.statement +
            "\n           expected " + claim.expected + "\n           observed " + claim.observed +
            "\n           checked by a second program: " + claim.checked_by.text() + "\n";
  }
  print(text);
}

void reproduce(Options options, int& exit_code) {
  check_range("--jobs", options.jobs, 1, kMostJobs);
  const lab::Paper& paper = paper_named(options.paper);
  const std::vector<const lab::PaperPart*> parts = parts_named(paper, options.parts);
  if (options.folder.empty()) options.folder = options.paper + (options.quick ? "-quick" : "");
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);  // errors are reported below
  const std::string claims_path = options.folder + "/claims.json";
  const std::string readme_path = options.folder + "/README.md";
  for (const std::string& path : {claims_path, readme_path}) {
    const formats::OutputFile probe(path,
                           options.force);  // leaves nothing behind when the program is killed
  }
  reproduce::ReproductionFacts facts;
  facts.build = lab::build_facts();
  facts.machine = lab::machine_facts();
  facts.command = command_of(options, "");
  for (const std::string& name : options.parts) facts.command += " " + name;
  lab::RecordStore store(options.folder + "/runs.jsonl", lab::program_identity(), options.fresh);

  InterruptGuard interrupt;
  std::vector<reproduce::ReproducedPart> done;
  std::vector<lab::Figure> figures;
  bool interrupted = false, failed = false, refuted = false;
  for (const lab::PaperPart* part : parts) {
    done.push_back(run_part(*part, options, store, interrupt));
    const reproduce::ReproducedPart& one = done.back();
    if (!options.json && !options.voice.quiet) tell(one);
    figures.insert(figures.end(), one.report.figures.begin(), one.report.figures.end());
    interrupted = interrupted || one.interrupted;
    failed = failed || !one.troubles.empty();
    for (const lab::PaperClaim& claim : one.report.claims) {
      refuted = refuted || claim.verdict == lab::Verdict::kRefuted;
    }
    if (interrupted) break;
  }
  const lab::Drawings drawings = lab::draw(figures, "gnuplot", interrupt.go_on_a_while());
  std::size_t drawn = 0;
  for (const reproduce::ReproducedPart& one : done) {
    for (const std::string& name : one.report.figure_names) {
      const std::size_t i = drawn++;
      if (i >= drawings.svg.size() || drawings.svg[i].empty()) continue;
      formats::OutputFile picture(options.folder + "/" + name + ".svg", options.force);
      picture.write(drawings.svg[i]);
      picture.commit();
    }
  }
  const std::string json = reproduce::claims_json(paper, done, facts);
  if (options.json) print(json);
  formats::OutputFile claims(claims_path, options.force);
  claims.write(json);
  claims.commit();
  formats::OutputFile readme(readme_path, options.force);
  readme.write(reproduce::paper_readme(paper, done, facts, drawings.problem.empty()));
  readme.commit();
  if (!drawings.problem.empty()) {
    options.voice.note("no figures: " + drawings.problem);
  }
  options.voice.note("claims.json and README.md are in " + options.folder +
                     (interrupted ? "; interrupted: the same command with --force resumes" : ""));
  if (failed || refuted) {
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
  verb->add_flag("--fresh", options->fresh, "Repeat the runs that are in runs.jsonl of the folder");
  verb->add_option("--jobs", options->jobs, "Simultaneous runs (1; more disturb the times)");
  verb->add_option(
      "--logcheck", options->logcheck,
      "The second program, which checks one small run of every claim (kinex-logcheck)");
  verb->add_flag("--json", options->json, "Print claims.json instead of the tables");
  verb->footer(
      "Every run is exact and audited. Runs that are done are kept in runs.jsonl: after an\n"
      "interruption the same command with --force goes on with the next one.\n"
      "Exit codes: 1 a claim is refuted, an audit or a bound failed, the log of a small run is "
      "refused;\n"
      "3 interrupted.\n"
      "Example:\n  kinex reproduce kds-report-1998 figure-3 --quick -o figure");
  verb->callback([options, verb, &exit_code] {
    options->voice = voice_of(*verb);
    reproduce(*options, exit_code);
  });
}

}  // namespace kinex::verbs

// SPDX-License-Identifier: GPL-3.0-or-later
// kinex sweep: plans of many cells, on one machine or many.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/lab/progress.h"
#include "experiments/sweep/cell_run.h"
#include "experiments/sweep/database.h"
#include "experiments/sweep/sweeper.h"
#include "experiments/verbs/experiment_files.h"
#include "experiments/verbs/experiments.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/swept_work.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

using namespace sweep;

constexpr int kMostJobs = 1024;
constexpr std::size_t kShownKey = 12;  // digits
constexpr std::size_t kMostTroubleRows = 20;

struct ShardOptions {
  PlanWords plan;
  std::string shard = "0/1", folder;
  int jobs = 1;
  bool fresh = false, retry = false;
  Voice voice;
};

std::string fill(std::string_view text, std::size_t width) {
  std::string filled(text);
  filled.resize(std::max(filled.size(), width), ' ');
  return filled;
}

std::string row(std::string_view status, const std::string& key, const std::string& rest) {
  return fill(status, 8) + key.substr(0, kShownKey) + "  " + rest + "\n";
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f s", seconds < 10 ? 2 : 0, seconds);
  return text;
}

int exit_code_of(const Tally& tally) {
  const auto some = [&](std::initializer_list<Outcome> outcomes) {
    for (const Outcome outcome : outcomes) {
      if (tally.of(outcome) > 0) return true;
    }
    return false;
  };
  if (some({Outcome::kFailed, Outcome::kRefused, Outcome::kCrash})) return kExitFailed;
  if (some({Outcome::kLimit, Outcome::kMemory, Outcome::kKilled})) return kExitGaveUp;
  return tally.missing > 0 ? kExitGaveUp : kExitFine;
}

// ---- list ---------------------------------------------------------------------------------------

void list_experiments() {
  std::string text;
  for (const Experiment& experiment : experiments().all) {
    text += fill(experiment.name, 28) + experiment.summary + "\n";
  }
  print(text);
}

void list(const PlanWords& words, const std::string& shard, bool json, const Voice& voice) {
  if (words.words.empty()) {
    list_experiments();
    return;
  }
  const Plan plan = words.plan();
  const std::vector<PlanCell> cells = shard_of(plan, parse_shard(shard));
  std::string text;
  for (const PlanCell& cell : cells) {
    if (json) {
      formats::JsonWriter line(text);
      line.begin_object().key("key").string(cell.key).key("cost").number(cell.cost);
      line.key("cell").raw(cell.text).end_object();
      text += "\n";
    } else {
      text += cell.key.substr(0, kShownKey) + "  " + cell.text + "\n";
    }
  }
  if (!json && !voice.quiet) text += formats::counted(cells.size(), "cell", "cells") + "\n";
  print(text);
  voice.detail("plan " + plan.name + " (" + plan.hash.substr(0, kShownKey) + "), shard " + shard +
               ": " + std::to_string(cells.size()) + " of " +
               formats::counted(plan.cells.size(), "cell", "cells"));
}

// ---- run ----------------------------------------------------------------------------------------

std::string command_of(const ShardOptions& options) {
  std::string command = "kinex sweep run " + options.plan.command() + " --shard " + options.shard;
  if (options.jobs != 1) command += " --jobs " + std::to_string(options.jobs);
  if (options.fresh) command += " --fresh";
  if (options.retry) command += " --retry";
  return command + " -o " + options.folder;
}

struct Work {
  std::vector<PlanCell> shard, rest;  // the cells of the shard; those still to be run
};

Work work_of(const Plan& plan, const Settled& settled, const ShardOptions& options) {
  Work work;
  work.shard = shard_of(plan, parse_shard(options.shard));
  for (const PlanCell& cell : work.shard) {
    const auto found = settled.find(cell.key);
    const bool is_finished = found != settled.end() && !options.fresh &&
                             is_settled(*found->second, plan.limits, options.retry);
    if (!is_finished) work.rest.push_back(cell);
  }
  return work;
}

// False if it was interrupted.
bool run_rest(const Plan& plan, const Work& work, const ShardOptions& options,
              std::deque<Record>& records, Settled& settled) {
  InterruptGuard interrupt;
  AttemptFile file(options.folder, parse_shard(options.shard),
                   provenance_of(plan, command_of(options), options.shard));
  std::vector<double> costs;
  for (const PlanCell& cell : work.rest) costs.push_back(static_cast<double>(cell.cost));
  lab::Progress progress(!options.voice.quiet);
  lab::PiecesDone pieces(std::move(costs));
  SweepOptions running;
  running.jobs = options.jobs;
  running.limits = plan.limits;
  running.program = kThisProgram;
  running.go_on = [&] { return !interrupt.interrupted(); };
  running.on_start = [&](std::size_t place) {
    if (options.voice.verbose) progress.wipe();
    options.voice.detail("start   " + work.rest[place].key.substr(0, kShownKey) + "  " +
                         work.rest[place].text);
    pieces.started(place);
    progress.show([&](double) { return pieces.text(place, work.rest[place].text); });
  };
  running.on_end = [&](std::size_t place, const Record& record) {
    file.append(record);
    take(settled, records.emplace_back(record));
    pieces.finished(place);
    progress.wipe();
    std::string rest = seconds_text(record.cpu_s) + "  " + record.cell;
    if (!record.message.empty()) rest += "  " + record.message;
    const std::string text = row(outcome_name(record.outcome), record.key, rest);
    if (options.voice.quiet && record.outcome != Outcome::kDone) {
      options.voice.error(text.substr(0, text.size() - 1));
    } else {
      options.voice.report(text);
    }
  };
  return run_cells(work.rest, running);
}

void run(const ShardOptions& options, int& exit_code) {
  check_range("--jobs", options.jobs, 1, kMostJobs);
  parse_shard(options.shard);
  const Plan plan = options.plan.plan();
  lab::check_limits({plan.limits.seconds, plan.limits.megabytes});
  make_folder("--output", options.folder);
  const std::vector<Attempt> attempts = read_attempts({options.folder});
  refuse_other_program(attempts);
  Settled settled = settle(attempts);
  const Work work = work_of(plan, settled, options);
  const std::size_t finished = work.shard.size() - work.rest.size();
  if (finished > 0) {
    options.voice.note("going on: " + formats::counted(finished, "cell", "cells") +
                       (finished == 1 ? " is" : " are") +
                       " finished already; --fresh runs them again");
  }
  std::deque<Record> records;
  const bool whole = work.rest.empty() || run_rest(plan, work, options, records, settled);
  const Tally counts = tally(work.shard, settled);
  options.voice.note("shard " + options.shard + " of " + plan.name + ": " +
                     formats::counted(work.shard.size(), "cell", "cells") + ": " + counts.text() +
                     (whole ? "" : "; interrupted: the same command resumes"));
  exit_code = whole ? exit_code_of(counts) : std::max(exit_code_of(counts), kExitGaveUp);
}

// ---- cell ---------------------------------------------------------------------------------------

extern "C" void say_that_time_is_up(int) {
  static constexpr char kText[] =
      "kinex: cell: the limit of CPU time is reached; raise --seconds\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kText, sizeof kText - 1);
  ::_exit(kExitGaveUp);
}

int exit_code_of(Outcome outcome) {
  if (outcome == Outcome::kDone) return kExitFine;
  if (outcome == Outcome::kRefused) return kExitBadInput;
  return outcome == Outcome::kFailed ? kExitFailed : kExitGaveUp;
}

// A sweep reads from its children what became of the cell, and how they ended. For others the exit code
// tells it, and standard error says why.
void cell(const std::string& text, const lab::ProcessLimits& limits, int parent, const Voice& voice,
          int& exit_code) {
  const bool by_hand = parent == 0;
  if (by_hand) std::signal(SIGXCPU, say_that_time_is_up);
  lab::limit_this_process(limits, parent);
  const CellReport report = run_any(text, experiments());
  print(report_text(report));
  if (!by_hand) return;
  exit_code = exit_code_of(report.outcome);
  if (!report.message.empty()) voice.error("cell: " + report.message);
}

// ---- status, merge ------------------------------------------------------------------------------

std::string trouble_rows(const Settled& settled) {
  std::string text;
  std::size_t rows = 0;
  for (const auto& [key, record] : settled) {
    if (record->outcome == Outcome::kDone) continue;
    if (++rows > kMostTroubleRows) continue;
    text += row(outcome_name(record->outcome), record->key,
                record->cell + (record->message.empty() ? "" : "  " + record->message));
  }
  if (rows > kMostTroubleRows) text += "and " + std::to_string(rows - kMostTroubleRows) + " more\n";
  return text;
}

std::string plan_line(const Plan& plan, const Settled& settled) {
  const Tally counts = tally(plan.cells, settled);
  std::string line = "plan " + plan.name + " (" + plan.hash.substr(0, kShownKey) +
                     "): " + formats::counted(counts.cells(), "cell", "cells") + ": " + counts.text();
  const auto rest = expected_rest(plan.cells, settled);
  if (counts.missing + counts.of(Outcome::kKilled) > 0 && rest) {
    line += "; about " + seconds_text(*rest) + " of CPU time left";
  }
  return line + "\n";
}

int exit_code_of(const std::vector<Plan>& plans, const Settled& settled) {
  int code = kExitFine;
  for (const Plan& plan : plans) {
    const int one = exit_code_of(tally(plan.cells, settled));
    if (code != kExitFailed && one != kExitFine) code = one;
  }
  return code;
}

std::vector<Attempt> attempts_in(const std::vector<std::string>& folders) {
  std::vector<Attempt> attempts = read_attempts(folders);
  if (attempts.empty()) {
    throw formats::InputError(folders.front(), "", "there is no attempt file in it",
                     "give the folder of a sweep, that of -o");
  }
  return attempts;
}

// "out/shard-0-..jsonl: shard 0/4 of growth, 12 records, kinex sweep run ..".
void tell_attempts(const std::vector<Attempt>& attempts, const Voice& voice) {
  for (const Attempt& attempt : attempts) {
    voice.detail(attempt.path + ": shard " + attempt.provenance.shard + ", " +
                 formats::counted(attempt.records.size(), "record", "records") + ", by " +
                 attempt.provenance.command);
  }
}

void status(const std::vector<std::string>& folders, const Voice& voice, int& exit_code) {
  const std::vector<Attempt> attempts = attempts_in(folders);
  const Settled settled = settle(attempts);
  const std::vector<Plan> plans = plans_of(attempts, experiments());
  std::string text;
  for (const Plan& plan : plans) text += plan_line(plan, settled);
  voice.report(text + trouble_rows(settled));
  tell_attempts(attempts, voice);
  exit_code = exit_code_of(plans, settled);
}

void merge(const std::vector<std::string>& folders, const std::string& path, bool force,
           const Voice& voice, int& exit_code) {
  keep_attempts("--output", path, folders);
  const std::vector<Attempt> attempts = attempts_in(folders);
  if (const auto conflict = find_conflict(attempts)) {
    voice.error("two attempts at one cell do not agree; nothing is written\n" + conflict->place_a +
                ":\n" + conflict->line_a + "\n" + conflict->place_b + ":\n" + conflict->line_b);
    exit_code = kExitFailed;
    return;
  }
  formats::OutputFile file(path, force);
  file.write(sweep_database(attempts, experiments()));
  file.commit();
  const Settled settled = settle(attempts);
  const std::vector<Plan> plans = plans_of(attempts, experiments());
  std::string text;
  for (const Plan& plan : plans) text += plan_line(plan, settled);
  voice.report(text + path + " is written\n");
  tell_attempts(attempts, voice);
  exit_code = exit_code_of(plans, settled);
}

// ---- the command line ---------------------------------------------------------------------------

void add_list(CLI::App& sweep) {
  struct Options {
    PlanWords plan;
    std::string shard = "0/1";
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = sweep.add_subcommand(
      "list", "Prints the cells of a plan, in their order; or the experiments that are plans");
  options->plan.add_options(*verb);
  verb->add_option("--shard", options->shard, "Only those of shard I of N, as I/N; I from 0");
  verb->add_flag("--json", options->json, "Print a JSON object per cell");
  add_voice(*verb, "Print the cells without their number",
            "Name the plan, its hash and its size, on standard error");
  verb->footer(
      "Example:\n  kinex sweep list plan.json\n  kinex sweep list verify " +
      example_structure(2) + " --quick");
  verb->callback([options, verb] {
    if (options->plan.words.empty()) {
      for (const char* name :
           {"--shard", "--json", "--quick", "--seeds", "--arithmetic", "--max-seconds"}) {
        const CLI::Option* given = verb->get_option_no_throw(name);
        if (given != nullptr && given->count() > 0) {
          throw formats::InputError(name, "", "it is for the cells of a plan",
                                    "name a plan, or leave it out");
        }
      }
    }
    list(options->plan, options->shard, options->json, voice_of(*verb));
  });
}

void add_run(CLI::App& sweep, int& exit_code) {
  auto options = std::make_shared<ShardOptions>();
  CLI::App* verb = sweep.add_subcommand("run", "Runs a plan, or a shard of it, into a folder");
  options->plan.add_options(*verb);
  verb->add_option("-o,--output", options->folder, "The folder of the sweep")->required();
  verb->add_option("--shard", options->shard, "Run shard I of N only, as I/N; I from 0");
  verb->add_option("--jobs", options->jobs, "Cells at a time (1)");
  verb->add_flag("--fresh", options->fresh,
                 "Run finished cells again, as another attempt, which must agree with the first");
  verb->add_flag("--retry", options->retry, "Run again cells that crashed or reached a limit");
  add_voice(*verb, "Print only cells that are not done", "Name cells when they start, too");
  verb->footer(
      "Each cell runs in a process of its own. When it ends its record is appended to a\n"
      "file that belongs to this attempt. After an interruption, a kill -9 or a power\n"
      "cut the same command goes on: only the cells that were running are lost. Several\n"
      "shards, attempts and machines can share the folder.\n"
      "Exit codes: 1 a cell failed, was refused or crashed; 3 interrupted, or cells\n"
      "reached a limit.\n"
      "Example:\n"
      "  kinex sweep run plan.json --jobs 4 -o out\n"
      "  seq 0 63 | parallel kinex sweep run plan.json --shard {}/64 -o out\n"
      "  kinex sweep run verify " +
      example_structure(2) + " --quick --shard 1/2 -o out");
  verb->callback([options, verb, &exit_code] {
    options->voice = voice_of(*verb);
    run(*options, exit_code);
  });
}

void add_cell(CLI::App& sweep, int& exit_code) {
  struct Options {
    std::string text;
    lab::ProcessLimits limits;
    int parent = 0;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = sweep.add_subcommand("cell", "Runs one cell here and prints its exact fields");
  verb->add_option("CELL", options->text, "The cell, as list prints it")->required();
  verb->add_option("--seconds", options->limits.seconds, "Limit of CPU time (none)");
  verb->add_option("--megabytes", options->limits.megabytes, "Limit of memory (none)");
  verb->add_option("--parent", options->parent, "End with this process")->group("");
  verb->footer(
      "Exit codes: 1 a bound or an audit failed; 2 the cell was refused; 3 a limit was\nreached.\n"
      "Example:\n  kinex sweep cell '{\"structure\": \"" +
      example_structure(2) + "\",\n    \"workload\": \"uniform-square\", \"n\": 50}'");
  verb->callback([options, verb, &exit_code] {
    for (const auto& [name, value] : {std::pair("--seconds", options->limits.seconds),
                                      {"--megabytes", options->limits.megabytes}}) {
      if (value < 0) {
        throw formats::InputError(name, "", std::to_string(value) + " is below 0",
                                  "write a number above 0; 0 is no limit");
      }
    }
    cell(options->text, options->limits, options->parent, voice_of(*verb), exit_code);
  });
}

void add_status(CLI::App& sweep, int& exit_code) {
  auto folders = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = sweep.add_subcommand(
      "status", "Prints the cells done, failed and missing, and the expected time left");
  verb->add_option("FOLDER", *folders, "The folders of the sweep")->required();
  add_voice(*verb, "Print nothing: the exit code tells whether all cells are done",
            "Name the attempts in the folders, on standard error");
  verb->footer(
      "Exit codes: 0 all cells done; 1 and 3 as for run, 3 also if cells are missing.\n"
      "Example:\n  kinex sweep status out");
  verb->callback([folders, verb, &exit_code] { status(*folders, voice_of(*verb), exit_code); });
}

void add_merge(CLI::App& sweep, int& exit_code) {
  struct Options {
    std::vector<std::string> folders;
    std::string output;
    bool force = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = sweep.add_subcommand("merge", "Merges all attempts into an SQLite database");
  verb->add_option("FOLDER", options->folders, "The folders of the sweep")->required();
  verb->add_option("-o,--output", options->output, "The database to write")->required();
  verb->add_flag("--force", options->force, "Replace it if it exists");
  add_voice(*verb, "Print no report", "Name the attempts in the folders, on standard error");
  verb->footer(
      "Attempts at one cell must agree in every exact field; if two do not, both lines\n"
      "are printed and nothing is written. The exact tables (plan, cell, run, counter,\n"
      "extreme, bound, violation) do not depend on shards, jobs and attempts;\n"
      "provenance and attempt say which build and machine ran what, and how long.\n"
      "Exit codes: 1 a conflict, or cells failed; 3 cells are missing or reached a\n"
      "limit; the database is written unless there is a conflict.\n"
      "Example:\n"
      "  kinex sweep merge out -o results.sqlite");
  verb->callback([options, verb, &exit_code] {
    merge(options->folders, options->output, options->force, voice_of(*verb), exit_code);
  });
}

}  // namespace

void add_sweep_verb(CLI::App& app, int& exit_code) {
  CLI::App* sweep = app.add_subcommand(
      "sweep", "Plans of many cells, on one machine or many: list, run, status, merge");
  sweep->require_subcommand(1);
  sweep->footer(
      "A plan is an experiment of the program (kinex sweep list names them), or a list\n"
      "of blocks, each a product of axes; a cell is then one run:\n"
      "  {\"kinex_plan\": 1, \"name\": \"growth\",\n"
      "   \"blocks\": [{\"structure\": [\"" +
      example_structure(2) +
      "\"], \"workload\": [\"uniform-square\"],\n"
      "               \"n\": [100, 200, 400], \"seed\": {\"from\": 1, \"to\": 50}}],\n"
      "   \"limits\": {\"seconds\": 600, \"megabytes\": 4000}}\n"
      "Axes, each a value or an array: structure (a name, an object as in a scene, or\n"
      "an array of these for one run), workload, n, m, degree, dimension, separation,\n"
      "turns, seed (as in gen); arithmetic, scheduling, audit, until, max_events (as in\n"
      "run). Limits of a cell: seconds of CPU time, megabytes of address space.\n"
      "Example:\n"
      "  kinex sweep run plan.json --jobs 4 -o out\n"
      "  kinex sweep status out\n"
      "  kinex sweep merge out -o results.sqlite\n"
      "  kinex sweep run verify --quick -o out && kinex verify --quick --from out");
  add_list(*sweep);
  add_run(*sweep, exit_code);
  add_status(*sweep, exit_code);
  add_merge(*sweep, exit_code);
  add_cell(*sweep, exit_code);
}

}  // namespace kinex::verbs

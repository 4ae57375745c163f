// SPDX-License-Identifier: GPL-3.0-or-later
// kinex sweep: plans of many runs, on one machine or many.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <cstdlib>
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
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"

namespace kinex {

namespace {

using namespace sweep;

constexpr int kMostJobs = 1024;
constexpr std::size_t kShownKey = 12;  // digits
constexpr std::size_t kMostTroubleRows = 20;
// posix_spawn finds the program under it even if its file has been replaced.
constexpr const char* kThisProgram = "/proc/self/exe";

struct RunOptions {
  std::string plan, shard = "0/1", folder;
  int jobs = 1;
  bool fresh = false, retry = false;
};

std::string row(std::string_view status, const std::string& key, const std::string& rest) {
  std::string text(status);
  text.resize(std::max<std::size_t>(text.size(), 8), ' ');
  return text + key.substr(0, kShownKey) + "  " + rest + "\n";
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

void list(const std::string& path, const std::string& shard, bool json) {
  const Plan plan = read_plan(path);
  const std::vector<PlannedCell> cells = shard_of(plan, parse_shard(shard));
  std::string text;
  for (const PlannedCell& cell : cells) {
    if (json) {
      JsonWriter line(text);
      line.begin_object().key("key").string(cell.key).key("cost").number(cell.cost);
      line.key("cell").raw(cell.text).end_object();
      text += "\n";
    } else {
      text += cell.key.substr(0, kShownKey) + "  " + cell.text + "\n";
    }
  }
  if (!json) text += counted(cells.size(), "cell", "cells") + "\n";
  print(text);
}

// ---- run ----------------------------------------------------------------------------------------

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// Of Slurm: "JOB", "JOB_TASK", or "JOB_TASK, restart 1".
std::string job_text() {
  std::string text = environment("SLURM_ARRAY_JOB_ID");
  if (text.empty()) return environment("SLURM_JOB_ID");
  text += "_" + environment("SLURM_ARRAY_TASK_ID");
  const std::string restarts = environment("SLURM_RESTART_COUNT");
  return restarts.empty() ? text : text + ", restart " + restarts;
}

std::string command_of(const RunOptions& options) {
  std::string command = "kinex sweep run " + options.plan + " --shard " + options.shard;
  if (options.jobs != 1) command += " --jobs " + std::to_string(options.jobs);
  if (options.fresh) command += " --fresh";
  if (options.retry) command += " --retry";
  return command + " -o " + options.folder;
}

Provenance provenance_of(const Plan& plan, const RunOptions& options) {
  Provenance provenance;
  provenance.plan_name = plan.name;
  provenance.plan_hash = plan.hash;
  provenance.plan = plan.text;
  provenance.program = program_identity();
  provenance.build = build_facts();
  provenance.machine = machine_facts();
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) == 0) provenance.host = host.data();
  provenance.command = command_of(options);
  provenance.shard = options.shard;
  provenance.job = job_text();
  provenance.started = utc_text("%Y-%m-%dT%H:%M:%SZ");
  return provenance;
}

void refuse_other_program(const std::vector<Attempt>& attempts, const std::string& program) {
  if (attempts.empty() || attempts.front().provenance.program == program) return;
  throw InputError(attempts.front().path, "line 1",
                   "its records are of another commit, " +
                       commit_text(attempts.front().provenance.build) + "; this program is of " +
                       commit_text(build_facts()),
                   "give another folder with -o: records of two commits are not mixed");
}

struct Work {
  std::vector<PlannedCell> shard, rest;  // the cells of the shard; those still to be run
};

Work work_of(const Plan& plan, const Settled& settled, const RunOptions& options) {
  Work work;
  work.shard = shard_of(plan, parse_shard(options.shard));
  for (const PlannedCell& cell : work.shard) {
    const auto found = settled.find(cell.key);
    const bool is_finished = found != settled.end() && !options.fresh &&
                             is_settled(*found->second, plan.limits, options.retry);
    if (!is_finished) work.rest.push_back(cell);
  }
  return work;
}

// False if it was interrupted.
bool run_rest(const Plan& plan, const Work& work, const RunOptions& options,
              std::deque<Record>& records, Settled& settled) {
  InterruptGuard interrupt;
  AttemptFile file(options.folder, parse_shard(options.shard), provenance_of(plan, options));
  std::vector<double> costs;
  for (const PlannedCell& cell : work.rest) costs.push_back(static_cast<double>(cell.cost));
  Progress progress;
  PiecesDone pieces(std::move(costs));
  SweepOptions running;
  running.jobs = options.jobs;
  running.limits = plan.limits;
  running.program = kThisProgram;
  running.go_on = [&] { return !interrupt.interrupted(); };
  running.on_start = [&](std::size_t place) {
    progress.show(
        [&](double seconds) { return pieces.text(place, work.rest[place].text, seconds); });
  };
  running.on_end = [&](std::size_t place, const Record& record) {
    file.append(record);
    take(settled, records.emplace_back(record));
    pieces.finished(place);
    progress.wipe();
    std::string rest = seconds_text(record.cpu_s) + "  " + record.cell;
    if (!record.message.empty()) rest += "  " + record.message;
    print(row(outcome_name(record.outcome), record.key, rest));
  };
  return run_cells(work.rest, running);
}

void run(const RunOptions& options, int& exit_code) {
  check_range("--jobs", options.jobs, 1, kMostJobs);
  parse_shard(options.shard);
  const Plan plan = read_plan(options.plan);
  check_limits({plan.limits.seconds, plan.limits.megabytes});
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);  // errors are reported below
  const std::vector<Attempt> attempts = read_attempts({options.folder});
  refuse_other_program(attempts, program_identity());
  Settled settled = settle(attempts);
  const Work work = work_of(plan, settled, options);
  const std::size_t finished = work.shard.size() - work.rest.size();
  if (finished > 0) {
    std::fprintf(stderr, "kinex: going on: %s finished already; --fresh runs them again\n",
                 (counted(finished, "cell", "cells") + (finished == 1 ? " is" : " are")).c_str());
  }
  std::deque<Record> records;
  const bool whole = work.rest.empty() || run_rest(plan, work, options, records, settled);
  const Tally counts = tally(work.shard, settled);
  std::fprintf(stderr, "kinex: shard %s of %s: %s: %s%s\n", options.shard.c_str(),
               plan.name.c_str(), counted(work.shard.size(), "cell", "cells").c_str(),
               counts.text().c_str(),
               whole ? "" : "; interrupted: the same command goes on from there");
  exit_code = whole ? exit_code_of(counts) : std::max(exit_code_of(counts), kExitGaveUp);
}

// ---- cell ---------------------------------------------------------------------------------------

void cell(const std::string& text, const ProcessLimits& limits, int parent) {
  limit_this_process(limits, parent);
  print(report_text(run_cell(parse_cell(text, "the cell"))));
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
                     "): " + counted(counts.cells(), "cell", "cells") + ": " + counts.text();
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
    throw InputError(folders.front(), "", "there is no attempt file in it",
                     "give the folder of a sweep, that of -o");
  }
  return attempts;
}

void status(const std::vector<std::string>& folders, int& exit_code) {
  const std::vector<Attempt> attempts = attempts_in(folders);
  const Settled settled = settle(attempts);
  const std::vector<Plan> plans = plans_of(attempts);
  std::string text;
  for (const Plan& plan : plans) text += plan_line(plan, settled);
  print(text + trouble_rows(settled));
  exit_code = exit_code_of(plans, settled);
}

void merge(const std::vector<std::string>& folders, const std::string& path, bool force,
           int& exit_code) {
  const std::vector<Attempt> attempts = attempts_in(folders);
  if (const auto conflict = find_conflict(attempts)) {
    std::fprintf(stderr,
                 "kinex: two attempts at one cell do not agree; nothing is written\n%s:\n%s\n%s:\n"
                 "%s\n",
                 conflict->place_a.c_str(), conflict->line_a.c_str(), conflict->place_b.c_str(),
                 conflict->line_b.c_str());
    exit_code = kExitFailed;
    return;
  }
  OutputFile file(path, force);
  file.write(sweep_database(attempts));
  file.commit();
  const Settled settled = settle(attempts);
  const std::vector<Plan> plans = plans_of(attempts);
  std::string text;
  for (const Plan& plan : plans) text += plan_line(plan, settled);
  print(text + path + " is written\n");
  exit_code = exit_code_of(plans, settled);
}

// ---- the command line ---------------------------------------------------------------------------

void add_list(CLI::App& sweep) {
  struct Options {
    std::string plan, shard = "0/1";
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = sweep.add_subcommand("list", "Prints the cells of a plan, in their order");
  verb->add_option("PLAN", options->plan, "The plan, - is standard input")->required();
  verb->add_option("--shard", options->shard, "Those of shard I of N, as I/N; I from 0");
  verb->add_flag("--json", options->json, "Print a JSON object per cell");
  verb->callback([options] { list(options->plan, options->shard, options->json); });
}

void add_run(CLI::App& sweep, int& exit_code) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* verb = sweep.add_subcommand("run", "Runs a plan, or a shard of it, into a folder");
  verb->add_option("PLAN", options->plan, "The plan, - is standard input")->required();
  verb->add_option("-o,--output", options->folder, "The folder of the sweep")->required();
  verb->add_option("--shard", options->shard, "Run shard I of N only, as I/N; I from 0");
  verb->add_option("--jobs", options->jobs, "Cells at a time (1)");
  verb->add_flag("--fresh", options->fresh,
                 "Run finished cells again: another attempt, which must agree with the first");
  verb->add_flag("--retry", options->retry, "Run cells again that crashed or reached a limit");
  verb->footer(
      "Each cell runs in a process of its own. When it ends its record is appended to a file that\n"
      "belongs to this attempt. After an interruption, a kill -9 or a power cut the same command\n"
      "goes on: only the cells that were running are lost. Several shards, attempts and machines\n"
      "can share the folder.\n"
      "Exit codes: 1 a cell failed, was refused or crashed; 3 interrupted, or cells reached a "
      "limit.\n"
      "Example:\n  kinex sweep run plan.json --jobs 4 -o out\n"
      "  seq 0 63 | parallel kinex sweep run plan.json --shard {}/64 -o out");
  verb->callback([options, &exit_code] { run(*options, exit_code); });
}

void add_cell(CLI::App& sweep) {
  struct Options {
    std::string text;
    ProcessLimits limits;
    int parent = 0;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = sweep.add_subcommand("cell", "Runs one cell here and prints its exact fields");
  verb->add_option("CELL", options->text, "The cell, as list prints it")->required();
  verb->add_option("--seconds", options->limits.seconds, "Limit of CPU time (none)");
  verb->add_option("--megabytes", options->limits.megabytes, "Limit of memory (none)");
  verb->add_option("--parent", options->parent, "End with this process")->group("");
  verb->footer(
      "Example:\n  kinex sweep cell '{\"structure\": \"delaunay_2\", \"workload\": "
      "\"uniform-square\", \"n\": 50}'");
  verb->callback([options] { cell(options->text, options->limits, options->parent); });
}

void add_status(CLI::App& sweep, int& exit_code) {
  auto folders = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = sweep.add_subcommand(
      "status", "Prints what is done, failed and missing, and the expected rest");
  verb->add_option("FOLDER", *folders, "The folders of the sweep")->required();
  verb->footer("Exit codes: 0 all is done; 1 and 3 as for run, 3 also if cells are missing.");
  verb->callback([folders, &exit_code] { status(*folders, exit_code); });
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
  verb->footer(
      "Attempts at one cell must agree in every exact field; if two do not, both lines are "
      "printed\n"
      "and nothing is written. The exact tables (plan, cell, run, counter, extreme, bound,\n"
      "violation) do not depend on shards, jobs and attempts; provenance and attempt say who ran\n"
      "what, and how long it took.\n"
      "Exit codes: 1 a conflict, or cells failed; 3 cells are missing or reached a limit; the\n"
      "database is written unless there is a conflict.\n"
      "Example:\n  kinex sweep merge out -o results.sqlite");
  verb->callback([options, &exit_code] {
    merge(options->folders, options->output, options->force, exit_code);
  });
}

}  // namespace

void add_sweep_verb(CLI::App& app, int& exit_code) {
  CLI::App* sweep = app.add_subcommand(
      "sweep", "Plans of many runs, on one machine or many: list, run, status, merge");
  sweep->require_subcommand(1);
  sweep->footer(
      "A plan is a list of blocks, each a product of axes; a cell is one run:\n"
      "  {\"kinex_plan\": 1, \"name\": \"growth\",\n"
      "   \"blocks\": [{\"structure\": [\"delaunay_2\"], \"workload\": [\"uniform-square\"],\n"
      "               \"n\": [100, 200, 400], \"seed\": {\"from\": 1, \"to\": 50}}],\n"
      "   \"limits\": {\"seconds\": 600, \"megabytes\": 4000}}\n"
      "Axes, each a value or an array: structure (a name, an object as in a scene, or an array of\n"
      "these for one run), workload, n, m, degree, dimension, separation, turns, seed (as in "
      "gen);\n"
      "arithmetic, scheduling, audit, until, max_events (as in run). Limits of a cell: seconds of\n"
      "CPU time, megabytes of address space.\n"
      "Example:\n  kinex sweep run plan.json --jobs 4 -o out\n  kinex sweep status out\n"
      "  kinex sweep merge out -o results.sqlite");
  add_list(*sweep);
  add_run(*sweep, exit_code);
  add_status(*sweep, exit_code);
  add_merge(*sweep, exit_code);
  add_cell(*sweep);
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// kinex run: simulates a scene and reports what happened.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/refused_change.h"
#include "core/numbers/stop.h"
#include "core/numbers/time_text.h"
#include "experiments/formats/box_queries.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/model_text.h"
#include "experiments/formats/plain_text.h"
#include "experiments/formats/run_report.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/summary.h"
#include "experiments/lab/colours.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/machine.h"
#include "experiments/lab/progress.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/structure_words.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/refused_scene.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct RunOptions {
  std::string scene, until, events, summary;
  std::string arithmetic = "exact";
  std::string audit = "end";
  std::string scheduling = "lazy";
  std::string instants = "names";
  std::vector<std::string> maintain, at, query;
  long long max_events = 0;
  double max_seconds = 0;
  bool json = false;
  bool force = false;
  bool explain = false;
  bool provenance = false;
  bool instants_given = false;
};

// A limit that has been reached.
constexpr double kNoSeconds = 1e-9;

AuditLevel audit_level(const std::string& name) {
  if (name == "none") return AuditLevel::kNone;
  if (name == "end") return AuditLevel::kEnd;
  if (name == "events") return AuditLevel::kEvents;
  throw formats::InputError("--audit", "", show_text(name) + " is not a level", "write end, events or none");
}

Scheduling scheduling(const std::string& name) {
  if (name == "lazy") return Scheduling::kLazy;
  if (name == "eager") return Scheduling::kEager;
  throw formats::InputError("--scheduling", "", show_text(name) + " is not a way of scheduling",
                   "write lazy or eager");
}

InstantDetail instant_detail(const std::string& name) {
  for (const InstantDetail detail :
       {InstantDetail::kName, InstantDetail::kInterval, InstantDetail::kNone}) {
    if (name == formats::detail_name(detail)) return detail;
  }
  throw formats::InputError("--instants", "", show_text(name) + " is not a detail of instants",
                   "write names, intervals or none");
}

void shorten(Scene& scene, const std::string& until) {
  if (until.empty()) return;
  const Rational end = rational_option("--until", until);
  if (end <= scene.start || (scene.end && end > *scene.end)) {
    throw formats::InputError("--until", "", show_text(until) + " is outside of the scene's time",
                              "write a time after " + time_text(scene.start) +
                                  (scene.end ? ", at most " + time_text(*scene.end) : ""));
  }
  scene.end = end;
}

std::vector<Rational> sample_times(const Scene& scene, const std::vector<std::string>& texts) {
  std::vector<Rational> times;
  for (const std::string& text : texts) {
    times.push_back(rational_option("--at", text));
    if (times.back() < scene.start || (scene.end && times.back() > *scene.end)) {
      throw formats::InputError("--at", "", show_text(text) + " is outside of the run's time",
                                "write a time from " + time_text(scene.start) + " on" +
                                    (scene.end ? ", at most " + time_text(*scene.end) : ""));
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// Every --query is asked at every --at, beside the queries of the scene.
void add_queries(Scene& scene, const RunOptions& options, const std::vector<Rational>& times) {
  for (std::size_t i = 0; i < scene.queries.size(); ++i) {
    const Rational& at = scene.queries[i].at;
    if (!scene.end || !(*scene.end < at)) continue;
    throw formats::InputError("--until", "",
                              "the scene's query " + std::to_string(i) + " is at " +
                                  time_text(at) + ", after the end of the run",
                              "write a time from " + time_text(at) + " on");
  }
  if (!options.query.empty() && times.empty()) {
    throw formats::InputError("--query", "", "there is no time at which it is asked",
                              "give --at, too");
  }
  std::vector<std::vector<std::array<Rational, 2>>> boxes;
  for (const std::string& text : options.query) {
    boxes.push_back(formats::read_box_option(text, scene));
  }
  const bool has_own = !scene.queries.empty();
  for (const Rational& t : times) {
    for (const auto& box : boxes) scene.queries.push_back({t, box});
  }
  formats::check_answered(scene, has_own ? options.scene : "--query", has_own ? "/queries/0" : "");
}

// "-" for a link to standard output.
void name_standard_output(std::string& path) {
  if (!path.empty() && formats::is_standard_output(path)) path = "-";
}

// Two results in one file would overwrite each other; a device (/dev/null) takes both.
void check_outputs(const RunOptions& options) {
  if (options.events == "-" && (options.json || options.summary == "-")) {
    throw formats::InputError(options.json ? "--json" : "--summary", "",
                              "standard output has the event log",
                              "give one of the two the name of a file");
  }
  keep_input("--events", options.events, options.scene);
  keep_input("--summary", options.summary, options.scene);
  keep_apart("--summary", options.summary, options.events, "the file of --events");
}

// A killed run has left its lines under another name.
void tell_leftovers(const formats::OutputFile& file, const Voice& voice) {
  for (const std::string& name : file.leftovers()) {
    voice.note(
        name +
        " is of a run that was cut off (or that goes on): its whole lines can be read; remove it "
        "when you need it no more");
  }
}

// Runs, and keeps the lines of the log written so far if that fails.
formats::RunOutcome run_keeping(Simulator& simulator, const std::vector<Rational>& times,
                                std::optional<formats::OutputFile>& events, const Voice& voice) {
  try {
    return lab::run_scene(simulator, times);
  } catch (const formats::InputError&) {
    throw;  // from the file itself, which reports what it kept
  } catch (const RefusedChange&) {
    throw;  // the log up to it will be written
  } catch (...) {
    const std::string kept = events ? events->keep_lines() : "";
    if (!kept.empty()) {
      voice.note(kept + " has the lines of the log up to the failure");
    }
    throw;
  }
}

// Why a run was stopped, where its finished part is, and what to do.
std::string stopping_text(const RunOptions& options, const formats::RunOutcome& outcome,
                          const Simulator& simulator) {
  std::string why = "interrupted", remedy = "run it again";
  if (simulator.out_of_memory()) {
    why = "there is not enough memory";
    remedy = "make the scene smaller, or set an earlier end with --until";
  } else if (outcome.status == RunStatus::kLimit) {
    std::string limits = options.max_events > 0 ? "--max-events" : "";
    if (options.max_seconds > 0) limits += limits.empty() ? "--max-seconds" : " or --max-seconds";
    why = "the limit of " + limits + " is reached";
    remedy = "raise it, or set an earlier end with --until";
  }
  std::string files;
  for (const std::string& file : {options.events, options.summary}) {
    if (!file.empty() && file != "-") files += (files.empty() ? "" : " and ") + file;
  }
  const std::string kept =
      files.empty() ? (options.events == "-" || options.summary == "-" || options.json
                           ? "what was finished is printed"
                           : "no file was asked for (--events FILE keeps what is finished)")
                    : "what was finished is in " + files;
  return "the run was stopped: " + why + "; " + kept + "; " + remedy;
}

// What is said about the log needs a log.
void check_log_options(const RunOptions& options) {
  if (!options.events.empty()) return;
  for (const auto& [name, given] :
       {std::pair("--instants", options.instants_given), {"--provenance", options.provenance}}) {
    if (!given) continue;
    throw formats::InputError(name, "", "no event log is written, and this is about the log alone",
                              "give --events FILE, too, or leave it out");
  }
}

void run(RunOptions options, const Voice& voice, int& exit_code) {
  constexpr const char* kRemedy = "write a number from 0 on, 0 for no limit";
  check_limit("--max-events", static_cast<double>(options.max_events), true, kRemedy);
  check_limit("--max-seconds", options.max_seconds, true, kRemedy);
  name_standard_output(options.events);
  name_standard_output(options.summary);
  check_outputs(options);
  SimulatorOptions simulator_options;
  simulator_options.audit = audit_level(options.audit);
  simulator_options.scheduling = scheduling(options.scheduling);
  const InstantDetail instants = instant_detail(options.instants);
  check_log_options(options);
  simulator_options.max_events = static_cast<std::uint64_t>(options.max_events);
  simulator_options.max_seconds = options.max_seconds;

  // While it reads, signals end the program: there is nothing to keep.
  const auto begin = std::chrono::steady_clock::now();
  Deadline reading(options.max_seconds, nullptr);
  std::optional<lab::GmpGuard> reading_guard(std::in_place, &reading);
  Scene scene = formats::read_scene(options.scene, &reading);
  const std::string hash = formats::scene_hash(scene);  // of the file, whatever the options change
  reading_guard.reset();
  if (options.max_seconds > 0) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    simulator_options.max_seconds = std::max(options.max_seconds - taken.count(), kNoSeconds);
  }
  if (!options.maintain.empty()) {
    formats::set_maintain(scene, options.maintain);
    lab::name_colours(scene);
  }
  if (scene.maintain.empty()) {
    throw formats::InputError(options.scene, "/maintain", "nothing is to be maintained",
                     "fill \"maintain\" in the scene, or give --maintain");
  }
  shorten(scene, options.until);
  const std::vector<Rational> times = sample_times(scene, options.at);
  add_queries(scene, options, times);
  if (options.explain) {
    const auto planned = lab::make_simulator(scene, options.arithmetic, simulator_options);
    print(formats::describe_model(scene, hash) + formats::explain_model(scene, *planned));
    return;
  }

  InterruptGuard interrupt;  // before a temporary file exists
  std::optional<formats::OutputFile> events_file, summary_file;
  if (!options.events.empty()) {
    events_file.emplace(options.events, options.force, formats::Unfinished::kLinesKept);
    tell_leftovers(*events_file, voice);
  }
  const bool json = options.json || options.summary == "-";
  if (!options.summary.empty() && options.summary != "-") {
    summary_file.emplace(options.summary, options.force);
  }

  // The files are worth finishing even if the reader of the report has gone.
  std::optional<formats::InputError> unprinted;
  const auto print_or_keep = [&unprinted](const std::string& text) {
    try {
      if (!unprinted) print(text);
    } catch (const formats::InputError& error) {
      unprinted = error;
    }
  };
  // For people: on standard error where standard output has the log or the summary.
  const auto tell = [&](const std::string& text) {
    if (json || options.events == "-") {
      std::fputs(text.c_str(), stderr);
    } else {
      print_or_keep(text);
    }
  };
  const auto report = [&](const std::string& text) {
    if (!voice.quiet) tell(text);
  };
  formats::RunOutcome outcome;
  std::unique_ptr<Simulator> simulator;
  std::optional<formats::EventLog> log;
  std::optional<std::string> refused;
  const auto simulate = [&] {
    lab::Progress progress(!voice.quiet);
    simulator_options.interrupt = &interrupt.flag();
    simulator_options.progress = [&](const Simulator& running) {
      progress.show([&](double seconds) { return lab::progress_text(running, seconds); });
      return true;
    };
    simulator = lab::make_simulator(scene, options.arithmetic, simulator_options);
    if (!refused) {  // else it has been printed
      const std::string numbers = voice.verbose
                                      ? formats::explain_model(scene, *simulator)
                                      : "numbers   " + simulator->arithmetic().name() + "\n";
      report(formats::describe_model(scene, hash) + numbers);
    }
    if (events_file || summary_file || json) {
      log.emplace(*simulator, hash, events_file ? &*events_file : nullptr, instants,
                  options.provenance ? std::optional(lab::run_provenance()) : std::nullopt);
      if (!events_file) log->charge_to(simulator->clock());
      simulator->set_sink(&*log, events_file.has_value());
    }
    outcome = run_keeping(*simulator, times, events_file, voice);
  };
  try {
    simulate();
  } catch (const RefusedChange& change) {
    // The part up to it is made once more, and kept.
    refused = refused_scene(scene, options.scene, change).what();
    simulator_options.stop_before = change.time();
    log.reset();
    if (events_file) events_file->begin_again();
    simulate();
  } catch (const std::invalid_argument& error) {
    throw refused_scene(scene, options.scene, error);
  }
  if (log) log->finish(outcome.status);
  const std::string digest = log ? log->digest() : "";
  if (summary_file || json) {
    const std::string summary =
        formats::write_summary(*simulator, outcome, hash, digest, lab::run_provenance());
    if (summary_file) {
      summary_file->write(summary);
      summary_file->commit();
    }
    if (json) print_or_keep(summary);
  }
  report(formats::describe_results(*simulator, outcome));
  // A summary that is printed has them.
  if (voice.quiet && !json) tell(formats::describe_samples(*simulator, outcome));
  if (outcome.status != RunStatus::kDone) {
    voice.error(stopping_text(options, outcome, *simulator));
    exit_code = kExitGaveUp;
  }
  if (!outcome.clean(*simulator)) {
    for (const std::string& problem : formats::failures_of(*simulator, outcome)) {
      voice.error(formats::plain(problem));
    }
    exit_code = kExitFailed;
  }
  if (refused) {
    voice.error(formats::plain(*refused));
    exit_code = kExitBadInput;
  }
  if (unprinted) throw *unprinted;
}

}  // namespace

void add_run_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* verb = app.add_subcommand("run", "Simulates a scene");
  verb->add_option("SCENE", options->scene, "Scene file, - reads standard input")->required();
  add_maintain_option(*verb, options->maintain, "Structures in place of those of the scene");
  verb->add_option("--arithmetic", options->arithmetic,
                   "exact (default), sturm, double, gsl or mpfr:P");
  verb->add_option("--scheduling", options->scheduling,
                   "lazy (default: failure times are searched for within a window) or eager");
  verb->add_option("--until", options->until, "Stop at this time, as if the scene ended there");
  verb->add_option("--events", options->events, "Write the event log to this file, - prints it");
  CLI::Option* const instants =
      verb->add_option("--instants", options->instants,
                       "Detail of the log's instants: names (default: exact), intervals or none");
  verb->add_flag("--provenance", options->provenance,
                 "Name the build, the processor and this command in the log's header, too");
  verb->add_option("--summary", options->summary, "Write the summary to this file, - prints it");
  add_list_option(*verb, "--at", options->at,
                  "Sample the attributes right after these times, T, ..; those that others read, too, as LABEL.NAME");
  verb->add_option("--query", options->query,
                   "The points in this closed box, X1,X2,Y1,Y2, right after the times of --at; can be "
                   "given several times")
      ->allow_extra_args(false);
  verb->add_option("--audit", options->audit, "end (default), events (after every one) or none");
  verb->add_flag("--json", options->json, "Print the summary, as --summary - does");
  CLI::Option* const explain = verb->add_flag(
      "--explain", options->explain,
      "Print the model chosen for the scene (degrees, number types, shared structures, "
      "parts left out), and run nothing");
  for (const char* name : {"--events", "--summary", "--json"}) {
    explain->excludes(verb->get_option(name));
  }
  verb->add_option("--max-events", options->max_events,
                   "Give up after this number of certificate failures (0, no limit)");
  verb->add_option("--max-seconds", options->max_seconds,
                   "Give up after this time, reading included (0, no limit)");
  verb->add_flag("--force", options->force, "Replace output files that exist");
  add_voice(*verb,
            "Print no report, only errors and the output of --at, --query, --json and --events -",
            "Print the model in detail, as --explain does, before the run");
  verb->footer("Structures (kinex list structures, kinex explain NAME):\n" +
               lab::structure_names_by_family() +
               "Columns of the report, of each structure, those included that others read:\n"
               "  events      external (they change what is maintained) and internal ones\n"
               "  failures    certificates that failed\n"
               "  rebuilds    times that its whole proof was made anew; lines \"rebuilt\" say why\n"
               "  groups      instants at which several of its certificates failed\n"
               "  max live    certificates at one time; max/object: of one object\n"
               "  violations  found by audits\n"
               "Where the log or the summary is printed, the report is on standard error.\n"
               "Example:\n  kinex run square.json --arithmetic exact --events square.log --at 1/3\n"
               "  kinex run square.json --explain");
  verb->callback([options, verb, instants, &exit_code] {
    options->instants_given = instants->count() > 0;
    run(*options, voice_of(*verb), exit_code);
  });
}

}  // namespace kinex::verbs

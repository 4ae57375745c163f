// SPDX-License-Identifier: GPL-3.0-or-later
// kinex view: a run as one page that can be played, stepped through and compared with another.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/log_reader.h"
#include "experiments/formats/model_text.h"
#include "experiments/formats/plain_text.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/colours.h"
#include "experiments/lab/progress.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/refused_scene.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"
#include "experiments/view/log_follower.h"
#include "experiments/view/page.h"
#include "experiments/view/page_data.h"
#include "experiments/view/recorder.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

constexpr std::size_t kMostObjects = 20000;
constexpr long long kMostEvents = 200000;

struct ViewOptions {
  std::string file, scene, with, output, arithmetic, from, until;
  std::vector<std::string> maintain;
  long long max_events = kMostEvents;
  bool force = false;
};

// A run to show: in an arithmetic, following a log if there is one.
struct Wanted {
  std::string arithmetic;
  std::string file, log;  // empty: no log
};

struct Viewed {
  Scene scene;
  std::string hash;  // of the scene's file
  std::vector<Wanted> runs;
  std::optional<Rational> from;
};

bool names_arithmetic(const std::string& text) {
  return text == "exact" || text == "sturm" || text == "double" || text == "gsl" ||
         text.substr(0, 5) == "mpfr:";
}

Rational time_option(const char* option, const std::string& text, const Scene& scene) {
  const Rational t = rational_option(option, text);
  if (t < scene.start || (scene.end && t > *scene.end)) {
    throw formats::InputError(option, "", show_text(text) + " is outside of the scene's time",
                              "write a time from " + time_text(scene.start) +
                                  (scene.end ? " to " + time_text(*scene.end) : " on"));
  }
  return t;
}

void set_times(Viewed& viewed, const ViewOptions& options) {
  Scene& scene = viewed.scene;
  if (!options.from.empty()) viewed.from = time_option("--from", options.from, scene);
  if (!options.until.empty()) scene.end = time_option("--until", options.until, scene);
  const Rational& from = viewed.from ? *viewed.from : scene.start;
  if (scene.end && *scene.end <= from) {
    throw formats::InputError(options.until.empty() ? "--from" : "--until", "",
                     "nothing is left to be shown", "the end must come after the start");
  }
}

Wanted wanted_log(std::string text, const std::string& file) {
  Wanted wanted;
  wanted.arithmetic = formats::LogReader(text, file).header().arithmetic;
  wanted.file = file;
  wanted.log = std::move(text);
  return wanted;
}

Wanted wanted_with(const std::string& with) {
  if (names_arithmetic(with)) return {with, "", ""};
  std::error_code error;
  if (with != "-" && !std::filesystem::exists(with, error)) {
    throw formats::InputError("--with", "", show_text(with) + " is neither an arithmetic nor a file",
                     "write exact, sturm, double, gsl, mpfr:P with P bits, or the name of an event "
                     "log of the scene");
  }
  return wanted_log(formats::read_text_file(with), with);
}

// The structures of --maintain; else those of the first log; else those of the scene.
void set_structures(Viewed& viewed, const ViewOptions& options, const std::string& scene_file) {
  const auto first = std::find_if(viewed.runs.begin(), viewed.runs.end(),
                                  [](const Wanted& wanted) { return !wanted.file.empty(); });
  std::optional<formats::LogHeader> log;
  if (first != viewed.runs.end()) {
    log = formats::LogReader(first->log, first->file).header();
    formats::require_same_scene(*log, first->file, viewed.hash);
  }
  if (!options.maintain.empty()) {
    formats::set_maintain(viewed.scene, options.maintain);
    lab::name_colours(viewed.scene);
    if (log && !formats::maintains_as_logged(viewed.scene, *log)) {
      throw formats::InputError("--maintain", "",
                                first->file + " is a log of " + formats::structures_of(*log),
                                "leave --maintain out, or give it as the run had it");
    }
  } else if (log) {
    formats::maintain_as_logged(viewed.scene, *log, first->file);
  }
  if (viewed.scene.maintain.empty()) {
    throw formats::InputError(scene_file, "/maintain", "nothing is to be maintained",
                     "fill \"maintain\" in the scene, or give --maintain");
  }
}

Viewed read_input(const ViewOptions& options) {
  Viewed viewed;
  std::string text = formats::read_text_file(options.file);
  const bool log = formats::looks_like_log(text);
  std::string scene_file = options.file;
  if (log) {
    if (options.scene.empty()) {
      throw formats::InputError(options.file, "", "an event log names its scene but does not hold it",
                       "give the scene too: --scene SCENE.json");
    }
    if (!options.arithmetic.empty()) {
      throw formats::InputError("--arithmetic", "", "a log names the arithmetic of its run",
                       "leave it out, or give the scene alone");
    }
    scene_file = options.scene;
    viewed.runs.push_back(wanted_log(std::move(text), options.file));
    text = formats::read_text_file(options.scene);
  } else {
    if (!options.scene.empty()) {
      throw formats::InputError("--scene", "", show_text(options.file) + " is a scene itself",
                       "leave it out, or give an event log first");
    }
    viewed.runs.push_back({options.arithmetic.empty() ? "exact" : options.arithmetic, "", ""});
  }
  viewed.scene = formats::parse_scene(text, scene_file);
  viewed.hash = formats::scene_hash(viewed.scene);
  if (!options.with.empty()) viewed.runs.push_back(wanted_with(options.with));
  set_structures(viewed, options, scene_file);
  set_times(viewed, options);
  return viewed;
}

void check(const ViewOptions& options) {
  if (options.max_events < 1) {
    throw formats::InputError("--max-events", "", "a page of no events", "write a number from 1 on");
  }
  check_standard_input(
      {{"FILE", options.file}, {"--scene", options.scene}, {"--with", options.with}});
  for (const std::string& input : {options.file, options.scene}) {
    if (!input.empty()) keep_input("--output", options.output, input);
  }
  if (!options.with.empty() && !names_arithmetic(options.with)) {
    keep_input("--output", options.output, options.with);
  }
}

// The disagreement of a log with its scene; empty if there is none. `note`: that the log is not whole.
std::string record(const Viewed& viewed, const Wanted& wanted, const ViewOptions& options,
                   const InterruptGuard& interrupt, const Voice& voice, view::RecordedRun& run,
                   std::string& note) {
  view::RecordOptions how;
  how.arithmetic = wanted.arithmetic;
  how.from = viewed.from;
  how.max_events = static_cast<std::uint64_t>(options.max_events);
  std::optional<view::LogFollower> follower;
  if (!wanted.file.empty()) {
    follower.emplace(wanted.log, wanted.file, viewed.scene, viewed.hash);
    how.observe = [&](const view::SeenEvent& event) { return follower->follow(event); };
  }
  lab::Progress progress(!voice.quiet);
  how.interrupt = &interrupt.flag();
  how.progress = [&](const Simulator& running) {
    progress.show([&](double seconds) { return lab::progress_text(running, seconds); });
    return true;
  };
  try {
    run = view::record_run(viewed.scene, how);
  } catch (const formats::InputError& error) {
    const bool second = &wanted != &viewed.runs.front();
    if (!second || error.file() != "--arithmetic") throw;
    throw formats::InputError("--with", error.place(), error.problem(), error.remedy());
  } catch (const std::invalid_argument& error) {
    throw refused_scene(viewed.scene, options.scene.empty() ? options.file : options.scene, error);
  }
  if (!follower) return "";
  if (run.complete) follower->finish();
  if (const auto ending = follower->ending()) note = formats::ending_note(*ending, wanted.file);
  return follower->problem();
}

std::string line_of(const view::RecordedRun& run) {
  std::string text = "run       " + run.arithmetic + ", " +
                     formats::counted(run.events.size(), "log record", "log records");
  if (run.before > 0) text += " after " + std::to_string(run.before) + " before them";
  if (!run.complete) text += " (not all: " + run.stopped + ")";
  for (const view::RecordedStructure& structure : run.structures) {
    if (structure.corrupt_after) {
      text += "\n          " + formats::plain(structure.label) + " became corrupt: " + structure.corruption;
    }
  }
  return text + "\n";
}

std::string report(const Viewed& viewed, const std::vector<view::RecordedRun>& runs,
                   const std::string& file, std::size_t bytes) {
  std::string text = "scene     " + formats::shown_name(viewed.scene) + ", " +
                     formats::counted(viewed.scene.objects.size(), "object", "objects") + "\n";
  for (const view::RecordedRun& run : runs) text += line_of(run);
  if (runs.size() > 1) {
    const std::uint64_t parted = view::first_divergence(runs[0], runs[1]);
    const bool whole = runs[0].complete && runs[1].complete;
    text += "compared  " +
            (parted != 0 ? "the runs part at log record " + std::to_string(parted)
             : whole     ? "the same log records"
                         : "the same log records, as far as both go") +
            "\n";
  }
  return text + "page      " + file + ", " + std::to_string((bytes + 1023) / 1024) + " kB\n";
}

void view(const ViewOptions& options, const Voice& voice, int& exit_code) {
  check(options);
  const Viewed viewed = read_input(options);
  if (viewed.scene.objects.size() > kMostObjects) {
    voice.error("gave up: " + formats::counted(viewed.scene.objects.size(), "object", "objects") +
                ", and a page draws " + std::to_string(kMostObjects) + " at most");
    exit_code = kExitGaveUp;
    return;
  }
  InterruptGuard interrupt;  // before a temporary file exists
  std::optional<formats::OutputFile> output;
  if (!formats::is_standard_output(options.output)) output.emplace(options.output, options.force);
  std::vector<view::RecordedRun> runs;
  for (const Wanted& wanted : viewed.runs) {
    std::string note;
    const std::string problem =
        record(viewed, wanted, options, interrupt, voice, runs.emplace_back(), note);
    if (!note.empty()) voice.note(note);
    voice.detail(runs.back().arithmetic + ": " +
                 formats::counted(runs.back().events.size(), "log record", "log records") + ", " +
                 formats::counted(runs.back().claims.size(), "certificate", "certificates") +
                 ", digest " + runs.back().digest);
    if (!problem.empty()) {
      voice.error(formats::plain(problem) + "; no page was written");
      exit_code = kExitFailed;
      return;
    }
  }
  const std::string page = view::view_page("kinex view: " + formats::shown_name(viewed.scene),
                                           view::page_data(viewed.scene, viewed.hash, runs));
  if (!output) {
    print(page);
  } else {
    output->write(page);
    output->commit();
    voice.report(report(viewed, runs, output->path(), page.size()));
  }
  for (const view::RecordedRun& run : runs) {
    if (run.complete || run.stopped == view::kLogEnds) continue;
    voice.error("the page holds the first " +
                formats::counted(run.events.size(), "log record", "log records") + " of the " +
                run.arithmetic + " run: " + run.stopped +
                "; choose others with --from and --until, or more with --max-events");
    exit_code = kExitGaveUp;
  }
}

}  // namespace

void add_view_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* verb = app.add_subcommand(
      "view", "A run as one HTML page: play it, step through its log, compare it with another");
  verb->add_option("FILE", options->file, "A scene, or an event log of one (with --scene)")
      ->required();
  verb->add_option("-o,--output", options->output, "Write the page to this file, - prints it")
      ->required();
  verb->add_option("--scene", options->scene, "The scene of the log");
  verb->add_option("--with", options->with,
                   "A second run to overlay: an event log, or an arithmetic");
  verb->add_option("--arithmetic", options->arithmetic,
                   "exact (default), sturm, double, gsl or mpfr:P");
  add_maintain_option(*verb, options->maintain,
                      "Structures in place of those of the log or the scene");
  verb->add_option("--from", options->from, "Show the run from this time on");
  verb->add_option("--until", options->until, "Stop at this time, as if the scene ended there");
  verb->add_option("--max-events", options->max_events,
                   "The most log records of each run (200000)");
  verb->add_flag("--force", options->force, "Replace a page that exists");
  add_voice(*verb, "Print no report", "Count what is recorded, with its digest, on standard error");
  verb->footer(
      "The scene is run again, and its states are recorded; a log is checked against\n"
      "that run. The page needs no network. page.html#event=7 opens it after record 7\n"
      "of the log. Pictures and animations of it: experiments/view/animate.py,\n"
      "installed as share/kinex/view/animate.py.\n"
      "Exit codes: 1 a log is not what its scene gives; 3 there are more log records\n"
      "than the page holds, or more objects than it draws.\n"
      "Example:\n"
      "  kinex view square.json -o square.html\n"
      "  kinex view square.exact.jsonl --scene square.json \\\n"
      "    --with square.gsl.jsonl -o parted.html\n"
      "  kinex view square.json --with double --from 1/3 --until 1/2 -o middle.html");
  verb->callback([options, verb, &exit_code] { view(*options, voice_of(*verb), exit_code); });
}

}  // namespace kinex::verbs

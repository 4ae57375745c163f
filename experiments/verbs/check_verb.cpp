// SPDX-License-Identifier: GPL-3.0-or-later
// kinex check: validates a scene, or re-verifies an event log.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/log_check.h"
#include "experiments/formats/log_ending.h"
#include "experiments/formats/model_text.h"
#include "experiments/formats/plain_text.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/scene_run.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct CheckOptions {
  std::string file, scene;
  bool json = false;
};

std::vector<std::uint64_t> levels_of(const formats::LogVerdict& verdict) {
  std::vector<std::uint64_t> levels{0};
  if (verdict.instants_checked()) levels.push_back(1);
  if (verdict.certificates_checked()) levels.push_back(2);
  return levels;
}

// "not checked: level 1 (instants) and level 2 (24 certificates), since ..", a line; empty: all was checked.
std::string unchecked_text(const formats::LogVerdict& verdict) {
  const std::string certificates =
      formats::counted(verdict.unchecked.count(), "certificate", "certificates");
  if (verdict.header.has_names()) {
    if (verdict.unchecked.count() == 0) return "";
    return (verdict.certificates_checked() ? "" : "level 2 was ") + verdict.unchecked.text() + "\n";
  }
  std::string levels = verdict.instants_checked() ? "" : "level 1 (instants)";
  if (verdict.with_scene) {
    levels += (levels.empty() ? "level 2 (" : " and level 2 (") + certificates + ")";
  }
  if (levels.empty()) return "";
  return "not checked: " + levels + ", since " +
         (!verdict.header.exact ? "the arithmetic " + verdict.header.arithmetic + " is not exact"
          : verdict.instants_checked() ? "the log does not name its instants"
                                       : "the log has no instants") +
         "\n";
}

// `no_scene`: why there is none; empty if there is one.
std::string levels_text(const formats::LogVerdict& verdict, const std::string& no_scene) {
  std::string text;
  for (const std::uint64_t level : levels_of(verdict)) {
    text += (text.empty() ? "" : ", ") + std::to_string(level);
  }
  text = (text.size() == 1 ? "level " : "levels ") + text + ": format, names, counts, digest, seal";
  if (verdict.header.has_names()) {
    text += "; every instant's root, the order of instants";
  } else if (verdict.header.has_intervals()) {
    text += "; the order of instants as far as their intervals decide";
  }
  if (verdict.with_scene) text += "; the scene";
  if (verdict.certificates_checked()) {
    text += ", and the polynomials of " +
            formats::counted(verdict.certificates, "certificate", "certificates");
  }
  text += "\n";
  const auto add_line = [&text](const std::string& line) {
    if (!line.empty()) text += "          " + line;
  };
  add_line(unchecked_text(verdict));
  const bool exact = verdict.header.has_names();
  std::string more;
  if (!verdict.with_scene) {
    more = no_scene + (no_scene.empty() ? "" : "; ") + "--scene SCENE " +
           (exact ? "checks the certificates too" : "checks that it is the scene of the log");
  }
  if (exact) more += std::string(more.empty() ? "" : "; ") + "kinex-logcheck replays the events";
  if (!more.empty()) add_line(more + "\n");
  return text;
}

std::string log_text(const formats::LogVerdict& verdict, const std::string& no_scene) {
  std::string text = "log       " + formats::plain(verdict.header.scene) + ", " + verdict.header.arithmetic + ", " +
                     formats::plain(verdict.header.build) + "\n";
  text += "scene     " + verdict.header.scene_hash + "\n";
  text += "records   " + formats::counted(verdict.records, "log record", "log records") + ", " +
          verdict.external_by_use.text();
  if (verdict.header.has_names()) {
    text += ", at " + formats::counted(verdict.instants, "instant", "instants");
  }
  text += "\ndigest    " + verdict.digest + "\n";
  text += "run       " + (verdict.status.empty() ? "cut off" : verdict.status) + "\n";
  for (const std::string& line : formats::corruption_texts(verdict.corrupt)) {
    text += "          " + line + "\n";
  }
  if (verdict.problems.empty()) text += "verified  " + levels_text(verdict, formats::plain(no_scene));
  return text;
}

std::string log_json(const formats::LogVerdict& verdict) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("kind").string("log").key("valid").boolean(verdict.problems.empty());
  json.key("scene").string(verdict.header.scene).key("hash").string(verdict.header.scene_hash);
  json.key("arithmetic").string(verdict.header.arithmetic);
  json.key("records").number(verdict.records).key("external").number(verdict.external);
  json.key("instants");
  if (verdict.header.has_names()) {
    json.number(verdict.instants);
  } else {
    json.null();
  }
  json.key("levels").begin_array();
  for (const std::uint64_t level : levels_of(verdict)) json.number(level);
  json.end_array().key("certificates").number(verdict.certificates);
  json.key("unchecked").number(verdict.unchecked.count());
  json.key("digest").string(verdict.digest).key("status");
  json.string(verdict.status.empty() ? "cut off" : verdict.status);
  json.key("corrupt").begin_object();
  for (const formats::LogCorruption& one : verdict.corrupt) json.key(one.label).string(one.text);
  json.end_object().key("problems").begin_array();
  for (const std::string& problem : verdict.problems) json.string(problem);
  json.end_array().end_object();
  return text + "\n";
}

std::string scene_json(const Scene& scene) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("kind").string("scene").key("valid").boolean(true);
  json.key("scene").string(scene.name).key("hash").string(formats::scene_hash(scene));
  json.key("dimension").number(scene.dimension).key("degree").number(scene.degree());
  json.key("objects").number(static_cast<std::uint64_t>(scene.objects.size())).end_object();
  return text + "\n";
}

void report_log(const formats::LogVerdict& verdict, const std::string& no_scene,
                const CheckOptions& options, const Voice& voice, int& exit_code) {
  if (options.json) {
    print(log_json(verdict));
  } else {
    voice.report(log_text(verdict, no_scene));
  }
  for (const std::string& problem : verdict.problems) voice.error(formats::plain(options.file + ": " + problem));
  if (!verdict.problems.empty()) exit_code = kExitFailed;
}

// The file beside the log with the name of its scene.
std::string file_beside(const formats::LogHeader& header, const std::string& path) {
  return (std::filesystem::path(path).parent_path() / (header.scene + ".json")).string();
}

// The scene in that file, if it is that of the log; else `why` not.
std::optional<Scene> scene_beside(const formats::LogHeader& header, const std::string& path,
                                  std::string& why) {
  if (path == "-") {
    why = "standard input has no scene beside it";
    return std::nullopt;
  }
  if (header.scene.empty() || header.scene.find('/') != std::string::npos) {
    why = "the name of the scene, " + show_text(header.scene) + ", is none of a file";
    return std::nullopt;
  }
  const std::string file = file_beside(header, path);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    why = "there is no " + file;
    return std::nullopt;
  }
  try {
    Scene scene = formats::read_scene(file);
    if (formats::scene_hash(scene) == header.scene_hash) return scene;
    why = file + " is another scene: it has another hash";
  } catch (const formats::InputError& problem) {
    why = problem.what();
  }
  return std::nullopt;
}

// The model of its run, as kinex run --explain prints it.
void tell_model(const Scene& scene, const Voice& voice) {
  if (!voice.verbose) return;
  if (scene.maintain.empty()) {
    voice.detail("nothing is to be maintained");
    return;
  }
  const auto planned = lab::make_simulator(scene, "exact", {});
  const std::string text = formats::explain_model(scene, *planned);
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    voice.detail(text.substr(at, text.find('\n', at) - at));
}

void check(const CheckOptions& options, const Voice& voice, int& exit_code) {
  check_standard_input({{"FILE", options.file}, {"--scene", options.scene}});
  const std::string text = formats::read_text_file(options.file);
  if (formats::looks_like_log(text)) {
    std::optional<Scene> scene;
    std::string no_scene;
    if (options.scene.empty()) {
      const formats::LogHeader header = formats::LogReader(text, options.file).header();
      scene = scene_beside(header, options.file, no_scene);
      voice.detail(scene ? "with the scene " + formats::plain(file_beside(header, options.file))
                         : "without the scene: " + formats::plain(no_scene));
    } else {
      scene = formats::read_scene(options.scene);
    }
    const formats::LogVerdict verdict =
        scene ? formats::check_log(text, options.file, &*scene, formats::scene_hash(*scene))
              : formats::check_log(text, options.file);
    report_log(verdict, no_scene, options, voice, exit_code);
    return;
  }
  if (!options.scene.empty()) {
    throw formats::InputError("--scene", "", show_text(options.file) + " is no event log",
                     "leave it out, or give an event log first");
  }
  const Scene scene = formats::parse_scene(text, options.file);
  if (options.json) {
    print(scene_json(scene));
  } else {
    voice.report(formats::describe_model(scene, formats::scene_hash(scene)) + "valid\n");
  }
  tell_model(scene, voice);
}

}  // namespace

void add_check_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* verb = app.add_subcommand("check", "Validates a scene, or verifies an event log again");
  verb->add_option("FILE", options->file, "A scene or an event log, - reads standard input")
      ->required();
  verb->add_option(
      "--scene", options->scene,
      "The scene of the log (default: next to the log, NAME.json for a scene with the name "
      "NAME, if its hash agrees)");
  verb->add_flag("--json", options->json, "Print one JSON object instead");
  add_voice(*verb, "Print nothing but errors: the exit code tells whether all is well",
            "Of a scene: the model of its run; of a log: which scene it was checked with; on standard "
            "error");
  verb->footer(
      "Of a log it checks every member, the digest and the seal (level 0) and, by\n"
      "Sturm's theorem, that every interval holds the root that it claims and that\n"
      "times never decrease (level 1); with the scene also that each certificate's\n"
      "polynomial, made anew, vanishes at its instant and is negative right after it\n"
      "(level 2, points). Of a log of an inexact arithmetic it checks level 0, and the\n"
      "scene, alone. It says what it did not check. kinex-logcheck replays the events.\n"
      "Example:\n"
      "  kinex check square.log --scene square.json");
  verb->callback([options, verb, &exit_code] { check(*options, voice_of(*verb), exit_code); });
}

}  // namespace kinex::verbs

// SPDX-License-Identifier: GPL-3.0-or-later
// kinex check: validates a scene, or re-verifies an event log.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "experiments/file_io.h"
#include "experiments/json_writer.h"
#include "experiments/log_check.h"
#include "experiments/model_text.h"
#include "experiments/scene_reader.h"
#include "experiments/scene_writer.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"

namespace kinex {

namespace {

std::string log_text(const LogVerdict& verdict) {
  std::string text = "log       " + verdict.header.scene + ", " + verdict.header.arithmetic + ", " +
                     verdict.header.build + "\n";
  text += "scene     " + verdict.header.scene_hash + "\n";
  text += "events    " + std::to_string(verdict.events) + ", " + std::to_string(verdict.external) +
          " external";
  if (verdict.header.exact) text += ", at " + std::to_string(verdict.instants) + " instants";
  text += "\ndigest    " + verdict.digest + "\n";
  text += "run       " + (verdict.status.empty() ? "cut off" : verdict.status) + "\n";
  if (verdict.problems.empty()) {
    text += verdict.header.exact ? "verified  names, order, every root and the order of time\n"
                                 : "verified  names and order (inexact: times are not checked)\n";
  }
  return text;
}

std::string log_json(const LogVerdict& verdict) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("kind").string("log").key("valid").boolean(verdict.problems.empty());
  json.key("scene").string(verdict.header.scene).key("hash").string(verdict.header.scene_hash);
  json.key("arithmetic").string(verdict.header.arithmetic);
  json.key("events").number(verdict.events).key("external").number(verdict.external);
  json.key("instants");
  if (verdict.header.exact) {
    json.number(verdict.instants);
  } else {
    json.null();
  }
  json.key("digest").string(verdict.digest).key("status");
  json.string(verdict.status.empty() ? "cut off" : verdict.status);
  json.key("problems").begin_array();
  for (const std::string& problem : verdict.problems) json.string(problem);
  json.end_array().end_object();
  return text + "\n";
}

std::string scene_json(const Scene& scene) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("kind").string("scene").key("valid").boolean(true);
  json.key("scene").string(scene.name).key("hash").string(scene_hash(scene));
  json.key("dimension").number(scene.dimension).key("degree").number(scene.degree());
  json.key("objects").number(static_cast<std::uint64_t>(scene.objects.size())).end_object();
  return text + "\n";
}

void report_log(const LogVerdict& verdict, const std::string& path, bool json, int& exit_code) {
  print(json ? log_json(verdict) : log_text(verdict));
  for (const std::string& problem : verdict.problems) {
    std::fprintf(stderr, "kinex: %s: %s\n", path.c_str(), problem.c_str());
  }
  if (!verdict.problems.empty()) exit_code = kExitFailed;
}

void check(const std::string& path, bool json, int& exit_code) {
  const std::string text = read_text_file(path);
  if (looks_like_log(text)) {
    report_log(check_log(text, path), path, json, exit_code);
    return;
  }
  const Scene scene = parse_scene(text, path);
  print(json ? scene_json(scene) : describe_model(scene, scene_hash(scene)) + "valid\n");
}

}  // namespace

void add_check_verb(CLI::App& app, int& exit_code) {
  auto path = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("check", "Validates a scene, or re-verifies an event log");
  verb->add_option("FILE", *path, "A scene or an event log, - reads standard input")->required();
  auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "Print one JSON object instead");
  verb->footer(
      "Of a log it checks sequence, names, digest and, by Sturm's theorem, that every interval\n"
      "holds the root that it claims and that times never decrease.\n"
      "Example:\n  kinex check square.log");
  verb->callback([path, json, &exit_code] { check(*path, *json, exit_code); });
}

}  // namespace kinex

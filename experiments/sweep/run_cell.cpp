// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/run_cell.h"

#include "core/numbers/time_text.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/sha256.h"

namespace kinex::sweep {

namespace {

// Members in the order of their names, as in canonical_json.
class MemberWriter {
 public:
  void raw(const char* name, const std::string& json) {
    text_ += text_.empty() ? '{' : ',';
    formats::append_json_string(text_, name);
    text_ += ':' + json;
  }
  void string(const char* name, const std::string& value) {
    std::string quoted;
    formats::append_json_string(quoted, value);
    raw(name, quoted);
  }
  void number(const char* name, std::uint64_t value) { raw(name, std::to_string(value)); }
  void number(const char* name, int value) { raw(name, std::to_string(value)); }
  std::string text() const { return text_ + "}"; }

 private:
  std::string text_;
};

// Time over that of `exact`, roughly.
std::uint64_t arithmetic_factor(const std::string& name) {
  if (name == "sturm") return 100;
  if (name.rfind("mpfr", 0) == 0) return 10;
  return name == "gsl" ? 2 : 1;
}

// Polygons of extreme sizes may degenerate in the doubles with which some families place vertices.
void check_bodies(const Scene& scene) {
  formats::parse_scene(formats::write_scene(scene), scene.name);
}

}  // namespace

std::string cell_text(const RunCell& cell) {
  const lab::Workload& workload = *lab::find_workload(cell.workload);
  const lab::WorkloadParameters& parameters = cell.parameters;
  MemberWriter json;
  json.string("arithmetic", cell.arithmetic);
  if (cell.audit != "end") json.string("audit", cell.audit);
  if (workload.takes_degree) json.number("degree", parameters.degree);
  json.number("dimension", parameters.dimension);
  if (workload.takes_m) json.number("m", parameters.m);
  if (cell.max_events != 0) json.number("max_events", cell.max_events);
  json.number("n", parameters.n);
  if (cell.scheduling != "lazy") json.string("scheduling", cell.scheduling);
  if (workload.random) json.number("seed", parameters.seed);
  if (parameters.separation) json.string("separation", parameters.separation->to_string());
  // An array would be an axis.
  const bool several = cell.structure.front() == '[';
  json.raw("structure", several ? "[" + cell.structure + "]" : cell.structure);
  if (workload.takes_turns) json.number("turns", parameters.turns);
  if (cell.until) json.string("until", cell.until->to_string());
  json.string("workload", cell.workload);
  return json.text();
}

std::string cell_key(const RunCell& cell) { return formats::sha256_hex(cell_text(cell)); }

std::uint64_t expected_cost(const RunCell& cell) {
  // At most 10^14 * 20 * 100.
  const auto n = static_cast<std::uint64_t>(cell.parameters.n);
  const auto degree = static_cast<std::uint64_t>(cell.parameters.degree);
  return n * n * degree * arithmetic_factor(cell.arithmetic);
}

Scheduling scheduling_of(const RunCell& cell) {
  return cell.scheduling == "eager" ? Scheduling::kEager : Scheduling::kLazy;
}

AuditLevel audit_of(const RunCell& cell) {
  if (cell.audit == "none") return AuditLevel::kNone;
  return cell.audit == "events" ? AuditLevel::kEvents : AuditLevel::kEnd;
}

Scene scene_of(const RunCell& cell) {
  Scene scene = lab::generate_scene(*lab::find_workload(cell.workload), cell.parameters);
  formats::set_maintain(scene, cell.maintain);
  if (scene.has_bodies()) check_bodies(scene);
  return scene;
}

void shorten(Scene& scene, const RunCell& cell) {
  if (!cell.until) return;
  if (*cell.until <= scene.start || (scene.end && *cell.until > *scene.end)) {
    throw formats::InputError(cell.workload, "--until",
                              time_text(*cell.until) + " is outside of the scene's time",
                              "write a time after " + time_text(scene.start) +
                                  (scene.end ? ", at most " + time_text(*scene.end) : ""));
  }
  scene.end = cell.until;
}

}  // namespace kinex::sweep

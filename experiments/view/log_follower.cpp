// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/log_follower.h"

#include <algorithm>
#include <vector>

#include "experiments/input_error.h"
#include "experiments/json_writer.h"
#include "experiments/scene_reader.h"
#include "experiments/scene_writer.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex {

namespace {

// The structures of a scene's run, as a log lists them.
std::vector<LogStructure> planned_structures(const Scene& scene) {
  std::vector<LogStructure> planned;
  for (const PlannedStructure& one : plan_structures(scene)) {
    LogStructure& structure = planned.emplace_back();
    structure.label = one.request.label;
    structure.structure = one.request.structure;
    if (find_structure_info(one.request.structure)->uses_key) {
      structure.key = key_json(one.request.key, scene);
    }
  }
  return planned;
}

std::string names(const std::vector<LogStructure>& structures) {
  std::string text;
  for (const LogStructure& structure : structures) {
    text += (text.empty() ? "" : ", ") + structure.label;
  }
  return text;
}

// An entry of --maintain.
std::string entry_for(const LogStructure& logged) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("structure").string(logged.structure);
  if (!logged.key.empty()) json.key("key").raw(logged.key);
  json.key("as").string(logged.label).end_object();
  return text;
}

// As far as the log's detail allows.
bool same_instant(const LogInstant& a, const InstantText& b, const LogHeader& header) {
  if (!header.has_times()) return true;
  if (!b.exact) return a.decimal == b.approximate;
  if (!header.has_names()) {
    return !(a.upper < *Rational::parse(b.lower) || *Rational::parse(b.upper) < a.lower);
  }
  if (a.root != b.root || a.polynomial.coefficients().size() != b.polynomial.size()) return false;
  for (std::size_t i = 0; i < b.polynomial.size(); ++i) {
    if (a.polynomial[i].to_string() != b.polynomial[i]) return false;
  }
  return true;
}

}  // namespace

void require_same_scene(const LogHeader& header, const std::string& file, const std::string& hash) {
  if (header.scene_hash == hash) return;
  throw InputError(file, "line 1",
                   "it is a log of another scene (" + show_text(header.scene) + ", hash " +
                       header.scene_hash.substr(0, 12) + ")",
                   "give the scene that was run");
}

bool maintains_as_logged(const Scene& scene, const LogHeader& header) {
  const std::vector<LogStructure> planned = planned_structures(scene);
  return std::equal(planned.begin(), planned.end(), header.structures.begin(),
                    header.structures.end(), [](const LogStructure& a, const LogStructure& b) {
                      return a.label == b.label && a.structure == b.structure && a.key == b.key;
                    });
}

void maintain_as_logged(Scene& scene, const LogHeader& header, const std::string& file) {
  if (maintains_as_logged(scene, header)) return;
  std::vector<std::string> entries;
  for (const LogStructure& logged : header.structures) entries.push_back(entry_for(logged));
  try {
    set_maintain(scene, entries);
  } catch (const InputError& error) {
    throw InputError(file, "line 1", error.problem(), "give a log of this program");
  }
}

std::string structures_of(const LogHeader& header) { return names(header.structures); }

LogFollower::LogFollower(std::string_view text, const std::string& file, const Scene& scene,
                         const std::string& hash)
    : reader_(text, file) {
  require_same_scene(header(), file, hash);
  if (maintains_as_logged(scene, header())) return;
  throw InputError(file, "line 1",
                   "the log is of " + structures_of(header()) + ", the page of " +
                       names(planned_structures(scene)),
                   "lay runs with the same structures over each other");
}

bool LogFollower::follow(const SeenEvent& event) {
  if (!reader_.next(next_)) return false;
  const char* part = nullptr;
  if (next_.structure != event.structure) part = "structure";
  if (next_.kind != event.kind) part = "kind";
  if (next_.external != event.event.external) part = "effect";
  if (!std::equal(next_.ids.begin(), next_.ids.end(), event.ids.begin(), event.ids.end())) {
    part = "objects";
  }
  if (next_.change.has_value() != event.event.has_difference()) part = "difference";
  if (next_.change && (!std::equal(next_.change->gone.begin(), next_.change->gone.end(),
                                   event.gone.begin(), event.gone.end()) ||
                       !std::equal(next_.change->came.begin(), next_.change->came.end(),
                                   event.came.begin(), event.came.end()))) {
    part = "difference";
  }
  if (!same_instant(next_.time, event.instant, header())) part = "time";
  if (part == nullptr) return true;
  problem_ = reader_.file() + ": line " + std::to_string(next_.line) +
             ": the log and the run of its scene part at record " + std::to_string(event.number) +
             ": other " + part;
  return false;
}

void LogFollower::finish() {
  if (!problem_.empty() || !reader_.next(next_)) return;
  problem_ = reader_.file() + ": line " + std::to_string(next_.line) +
             ": the run of the scene has no such record";
}

}  // namespace kinex

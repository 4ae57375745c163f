// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/log_follower.h"

#include <algorithm>
#include <vector>

#include "experiments/input_error.h"
#include "structures/plan.h"

namespace kinex {

namespace {

std::string names(const std::vector<LogStructure>& structures) {
  std::string text;
  for (const LogStructure& structure : structures) {
    text += (text.empty() ? "" : ", ") + structure.label;
  }
  return text;
}

bool same_instant(const LogInstant& a, const InstantText& b) {
  if (!b.exact) return a.decimal == b.approximate;
  if (a.root != b.root || a.polynomial.coefficients().size() != b.polynomial.size()) return false;
  for (std::size_t i = 0; i < b.polynomial.size(); ++i) {
    if (a.polynomial[i].to_string() != b.polynomial[i]) return false;
  }
  return true;
}

}  // namespace

LogFollower::LogFollower(std::string_view text, const std::string& file, const Scene& scene,
                         const std::string& hash)
    : reader_(text, file) {
  if (header().scene_hash != hash) {
    throw InputError(file, "line 1",
                     "it is a log of another scene (" + show_text(header().scene) + ", hash " +
                         header().scene_hash.substr(0, 12) + ")",
                     "give the scene that was run");
  }
  std::vector<LogStructure> maintained;
  for (const PlannedStructure& planned : plan_structures(scene)) {
    maintained.push_back({planned.request.label, planned.request.structure, {}});
  }
  bool same = maintained.size() == header().structures.size();
  for (std::size_t i = 0; same && i < maintained.size(); ++i) {
    same = maintained[i].label == header().structures[i].label &&
           maintained[i].structure == header().structures[i].structure;
  }
  if (!same) {
    throw InputError(file, "line 1",
                     "the log is of " + names(header().structures) + ", the scene maintains " +
                         names(maintained),
                     "give --maintain as the run had it");
  }
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
  if (!same_instant(next_.time, event.instant)) part = "time";
  if (part == nullptr) return true;
  problem_ = reader_.file() + ": line " + std::to_string(next_.line) +
             ": the log and the run of its scene part at event " + std::to_string(event.number) +
             ": other " + part;
  return false;
}

void LogFollower::finish() {
  if (!problem_.empty() || !reader_.next(next_)) return;
  problem_ = reader_.file() + ": line " + std::to_string(next_.line) +
             ": the run of the scene has no such event";
}

}  // namespace kinex

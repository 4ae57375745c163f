// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/log_follower.h"

#include <algorithm>

#include "experiments/formats/input_error.h"

namespace kinex::view {

namespace {

// As far as the log's detail allows.
bool same_instant(const formats::LogInstant& a, const InstantName& b, const formats::LogHeader& header) {
  if (!header.has_times()) return true;
  if (!b.exact) return a.decimal == b.decimal;
  if (!header.has_names()) return !(a.upper < b.lower || b.upper < a.lower);
  return a.root == b.root && a.polynomial == b.polynomial;
}

}  // namespace

LogFollower::LogFollower(std::string_view text, const std::string& file, const Scene& scene,
                         const std::string& hash)
    : reader_(text, file) {
  formats::require_same_scene(header(), file, hash);
  if (formats::maintains_as_logged(scene, header())) return;
  throw formats::InputError(
      file, "line 1",
      "the log is of " + formats::structures_of(header()) + ", the page of " + formats::structures_of(scene),
      "lay runs with the same structures over each other");
}

bool LogFollower::next() {
  has_ended_ = has_ended_ || !reader_.next(next_);
  return !has_ended_;
}

bool LogFollower::follow(const SeenEvent& event) {
  if (!next()) return false;
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
  if (!problem_.empty() || !next()) return;
  problem_ = reader_.file() + ": line " + std::to_string(next_.line) +
             ": the run of the scene has no such record";
}

}  // namespace kinex::view

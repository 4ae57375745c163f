// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/recorded_run.h"

#include <algorithm>

namespace kinex::view {

namespace {

// Derived objects are the same if their names are: each run has its own numbers.
bool same_object(const RecordedRun& a, ObjectId x, const RecordedRun& b, ObjectId y) {
  if (x < a.objects || y < b.objects) return x == y;
  return a.things[x - a.objects].name == b.things[y - b.objects].name;
}

}  // namespace

std::optional<Attribute> attribute_after(const RecordedStructure& structure, std::uint64_t event) {
  if (structure.corrupt_after && event >= *structure.corrupt_after) return std::nullopt;
  Attribute attribute = structure.initial;
  for (const AttributeChange& change : structure.changes) {
    if (change.event > event) break;
    apply(change, attribute);
  }
  return attribute;
}

std::uint64_t first_divergence(const RecordedRun& a, const RecordedRun& b) {
  const auto same = [&](const Event& x, const Event& y) {
    bool all = x.structure == y.structure && x.kind == y.kind && x.count == y.count;
    for (std::size_t i = 0; all && i < x.count; ++i) all = same_object(a, x.ids[i], b, y.ids[i]);
    return all;
  };
  const auto [x, y] = std::mismatch(a.all.begin(), a.all.end(), b.all.begin(), b.all.end(), same);
  const bool a_ends = x == a.all.end(), b_ends = y == b.all.end();
  if (a_ends && b_ends) return 0;
  if ((a_ends && !a.complete) || (b_ends && !b.complete)) return 0;
  return static_cast<std::uint64_t>(x - a.all.begin()) + 1;
}

}  // namespace kinex::view

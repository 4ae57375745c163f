// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/recorded_run.h"

#include <algorithm>

namespace kinex {

namespace {

bool same(const Event& a, const Event& b) {
  return a.structure == b.structure && a.kind == b.kind && a.count == b.count && a.ids == b.ids;
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
  const auto [x, y] = std::mismatch(a.all.begin(), a.all.end(), b.all.begin(), b.all.end(), same);
  const bool a_ends = x == a.all.end(), b_ends = y == b.all.end();
  if (a_ends && b_ends) return 0;
  if ((a_ends && !a.complete) || (b_ends && !b.complete)) return 0;
  return static_cast<std::uint64_t>(x - a.all.begin()) + 1;
}

}  // namespace kinex

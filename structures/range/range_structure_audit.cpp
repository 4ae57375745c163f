// SPDX-License-Identifier: GPL-3.0-or-later
// RangeStructure: its audit: both orders and the answers to boxes between points, by exact
// positions.
#include <algorithm>
#include <string>
#include <vector>

#include "structures/range/range_structure.h"
#include "structures/range/static_range_audit.h"

namespace kinex {
namespace {

std::vector<ObjectId> alive_in(const Snapshot& snapshot) {
  std::vector<ObjectId> result;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) result.push_back(id);
  }
  return result;
}

}  // namespace

// The labels are found by position, without the search for corners, which is by signs.
void RangeStructure::audit_box(const Snapshot& snapshot, const ExactBox& box,
                               AuditReport& report) const {
  LabelBox labelled;
  for (const int axis : {0, 1}) {
    const auto a = static_cast<std::size_t>(axis);
    labelled.low[a] = 0;
    labelled.high[a] = static_cast<AxisLabels::Label>(labels(axis).size() - 1);
    for (const ObjectId id : labels(axis).in_order()) {
      if (snapshot.position(id, axis) < box[a][0]) labelled.low[a] = label(axis, id) + 1;
    }
    const std::vector<ObjectId> order = labels(axis).in_order();
    for (auto id = order.rbegin(); id != order.rend(); ++id) {
      if (!(box[a][1] < snapshot.position(*id, axis))) continue;
      if (label(axis, *id) == 0) return;  // all points are behind the box
      labelled.high[a] = label(axis, *id) - 1;
    }
    if (labelled.low[a] > labelled.high[a]) return;
  }
  std::vector<ObjectId> found;
  const Cost cost = search(labelled, found, nullptr);
  std::sort(found.begin(), found.end());
  const std::vector<ObjectId> expected = scanned_range(snapshot, box);
  report.check(found == expected, [] { return "a box holds other points"; });
  report.check(cgal_range(snapshot, box) == expected,
               [] { return "CGAL finds other points in a box"; });
  report.check(cost.bounded <= most_looked_at(found.size()),
               [] { return "a box takes too many nodes"; });
}

void RangeStructure::audit(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<ObjectId> alive = alive_in(snapshot);
  for (const int axis : {0, 1}) {
    std::vector<ObjectId> expected = alive;
    std::stable_sort(expected.begin(), expected.end(), [&](ObjectId a, ObjectId b) {
      return snapshot.position(a, axis) < snapshot.position(b, axis);
    });
    const bool holds = expected == labels(axis).in_order();
    report.check(holds, [&] { return std::string("another order along ") + "xy"[axis]; });
    if (!holds) return;
  }
  for (const ExactBox& box : boxes_between_points(snapshot, alive, report.checks)) {
    audit_box(snapshot, box, report);
  }
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/closest_point_line.h"

#include "structures/arrangement/line_bounds.h"

namespace kinex {

ClosestPointLine::ClosestPointLine(Kernel& kernel, StructureId id, const Scene& scene,
                                   LineMeasure measure)
    : FrontPair(kernel, id, "pairs", "lines and points by distance",
                LineDistances(kernel, measure, lines_of(scene))),
      measure_(measure) {}

std::vector<ClosestPointLine::Pair> ClosestPointLine::all_pairs() const {
  return members_.all([this](ObjectId a, ObjectId b) { return is_pair(a, b); });
}

void ClosestPointLine::build(std::span<const ObjectId> objects) {
  members_.assign(objects);
  pairs_.assign(all_pairs());
  begin();
}

void ClosestPointLine::insert(ObjectId object) {
  members_.insert(object, [this](const Pair& pair) {
    if (is_pair(pair[0], pair[1])) pairs_.come(pair);
  });
  begin();
}

void ClosestPointLine::erase(ObjectId object) {
  members_.erase(object, [this](const Pair& pair) {
    if (is_pair(pair[0], pair[1])) pairs_.go(pair);
  });
  begin();
}

std::vector<BoundCheck> ClosestPointLine::bounds(const BoundContext& context) const {
  const LinesAndPoints both(context, pairs_.claims().is_line());
  const Integer all = counted(both.lines.size()) * counted(both.points.size());
  return tournament_bounds(context, all, "a tournament of all pairs of a line and a point",
                           degree_of_claims(context.degree), all);
}

void ClosestPointLine::check_invariants(AuditReport& report) const {
  FrontPair::check_invariants(report);
  report.check(pairs_.values() == all_pairs(),
               [] { return "other pairs than those of its lines and points"; });
}

}  // namespace kinex

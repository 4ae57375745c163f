// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/closest_point_line.h"

#include <algorithm>
#include <string>

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
  const StructureLedger& ledger = *context.ledger;
  const std::string own(name());
  const LinesAndPoints both(context, pairs_.claims().is_line());
  const Integer all = counted(both.lines.size()) * counted(both.points.size());
  const int degree = degree_of_claims(context.degree);
  std::vector<BoundCheck> result{
      at_most(own + ".certificates", "a tournament of all pairs of a line and a point",
              std::max(Integer(0), all - Integer(1)), counted(ledger.max_live)),
      at_most(own + ".events", "the epochs of the nodes of the tournament",
              pairs_.most_failures(degree), counted(ledger.failures))};
  if (context.plain() && all.sign() > 0) {
    result.push_back(
        at_most(own + ".external", "pieces of the lower envelope of the distances of all pairs",
                davenport_schinzel_bound(degree, all) - Integer(1), counted(ledger.external)));
  }
  return result;
}

void ClosestPointLine::check_invariants(AuditReport& report) const {
  FrontPair::check_invariants(report);
  report.check(pairs_.values() == all_pairs(),
               [] { return "other pairs than those of its lines and points"; });
}

}  // namespace kinex

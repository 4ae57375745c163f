// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/box_of_maxima.h"

#include <algorithm>

#include "structures/extent/static_box_audit.h"
#include "structures/parts/extremum_bounds.h"

namespace kinex {

// Empty without points.
std::vector<ObjectId> BoxOfMaxima::box() const {
  std::vector<ObjectId> result;
  for (const Structure* extremum : extrema_) {
    const std::vector<ObjectId> ids = extremum->attribute().ids;
    result.insert(result.end(), ids.begin(), ids.end());
  }
  return result;
}

std::vector<BoundCheck> BoxOfMaxima::bounds(const BoundContext& context) const {
  const Integer sides = counted(extrema_.size());
  Integer changes = sides * extremum_changes(context, context.pieces, 1, context.degree);
  if (context.plain() && context.degree <= 1) {
    changes = std::min(changes, counted(extrema_.size() / 2) * counted(context.objects()));
  }
  const std::string name(name_);
  return {at_most(name + ".certificates", "it reads those of the extrema", Integer(0),
                  counted(context.ledger->max_live)),
          at_most(name + ".external", "pieces of the upper and lower envelope of each axis",
                  std::move(changes), counted(context.ledger->external))};
}

void BoxOfMaxima::check_invariants(AuditReport& report) const {
  const std::vector<ObjectId> now = box();
  report.check(now == events_.told().ids, [] { return "a change of the box was not reported"; });
  report.check(now.empty() || now.size() == extrema_.size(),
               [] { return "a side of the box has no point"; });
}

void BoxOfMaxima::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_box(snapshot) == box(), [] { return "other points are extreme"; });
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/convex_hull_2_delaunay.h"

#include <algorithm>
#include <string>

#include "predicates/predicates.h"

namespace kinex {

ConvexHull2Delaunay::ConvexHull2Delaunay(Kernel& kernel, StructureId id,
                                         const Delaunay2& triangulation)
    : HullSource(kernel, id),
      orientation_(kernel.bind(make_orientation_2())),
      triangulation_(&triangulation) {}

std::vector<ObjectId> ConvexHull2Delaunay::cycle() const {
  std::vector<ObjectId> hull = triangulation_->hull();
  if (hull.size() <= 1) return hull;
  if (triangulation_->on_line()) {
    return {std::min(hull.front(), hull.back()), std::max(hull.front(), hull.back())};
  }
  std::vector<ObjectId> strict;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const ObjectId before = hull[i == 0 ? hull.size() - 1 : i - 1];
    const ObjectId after = hull[i + 1 == hull.size() ? 0 : i + 1];
    if (kernel_->sign_after(orientation_, {before, hull[i], after}) != Sign::kZero) {
      strict.push_back(hull[i]);
    }
  }
  start_at_smallest(strict);
  return strict;
}

void ConvexHull2Delaunay::build(std::span<const ObjectId>) { events_.begin(cycle()); }

// Inner flips do not matter. After a failure the triangulation may go on changing at this instant,
// so the hull is read when the instant is settled. A rebuild, or a "settled", is final.
void ConvexHull2Delaunay::look() {
  if (!kernel_->failure_is_due()) return events_.settle(cycle());
  kernel_->settle_later(id_);
}

void ConvexHull2Delaunay::watched_changed(const Event* event) {
  if (event == nullptr || event->kind > Delaunay2::kReinsert) return look();
  if (event->kind != Delaunay2::kFlip) kernel_->settle_later(id_);
}

std::vector<BoundCheck> ConvexHull2Delaunay::bounds(const BoundContext& context) const {
  return {at_most(std::string(name()) + ".certificates", "it reads the triangulation's", Integer(0),
                  counted(context.ledger->max_live))};
}

void ConvexHull2Delaunay::check_invariants(AuditReport& report) const {
  report.check(events_.cycle() == cycle(), [] { return "the hull was not reported"; });
}

}  // namespace kinex

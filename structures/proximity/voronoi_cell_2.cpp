// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/voronoi_cell_2.h"

#include <algorithm>
#include <optional>

#include "structures/parts/binomial.h"
#include "structures/proximity/delaunay_edges.h"

namespace kinex {

VoronoiCell2::VoronoiCell2(Kernel& kernel, StructureId id, const Delaunay2& triangulation,
                           ObjectId site)
    : kernel_(&kernel),
      id_(id),
      triangulation_(&triangulation),
      site_(site),
      events_(kernel, id) {}

// As the triangulation is now.
std::vector<ObjectId> VoronoiCell2::cycle() const {
  if (site_ >= triangulation_->objects()) return {};  // a scene without objects
  const ObjectId vertex = triangulation_->representative(site_);
  if (vertex == kNoObject) return {};
  std::vector<ObjectId> around = triangulation_->around(vertex);
  if (!around.empty()) {
    std::rotate(around.begin(), std::min_element(around.begin(), around.end()), around.end());
  }
  return around;
}

// False if the event changes one edge, or exchanges two, and none of them ends at the site.
bool VoronoiCell2::touches(const Event& event) const {
  const auto change = DelaunayGraph(*triangulation_).change(event);
  if (!change) return true;
  const ObjectId vertex = triangulation_->representative(site_);
  const auto ends_here = [vertex](const std::optional<DelaunayEdge>& edge) {
    return edge && ((*edge)[0] == vertex || (*edge)[1] == vertex);
  };
  return ends_here(change->gone) || ends_here(change->came);
}

// After a failure the triangulation may go on changing at this instant, so the star is read when the
// instant is settled.
void VoronoiCell2::look() {
  if (!kernel_->failure_is_due()) return events_.settle(cycle());
  kernel_->settle_later(id_);
}

// A rebuild, or a "settled", is final.
void VoronoiCell2::watched_changed(const Event* event) {
  if (event == nullptr || event->kind > Delaunay2::kReinsert) return look();
  if (touches(*event)) kernel_->settle_later(id_);
}

std::vector<BoundCheck> VoronoiCell2::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result{at_most("voronoi_cell_2.certificates",
                                         "it reads the triangulation's", Integer(0),
                                         counted(context.ledger->max_live))};
  const std::size_t n = context.objects();
  if (!context.plain() || n == 0) return result;
  // A site that leaves or enters is in a polynomial that changes its sign then, with at most two
  // others; besides there is at most one "turn" an instant.
  const Integer degree(context.degree), others = counted(n - 1);
  result.push_back(at_most("voronoi_cell_2.external",
                           "three sites, and one turn, for each root of a circle through the site and "
                           "three others, or of a line through it and two",
                           Integer(4) * degree *
                               (Integer(4) * binomial(others, 3) + Integer(2) * binomial(others, 2)),
                           counted(context.ledger->external)));
  return result;
}

void VoronoiCell2::check_invariants(AuditReport& report) const {
  report.check(events_.cycle() == cycle(), [] { return "a change of the cell was not reported"; });
}

}  // namespace kinex

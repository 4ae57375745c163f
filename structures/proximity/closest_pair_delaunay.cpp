// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_delaunay.h"

#include <utility>

#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {

ClosestPairDelaunay::ClosestPairDelaunay(Kernel& kernel, StructureId id, std::string_view name,
                                         CountedEdges edges)
    : FrontPair(kernel, id, "edges", "edges by length",
                PairDistances(kernel, edges.graph().dimension()), edges.graph().id()),
      name_(name),
      counted_(std::move(edges)),
      seen_(counted_.graph()) {}

void ClosestPairDelaunay::read_all() {
  seen_.forget();
  read_touched();
}

void ClosestPairDelaunay::read_touched() {
  catch_up();
  begin();
}

void ClosestPairDelaunay::catch_up() {
  seen_.look([this] { pairs_.assign(counted_.all()); },
             [this](const DelaunayEdge& edge, bool is_there) { put(edge, is_there); });
}

// False if that is known already.
bool ClosestPairDelaunay::put(const DelaunayEdge& edge, bool is_there) {
  if (!counted_.counts(edge[0], edge[1])) return true;
  return is_there ? pairs_.come(edge) : pairs_.go(edge);
}

// What was touched is looked at after a change that is not one of single edges, and all edges after one that
// contradicts those known. A change of the closest pair is reported when the instant is over, for certificates of this
// structure may fail at the same instant.
void ClosestPairDelaunay::follow(const std::optional<DelaunayEdgeChange>& change) {
  const bool followed = change && (!change->gone || put(*change->gone, false)) &&
                        (!change->came || put(*change->came, true));
  if (followed) {
    seen_.followed(*change);
  } else {
    if (change) seen_.forget();  // a contradiction, of an inexact arithmetic
    catch_up();
  }
  pairs_.apply(tied());
  if (!is_told()) kernel_->settle_later(id_);
}

std::vector<BoundCheck> ClosestPairDelaunay::bounds(const BoundContext& context) const {
  const CountedEdges::Most most = counted_.most(context.objects());
  return tournament_bounds(context, counted(most.edges), most.why, 2 * context.degree,
                           counted_.most_pairs(context.objects()));
}

void ClosestPairDelaunay::check_invariants(AuditReport& report) const {
  FrontPair::check_invariants(report);
  report.check(pairs_.values() == counted_.all(), [] { return "a change of the edges is missed"; });
}

void ClosestPairDelaunay::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto pair = static_closest_pair(
      snapshot, [this](ObjectId a, ObjectId b) { return counted_.counts(a, b); });
  report.check(pair == attribute().ids, [] { return "another pair is the closest"; });
}

}  // namespace kinex

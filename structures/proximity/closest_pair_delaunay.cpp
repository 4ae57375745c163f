// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_delaunay.h"

#include <algorithm>

#include "structures/parts/tournament_proof.h"
#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {

ClosestPairDelaunay::ClosestPairDelaunay(Kernel& kernel, StructureId id,
                                         const Delaunay2& triangulation)
    : kernel_(&kernel),
      id_(id),
      triangulation_(&triangulation),
      edges_(kernel, id, "edges", PairDistances(kernel, 2)),
      events_(kernel, id, Attribute::Shape::kTuples) {}

std::span<const ObjectId> ClosestPairDelaunay::closest() const {
  const Pair* front = edges_.front();
  return front == nullptr ? std::span<const ObjectId>() : std::span<const ObjectId>(*front);
}

// The edges of the triangulation and the pairs of a vertex and a point hidden behind it, ascending.
std::vector<ClosestPairDelaunay::Pair> ClosestPairDelaunay::pairs() const {
  const std::vector<ObjectId> ids = triangulation_->attribute().ids;
  std::vector<Pair> result;
  for (std::size_t i = 0; i + 1 < ids.size(); i += 2) result.push_back({ids[i], ids[i + 1]});
  for (ObjectId object = 0; object < triangulation_->objects(); ++object) {
    const ObjectId vertex = triangulation_->representative(object);
    if (vertex != object && vertex != kNoObject) result.push_back({vertex, object});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void ClosestPairDelaunay::begin() {
  edges_.assign(pairs());
  edges_.apply(tied());
  events_.begin(closest());
}

// Makes the change of edges that the event states; false if it is not one of a single edge, or
// contradicts what is there.
bool ClosestPairDelaunay::follow(const Event& event) {
  const auto& ids = event.ids;
  if (event.kind == Delaunay2::kFlip) {
    return edges_.go({ids[0], ids[1]}) && edges_.come({ids[2], ids[3]});
  }
  if (event.kind == Delaunay2::kEnter) return edges_.go({ids[1], ids[2]});
  return event.kind == Delaunay2::kLeave && edges_.come({ids[1], ids[2]});
}

// Whether the pair is another one is seen when the instant is over: certificates of this structure
// may fail at it, too.
void ClosestPairDelaunay::watched_changed(const Event* event) {
  if (event == nullptr || !follow(*event)) edges_.assign(pairs());
  edges_.apply(tied());
  if (!std::ranges::equal(closest(), events_.told().ids)) kernel_->settle_later(id_);
}

void ClosestPairDelaunay::certificate_failed(CertificateId failed) {
  const auto [old, fresh] = edges_.failed(failed, tied());
  events_.repaired(kReplace, {old[0], old[1], fresh[0], fresh[1]}, closest(), triangulation_->id());
}

void ClosestPairDelaunay::visit_proof(ProofVisitor& visitor) const {
  visit_tournament(visitor, edges_, 0, "edges by length", [](const Pair& winner) {
    return std::vector<ObjectId>(winner.begin(), winner.end());
  });
}

std::vector<BoundCheck> ClosestPairDelaunay::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::size_t n = context.objects();
  std::vector<BoundCheck> result{
      at_most("closest_pair_delaunay.certificates", "a tournament of at most 3n - 6 edges",
              counted(n < 3 ? 0 : 3 * n - 7), counted(ledger.max_live)),
      at_most("closest_pair_delaunay.events", "the epochs of the nodes of the tournament",
              edges_.most_failures(2 * context.degree), counted(ledger.failures))};
  if (context.plain() && n > 1) {
    const Integer envelope = davenport_schinzel_bound(2 * context.degree, kinex::pairs(counted(n)));
    result.push_back(at_most("closest_pair_delaunay.external",
                             "pieces of the lower envelope of the distances of all pairs",
                             envelope - Integer(1), counted(ledger.external)));
  }
  return result;
}

void ClosestPairDelaunay::check_invariants(AuditReport& report) const {
  edges_.check(report, "edges");
  report.check(edges_.values() == pairs(), [] { return "it has missed a change of the edges"; });
  report.check(std::ranges::equal(closest(), events_.told().ids),
               [] { return "a change of the closest pair was not reported"; });
}

void ClosestPairDelaunay::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_closest_pair(snapshot) == attribute().ids,
               [] { return "another pair is the closest"; });
}

}  // namespace kinex

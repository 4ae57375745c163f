// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_delaunay.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/parts/tournament_proof.h"
#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {

ClosestPairDelaunay::ClosestPairDelaunay(Kernel& kernel, StructureId id, std::string_view name,
                                         CountedEdges edges)
    : kernel_(&kernel),
      id_(id),
      name_(name),
      counted_(std::move(edges)),
      edges_(kernel, id, "edges", PairDistances(kernel, counted_.graph().dimension())),
      events_(kernel, id, Attribute::Shape::kTuples) {}

// Empty if there are fewer than two points.
std::span<const ObjectId> ClosestPairDelaunay::closest() const {
  const Pair* front = edges_.front();
  return front == nullptr ? std::span<const ObjectId>() : std::span<const ObjectId>(*front);
}

void ClosestPairDelaunay::begin() {
  edges_.assign(counted_.all());
  edges_.apply(tied());
  events_.begin(closest());
}

// All edges are read after a change that does not change single edges or contradicts the edges known.
// A change of the closest pair is reported when the instant is over, for certificates of this
// structure may fail at the same instant.
void ClosestPairDelaunay::follow(const std::optional<DelaunayEdgeChange>& change) {
  const bool followed = change && (!change->gone || edges_.go(*change->gone)) &&
                        (!change->came || edges_.come(*change->came));
  if (!followed) edges_.assign(counted_.all());
  edges_.apply(tied());
  if (!std::ranges::equal(closest(), events_.told().ids)) kernel_->settle_later(id_);
}

void ClosestPairDelaunay::certificate_failed(CertificateId failed) {
  const auto [old, fresh] = edges_.failed(failed, tied());
  events_.repaired(kReplace, {old[0], old[1], fresh[0], fresh[1]}, closest(),
                   counted_.graph().id());
}

void ClosestPairDelaunay::visit_proof(ProofVisitor& visitor) const {
  visit_tournament(visitor, edges_, 0, "edges by length", [](const Pair& winner) {
    return std::vector<ObjectId>(winner.begin(), winner.end());
  });
}

std::vector<BoundCheck> ClosestPairDelaunay::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string own(name_);
  const CountedEdges::Most most = counted_.most(context.objects());
  std::vector<BoundCheck> result{
      at_most(own + ".certificates", most.why, counted(std::max<std::size_t>(1, most.edges) - 1),
              counted(ledger.max_live)),
      at_most(own + ".events", "the epochs of the nodes of the tournament",
              edges_.most_failures(2 * context.degree), counted(ledger.failures))};
  const Integer pairs = counted_.most_pairs(context.objects());
  if (context.plain() && pairs.sign() > 0) {
    const Integer envelope = davenport_schinzel_bound(2 * context.degree, pairs);
    result.push_back(at_most(own + ".external",
                             "pieces of the lower envelope of the distances of all pairs",
                             envelope - Integer(1), counted(ledger.external)));
  }
  return result;
}

void ClosestPairDelaunay::check_invariants(AuditReport& report) const {
  edges_.check(report, "edges");
  report.check(edges_.values() == counted_.all(), [] { return "a change of the edges is missed"; });
  report.check(std::ranges::equal(closest(), events_.told().ids),
               [] { return "a change of the closest pair was not reported"; });
}

void ClosestPairDelaunay::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto pair = static_closest_pair(
      snapshot, [this](ObjectId a, ObjectId b) { return counted_.counts(a, b); });
  report.check(pair == attribute().ids, [] { return "another pair is the closest"; });
}

}  // namespace kinex

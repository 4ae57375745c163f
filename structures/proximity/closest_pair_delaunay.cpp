// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_delaunay.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/parts/tournament_proof.h"
#include "structures/proximity/delaunay_edges.h"
#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {

ClosestPairDelaunay::ClosestPairDelaunay(Kernel& kernel, StructureId id,
                                         const DelaunayGraph& triangulation,
                                         std::optional<TwoClasses> classes)
    : kernel_(&kernel),
      id_(id),
      triangulation_(triangulation),
      classes_(std::move(classes)),
      edges_(kernel, id, "edges", PairDistances(kernel, triangulation.dimension())),
      events_(kernel, id, Attribute::Shape::kTuples) {}

std::span<const ObjectId> ClosestPairDelaunay::closest() const {
  const Pair* front = edges_.front();
  return front == nullptr ? std::span<const ObjectId>() : std::span<const ObjectId>(*front);
}

// The edges that count, ascending.
std::vector<ClosestPairDelaunay::Pair> ClosestPairDelaunay::candidates() const {
  std::vector<Pair> edges = triangulation_.edges();
  std::erase_if(edges, [this](const Pair& edge) { return !counts(edge); });
  return edges;
}

void ClosestPairDelaunay::begin() {
  edges_.assign(candidates());
  edges_.apply(tied());
  events_.begin(closest());
}

// Makes the change of edges that the event states; false if it is not one of a single edge, or
// contradicts what is there.
bool ClosestPairDelaunay::follow(const Event& event) {
  const auto change = triangulation_.change(event);
  if (!change) return false;
  const auto [gone, came] = *change;
  if (gone && counts(*gone) && !edges_.go(*gone)) return false;
  return !came || !counts(*came) || edges_.come(*came);
}

// Whether the pair is another one is seen when the instant is over: certificates of this structure
// may fail at it, too.
void ClosestPairDelaunay::watched_changed(const Event* event) {
  if (event == nullptr || !follow(*event)) edges_.assign(candidates());
  edges_.apply(tied());
  if (!std::ranges::equal(closest(), events_.told().ids)) kernel_->settle_later(id_);
}

void ClosestPairDelaunay::certificate_failed(CertificateId failed) {
  const auto [old, fresh] = edges_.failed(failed, tied());
  events_.repaired(kReplace, {old[0], old[1], fresh[0], fresh[1]}, closest(), triangulation_.id());
}

void ClosestPairDelaunay::visit_proof(ProofVisitor& visitor) const {
  visit_tournament(visitor, edges_, 0, "edges by length", [](const Pair& winner) {
    return std::vector<ObjectId>(winner.begin(), winner.end());
  });
}

// The largest number of edges that count, of n points.
std::size_t ClosestPairDelaunay::most_edges(std::size_t n) const {
  if (!classes_) return triangulation_.most_edges(n);
  if (triangulation_.dimension() == 3) return classes_->size(0) * classes_->size(1);
  return n < 3 ? triangulation_.most_edges(n) : 2 * n - 4;
}

std::vector<BoundCheck> ClosestPairDelaunay::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::size_t n = context.objects();
  const std::string own(name());
  std::vector<BoundCheck> result{
      at_most(own + ".certificates",
              classes_ ? "a tournament of the edges between two classes: at most 2n - 4, in space all pairs of them"
                       : "a tournament of the edges: at most 3n - 6, in space all pairs",
              counted(std::max<std::size_t>(1, most_edges(n)) - 1), counted(ledger.max_live)),
      at_most(own + ".events", "the epochs of the nodes of the tournament",
              edges_.most_failures(2 * context.degree), counted(ledger.failures))};
  const Integer all =
      classes_ ? counted(classes_->size(0)) * counted(classes_->size(1)) : pairs(counted(n));
  if (context.plain() && all.sign() > 0) {
    const Integer envelope = davenport_schinzel_bound(2 * context.degree, all);
    result.push_back(at_most(own + ".external",
                             "pieces of the lower envelope of the distances of all pairs",
                             envelope - Integer(1), counted(ledger.external)));
  }
  return result;
}

void ClosestPairDelaunay::check_invariants(AuditReport& report) const {
  edges_.check(report, "edges");
  report.check(edges_.values() == candidates(),
               [] { return "it has missed a change of the edges"; });
  report.check(std::ranges::equal(closest(), events_.told().ids),
               [] { return "a change of the closest pair was not reported"; });
}

void ClosestPairDelaunay::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto pair = static_closest_pair(snapshot, [this](ObjectId a, ObjectId b) {
    return counts({a, b});
  });
  report.check(pair == attribute().ids, [] { return "another pair is the closest"; });
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_bins.h"

#include <algorithm>
#include <utility>

#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {

// The grid is the first part in the ledger.
ClosestPairBins::ClosestPairBins(Kernel& kernel, StructureId id, const Scene& scene)
    : ClosestPairBins(kernel, id,
                      PointGrid(kernel, id, FlightBox::of(scene), scene.objects.size(), kReach)) {}

ClosestPairBins::ClosestPairBins(Kernel& kernel, StructureId id, PointGrid grid)
    : FrontPair(kernel, id, "pairs", "pairs by distance", PairDistances(kernel, 2)),
      grid_(std::move(grid)) {}

// ---- the grid

// Of points in near cells, ascending.
std::vector<ClosestPairBins::Pair> ClosestPairBins::near_pairs() const {
  std::vector<Pair> result;
  for (const ObjectId a : members_) {
    for (const ObjectId b : grid_.near(a)) {
      if (a < b) result.push_back({a, b});
    }
  }
  return result;
}

void ClosestPairBins::lay(std::size_t squares) {
  grid_.lay(std::max<std::size_t>(squares, 1), members_);
  most_lines_ = std::max(most_lines_, grid_.lines());
  ++layings_;
  pairs_.assign(near_pairs());
}

// ---- calls

void ClosestPairBins::build(std::span<const ObjectId> objects) {
  members_.assign(objects.begin(), objects.end());
  lay(members_.empty() ? 0 : members_.size() - 1);
  begin();
}

void ClosestPairBins::rebuild() {
  lay(members_.empty() ? 0 : members_.size() - 1);
  FrontPair::rebuild();
}

void ClosestPairBins::insert(ObjectId object) {
  members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  grid_.insert(object);
  if (members_.size() > 4 * grid_.cells()) {
    lay(members_.size() - 1);
  } else {
    for (const ObjectId other : grid_.near(object)) {
      pairs_.come({std::min(object, other), std::max(object, other)});
    }
  }
  begin();
}

// Half as many squares as points: the next one that goes is no reason to lay the grid again.
void ClosestPairBins::erase(ObjectId object) {
  for (const ObjectId other : grid_.near(object)) {
    pairs_.go({std::min(object, other), std::max(object, other)});
  }
  grid_.erase(object);
  members_.erase(std::lower_bound(members_.begin(), members_.end(), object));
  if (members_.size() <= grid_.cells() && grid_.cells() > 1) lay(members_.size() / 2);
  begin();
}

void ClosestPairBins::certificate_failed(CertificateId failed) {
  if (grid_.owns(failed)) {
    const ObjectId point = grid_.point_of(failed);
    const std::vector<ObjectId> before = grid_.near(point);
    grid_.move_on(failed);
    const std::vector<ObjectId> after = grid_.near(point);
    const auto pair = [point](ObjectId other) {
      return Pair{std::min(point, other), std::max(point, other)};
    };
    for (const ObjectId other : before) {
      if (!std::binary_search(after.begin(), after.end(), other)) pairs_.go(pair(other));
    }
    for (const ObjectId other : after) pairs_.come(pair(other));
    pairs_.apply(tied());
    return repaired(kCell, {point});
  }
  FrontPair::certificate_failed(failed);
}

// ---- checks

void ClosestPairBins::visit_proof(ProofVisitor& visitor) const {
  grid_.visit_proof(visitor);
  FrontPair::visit_proof(visitor);
}

std::vector<BoundCheck> ClosestPairBins::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::size_t n = context.objects();
  const Integer all = kinex::pairs(counted(n));
  Integer crossings;
  for (const int pieces : context.pieces) {
    crossings += counted(static_cast<std::uint64_t>(pieces * (context.degree + 1)));
  }
  std::vector<BoundCheck> result{
      at_most("closest_pair_bins.certificates", "four sides of each cell, and all pairs at worst",
              counted(4 * n) + all, counted(ledger.max_live)),
      at_most("closest_pair_bins.events",
              "each point crosses each line of each grid at most d times in a piece, and where "
              "pieces meet; the epochs of the nodes of the tournament",
              crossings * counted(most_lines_) * counted(layings_) +
                  pairs_.most_failures(2 * context.degree),
              counted(ledger.failures))};
  if (context.plain() && all.sign() > 0) {
    result.push_back(at_most(
        "closest_pair_bins.external", "pieces of the lower envelope of the distances of all pairs",
        davenport_schinzel_bound(2 * context.degree, all) - Integer(1), counted(ledger.external)));
  }
  return result;
}

void ClosestPairBins::check_invariants(AuditReport& report) const {
  grid_.check(report);
  report.check(members_.size() < 2 || grid_.cells() < members_.size(),
               [] { return "too many cells for its points"; });
  report.check(pairs_.values() == near_pairs(),
               [] { return "other pairs than those in near cells"; });
  FrontPair::check_invariants(report);
}

void ClosestPairBins::audit(const Snapshot& snapshot, AuditReport& report) const {
  grid_.audit(snapshot, report);
  report.check(static_closest_pair(snapshot) == attribute().ids,
               [] { return "another pair is the closest"; });
}

std::size_t ClosestPairBins::bytes() const {
  return grid_.bytes() + FrontPair::bytes() + members_.capacity() * sizeof(ObjectId);
}

}  // namespace kinex

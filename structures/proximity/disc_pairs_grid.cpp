// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/disc_pairs_grid.h"

#include <algorithm>

#include "structures/proximity/meeting_bounds.h"

namespace kinex {

DiscPairsGrid::DiscPairsGrid(Kernel& kernel, StructureId id, const Scene& scene)
    : grid_(kernel, id, FlightBox::of_discs(scene), scene.objects.size(), kReach),
      claims_(kernel, id, scene),
      events_(kernel, id) {}

// ---- the grid

// Ascending.
std::vector<DiscPairsGrid::Pair> DiscPairsGrid::near_pairs() const {
  std::vector<Pair> result;
  for (const ObjectId a : members_) {
    for (const ObjectId b : grid_.near(a)) {
      if (a < b) result.push_back({a, b});
    }
  }
  return result;
}

// The pairs become those that are near in a new grid.
void DiscPairsGrid::lay() {
  grid_.lay(std::max<std::size_t>(members_.size(), 1), members_);
  most_lines_ = std::max(most_lines_, grid_.lines());
  ++layings_;
  const std::vector<Pair> wanted = near_pairs();
  for (const Pair& pair : claims_.pairs()) {
    if (!std::binary_search(wanted.begin(), wanted.end(), pair)) claims_.remove(pair);
  }
  for (const Pair& pair : wanted) {
    if (!claims_.has(pair)) claims_.add(pair);
  }
}

// ---- calls

void DiscPairsGrid::build(std::span<const ObjectId> objects) {
  claims_.clear();
  members_.assign(objects.begin(), objects.end());
  lay();
  events_.begin();
}

void DiscPairsGrid::certificate_failed(CertificateId failed) {
  if (grid_.owns(failed)) return cell_changed(failed);
  const auto [pair, meets] = claims_.failed(failed);
  events_.changed(pair[0], pair[1], meets);
  events_.repaired(pair[0], pair[1]);
}

// Pairs that come near, or cease to be, are apart then; in an inexact arithmetic one may be said to
// meet.
void DiscPairsGrid::cell_changed(CertificateId failed) {
  const ObjectId disc = grid_.point_of(failed);
  const std::vector<ObjectId> before = grid_.near(disc);
  grid_.move_on(failed);
  const std::vector<ObjectId> after = grid_.near(disc);
  for (const ObjectId other : before) {
    if (std::binary_search(after.begin(), after.end(), other)) continue;
    if (claims_.remove({std::min(disc, other), std::max(disc, other)})) {
      events_.changed(disc, other, false);
    }
  }
  for (const ObjectId other : after) {
    const Pair pair{std::min(disc, other), std::max(disc, other)};
    if (!claims_.has(pair) && claims_.add(pair)) events_.changed(disc, other, true);
  }
  events_.repaired(disc, disc, kMeetingCell);
}

void DiscPairsGrid::insert(ObjectId object) {
  members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  grid_.insert(object);
  if (members_.size() > 2 * grid_.cells()) {
    lay();
  } else {
    for (const ObjectId other : grid_.near(object)) {
      claims_.add({std::min(object, other), std::max(object, other)});
    }
  }
  events_.begin();
}

void DiscPairsGrid::erase(ObjectId object) {
  for (const ObjectId other : grid_.near(object)) {
    claims_.remove({std::min(object, other), std::max(object, other)});
  }
  grid_.erase(object);
  members_.erase(std::lower_bound(members_.begin(), members_.end(), object));
  if (4 * members_.size() < grid_.cells()) lay();
  events_.begin();
}

void DiscPairsGrid::motions_changed(std::span<const ObjectId> objects) {
  claims_.motions_changed(objects, [this](const Pair& pair) {
    events_.changed(pair[0], pair[1], true);
    events_.tied(pair[0], pair[1]);
  });
}

// ---- checks

void DiscPairsGrid::visit_proof(ProofVisitor& visitor) const {
  grid_.visit_proof(visitor);
  claims_.visit_proof(visitor);
}

std::vector<BoundCheck> DiscPairsGrid::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const Integer n = counted(context.objects());
  Integer crossings;
  for (const int pieces : context.pieces) {
    crossings += counted(static_cast<std::uint64_t>(pieces * (context.degree + 1)));
  }
  return {at_most("disc_pairs_grid.certificates",
                  "the sides of each cell, and all pairs at worst",
                  Integer(2) * counted(grid_.axes()) * n + pairs(n), counted(ledger.max_live)),
          at_most("disc_pairs_grid.events",
                  "each centre crosses each line of each grid at most d times in a piece, and where "
                  "pieces meet; a pair changes only at a root of its polynomial, and where pieces "
                  "meet",
                  crossings * counted(most_lines_) * counted(layings_) +
                      pair_sign_changes(context.pieces, 2 * context.degree),
                  counted(ledger.failures)),
          meeting_bound("disc_pairs_grid", 1, 2, context)};
}

void DiscPairsGrid::check_invariants(AuditReport& report) const {
  grid_.check(report);
  claims_.check(report);
  report.check(claims_.pairs() == near_pairs(),
               [] { return "other pairs than those in neighbouring cells"; });
  report.check(!events_.any(), [] { return "a change of the pairs was not reported"; });
}

std::size_t DiscPairsGrid::bytes() const {
  return grid_.bytes() + claims_.bytes() + events_.bytes() + members_.capacity() * sizeof(ObjectId);
}

}  // namespace kinex

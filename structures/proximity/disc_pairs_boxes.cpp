// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "structures/proximity/disc_pairs.h"
#include "structures/proximity/meeting_bounds.h"

namespace kinex {
namespace {

// Where the pairs are read afterwards, single changes are of no interest.
constexpr auto kNoChange = [](ObjectId, ObjectId, bool) {};
constexpr auto kNoTie = [](ObjectId, ObjectId) {};

}  // namespace

// The pairs become those whose boxes meet.
void DiscPairsBoxes::read_boxes() {
  const std::vector<BoxOverlaps::Pair> wanted = overlaps_.pairs();
  for (const DiscClaims::Pair& pair : claims_.pairs()) {
    if (!std::binary_search(wanted.begin(), wanted.end(), pair)) claims_.remove(pair);
  }
  for (const BoxOverlaps::Pair& pair : wanted) {
    if (!claims_.has(pair)) claims_.add(pair);
  }
  events_.begin();
}

void DiscPairsBoxes::build(std::span<const ObjectId> objects) {
  claims_.clear();
  overlaps_.build(objects, kNoChange, kNoTie);
  read_boxes();
}

void DiscPairsBoxes::certificate_failed(CertificateId failed) {
  if (claims_.owns(failed)) {
    const auto [pair, meets] = claims_.failed(failed);
    events_.changed(pair[0], pair[1], meets);
    events_.repaired(pair[0], pair[1]);
    return;
  }
  const auto [a, b] = overlaps_.failed(failed, boxes_changed());
  events_.repaired(a, b);
  overlaps_.settle(boxes_changed(), tied());
}

void DiscPairsBoxes::insert(ObjectId object) {
  overlaps_.insert(object, kNoChange, kNoTie);
  read_boxes();
}

void DiscPairsBoxes::erase(ObjectId object) {
  for (const ObjectId other : overlaps_.partners(object)) {
    claims_.remove({std::min(object, other), std::max(object, other)});
  }
  overlaps_.erase(object, kNoChange, kNoTie);
  read_boxes();
}

void DiscPairsBoxes::motions_changed(std::span<const ObjectId> objects) {
  overlaps_.motions_changed(objects, boxes_changed(), tied());
  claims_.motions_changed(objects, [this](const DiscClaims::Pair& pair) {
    events_.changed(pair[0], pair[1], true);
    events_.tied(pair[0], pair[1]);
  });
}

void DiscPairsBoxes::visit_proof(ProofVisitor& visitor) const {
  overlaps_.visit_proof(visitor);
  claims_.visit_proof(visitor);
}

std::vector<BoundCheck> DiscPairsBoxes::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = end_bounds("disc_pairs_boxes", overlaps_, context);
  result.push_back(meeting_bound("disc_pairs_boxes", 1, 2, context));
  return result;
}

void DiscPairsBoxes::check_invariants(AuditReport& report) const {
  overlaps_.check(report);
  claims_.check(report);
  report.check(claims_.pairs() == overlaps_.pairs(),
               [] { return "other pairs of discs than those of boxes that meet"; });
  report.check(!events_.any(), [] { return "a change of the pairs was not reported"; });
}

}  // namespace kinex

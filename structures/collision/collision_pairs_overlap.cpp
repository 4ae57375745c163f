// SPDX-License-Identifier: GPL-3.0-or-later
// CollisionPairs: two bodies that overlap, from contact to separation.
#include <array>

#include "core/numbers/check.h"
#include "structures/collision/collision_pairs.h"

namespace kinex {

OverlapProof CollisionPairs::overlap_proof(const SumBoundary& sum, PairId p) {
  if (!rays_) rays_.emplace(kernel_);
  return OverlapProof(*rays_, sum, pairs_[p].pose);
}

// Searched from the edge after the first vertex if `near` are two vertices.
std::optional<SumBoundary::Edge> CollisionPairs::edge_ahead(PairId p, const Features& near) {
  const SumBoundary sum = pairs_.boundary(p);
  const bool of_b = near.of_b.edge;
  const SumBoundary::Edge from = of_b ? SumBoundary::Edge{1, near.of_b.i, near.of_a.i}
                                      : SumBoundary::Edge{0, near.of_a.i, near.of_b.i};
  return overlap_proof(sum, p).ahead(from);
}

// The features of the edge of M that the point is on: two vertices at an end of it.
Features CollisionPairs::features_at(PairId p, const SumBoundary::Edge& edge) {
  const SumBoundary sum = pairs_.boundary(p);
  for (const bool last : {false, true}) {
    if (!kernel_.tells_sign_now()) break;
    if (kernel_.sign(sum.past(edge, last), When::kNow) != Sign::kZero) continue;
    const auto [x, y] = sum.end(edge, last);
    return {{false, x}, {false, y}};
  }
  return edge.features();
}

// In an inexact arithmetic there may be no proof: the bodies then stay in contact until a motion
// changes.
void CollisionPairs::follow_overlap(PairId p, const std::optional<SumBoundary::Edge>& ahead) {
  if (!ahead) {
    require(!kernel_.is_exact(), "no proof that two bodies overlap");
    pairs_.drop(p);
    pairs_[p].state = State::kUnproved;
    return;
  }
  const SumBoundary sum = pairs_.boundary(p);
  pairs_.set(p, overlap_, overlap_proof(sum, p).certificates(*ahead));
  pairs_[p].ahead = *ahead;
  pairs_[p].state = State::kOverlap;
}

// With three or more bodies: by discs within the two, if they overlap. The edge ahead is kept.
bool CollisionPairs::follow_discs_within(PairId p) {
  if (!grid_) return false;
  const auto query = pairs_.volumes().proof_of_overlap(pairs_[p].a, pairs_[p].b);
  if (!query) return false;
  pairs_.set(p, overlap_, {&*query, 1});
  pairs_[p].state = State::kInner;
  return true;
}

void CollisionPairs::overlap_failed(PairId p, std::uint32_t slot) {
  if (slot == OverlapProof::kInside || !follow_discs_within(p)) {
    const SumBoundary sum = pairs_.boundary(p);
    const OverlapProof proof = overlap_proof(sum, p);
    const auto ahead = proof.ahead(pairs_[p].ahead);
    if (ahead && !proof.is_inside(*ahead)) return part(p, *ahead);
    follow_overlap(p, ahead);
  }
  report(p, CollisionEvent::kInside);
}

// The motion of one of the two bodies has changed.
void CollisionPairs::overlap_moved(PairId p) {
  if (pairs_[p].state == State::kUnproved) {
    follow(p);
    if (pairs_[p].in_contact()) return;
    const std::array<ObjectId, 2> parted{pairs_[p].a, pairs_[p].b};
    return kernel_.report_settled(id_, parted, {});
  }
  const SumBoundary sum = pairs_.boundary(p);
  const OverlapProof proof = overlap_proof(sum, p);
  const auto ahead = proof.ahead(pairs_[p].ahead);
  if (ahead && !proof.is_inside(*ahead)) part(p, *ahead);
}

// The bodies separate across this edge of M.
void CollisionPairs::part(PairId p, const SumBoundary::Edge& edge) {
  report_meeting(p, CollisionEvent::kSeparation, features_at(p, edge));
  pairs_[p].state = State::kResting;  // a touch that goes on is not a new one
  if (proof_->start(p, &edge)) return;
  require(!kernel_.is_exact(), "no proof that two bodies are disjoint when they have parted");
  pairs_.drop(p);
  pairs_[p].state = State::kUnproved;
  report(p, CollisionEvent::kOverlap, true);
}

}  // namespace kinex

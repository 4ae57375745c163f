// SPDX-License-Identifier: GPL-3.0-or-later
// CollisionPairs: two bodies that overlap, from contact to separation.
#include <stdexcept>

#include "core/numbers/check.h"
#include "structures/collision/collision_pairs.h"

namespace kinex {

SumBoundary CollisionPairs::boundary(PairId p) {
  return SumBoundary(kernel_, predicates_, pairs_[p].pose,
                     {&frames_.frame(pairs_[p].a, false), &frames_.frame(pairs_[p].b, true)});
}

OverlapProof CollisionPairs::overlap_proof(const SumBoundary& sum, PairId p) {
  if (!rays_) rays_.emplace(kernel_);
  return OverlapProof(*rays_, sum, pairs_[p].pose);
}

// Searched from the edge after the first vertex if `near` are two vertices.
std::optional<SumBoundary::Edge> CollisionPairs::edge_ahead(PairId p, const Features& near) {
  const SumBoundary sum = boundary(p);
  const bool of_b = near.of_b.edge;
  const SumBoundary::Edge from = of_b ? SumBoundary::Edge{1, near.of_b.i, near.of_a.i}
                                      : SumBoundary::Edge{0, near.of_a.i, near.of_b.i};
  return overlap_proof(sum, p).ahead(from);
}

// The features of the edge of M that the point is on: two vertices at an end of it.
CollisionPairs::Features CollisionPairs::features_at(PairId p, const SumBoundary::Edge& edge) {
  const SumBoundary sum = boundary(p);
  if (kernel_.tells_sign_now()) {
    for (const bool last : {false, true}) {
      if (kernel_.sign(sum.past(edge.z, edge.edge, last, edge.vertex), When::kNow) != Sign::kZero) continue;
      const auto [x, y] = sum.end(edge, last);
      return {{false, x}, {false, y}};
    }
  }
  const Feature line{true, edge.edge}, vertex{false, edge.vertex};
  return edge.z == 0 ? Features{line, vertex} : Features{vertex, line};
}

// In an inexact arithmetic there may be no proof: the bodies then stay in contact until a motion
// changes.
void CollisionPairs::follow_overlap(PairId p, const std::optional<SumBoundary::Edge>& ahead) {
  if (!ahead) {
    require(!kernel_.is_exact(), "no proof that two bodies overlap");
    drop_certificates(p);
    return;
  }
  pairs_[p].ahead = *ahead;
  const SumBoundary sum = boundary(p);
  set_certificates(p, overlap_proof(sum, p).certificates(*ahead));
}

// With three or more bodies: by discs within the two, if they overlap. The edge ahead is kept.
bool CollisionPairs::follow_discs_within(PairId p) {
  if (!grid_) return false;
  const auto query = volumes_.proof_of_overlap(pairs_[p].a, pairs_[p].b);
  if (!query) return false;
  set_certificates(p, {&*query, 1});
  return true;
}

// A proof that is repaired again and again at one instant cycles: where edges are parallel several
// repairs can undo each other. It is then started anew, which is right just after the instant.
bool CollisionPairs::is_stuck(PairId p) {
  constexpr std::uint8_t kPatience = 64;
  if (!kernel_.is_exact()) return false;
  Pair& pair = pairs_[p];
  if (!kernel_.instant_is_shared(id_)) {
    pair.repairs = 0;
    return false;
  }
  const std::uint64_t now = kernel_.instant_number();
  if (pair.instant != now) pair.repairs = 0;
  pair.instant = now;
  if (pair.repairs >= kPatience) return true;
  ++pair.repairs;
  return false;
}

void CollisionPairs::start_anew(PairId p) {
  stop(p);
  if (start(p)) {
    report(p, kFirstOwn);
  } else {
    contact(p, {});
  }
}

void CollisionPairs::contact(PairId p, const Features& near) {
  const auto ahead = edge_ahead(p, near);
  if (kernel_.is_exact() && ahead) {
    const SumBoundary sum = boundary(p);
    if (!overlap_proof(sum, p).is_inside(*ahead)) {
      stop(p);
      require(start(p), "no proof that two bodies are disjoint, which do not overlap");
      report(p, kFirstOwn);
      return;
    }
  }
  report_meeting(p, kContact, ahead ? features_at(p, *ahead) : near);
  stop(p);
  pairs_[p].touching = true;
  pairs_[p].resting = false;
  follow_overlap(p, ahead);
}

void CollisionPairs::fail_in_contact(PairId p, std::uint32_t slot) {
  ++failures_in_contact_;
  if (slot != OverlapProof::kInside && follow_discs_within(p)) {
    report(p, kInside);
    return;
  }
  const SumBoundary sum = boundary(p);
  const OverlapProof proof = overlap_proof(sum, p);
  const auto ahead = proof.ahead(pairs_[p].ahead);
  if (ahead && !proof.is_inside(*ahead)) {
    part(p, *ahead);
    return;
  }
  follow_overlap(p, ahead);
  report(p, kInside);
}

// The motion of one of the two bodies has changed.
void CollisionPairs::move_in_contact(PairId p) {
  if (pairs_[p].certificates == 0) {  // an inexact arithmetic had no proof
    follow(p);
    if (pairs_[p].touching) return;
    const std::array<ObjectId, 2> parted{pairs_[p].a, pairs_[p].b};
    kernel_.report_settled(id_, parted, {});
    return;
  }
  const SumBoundary sum = boundary(p);
  const OverlapProof proof = overlap_proof(sum, p);
  const auto ahead = proof.ahead(pairs_[p].ahead);
  if (ahead && !proof.is_inside(*ahead)) part(p, *ahead);
}

// The bodies separate across this edge of M.
void CollisionPairs::part(PairId p, const SumBoundary::Edge& edge) {
  report_meeting(p, kSeparation, features_at(p, edge));
  pairs_[p].touching = false;
  pairs_[p].resting = true;  // a touch that goes on is not a new one
  if (leave(p, edge)) return;
  require(!kernel_.is_exact(), "no proof that two bodies are disjoint when they have parted");
  pairs_[p].touching = true;
  pairs_[p].resting = false;
  drop_certificates(p);
  report_overlap(p);
}

}  // namespace kinex

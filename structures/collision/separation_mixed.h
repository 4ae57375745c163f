// SPDX-License-Identifier: GPL-3.0-or-later
// SeparationMixed: separation-sensitive collision detection by the mixed hierarchy, and, for
// translation alone, by the hierarchy of the Minkowski sum itself.
//
// Seen from A, B is one point moving outside the Minkowski sum M of A and R B'. The proof is the
// tile of the exterior's hierarchy that holds the point (mixed_tiles.h); far from M tiles are
// large.
//
//       \          tile of a low level         /     o  the point, the position of B. The tile that
//        \               o                    /         holds it proves that A and B are apart.
//         \__________________________________/      A side of the tile fails: the point is in the
//          \  higher level  / \  higher level /         neighbour behind it, the new tile. If that
//           \______________/___\_____________/          side is an edge of M, the bodies touch.
//                         M
//
//   separation_mixed      the mixed hierarchy, for rigid motions; never built whole
//   separation_minkowski  the hierarchy of M (separation_minkowski.h), for bodies that do not turn
//
// Compactness: at most 6 certificates a pair, 8 while a body slides along the other; O(n) space for the trees.
// Responsiveness: O(depth) signs and at most 6 new certificates an event. In numbers: a failure
// takes at most 2 (l + 1) + 33 signs, l the larger of the levels of the old and the new tile
// (kSignsPerLevel, kSigns), and 24 more where the bodies touch (kSignsOfTouch); the bound does not
// apply where the point is located anew, which may happen at a contact.
// Events, for motions of constant degree at distance sigma or more, with
// mu = min(n, sqrt(D / sigma)):
//   rigid motion                       O(mu^2)
//   translation                        O(mu)
//   separation_minkowski on a line     at most 2 per level, O(log mu)
//
// Source: Erickson, Guibas, Stolfi, Zhang, Separation-sensitive collision detection for convex
// objects (1999).
#ifndef KINEX_STRUCTURES_COLLISION_SEPARATION_MIXED_H
#define KINEX_STRUCTURES_COLLISION_SEPARATION_MIXED_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "structures/collision/hierarchy_bounds.h"
#include "structures/collision/mixed_tiles.h"
#include "structures/collision/pair_sums.h"
#include "structures/collision/separation_proof.h"
#include "structures/parts/slots.h"

namespace kinex {

class SeparationMixed final : public SeparationProof {
 public:
  enum Kind : std::uint8_t {
    kSide = CollisionEvent::kFirstOwn,  // the point has crossed a side
    kFlip,  // an order of normals failed: the two tiles about it are divided anew
    kCell,  // the point moved between half-planes, into the boxes or out of them
  };
  // The bound on the signs of one failure, term by term. A descent takes at most two signs at each
  // level of one polygon. kSigns:
  //   1 + 2  the certificate that failed, and its tile
  //   4      the choice between two sides that fail together
  //   1 + 5  the neighbour; edges without length (a vertex has at most two) and the descent's end
  //   2 + 1  at the boundary of M
  //   9      the certificates of the new tile and of a slide
  //   8      whether the bodies touch
  // kSignsOfTouch: 8 to see that the proof holds, 8 for its other certificates that touch zero, 8
  // to see whether the bodies rest; or, at a contact, a few orders of normals to find the edge of M
  // that is ahead.
  static constexpr std::int64_t kSignsPerLevel = 2, kSigns = 33, kSignsOfTouch = 24;

  // `of_sums`: by the hierarchies of the Minkowski sums, for bodies that do not turn against each
  // other.
  explicit SeparationMixed(PairTable& pairs, bool of_sums = false);

  bool start(PairId p, const Edge* left) override;
  Repair repair(PairId p, std::uint32_t slot) override;
  std::optional<Features> touch(PairId p, When when) override;
  void moved(PairId p) override;
  Roles describe(PairId p, ProofGroup& group) const override;
  std::uint32_t most_certificates() const override {
    return (sums_ ? 3 : MixedTiles::kMost) + (slides_ ? 2 : 0);
  }
  void handled(std::uint64_t signs) override;
  // Includes those of the hierarchies built (hierarchy_bounds.h).
  void add_bounds(const BoundContext& context, std::vector<BoundCheck>& checks) const override;
  std::size_t bytes() const override;

  // The tile of the pair; nullopt if the pair has none.
  std::optional<Tile> tile(ObjectId a, ObjectId b) const;

 private:
  // The two hierarchies of a pair.
  std::array<BodyFrame*, 2> frames_of(PairId p);
  MixedTiles tiles(PairId p);
  // The certificates of the tile and of a slide along its side; returns their number.
  using Proof = std::array<Query, BodyPair::kMostCertificates>;
  std::uint32_t prove(const MixedTiles& about, const Tile& tile, Proof& queries);
  void enter(PairId p, const MixedTiles& about, const Tile& tile);
  // The features of the two bodies that meet.
  Features features(PairId p, const MixedTiles::Move& contact);
  // "triangle: node 3 of a is cut, at node 2 of b"
  std::string tile_text(PairId p, const Tile& tile) const;
  std::string name() const { return sums_ ? "separation_minkowski" : "separation_mixed"; }

  PairTable& pairs_;
  Slots slots_;
  std::optional<PairSums> sums_;
  std::vector<Tile> tile_;  // per pair
  bool slides_ = false;     // a point has stayed on the line of a side of M
  // While a failure is handled: its level (nullopt if the point is located anew or there is no
  // tile), and whether the bodies touch.
  std::optional<int> level_;
  bool touches_ = false;
  WorstRatio signs_{kSigns, 0};  // of a failure
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// InnerTangents: collision detection by the two inner common tangents of two convex polygons: a
// baseline.
//
// State: for each tangent the vertices a of A and b of B that it touches. Along the first, from a
// to b, A lies on the left and B on the right; along the second the other way round.
//
//       .----.                .----.
//       | A   a.          . b'  B  |      first: from a to b
//       |    |   ' .  . '     |    |      second: from a' to b'
//       |   a'.  . '  ' .   . b    |
//       '----'                '----'
//
// Certificates: 4 for each tangent, the turns at a and at b towards their neighbours; 8 a pair.
// Events: a failure advances one vertex; when both tangents touch the same two vertices the bodies
// meet. (Seen from A, they are the tangents to the Minkowski sum from the point that B is.)
// Responsiveness: O(1). Efficiency: not separation-sensitive; one full turn at constant separation
// can cause Omega(n^2) events.
//
// Source: the classic separation proof by tangents; certificates and moves are worked out here.
#ifndef KINEX_STRUCTURES_COLLISION_INNER_TANGENTS_H
#define KINEX_STRUCTURES_COLLISION_INNER_TANGENTS_H

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "structures/collision/separation_proof.h"
#include "structures/parts/slots.h"

namespace kinex {

class InnerTangents final : public SeparationProof {
 public:
  enum Kind : std::uint8_t { kChange = CollisionEvent::kFirstOwn };  // of a vertex of a tangent

  explicit InnerTangents(PairTable& pairs)
      : pairs_(pairs), slots_(pairs.kernel(), pairs.id(), "inner tangents") {}

  // The vertices of the pair's tangents; nullopt if the pair has none.
  using Touch = std::array<std::uint32_t, 2>;  // a vertex of A, one of B'
  using Tangents = std::array<Touch, 2>;
  std::optional<Tangents> tangents(ObjectId a, ObjectId b) const;

  bool start(PairId p, const Edge* left) override;
  Repair repair(PairId p, std::uint32_t slot) override;
  std::optional<Features> touch(PairId p, When when) override;
  Roles describe(PairId p, ProofGroup& group) const override;
  std::uint32_t most_certificates() const override { return 8; }
  std::size_t bytes() const override { return tangents_.capacity() * sizeof(Tangents); }

 private:
  static Query claim(const SumBoundary& sum, const Tangents& tangents, std::uint32_t slot);
  static Edge beside(const SumBoundary& sum, const Touch& touch, bool forward) {
    return sum.beside(touch[0], touch[1], forward);
  }
  static bool is_vertex(const SumBoundary& sum, const Touch& touch);
  Touch on_boundary(const SumBoundary& sum, const Touch& touch);
  void enter(PairId p, const SumBoundary& sum, const Tangents& tangents);

  PairTable& pairs_;
  Slots slots_;
  std::vector<Tangents> tangents_;  // per pair
};

}  // namespace kinex

#endif

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
#include <string_view>
#include <vector>

#include "structures/collision/collision_pairs.h"
#include "structures/collision/sum_boundary.h"

namespace kinex {

class InnerTangents : public CollisionPairs {
 public:
  static constexpr std::uint8_t kChange = kFirstOwn;  // of a vertex of a tangent

  InnerTangents(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "inner_tangents"; }
  std::vector<std::string_view> event_kinds() const override;
  std::size_t bytes() const override;

  // The vertices of the pair's tangents, a < b; nullopt if the pair has none.
  using Touch = std::array<std::uint32_t, 2>;  // a vertex of A, one of B'
  using Tangents = std::array<Touch, 2>;
  std::optional<Tangents> tangents(ObjectId a, ObjectId b) const;

 protected:
  Roles describe(PairId p, ProofGroup& group) const override;
  bool start(PairId p) override;
  void fail(PairId p, std::uint32_t slot) override;
  std::optional<Features> touch(PairId p, When when) override;
  std::uint32_t most_certificates() const override { return 8; }

 private:
  static Query claim(const SumBoundary& sum, const Tangents& tangents, std::uint32_t slot);
  static SumBoundary::Edge beside(const SumBoundary& sum, const Touch& touch, bool forward);
  static bool is_vertex(const SumBoundary& sum, const Touch& touch);
  Touch on_boundary(const SumBoundary& sum, const Touch& touch);
  static bool is_along(const SumBoundary& sum, const SumBoundary::Edge& edge, bool forward);
  static Features at(const SumBoundary::Edge& edge);
  void enter(PairId p, const SumBoundary& sum, const Tangents& tangents);

  std::vector<Tangents> tangents_;  // per pair
};

}  // namespace kinex

#endif

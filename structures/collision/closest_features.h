// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestFeatures: collision detection by the pair of closest features (Lin and Canny), kinetised:
// a baseline.
//
// State: two vertices, or a vertex and an edge. With d from the feature of A to that of B:
//   vertex, vertex   4 certificates: d lies in both normal cones (2 each)
//   vertex, edge     5 certificates: the vertex projects into the edge (2); it is the support
//                    vertex of its polygon against the edge's normal (2); it lies outside the edge
//                    (1), which fails at contact
//
//     vertex, vertex           vertex, edge
//       \ cone /                  :  . v  :
//        \  y /                   : / \   :      v between the two lines across e,
//         \. /                  __:_______:__    on its outer side
//          x                          e
//
// An event is a change of the pair. Compactness: at most 5 certificates a pair. Responsiveness:
// O(1) signs and certificates. Efficiency: not separation-sensitive; one full turn at constant
// separation can cause Omega(n^2) events.
//
// Source: Lin and Canny, A fast algorithm for incremental distance calculation (1991); certificates
// and moves are worked out here.
#ifndef KINEX_STRUCTURES_COLLISION_CLOSEST_FEATURES_H
#define KINEX_STRUCTURES_COLLISION_CLOSEST_FEATURES_H

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "structures/collision/collision_pairs.h"
#include "structures/collision/sum_boundary.h"

namespace kinex {

class ClosestFeatures : public CollisionPairs {
 public:
  static constexpr std::uint8_t kChange = kFirstOwn;  // of the pair of features

  ClosestFeatures(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "closest_features"; }
  std::vector<std::string_view> event_kinds() const override;
  std::size_t bytes() const override;

 protected:
  Roles describe(PairId p, ProofGroup& group) const override;
  bool start(PairId p) override;
  void fail(PairId p, std::uint32_t slot) override;
  std::optional<Features> touch(PairId p, When when) override;
  std::uint32_t most_certificates() const override { return 5; }
  // An additional certificate in the slot after those of the features; nullopt: none.
  virtual std::optional<Query> extra(PairId p) {
    static_cast<void>(p);
    return std::nullopt;
  }
  std::uint32_t extra_slot(PairId p) const { return state_[p].edge ? 5 : 4; }
  // The certificate of this slot is the one that fails at contact.
  bool is_contact_slot(PairId p, std::uint32_t slot) const { return state_[p].edge && slot == 4; }

 private:
  // Vertices x of A and y of B' (edge = false), or edge `e` of polygon z and vertex `v` of the
  // other.
  struct State {
    bool edge = false;
    std::uint8_t z = 0;
    std::uint32_t e = 0, v = 0;  // vertices: of A, of B'
  };
  static Query claim(const SumBoundary& sum, const State& state, std::uint32_t slot);
  void enter(PairId p, const SumBoundary& sum, const State& state);
  // True if the point is on this edge of M.
  static bool is_along(const SumBoundary& sum, const SumBoundary::Edge& edge, bool forward);
  static Features at(const SumBoundary::Edge& edge);
  State next(const SumBoundary& sum, const State& state, std::uint32_t slot) const;

  std::vector<State> state_;  // per pair
};

}  // namespace kinex

#endif

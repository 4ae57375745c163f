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
#include <vector>

#include "structures/collision/separation_proof.h"
#include "structures/parts/slots.h"

namespace kinex {

class ClosestFeatures final : public SeparationProof {
 public:
  enum Kind : std::uint8_t { kChange = CollisionEvent::kFirstOwn };  // of the pair of features

  // `watch_discs`: one certificate more, that the discs about the bodies overlap.
  explicit ClosestFeatures(PairTable& pairs, bool watch_discs = false)
      : pairs_(pairs),
        slots_(pairs.kernel(), pairs.id(), "closest features"),
        watch_discs_(watch_discs) {}

  bool start(PairId p, const Edge* left) override;
  Repair repair(PairId p, std::uint32_t slot) override;
  std::optional<Features> touch(PairId p, When when) override;
  Roles describe(PairId p, ProofGroup& group) const override;
  std::uint32_t most_certificates() const override { return watch_discs_ ? 6 : 5; }
  std::size_t bytes() const override { return state_.capacity() * sizeof(State); }

  // The certificate of this slot is the one that fails at contact.
  bool is_contact_slot(PairId p, std::uint32_t slot) const { return state_[p].edge && slot == 4; }
  // It is the one about the discs, after those of the features.
  bool is_disc_slot(PairId p, std::uint32_t slot) const { return slot == (state_[p].edge ? 5 : 4); }

 private:
  // Vertices x of A and y of B' (edge = false), or edge `e` of polygon z and vertex `v` of the
  // other.
  struct State {
    bool edge = false;
    std::uint8_t z = 0;
    std::uint32_t e = 0, v = 0;  // vertices: of A, of B'
    Edge as_edge() const { return {z, e, v}; }
  };
  static Query claim(const SumBoundary& sum, const State& state, std::uint32_t slot);
  void enter(PairId p, const SumBoundary& sum, const State& state);
  State next(const SumBoundary& sum, const State& state, std::uint32_t slot) const;

  PairTable& pairs_;
  Slots slots_;
  bool watch_discs_;
  std::vector<State> state_;  // per pair
};

}  // namespace kinex

#endif

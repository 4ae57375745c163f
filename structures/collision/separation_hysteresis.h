// SPDX-License-Identifier: GPL-3.0-or-later
// SeparationHysteresis: collision detection by wedges that cannot fail before a constant fraction
// of the separation has been travelled (predicates/bodies/separating_wedge.h).
//
// A proof is a wedge of 3 certificates: a line of one body and two tangents of the other. Its role
// names the body of the line; here it is A:
//
//      ______ :            .-'  g1
//     /      \:         .-'  _____
//    |   A    :      v <    |  B  |     line with normal m; tangents with normals g1, g2
//     \______/:         '-.  -----      that meet at v
//             : m ->       '-.  g2
//
// When one fails, a new wedge is made for the present separation s, in the role that withstands
// more motion. It cannot fail before the bodies have moved by 0.23 s in the metric of its role
// (|dt| + rho_B |d theta| in A's frame, or |dt'| + rho_A |d theta| in that of B), hence not before
// they have moved that far in the larger of the two metrics. So the number of events is at most the
// number of pieces of the path, each inside a ball of that larger metric of radius 0.103 times the
// separation at its centre, however jagged the path. The choice of the role does not depend on
// which body is called A, except for rounding and for bodies that are alike. Where the bodies are
// so close that doubles find no wedge (2^-26 of their size), the pair of closest features takes
// over until they part: contacts are as exact as in the other structures.
//
// Compactness: 3 certificates a pair, 5 for closest features. Responsiveness: 3 certificates; the
// search for a wedge visits all vertices, in doubles.
// Source: the hysteresis property of Erickson, Guibas, Stolfi, Zhang (1999); the rest is worked out
// here.
#ifndef KINEX_STRUCTURES_COLLISION_SEPARATION_HYSTERESIS_H
#define KINEX_STRUCTURES_COLLISION_SEPARATION_HYSTERESIS_H

#include <cstdint>
#include <optional>
#include <vector>

#include "predicates/bodies/wedge_search.h"
#include "structures/collision/closest_features.h"
#include "structures/collision/separation_proof.h"
#include "structures/parts/slots.h"

namespace kinex {

class SeparationHysteresis final : public SeparationProof {
 public:
  enum Kind : std::uint8_t { kWedge = ClosestFeatures::kChange + 1 };  // a new wedge

  explicit SeparationHysteresis(PairTable& pairs)
      : pairs_(pairs),
        slots_(pairs.kernel(), pairs.id(), "wedges"),
        near_(pairs),
        search_(pairs.kernel(), pairs.frames(), pairs.predicates()) {}

  bool start(PairId p, const Edge* left) override;
  Repair repair(PairId p, std::uint32_t slot) override;
  // While a wedge holds the bodies are apart.
  std::optional<Features> touch(PairId p, When when) override {
    return has_wedge(p) ? std::nullopt : near_.touch(p, when);
  }
  Roles describe(PairId p, ProofGroup& group) const override;
  std::uint32_t most_certificates() const override { return near_.most_certificates(); }
  void add_bounds(const BoundContext& context, std::vector<BoundCheck>& checks) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  // The displacements at which wedges have failed. Failures after a change of motion count too.
  const WedgeSearch& search() const { return search_; }

 private:
  bool has_wedge(PairId p) const { return pairs_[p].part == &slots_; }
  WedgeSearch::Bodies bodies(PairId p) const { return {pairs_[p].a, pairs_[p].b, pairs_[p].pose}; }
  // True if a wedge that holds right after now is in place.
  bool put_wedge(PairId p);

  PairTable& pairs_;
  Slots slots_;
  ClosestFeatures near_;
  WedgeSearch search_;
  std::vector<WedgeSearch::Wedge> wedges_;  // per pair
};

}  // namespace kinex

#endif

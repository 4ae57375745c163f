// SPDX-License-Identifier: GPL-3.0-or-later
// DiscClaims: pairs of discs, each with a certificate that it meets, or that it is apart. A part of
// the structures disc_pairs_..; the owner says which pairs there are.
//
// Certificates. One a pair, +-disc_overlap: degree 2d for motions and radii of degree d. A failure
// is a change of the pair, and renews its certificate.
//
// Ties. A pair that touches identically meets.
#ifndef KINEX_STRUCTURES_PROXIMITY_DISC_CLAIMS_H
#define KINEX_STRUCTURES_PROXIMITY_DISC_CLAIMS_H

#include <vector>

#include "predicates/points/extent_predicates.h"
#include "structures/parts/pair_sides.h"

namespace kinex {

// Pairs: the smaller id first. Those that meet are on the positive side.
class DiscClaims : public PairSides {
 public:
  DiscClaims(Kernel& kernel, StructureId id, const Scene& scene)
      : PairSides(
            kernel, id, "pairs", "pair of discs",
            {.positive = {kernel.bind(make_disc_overlap(scene.dimension)), "they meet", "meeting"},
             .negative = {kernel.bind(make_disc_apart(scene.dimension)), "they are apart", "apart"},
             .tie = true}) {}

  // Those that meet, ascending, flattened.
  std::vector<ObjectId> meeting() const {
    std::vector<ObjectId> ids;
    each([&ids](const Pair& pair, bool meets) {
      if (meets) ids.insert(ids.end(), pair.begin(), pair.end());
    });
    return ids;
  }
  // All pairs, ascending.
  std::vector<Pair> pairs() const {
    std::vector<Pair> result;
    each([&result](const Pair& pair, bool) { result.push_back(pair); });
    return result;
  }
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// RecordedProofs: the proofs that a structure on pairs of bodies has held, as data: after every
// event the certificates of each pair, by slot, and where it has one the tile. What a certificate's
// lines and points are on the two polygons is found exactly, once, when it is first seen.
#ifndef KINEX_EXPERIMENTS_VIEW_RECORDED_PROOF_H
#define KINEX_EXPERIMENTS_VIEW_RECORDED_PROOF_H

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/rational.h"
#include "core/scene.h"
#include "experiments/view/frame_feature.h"
#include "structures/mixed_tiles.h"

namespace kinex {

// A derived object of the run, as it was when it was seen: one that was made into another constant
// is another entry.
struct RecordedThing {
  std::string name;
  std::vector<Rational> coordinates;  // of a constant
};

// A certificate of a pair. Its arguments are objects of the scene, or beyond those places in
// RecordedRun::things.
struct RecordedClaim {
  PredicateId predicate = 0;
  std::vector<ObjectId> arguments;
  // By argument: what a line or a point is on its polygon. The pose itself has none.
  std::vector<FrameFeature> features;
  friend bool operator==(const RecordedClaim&, const RecordedClaim&) = default;
};

struct PairProof {
  std::uint64_t event = 0;            // since when
  std::vector<std::uint32_t> claims;  // places in RecordedRun::claims, by slot; none: no proof
  std::optional<Tile> tile;
};

// Of one pair over the run, ascending in `event`; the first is what the recording began with.
struct PairHistory {
  ObjectId a = kNoObject, b = kNoObject;
  std::vector<PairProof> proofs;
};

// The proof after event `event`; nullptr: the pair was not there yet.
const PairProof* proof_after(const PairHistory& history, std::uint64_t event);

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// RecordedProofs: the proofs of a structure on pairs of bodies as data: after every event the
// certificates of each pair, by slot, and its tile, if it has one. The features of a certificate's
// lines and points on the two polygons are found exactly, once, when it is first seen.
#ifndef KINEX_EXPERIMENTS_VIEW_RECORDED_PROOF_H
#define KINEX_EXPERIMENTS_VIEW_RECORDED_PROOF_H

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/rational.h"
#include "experiments/view/frame_feature.h"
#include "structures/collision/mixed_tiles.h"

namespace kinex {

// A derived object of the run as first seen. An object that was redefined as another constant has
// another entry.
struct RecordedThing {
  std::string name;
  std::vector<Rational> coordinates;  // of a constant
};

// A certificate of a pair. Its arguments are objects of the scene, or beyond those places in
// RecordedRun::things.
struct RecordedClaim {
  PredicateId predicate = 0;
  std::vector<ObjectId> arguments;
  // By argument: the feature of a line or point on its polygon. The pose itself has none.
  std::vector<FrameFeature> features;
  friend bool operator==(const RecordedClaim&, const RecordedClaim&) = default;
};

struct PairProof {
  std::uint64_t event = 0;            // from this event on
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

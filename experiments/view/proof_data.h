// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the page's data that only scenes of bodies have:
//   "polygons"  [[[x, y], ..] per object] in the frames of the bodies, divided by "scale"
//   "things"    [[NAME, NUMBERS], ..], derived objects, numbered on from "ids"
//   in a run:
//   "claims"    [[PREDICATE, [ARGUMENTS], [FEATURE per argument]]]
//   "proofs"    [[[A, B, [[EVENT, [CLAIMS], TILE], ..]] per pair] per structure]
// with
//   NUMBERS  of a constant with three coordinates (a, b, c): a line's [a/s, b/s, c/s/scale] with s
//            the larger of |a| and |b|, and a point's [a/c/scale, b/c/scale]; null if it is none
//   FEATURE  0 or [KIND, FIRST, LAST], kinds as in frame_feature.h: "vertex", "edge", "across",
//            "corner", "support"
//   TILE     0 or [KIND, X, V, OTHER], as in structures/collision/mixed_tiles.h
#ifndef KINEX_EXPERIMENTS_VIEW_PROOF_DATA_H
#define KINEX_EXPERIMENTS_VIEW_PROOF_DATA_H

#include <vector>

#include "experiments/json_writer.h"
#include "experiments/view/recorded_run.h"

namespace kinex {

// One numbering of the derived objects of several runs: equal names are one object.
class ShownThings {
 public:
  explicit ShownThings(const std::vector<RecordedRun>& runs);
  // The number on the page of an object that a run has recorded.
  ObjectId shown(std::size_t run, ObjectId id) const {
    return id < objects_ ? id : shown_[run][id - objects_];
  }
  void write(JsonWriter& json, const Rational& scale) const;

 private:
  std::size_t objects_;
  std::vector<const RecordedThing*> things_;
  std::vector<std::vector<ObjectId>> shown_;  // per run
};

void write_proofs(JsonWriter& json, const RecordedRun& run, std::size_t index,
                  const ShownThings& things);

}  // namespace kinex

#endif

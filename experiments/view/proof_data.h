// SPDX-License-Identifier: GPL-3.0-or-later
// The members about bodies and proofs in the data of the page of `kinex view` (page_data.h). Beside
// "motions", in scenes of bodies:
//   "polygons"  [[[x, y], ..] per object], in the frames of the bodies, divided by "scale"
// and in scenes of bodies, or if a run has derived objects:
//   "things"    [[NAME, NUMBERS, PART], ..], the derived objects, numbered on after "ids"
// In every run:
//   "forms"   [[FIGURE, SIGN, SAYS, DIRECTION, [[ROLE, KIND, FRAME] per argument]] per predicate],
//             as in core/arithmetic/claim_form.h; DIRECTION: 0, or numbers of which the largest
//             absolute value is 1
//   "claims"  [[PREDICATE, [ARGUMENTS], [FEATURE per argument]]]
//   "proofs"  [{"reads": STRUCTURE or null, "ends": EVENT or null, "roles": [TEXT],
//               "certificates": [[GROUP, SLOT, ROLE, CLAIM, FAILURE]],
//               "groups": [[GROUP, KIND, [ABOUT], TEXT, PLACE, PARENT, BRANCH, [MARK]]],
//               "changes": [[EVENT, [GONE], [CAME], [STATES], [ENDED]]]} per structure]
//             as in recorded_proof.h: GONE and CAME are indices into "certificates", STATES
//             indices into "groups", ENDED numbers of groups; "ends": the proof was too large to be
//             followed beyond this event
// where
//   NUMBERS  of a constant with three coordinates (a, b, c): five numbers, those of the line
//            a/s, b/s, c/s/scale, where s is the larger of |a| and |b|, and those of the point
//            a/c/scale, b/c/scale; of a constant with one coordinate: [c/scale]; of anything else:
//            0. A number that is not finite is null
//   PART     0 or ["vertex" or "edge", BODY, PLACE]: the feature that the derived object stands for
//   FEATURE  0 or [KIND, FIRST, LAST], kinds as in frame_feature.h: "vertex", "edge", "across",
//            "corner", "support"
//   FAILURE  0: never; -1: never, identically zero; -2: at the instant; [U]: at U; [U, 0]: not
//            before U
//   MARK     [SHAPE, NAME, ..], as in core/engine/proof.h; what follows depends on the shape:
//              "chain"            a list of objects
//              "join", "through"  two PARTs
//              "line"             a thing, and 0 or 1 for the first or the second body
//              "outline"          0 or 1 likewise, and a list of points [x, y]
#ifndef KINEX_EXPERIMENTS_VIEW_PROOF_DATA_H
#define KINEX_EXPERIMENTS_VIEW_PROOF_DATA_H

#include <vector>

#include "experiments/formats/json_writer.h"
#include "experiments/view/recorded_run.h"

namespace kinex::view {

// One numbering of the derived objects of several runs: objects of the same name are one.
class ShownThings {
 public:
  explicit ShownThings(const std::vector<RecordedRun>& runs);
  // The number on the page of an object that run number `run` has recorded.
  ObjectId shown(std::size_t run, ObjectId id) const {
    return id < objects_ ? id : shown_[run][id - objects_];
  }
  std::size_t size() const { return things_.size(); }
  // Writes "things".
  void write(formats::JsonWriter& json, const Rational& scale) const;

 private:
  std::size_t objects_;
  std::vector<const RecordedThing*> things_;
  std::vector<std::vector<ObjectId>> shown_;  // per run
};

// Writes the members of run number `index`. `span`: the time that one unit of U stands for;
// `scale`: the divisor of coordinates.
void write_proofs(formats::JsonWriter& json, const RecordedRun& run, std::size_t index,
                  const ShownThings& things, const Rational& span, const Rational& scale);

}  // namespace kinex::view

#endif

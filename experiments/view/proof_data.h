// SPDX-License-Identifier: GPL-3.0-or-later
// The proofs in the page's data. In scenes of bodies, or with derived objects:
//   "polygons"  [[[x, y], ..] per object] in the frames of the bodies, divided by "scale"
//   "things"    [[NAME, NUMBERS, PART], ..], derived objects, numbered on from "ids"
// In a run:
//   "forms"   [[FIGURE, SIGN, SAYS, DIRECTION, [[ROLE, KIND, FRAME] per argument]] per predicate],
//             as in core/arithmetic/claim_form.h; DIRECTION: 0, or numbers of which the largest
//             absolute value is 1
//   "claims"  [[PREDICATE, [ARGUMENTS], [FEATURE per argument]]]
//   "proofs"  [{"reads": STRUCTURE or null, "ends": EVENT or null, "roles": [TEXT],
//               "certificates": [[GROUP, SLOT, ROLE, CLAIM, FAILURE]],
//               "groups": [[GROUP, KIND, [ABOUT], TEXT, PLACE, PARENT, BRANCH, [MARK]]],
//               "changes": [[EVENT, [GONE], [CAME], [STATES], [ENDED]]]} per structure]
//             GONE and CAME are indices into "certificates", STATES indices into "groups", ENDED
//             numbers of groups, as in recorded_proof.h
// with
//   NUMBERS  of a constant with three coordinates (a, b, c): a line's [a/s, b/s, c/s/scale] with s
//            the larger of |a| and |b|, and a point's [a/c/scale, b/c/scale]; of a constant with
//            one: [c/scale]; 0 if it is neither, null for what is not a finite number
//   PART     0 or ["vertex" or "edge", BODY, PLACE]: the feature that it stands for
//   FEATURE  0 or [KIND, FIRST, LAST], kinds as in frame_feature.h: "vertex", "edge", "across",
//            "corner", "support"
//   FAILURE  0: never, -1: identically zero, -2: at the instant, [U]: at U, [U, 0]: not before U
//   MARK     [SHAPE, NAME, ..], as in core/engine/proof.h: "chain" and its objects, "join" or
//            "through" and two PARTs, "line", a thing and 0 or 1 for the first or second body,
//            "outline", 0 or 1, and points [x, y]
#ifndef KINEX_EXPERIMENTS_VIEW_PROOF_DATA_H
#define KINEX_EXPERIMENTS_VIEW_PROOF_DATA_H

#include <vector>

#include "experiments/formats/json_writer.h"
#include "experiments/view/recorded_run.h"

namespace kinex::view {

// One numbering of the derived objects of several runs: equal names are one object.
class ShownThings {
 public:
  explicit ShownThings(const std::vector<RecordedRun>& runs);
  // The number on the page of an object that a run has recorded.
  ObjectId shown(std::size_t run, ObjectId id) const {
    return id < objects_ ? id : shown_[run][id - objects_];
  }
  std::size_t size() const { return things_.size(); }
  void write(formats::JsonWriter& json, const Rational& scale) const;

 private:
  std::size_t objects_;
  std::vector<const RecordedThing*> things_;
  std::vector<std::vector<ObjectId>> shown_;  // per run
};

// `span`: the time that one unit of U stands for; `scale`: what coordinates are divided by.
void write_proofs(formats::JsonWriter& json, const RecordedRun& run, std::size_t index,
                  const ShownThings& things, const Rational& span, const Rational& scale);

}  // namespace kinex::view

#endif

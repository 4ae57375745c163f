// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the page of `kinex view`, as JSON.
//
// Combinatorial data, polynomials and instants are exact, as in the run. Doubles are for drawing
// only: times as u = (t - start) / span, and motions as polynomials in u, divided by one power of
// two so that no coefficient is above 1 (a scene may have coordinates of 2^5000).
//
// {"format": "kinex-view", "version": 1, "program": S,
//  "scene": {"name", "hash", "dimension", "weights": true if points have weights, "lines": [LINE, ..],
//            "colours": [NAME, ..], "colour_of": [PLACE among these or -1 per object] if some have colours},
//  "time": {"start": [TEXT, NUMBER], "span": NUMBER}, "scale": NUMBER,
//  "ids": [ID, ..], "motions": [[[FROM, TO, [[c0, c1, ..] per axis]], ..] per object],
//  "structures": [{"label", "name", "role", "shape", "width", "key", "kinds", "meanings",
//                  "directions": [[x, y] ..] of a structure that orders objects along vectors,
//                  "members": [..] the objects it is built from, if these are not all,
//                  "query": the object that it is about, if there is one,
//                  "own": how many of its kinds are its own; those behind them all structures have}],
//  "runs": [{"arithmetic", "exact", "before", "stopped", "predicates",
//     "u", "s", "k", "x", "ids", "certificates", "i", "p", "g": lists with one entry per event,
//     "instants": [[DECIMAL, POLYNOMIAL, ROOT, LOWER, UPPER]], "reasons": {EVENT: TEXT},
//     "differences": {EVENT: [[GONE], [CAME]]} of external events without a certificate, as in a log,
//     "states": [{"initial": [..], "changes": [[EVENT, PLACE, [REMOVED], [ADDED]]], "corrupt"}],
//     "queries": [{"u", "at": TEXT, "box": [[LOW, HIGH] per axis],
//                  "answers": [[STRUCTURE, [IDS], [[PLACE, [IDS]] per node], NODES]]}]}],
//  "divergence": EVENT or 0}
// An event has
//   "u"             its time
//   "s", "k", "x"   its structure, its kind (indices into "structures" and "kinds"), 1 if external
//   "ids"           its objects
//   "certificates"  0 or [PREDICATE, [ARGUMENTS]]
//   "i"             its index into "instants" less that of the event before
//   "p"             the certificate's polynomial, a list of coefficients as texts; 1 or -1 if it
//                   is that of the instant or its negation; 0 without a certificate
//   "g"             0, or the stages [FOUND, ORDERED] that its failure time needed (stage_watch.h)
// A query's PLACE is that of a node of a tree: 0 outside the box, 1 crossed by it, 2 inside it. NODES is how many the tree has looked
// at, as `kinex run` counts them: those below the nodes inside and in trees of nodes, too.
// In "instants" a POLYNOMIAL is a text, its coefficients with blanks between them, lowest first; an
// inexact instant is [DECIMAL]. Objects are numbers, indices into "ids". Where all ids of an event,
// or all that a change removes or adds, are arguments of the event's certificate, a text stands for
// them: the place of each among the arguments, one digit each. A body has four axes; its rotor is
// divided by a positive number of its own. Further members for bodies and proofs: proof_data.h.
// Readers: page/*.js.
#ifndef KINEX_EXPERIMENTS_VIEW_PAGE_DATA_H
#define KINEX_EXPERIMENTS_VIEW_PAGE_DATA_H

#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/view/recorded_run.h"

namespace kinex::view {

// `runs`: one run, or two of the same scene that start at the same time. `hash`: that of the scene.
std::string page_data(const Scene& scene, const std::string& hash,
                      const std::vector<RecordedRun>& runs);

}  // namespace kinex::view

#endif

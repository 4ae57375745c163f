// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the page of `kinex view`, as JSON.
//
// Combinatorics, polynomials and instants are exact, as in the run. Doubles are for drawing only:
// times as u = (t - start) / span, and motions as polynomials in u, divided by one power of two so
// that no coefficient is above 1 (a scene may have coordinates of 2^5000).
//
// {"format": "kinex-view", "version": 1, "program": S,
//  "scene": {"name", "hash", "dimension"},
//  "time": {"start": [TEXT, NUMBER], "span": NUMBER}, "scale": NUMBER,
//  "ids": [ID, ..], "motions": [[[FROM, TO, [[c0, c1, ..] per axis]], ..] per object],
//  "structures": [{"label", "name", "shape", "key", "kinds"}],
//  "runs": [{"arithmetic", "exact", "before", "stopped", "predicates",
//     "u", "s", "k", "x", "ids", "certificates", "i", "p", "g": an entry an event,
//     "instants": [[DECIMAL, POLYNOMIAL, ROOT, LOWER, UPPER]], "reasons": {EVENT: TEXT},
//     "states": [{"initial": [..], "changes": [[EVENT, PLACE, [REMOVED], [ADDED]]], "corrupt"}]}],
//  "divergence": EVENT or 0}
// "i" has the differences of consecutive indices into "instants"; a POLYNOMIAL there is its coefficients with
// blanks between them, lowest first. The ids of an event, and those that a change removes and adds, are
// a text where all of them are in the certificate of its event: their places there, a digit each.
// Objects are numbers, indices into "ids". A body has four axes; its rotor is divided by a number
// of its own. Further members for proofs and bodies: proof_data.h. Readers: page/*.js.
#ifndef KINEX_EXPERIMENTS_VIEW_PAGE_DATA_H
#define KINEX_EXPERIMENTS_VIEW_PAGE_DATA_H

#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/view/recorded_run.h"

namespace kinex::view {

// One run, or two of the same scene that start at the same time. `hash`: of the scene's file.
std::string page_data(const Scene& scene, const std::string& hash,
                      const std::vector<RecordedRun>& runs);

}  // namespace kinex::view

#endif

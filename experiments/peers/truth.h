// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answer to a query, for the motion actually given to the libraries.
//
// Without turns that motion is a scene of kinex, number by number. An angle that is linear in time
// is followed by rotors in pieces of at most 0.1 radians: in one of d radians the angle is off by
// 0.0042 d^3 at most. Body B, made larger or smaller by more than that can move any point, encloses
// the truth (unless only the pace of the turn matters, which decides no answer): if the larger one
// stays clear the bodies do, if the smaller one overlaps so do they, and the first time is between
// the two. All other cases are unknown.
//
// The answer comes from separation_mixed in `exact`. It is checked against the witness, which
// shares only polynomials and their roots with it, or, where that would take minutes, against
// separation_hysteresis (separation_minkowski without turns).
#ifndef KINEX_EXPERIMENTS_PEERS_TRUTH_H
#define KINEX_EXPERIMENTS_PEERS_TRUTH_H

#include <cstdint>
#include <optional>
#include <string>

#include "core/motion/scene.h"
#include "experiments/peers/case.h"

namespace kinex::peers {

enum class TruthKind : std::uint8_t { kApart, kTouch, kOverlap, kUnknown };

struct Truth {
  TruthKind kind = TruthKind::kUnknown;
  double earliest = 0, latest = 0;  // of the first overlap
  bool by_witness = false;          // checked by the witness
};

// The scene of a question; B's polygon is scaled by `scale`.
Scene scene_of(const PeerCase& question, const Rational& scale = 1);
// The same bodies as orbit_case, with one rotor for every quarter turn of the whole.
Scene orbit_scene(const PeerCase& orbit);

// Throws std::logic_error if the structure and its check disagree.
Truth find_truth(const PeerCase& question);

// The cost and the answer of a run of one structure.
struct OurRun {
  std::optional<double> contact;
  double build_seconds = 0, run_seconds = 0;
  std::uint64_t events = 0, polynomials = 0, roots = 0, signs = 0;
};
// `looks`: the number of times at which the run is stopped and queried.
OurRun run_ours(const Scene& scene, const std::string& structure, const std::string& arithmetic,
                int looks = 1);

}  // namespace kinex::peers

#endif

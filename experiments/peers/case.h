// SPDX-License-Identifier: GPL-3.0-or-later
// A query for all libraries: do two convex polygons overlap at some time of a motion, and when
// first? All numbers are binary64, so the input of a library is known exactly.
#ifndef KINEX_EXPERIMENTS_PEERS_CASE_H
#define KINEX_EXPERIMENTS_PEERS_CASE_H

#include <string>
#include <vector>

#include "experiments/peers/peer.h"

namespace kinex::peers {

struct PeerFrame {
  PeerPose a, b;
};

struct PeerCase {
  std::string family, name;
  PeerShape a, b;
  // Poses at equal distances in the time [0, 1]. In between centres and angles are linear in time.
  std::vector<PeerFrame> frames;

  // With all numbers rounded to the nearest floats.
  PeerCase as_float() const;
  PeerFrame at(double time) const;
  // The largest turn of a body between two frames.
  double largest_turn() const;
  bool turns() const { return largest_turn() > 0; }
  // Both turn equally and their centres rest: whether they meet does not depend on the speed.
  bool turns_alike() const;
  int vertices() const { return static_cast<int>(a.size() + b.size()); }
};

// The largest distance of a vertex from the origin of the frame.
double outer_radius(const PeerShape& shape);
// The radius of a disc about the origin that lies in the polygon.
double inner_radius(const PeerShape& shape);
// The distance of the polygons in these poses; if they overlap, minus the depth. In doubles.
double signed_distance(const PeerCase& question, const PeerFrame& frame);

// ---- families (cases.cpp)

PeerShape regular_shape(int n);
// B passes A on a straight line, vertex above vertex, `gap` above it; below 0: it overlaps it.
PeerCase line_case(int n, double gap);
// Both turn once, equally, so that B orbits A at the distance `gap`, in quarter turns.
PeerCase orbit_case(int n, double gap);
// B crosses A's upper part and turns by six radians, in `frames` equal steps.
PeerCase spin_case(int n, int steps);
// Random polygons of at most n vertices in random motion; they may meet.
PeerCase random_case(int n, int seed);
// B slides along A in contact with it, without overlap.
PeerCase touch_case(int n);
// Reported failures, one step each (corpus.cpp).
std::vector<PeerCase> corpus_cases();

}  // namespace kinex::peers

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Motions in doubles, for drawing: in u = (t - start) / span and divided by a power of two.
#ifndef KINEX_EXPERIMENTS_VIEW_DRAWN_MOTIONS_H
#define KINEX_EXPERIMENTS_VIEW_DRAWN_MOTIONS_H

#include <array>
#include <limits>
#include <vector>

#include "core/motion/scene.h"

namespace kinex::view {

struct DrawnPiece {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> coordinates;  // per axis, low degree first
};

struct DrawnMotions {
  std::vector<std::vector<DrawnPiece>> objects;
  std::vector<std::vector<std::array<double, 2>>> polygons;  // of bodies, in their frames
  double scale = 1;  // factor of the coordinates; +infinity beyond the doubles
  Rational exact_scale = Rational(1);
};

// Each rotor is divided by a positive number, which does not change the turn; slopes of lines are as
// they are. Pieces outside
// [start, start + span] are left out. Requires span > 0.
DrawnMotions drawn_motions(const Scene& scene, const Rational& start, const Rational& span);

}  // namespace kinex::view

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of lines: objects in linear motion, by their first coordinate.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_LINES_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_LINES_H

#include <vector>

#include "core/motion/scene.h"

namespace kinex::families {

struct Line {
  Rational value;  // at the start
  Rational slope;
};

// The lines by object; `negated`: value and slope are negated. Throws std::invalid_argument for a
// motion that is not linear, or has several pieces.
std::vector<Line> lines_of(const Scene& scene, bool negated);

}  // namespace kinex::families

#endif

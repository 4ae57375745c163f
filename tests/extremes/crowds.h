// SPDX-License-Identifier: GPL-3.0-or-later
// Large scenes with many events at one instant: generated, because they are too large for files.
//
//   pairs k=K              K pairs on a line, far apart, that meet at t = 1/2, at different speeds
//   curves k=K             K pairs whose differences are (t^2 - 2)(t^2 + j), j = 1 .. K, in -2 .. 2
//   pencil n=N             N lines through one point at t = 1/3
//   shear m=M              an M x M lattice that is sheared through the square one at t = 1
//   through n=N            N points in the plane, all at one place at t = 1/2
//   reflection n=N         N points in the plane, all on one line at t = 1/2, fixed along it
//   exchange n=N           pairs of points that meet at t = 1/2
//   touching-lattice m=M   M^2 points on a lattice at t = 1, at which they turn back
// and every workload of `kinex gen` with its own n.
#ifndef KINEX_TESTS_EXTREMES_CROWDS_H
#define KINEX_TESTS_EXTREMES_CROWDS_H

#include <string>

#include "core/motion/scene.h"

namespace kinex::extremes {

// "FAMILY LETTER=SIZE". Throws std::runtime_error for one that does not exist.
Scene make_crowd(const std::string& description);

}  // namespace kinex::extremes

#endif

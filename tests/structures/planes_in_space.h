// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of the plane, placed in planes of space, which may turn.
#ifndef KINEX_TESTS_STRUCTURES_PLANES_IN_SPACE_H
#define KINEX_TESTS_STRUCTURES_PLANES_IN_SPACE_H

#include <array>
#include <utility>
#include <vector>

#include "tests/structures/test_scenes.h"

namespace kinex::test {

using Coefficients = std::vector<Rational>;
// Where the axes of the plane go: a polynomial for each axis of space, of each axis of the plane.
using Turn = std::array<std::array<Coefficients, 3>, 2>;

inline const Turn kFlat{{{{{1}, {}, {}}}, {{{}, {1}, {}}}}};
inline const Turn kUpright{{{{{}, {1}, {}}}, {{{}, {}, {1}}}}};
inline const Turn kSideways{{{{{}, {}, {1}}}, {{{1}, {}, {}}}}};
// Perpendicular and equally long.
inline const Turn kOblique{{{{{1}, {2}, {2}}}, {{{2}, {1}, {-2}}}}};
// In the plane x + y + z = 0, stretched.
inline const Turn kStretched{{{{{1}, {-1}, {}}}, {{{}, {1}, {-1}}}}};
// (1 - t^2, 0, 2t) and (0, 1 + t^2, 0): upright on x and y at t = -1 and 1.
inline const Turn kTurning{{{{{1, 0, -1}, {}, {0, 2}}}, {{{}, {1, 0, 1}, {}}}}};

inline void add_product(Coefficients& sum, const Coefficients& a, const Coefficients& b) {
  if (a.empty() || b.empty()) return;
  if (sum.size() < a.size() + b.size() - 1) sum.resize(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) sum[i + j] += a[i] * b[j];
  }
}

// The scene of the plane, in space.
inline Scene in_space(Scene scene, const Turn& turn) {
  scene.dimension = 3;
  for (SceneObject& object : scene.objects) {
    for (auto& piece : object.motion.pieces) {
      std::vector<Coefficients> axes(3, Coefficients{0});
      for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          add_product(axes[axis], piece.trajectory.coordinates[k], turn[k][axis]);
        }
      }
      piece.trajectory = path(std::move(axes));
    }
  }
  return scene;
}

}  // namespace kinex::test

#endif

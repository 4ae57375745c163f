// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and runs for the tests of convex hulls.
#ifndef KINEX_TESTS_STRUCTURES_HULL_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_HULL_SUPPORT_H

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "structures/convex_hull_2.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {

// Start and destination (at t = 1) uniform in a square; `degree` 1 to 3.
inline Scene random_plane(int n, std::uint64_t seed, int degree = 1) {
  Random random(seed);
  const int unit = 1 << 20;
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int a = 0; a < 2; ++a) {
      std::vector<Rational> c{Rational(Integer(random.between(0, unit)), Integer(unit))};
      for (int k = 1; k <= degree; ++k) {
        c.push_back(Rational(Integer(random.between(-unit, unit)), Integer(unit)));
      }
      axes.push_back(std::move(c));
    }
    motions.push_back(path(std::move(axes)));
  }
  return scene_of(motions, 0, Rational(1));
}

// One run of one structure, audited at every event, and compared with `sturm`.
struct HullRun : Trial {
  explicit HullRun(const Scene& given, const std::string& structure = "convex_hull_2",
                   const std::string& arithmetic = "exact", AuditLevel audit = AuditLevel::kEvents)
      : HullRun(std::make_unique<Scene>(given), structure, arithmetic, audit) {}
  const ConvexHull2& hull() { return dynamic_cast<const ConvexHull2&>(simulator.structure(0)); }

 private:
  HullRun(std::unique_ptr<Scene> scene, const std::string& structure, const std::string& arithmetic,
          AuditLevel audit)
      : Trial(*scene, structure, arithmetic, audit), scene_(std::move(scene)) {}
  std::unique_ptr<Scene> scene_;
};

}  // namespace kinex::test

#endif

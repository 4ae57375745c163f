// SPDX-License-Identifier: GPL-3.0-or-later
// The closing audit may look beyond the end of a scene, at positions where all certificates hold again although triangles have
// turned over in between: they prove nothing there.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "structures/plan.h"
#include "structures/registry.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace after_the_end_test {

Rational ratio(int a, int b) { return Rational(Integer(a), Integer(b)); }

// The point w passes through the edge ab before d does, both long after the end: then w is in the lower of the two triangles at
// ab, which have turned over.
Scene plane() {
  return scene_of({path({{-1}, {0}}), path({{1}, {0}}), path({{0}, {2}}),
                   path({{0}, {-3, ratio(29, 10)}}), path({{0}, {ratio(1, 2), ratio(-8, 10)}})},
                  0, ratio(1, 100));
}

// The same of cells.
Scene space() {
  const Rational x = ratio(-1, 12);
  Scene scene = scene_of(
      {path({{1}, {0}, {0}}), path({{ratio(-1, 2)}, {1}, {0}}), path({{ratio(-1, 2)}, {-1}, {0}}),
       path({{x}, {0}, {2}}), path({{x}, {0}, {-3, ratio(29, 10)}}),
       path({{x}, {0}, {ratio(1, 2), ratio(-8, 10)}})},
      0, ratio(1, 100));
  scene.dimension = 3;
  return scene;
}

// After the end the points are spread over many times the box of the scene: two in one cell of its grid may be
// farther apart than two in distant cells.
Scene beyond_the_box() {
  return scene_of({path({{0}, {0}}), path({{61}, {0}}), path({{62, 100}, {0}}),
                   path({{64, 300}, {0}}), path({{67, 900}, {0}})},
                  0, ratio(1, 100));
}

// A pentagon that becomes a pentagram of the same left turns: each corner goes to twice its angle.
Scene pentagram() {
  return scene_of({path({{10, 0}, {0, 0}}), path({{3, -11}, {9, -3}}), path({{-8, 11}, {6, -15}}),
                   path({{-8, 11}, {-6, 15}}), path({{3, -11}, {-9, 3}})},
                  0, ratio(1, 100));
}

// After the end one disc is larger than a cell of the grid: it meets discs that are several columns away.
Scene larger_than_a_cell() {
  Scene scene = scene_of({path({{0}, {0}, {1, 100}}), path({{60}, {0}, {1}}),
                          path({{61}, {3}, {1}}), path({{63}, {0}, {1}}), path({{65}, {3}, {1}})},
                         0, ratio(1, 100));
  scene.dimension = 2;
  scene.extents = Extents::kRadius;
  return scene;
}

TEST(AfterTheEnd, CertificatesThatHoldAgainProveNothing) {
  int runs = 0;
  for (const Scene& base :
       {plane(), space(), beyond_the_box(), pentagram(), larger_than_a_cell()}) {
    for (const StructureInfo& info : structure_infos()) {
      if (refusal_of(info, base)) continue;
      Scene scene = base;
      scene.maintain = {{std::string(info.name), std::string(info.name), {}}};
      Simulator simulator(scene, planned_arithmetic("exact", scene),
                          Trial::options(AuditLevel::kEnd));
      add_structures(simulator, scene);
      simulator.start();
      EXPECT_EQ(simulator.run_until(std::nullopt), RunStatus::kDone);
      EXPECT_EQ(simulator.violations(), std::vector<std::string>{})
          << info.name << " of " << scene.dimension << " axes";
      ++runs;
    }
  }
  EXPECT_GT(runs, 50);
}

}  // namespace after_the_end_test
}  // namespace kinex::test

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

TEST(AfterTheEnd, CertificatesThatHoldAgainProveNothing) {
  int runs = 0;
  for (const Scene& base : {plane(), space()}) {
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

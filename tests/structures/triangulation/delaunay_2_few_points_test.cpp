// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2 with at most three points, and the reasons of its rebuilds.
#include <gtest/gtest.h>

#include "tests/structures/triangulation/delaunay_2_support.h"

namespace kinex::delaunay_2_test {
namespace delaunay_2_few_points_test {

// The audit after every event compares with CGAL; the run itself must not need a rebuild.
TEST(Delaunay2FewPoints, ComeAndGoWithoutARebuild) {
  World world(scene_of({integers(0, 1, 0, 0), integers(6, 0, 0, 1), integers(0, 0, 6, 1)}, 0, 20));
  world.start();
  world.erase(1, 2);
  world.update(2, 0, integers(4, -1, -4, 2));
  world.erase(3, 1);
  world.insert(4, 1, integers(0, 1, 0, 2));
  world.erase(5, 0);
  world.erase(6, 1);
  world.insert(7, 1, integers(0, 0, 0, 0));
  world.insert(8, 2, integers(1, 0, 1, 0));
  world.insert(9, 0, integers(2, 0, 5, 0));
  world.run_until(20);
  world.expect_clean();
  EXPECT_EQ(world.ledger().rebuilds, 0u);
  EXPECT_FALSE(world.structure().on_line());
}

TEST(Delaunay2FewPoints, TwoThatBecomeOneAreAnEvent) {
  World world(scene_of({integers(0, 1, 0, 1), integers(4, 0, 4, 0)}, 0, 9));
  world.start();
  EXPECT_EQ(world.structure().attribute().ids.size(), 2u);
  world.update(4, 0, integers(4, 0, 4, 0));
  world.run_until(5);
  EXPECT_EQ(world.structure().representative(1), 0u);
  EXPECT_TRUE(world.structure().attribute().ids.empty());
  ASSERT_FALSE(world.recorder.events.empty());
  EXPECT_TRUE(world.recorder.events.back().external);
  world.update(6, 1, integers(-2, 1, 4, 0));
  world.run_until(7);
  EXPECT_EQ(world.structure().attribute().ids.size(), 2u);
  world.expect_clean();
}

TEST(Delaunay2FewPoints, ThreeThroughTheirLineAreARebuildWithAReason) {
  World world(scene_of({integers(0, 0, 0, 0), integers(4, 0, 0, 0), integers(2, 0, 2, -1)}, 0, 4));
  world.run();
  world.expect_clean();
  EXPECT_EQ(world.ledger().rebuilds, 1u);
  const auto& reasons = world.ledger().rebuild_reasons;
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons.begin()->first, "the only three points pass through one line");
}

TEST(Delaunay2FewPoints, FourOnALineAreCounted) {
  World world(scene_of(
      {integers(0, 0, 0, 0), integers(1, 0, 0, 0), integers(2, 0, 0, 0), integers(3, 0, 0, 0)}, 0,
      4));
  world.start();
  world.update(1, 2, integers(1, 1, 0, 0));
  world.run_until(4);
  world.expect_clean();
  EXPECT_EQ(world.ledger().rebuilds, 1u);
}

// The edges and the neighbours on a line are two parts, of which one is empty.
TEST(Delaunay2FewPoints, TheLineHasALedgerLineOfItsOwn) {
  World world(scene_of({integers(0, 1, 0, 0), integers(3, 0, 0, 0), integers(5, 0, 0, 0)}, 0, 9));
  world.start();
  const auto& parts = world.ledger().parts;
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].name, "edges");
  EXPECT_EQ(parts[1].name, "line");
  world.run_until(6);
  EXPECT_EQ(parts[1].failures, 2u);
  EXPECT_EQ(parts[1].live, 2u);
  EXPECT_EQ(parts[0].created, 0u);
  EXPECT_EQ(world.structure().hull(), (std::vector<ObjectId>{1, 2, 0}));
  EXPECT_EQ(world.structure().around(2), (std::vector<ObjectId>{1, 0}));
  world.update(7, 2, integers(5, 0, -7, 1));
  world.run_until(9);
  world.expect_clean();
  EXPECT_EQ(parts[1].live, 0u);
  EXPECT_EQ(parts[0].live, 6u);
}

}  // namespace delaunay_2_few_points_test
}  // namespace kinex::delaunay_2_test

// SPDX-License-Identifier: GPL-3.0-or-later
// emst_cycles against emst_list: cycles that lose an edge, that belong to another edge, or are joined,
// and what becomes of the tree. Every run is audited after every instant: the invariants compare each
// cycle and its certificates (TreeByShortCycles::check), and the tree is that of all pairs.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace short_cycles_test {

using Ids = std::vector<ObjectId>;

struct Pair : TwinRun {
  explicit Pair(Scene given, const std::string& arithmetic = "exact")
      : TwinRun(std::move(given), {ask("emst_list"), ask("emst_cycles")}, arithmetic) {}
  const StructureLedger& cycles() const { return ledger(1); }
  std::size_t lines(const std::string& text) const {
    std::size_t count = 0;
    for (const std::string& line : sink.log.lines) count += line.find(text) != std::string::npos ? 1 : 0;
    return count;
  }
};

Scene in_plane(std::vector<Trajectory> points, const Rational& end) {
  Scene scene = scene_of(std::move(points), 0, end);
  scene.dimension = 2;
  return scene;
}

// The triangle 0, 1, 2: |02| grows beyond |01|, an edge outside the tree that takes its place.
TEST(ShortCycles, ATriangleChangesTheTree) {
  const Pair run(in_plane({path({{0}, {0}}), path({{0}, {10}}), path({{3}, {8, 1}})}, Rational(3)));
  EXPECT_EQ(run.begins_with, (Ids{0, 2, 1, 2}));
  EXPECT_EQ(run.attribute(1), (Ids{0, 1, 1, 2}));
  EXPECT_EQ(run.cycles().external, 1u);
  EXPECT_EQ(run.cycles().failures, 1u);
  EXPECT_EQ(run.cycles().max_live, 2u);
}

// The edge 01 is the longest of 0, 1, 2 until 02 is longer; both stay outside the tree 03, 23, 12.
//
//        1---2      02 is the longest of 0, 2, 3 (the angle at 3 is obtuse) before and after, so the
//        |  / .     cycle of 01 becomes 0, 3, 2, 1
//        | /   3
//        0  '
Scene two_triangles(const Trajectory& three) {
  return in_plane({path({{0}, {0}}), path({{0}, {100}}), path({{20}, {97, 2}}), three},
                  Rational(3, 2));
}

TEST(ShortCycles, ATriangleGivesWayToALongerCycle) {
  const Pair run(two_triangles(path({{58}, {40}})));
  EXPECT_EQ(run.begins_with, (Ids{0, 3, 1, 2, 2, 3}));
  EXPECT_EQ(run.attribute(1), run.begins_with);
  EXPECT_EQ(run.cycles().external, 0u);
  EXPECT_EQ(run.cycles().failures, 1u);
  EXPECT_EQ(run.cycles().max_live, 5u);  // 01 has three, 02 has two
}

// The same, with a point 3 that moves through the circle of the others before: 02 gives way to 13, and
// stays in the cycle of 01 until it is longer.
TEST(ShortCycles, AnEdgeOfACycleLeavesTheGraph) {
  const Pair run(two_triangles(path({{58, -20}, {40}})));
  EXPECT_EQ(run.simulator.ledger(0).external, 1u);
  EXPECT_EQ(run.cycles().external, 0u);
  EXPECT_EQ(run.cycles().failures, 1u);
  EXPECT_EQ(run.attribute(1), (Ids{0, 3, 1, 2, 2, 3}));
}

// Points of {0, 1, 2}^2 with velocities in {-1, 0, 1}^2: ties, and several failures at most instants.
void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0, internal = 0, ties = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const Pair run(lattice_scene(seed, 5 + static_cast<int>(seed % 6), 2));
    external += run.cycles().external;
    internal += run.cycles().internal;
    ties += run.lines("tie");
  }
  EXPECT_GT(external, test::seen_in_fewer(seeds));
  EXPECT_GT(internal, test::seen_in_fewer(seeds) / 4);
  EXPECT_GT(ties, 0u);
}

TEST(ShortCycles, TinyLattices) { on_lattices(300); }

// Instants at which several lengths become equal, so that each of two edges is in the cycle of the other:
// that of one was made before the instant, that of the other at it. When they exchange their cycles,
// no edge may be in its own.
TEST(ShortCycles, TwoEdgesInEachOthersCycles) {
  const std::pair<std::uint64_t, int> scenes[] = {{20101, 5}, {21363, 6}, {22192, 5}, {20603, 9},
                                                  {20750, 8}, {21073, 8}, {21571, 9}};
  for (const auto& [seed, n] : scenes) {
    SCOPED_TRACE(seed);
    const Pair run(lattice_scene(seed, n, 2));
    EXPECT_GT(run.cycles().internal, 0u);
  }
}

// A pair that has left the graph is as long as the two edges of a failure at that instant, and shorter than
// they are before and after it, so none of its certificates fails; but the failing edge of the tree was on
// its path, and not on that of the owner.
TEST(ShortCycles, APairThatHasLeftIsLevelForAnInstant) {
  const Pair run(lattice_scene(385, 5, 2));
  EXPECT_EQ(run.cycles().external, 4u);
  EXPECT_EQ(run.cycles().rebuilds, 0u);
}

TEST(SlowShortCycles, TinyLattices) { on_lattices(600); }

// Points come, go, jump and change their motions.
TEST(ShortCycles, PointsComeAndGo) {
  std::uint64_t internal = 0, updates = 0;
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 2u : 12u); ++seed) {
    SCOPED_TRACE(seed);
    const Pair run(random_flights(seed, 14, 2, 1, true));
    internal += run.cycles().internal;
    updates += run.cycles().motion_updates + run.cycles().insertions + run.cycles().erasures;
  }
  EXPECT_GT(internal, kSanitized ? 5u : 50u);
  EXPECT_GT(updates, kSanitized ? 5u : 50u);
  Scene scene = in_plane({path({{0}, {0}}), path({{4}, {1}}), path({{9}, {3}}), path({{2}, {8}}),
                          path({{8, -1}, {2}}), path({{0, 1}, {2}}), path({{5}, {5, -1}})},
                         Rational(8));
  jump(scene, 2, 1, path({{2}, {7}}));
  jump(scene, 0, 3, path({{11}, {7}}));
  const Pair jumps(scene);
  EXPECT_GT(jumps.cycles().external, 0u);
}

TEST(ShortCycles, AFewCertificatesAPoint) {
  const Scene scene = TwinRun::asking(random_flights(3, 100, 2, 1, false), {ask("emst_cycles")});
  Simulator simulator(scene, planned_arithmetic("exact", scene), Trial::options(AuditLevel::kNone));
  add_structures(simulator, scene);
  simulator.start();
  simulator.run_until(std::nullopt);
  const StructureLedger& ledger = simulator.ledger(1);
  EXPECT_GT(ledger.external, 100u);
  EXPECT_GT(ledger.max_live, 300u);  // at least two for each of nearly 2n edges outside the tree
  EXPECT_LT(ledger.max_live, 600u);  // the paths of the tree have thousands
}

TEST(ShortCycles, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(3u); ++seed) {
      const Pair flights(random_flights(seed, 12, 2, 1, seed % 2 == 0), arithmetic);
      const Pair lattice(lattice_scene(seed, 9, 2), arithmetic);
      for (const Pair* run : {&flights, &lattice}) {
        EXPECT_TRUE(run->cycles().corrupt || run->attribute(1).size() <= 2u * 11u) << arithmetic;
      }
    }
  }
}

}  // namespace short_cycles_test
}  // namespace kinex::test

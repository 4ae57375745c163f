// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: counts found by brute force, tiny lattices, worst cases.
#include <algorithm>
#include <functional>
#include <tuple>

#include "tests/sanitized.h"
#include "tests/structures/triangulation/regular_support.h"

namespace kinex::regular_test {
namespace regular_2_test {

using World = RegularWorld<Regular2>;
using test::path;
using test::reference_scene;

TEST(Regular2, ReferenceCounts) {
  struct Row {
    int n;
    std::uint64_t seed;
    bool linear;
    std::uint64_t flips, hull_flips, inner_show, hull_show, inner_hide, hull_hide;
  };
  for (const Row& row : {Row{8, 1, false, 8, 6, 3, 1, 3, 0}, Row{10, 2, false, 18, 10, 4, 0, 3, 0},
                         Row{8, 1, true, 9, 7, 3, 1, 2, 2}, Row{10, 2, true, 27, 18, 2, 2, 3, 1}}) {
    SCOPED_TRACE(std::to_string(row.n) + (row.linear ? ", linear" : ", constant"));
    const Scene scene = weighted_reference(row.n, row.seed, row.linear);
    World world(scene), sturm(scene, "sturm");
    world.run().expect_clean();
    sturm.run().expect_clean();
    std::uint64_t hull_show = 0, hull_hide = 0;
    for (const std::string& line : world.lines()) {
      const auto blanks = std::count(line.begin(), line.end(), ' ');  // before three ids and "!"
      hull_show += line.find("show") == 0 && blanks == 4;
      hull_hide += line.find("hide") == 0 && blanks == 4;
    }
    EXPECT_EQ(world.count("flip"), row.flips);
    EXPECT_EQ(world.count("enter") + world.count("leave"), row.hull_flips);
    EXPECT_EQ(world.count("show"), row.inner_show + row.hull_show);
    EXPECT_EQ(world.count("hide"), row.inner_hide + row.hull_hide);
    EXPECT_EQ(hull_show, row.hull_show);
    EXPECT_EQ(hull_hide, row.hull_hide);
    EXPECT_EQ(world.count("retile") + world.count("blocked"), 0u);
    EXPECT_EQ(world.lines(), sturm.lines());
  }
}

// Points of {0, 1, 2}^2 with weights in 0 .. 4 and velocities in {-1, 0, 1}: most instants are
// degenerate.
void tiny_lattices(std::uint64_t first, std::uint64_t last, bool moving) {
  for (std::uint64_t seed = first; seed < first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = weighted_lattice(seed, 5 + static_cast<int>(seed % 5), moving);
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.cells(), static_cells<Regular2>(scene, *scene.end));
  }
}
TEST(Regular2, TinyLattices) { tiny_lattices(0, 60, false); }
TEST(Regular2, TinyLatticesOfMovingWeights) { tiny_lattices(0, 40, true); }
TEST(SlowRegular2, TinyLattices) { tiny_lattices(60, 500, false); }
TEST(SlowRegular2, TinyLatticesOfMovingWeights) { tiny_lattices(40, 500, true); }

// P4: light points pass under a strip of heavy ones, and show next to its circumcentres.
TEST(Regular2, ShowAndHide) {
  for (const auto& [m, n, events] :
       {std::tuple(2, 1, 4u), std::tuple(2, 2, 8u), std::tuple(3, 2, 16u)}) {
    SCOPED_TRACE(std::to_string(m) + ", " + std::to_string(n));
    const Rational heavy = fraction(3, 2) - fraction(1, 64 * n * n);
    std::vector<Trajectory> motions;
    for (int j = 0; j < m; ++j) {
      motions.push_back(path({{2 * j}, {1}, {heavy}}));
      motions.push_back(path({{2 * j + 1}, {-1}, {heavy}}));
    }
    for (int i = 0; i < n; ++i) {
      motions.push_back(path({{fraction(1, 2) + fraction(2 * i + 1, 4 * n), 1}, {0}, {0}}));
    }
    const Scene scene = weighted_scene(motions, 0, Rational(2 * m) - fraction(5, 2));
    World world(scene), sturm(scene, "sturm");
    world.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(world.lines(), sturm.lines());
    EXPECT_EQ(world.ledger().external, events);
    EXPECT_EQ(world.count("show"), events / 2);
    EXPECT_EQ(world.count("hide"), events / 2);
  }
}

// P5: the weight of a point in a triangle crosses the value at which it shows k times.
TEST(Regular2, Breathing) {
  for (const int k : {1, 2, 5, 8}) {
    SCOPED_TRACE(k);
    const Coefficients weight = crossing_weight(k, -13);  // the height 5 + 13 is that of the plane
    const Scene scene = weighted_scene({path({{0}, {0}, {0}}), path({{6}, {0}, {0}}),
                                        path({{0}, {6}, {0}}), path({{2}, {1}, weight})},
                                       0, Rational(k + 1));
    World world(scene), sturm(scene, "sturm");
    world.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(world.lines(), sturm.lines());
    ASSERT_EQ(world.lines().size(), static_cast<std::size_t>(k));
    for (int i = 0; i < k; ++i) {
      const char* const kind = (k - i) % 2 == 0 ? "hide 3 0 1 2 !" : "show 3 0 1 2 !";
      EXPECT_EQ(world.lines()[static_cast<std::size_t>(i)], kind);
    }
    EXPECT_EQ(world.ledger().external, static_cast<std::uint64_t>(k));
  }
}

// Equal weights give the flips of the Delaunay triangulation, counted by brute force; one polynomial
// added to all weights changes nothing.
TEST(Regular2, EqualWeightsAreNone) {
  struct Row {
    int n;
    std::uint64_t seed, inner, hull;
  };
  for (const Row& row :
       {Row{6, 1, 10, 8}, Row{8, 1, 17, 8}, Row{10, 2, 34, 12}, Row{12, 3, 29, 5}}) {
    SCOPED_TRACE(row.n);
    Scene scene = reference_scene(row.n, 2, row.seed);
    World plain(scene);
    plain.run().expect_clean();
    scene.extents = Extents::kWeight;
    for (SceneObject& object : scene.objects) {
      object.motion.pieces[0].trajectory.coordinates.push_back({7, -5, 3});
    }
    World equal(scene);
    equal.run().expect_clean();
    EXPECT_EQ(equal.count("flip"), row.inner);
    EXPECT_EQ(equal.count("enter") + equal.count("leave"), row.hull);
    EXPECT_EQ(equal.ledger().external, row.inner + row.hull);
    EXPECT_EQ(equal.lines(), plain.lines());
  }
  for (const bool linear : {false, true}) {
    const Scene scene = weighted_reference(8, 1, linear);
    Scene raised = scene;
    for (SceneObject& object : raised.objects) {
      Coefficients& weight = object.motion.pieces[0].trajectory.coordinates[2];
      weight.resize(4);
      for (const auto& [k, c] : {std::pair(0, -900), std::pair(1, 70), std::pair(3, 2)}) {
        weight[static_cast<std::size_t>(k)] += Rational(c);
      }
    }
    World before(scene), after(raised);
    before.run();
    after.run().expect_clean();
    EXPECT_EQ(before.lines(), after.lines());
  }
}

// A motion added to all points, or the reverse of time, changes the instants only.
TEST(Regular2, CommonMotionAndReversedTime) {
  for (const bool linear : {false, true}) {
    const Scene scene = weighted_reference(8, 1, linear);
    Scene carried = scene, reversed = scene;
    for (SceneObject& object : carried.objects) {
      auto& axes = object.motion.pieces[0].trajectory.coordinates;
      for (Coefficients& axis : {std::ref(axes[0]), std::ref(axes[1])}) axis.resize(3);
      axes[0][1] += Rational(3);
      axes[0][2] -= Rational(1);
      axes[1][2] += Rational(2);
    }
    for (SceneObject& object : reversed.objects) {  // 10 - t in the place of t
      for (Coefficients& axis : object.motion.pieces[0].trajectory.coordinates) {
        axis.resize(2);
        axis = {axis[0] + Rational(10) * axis[1], -axis[1]};
      }
      object.motion.pieces[0].trajectory.normalise();
    }
    World world(scene), with(carried), back(reversed);
    std::vector<std::vector<ObjectId>> values, last;
    for (int i = 0; i < 40; ++i) {
      world.run_until(fraction(2 * i + 1, 8));
      back.run_until(fraction(2 * i + 1, 8));
      values.push_back(world.cells());
      last.push_back(back.cells());
    }
    std::reverse(last.begin(), last.end());
    EXPECT_EQ(values, last);
    world.run().expect_clean();
    with.run().expect_clean();
    back.run().expect_clean();
    EXPECT_EQ(world.lines(), with.lines());
    EXPECT_EQ(world.count("flip"), back.count("flip"));
    EXPECT_EQ(world.count("enter"), back.count("leave"));
    EXPECT_EQ(world.count("show"), back.count("hide"));
    EXPECT_EQ(world.count("hide"), back.count("show"));
  }
}

// Discs have the squares of their radii as weights.
TEST(Regular2, Discs) {
  Scene weights = weighted_reference(8, 1, false), discs = weights;
  discs.extents = Extents::kRadius;
  for (std::size_t i = 0; i < weights.objects.size(); ++i) {
    const Rational radius(static_cast<std::int64_t>(5 * i % 8));
    weights.objects[i].motion.pieces[0].trajectory.coordinates[2] = {radius * radius};
    discs.objects[i].motion.pieces[0].trajectory.coordinates[2] = {radius};
  }
  World one(weights), other(discs);
  one.run().expect_clean();
  other.run().expect_clean();
  EXPECT_EQ(one.lines(), other.lines());
  EXPECT_GT(one.lines().size(), 10u);
}

}  // namespace regular_2_test
}  // namespace kinex::regular_test

// SPDX-License-Identifier: GPL-3.0-or-later
// Spanning trees with vertices of many edges, by clusters, beside those by the list and by cycles.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {
namespace hub_trees_test {

std::vector<Request> engines(const std::string& group) {
  std::vector<Request> all{ask(group + "_list"), ask(group + "_cycles"), ask(group + "_clusters")};
  for (const int size : {1, 2, 3, 4}) all.push_back(ask(group + "_clusters", "cluster", size));
  return all;
}

std::vector<std::string> between(const std::string& a, int i, const std::string& b, int j) {
  return {a + std::to_string(i), b + std::to_string(j)};
}

// A wheel: a spoke from the hub to each of n vertices of a rim.
Scene as_wheel(Scene scene) {
  const int n = static_cast<int>(scene.objects.size()) / 2;
  for (int i = 0; i < n; ++i) {
    scene.objects[static_cast<std::size_t>(i)].ends = between("h", 0, "v", i);
    scene.objects[static_cast<std::size_t>(n + i)].ends = between("v", i, "v", (i + 1) % n);
  }
  return scene;
}

// Two hubs with spokes to the same n vertices, and an edge between each other's spokes.
Scene as_two_hubs(Scene scene) {
  const int n = static_cast<int>(scene.objects.size()) / 2;
  for (int i = 0; i < n; ++i) {
    scene.objects[static_cast<std::size_t>(i)].ends = between("h", 0, "v", i);
    scene.objects[static_cast<std::size_t>(n + i)].ends = between("h", 1, "v", i);
  }
  return scene;
}

// Edges between random vertices, most of them at the first ones.
Scene as_hub_graph(Scene scene, std::uint64_t seed, int vertices, int hubs) {
  Random random(seed);
  for (SceneObject& object : scene.objects) {
    const int hub = random.between(0, hubs - 1);
    const int u = random.chance(70) ? hub : random.between(0, vertices - 1);
    const int v = random.between(1, vertices - 1);
    object.ends = between("v", u, "v", (u + v) % vertices);
  }
  return scene;
}

// Weights in small integers: spokes near 0 and rising, others near 3 and falling.
Scene crossing_weights(std::uint64_t seed, int n) {
  Random random(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < 2 * n; ++i) {
    const int at = random.between(0, 20), by = random.between(0, 20);
    t.push_back(i < n ? path({{Rational(at), Rational(by)}})
                      : path({{Rational(60 + at), Rational(-by)}}));
  }
  return scene_of(t, 0, Rational(6));
}

std::uint64_t run_all(const Scene& scene) {
  const TwinRun run(scene, engines("graph_mst"));
  return run.ledger().external;
}

// Spokes leave the tree one by one, until the hub has few.
TEST(HubTrees, AWheel) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
    SCOPED_TRACE(seed);
    external += run_all(as_wheel(crossing_weights(seed, 14)));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::fewer(4u) * 5u);
}

// Leaves go from one hub to the other.
TEST(HubTrees, HubsChange) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
    SCOPED_TRACE(seed);
    external += run_all(as_two_hubs(crossing_weights(seed, 14)));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::fewer(4u) * 5u);
}

// Edges come, go, and change their motions; `sturm` agrees.
TEST(HubTrees, RandomGraphs) {
  std::uint64_t external = 0, sizes = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene flights = random_flights(seed, 32, 1, 1 + static_cast<int>(seed % 2), true);
    const Scene scene = seed % 4 == 0 ? as_wheel(flights) : as_hub_graph(flights, seed, 12, 2);
    const TwinRun run(scene, engines("graph_mst")), twin(scene, engines("graph_mst"), "sturm");
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
    external += run.ledger().external;
    sizes += run.ledger().insertions + run.ledger().erasures;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(8u));
  EXPECT_GT(sizes, test::seen_in_fewer(24u));
}

// Several hubs, and paths between them.
TEST(HubTrees, ManyVertices) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(3u); ++seed) {
    SCOPED_TRACE(seed);
    const int degree = 1 + static_cast<int>(seed % 3);
    external +=
        run_all(as_hub_graph(random_flights(seed, 60, 1, degree, seed % 2 == 1), seed, 30, 4));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(16u));
}

// A vertex comes with its edges, and goes with them: leaves of the hub, then the hub itself.
TEST(HubTrees, VerticesComeAndGo) {
  Scene scene = as_wheel(crossing_weights(1, 12));
  for (std::size_t i = 0; i < 12; ++i) {
    const auto edge_of = [&](std::size_t at) -> auto& {
      return scene.objects[at].motion.pieces[0];
    };
    // The vertex i: its spoke, and the edge of the rim that begins there.
    if (i % 3 == 0) {
      for (const std::size_t at : {i, 12 + i}) {
        edge_of(at).from = Rational(1);
        edge_of(at).to = Rational(4);
      }
    } else {
      edge_of(i).to = Rational(5);
    }
  }
  const TwinRun run(scene, engines("graph_mst"));
  EXPECT_EQ(run.ledger().insertions, 8u);
  EXPECT_EQ(run.ledger().erasures, 16u);
}

// Weights of few kinds, many identically equal: smaller objects go first.
TEST(HubTrees, TiesForEver) {
  for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int kinds = 1 + static_cast<int>(seed % 4);
    std::vector<Trajectory> t;
    for (int i = 0; i < 30; ++i) {
      const int kind = random.between(1, kinds);
      t.push_back(path({{Rational(kind * kind), Rational(-kind)}}));
    }
    const Scene scene = scene_of(t, -1, Rational(6));
    run_all(as_wheel(scene));
    run_all(as_hub_graph(scene, seed, 12, 2));
    if (testing::Test::HasFailure()) return;
  }
}

// A point in the centre of an icosahedron is the neighbour of all twelve corners, and they move.
TEST(HubTrees, PointsInSpace) {
  Random random(1);
  std::vector<Trajectory> t{path({{0}, {0}, {0}})};
  for (const int a : {-500, 500}) {
    for (const int b : {-809, 809}) {
      for (const auto& [x, y, z] : {std::array{0, a, b}, {b, 0, a}, {a, b, 0}}) {
        std::vector<std::vector<Rational>> axes;
        for (const int at : {x, y, z}) axes.push_back({at, random.between(-40, 40)});
        t.push_back(path(std::move(axes)));
      }
    }
  }
  const TwinRun run(scene_of(t, 1, Rational(2)), engines("emst"));
  EXPECT_GT(run.ledger().external, 0u);
  std::size_t at_centre = 0;
  for (std::size_t i = 0; i < run.begins_with.size(); i += 2) {
    if (run.begins_with[i] == 0) ++at_centre;
  }
  EXPECT_GE(at_centre, 8u);
}

}  // namespace hub_trees_test
}  // namespace kinex::test

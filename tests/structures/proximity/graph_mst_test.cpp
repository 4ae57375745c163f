// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning forest of a graph with moving weights, by all engines in one run; that by
// clusters with clusters of several sizes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {
namespace graph_mst_test {

using Ids = std::vector<ObjectId>;

std::vector<Request> engines() {
  return {ask("graph_mst_list"), ask("graph_mst_cycles"), ask("graph_mst_clusters"),
          ask("graph_mst_clusters", "cluster", 1), ask("graph_mst_clusters", "cluster", 2),
          ask("graph_mst_sparsified")};
}

// A graph of more vertices: paths through many clusters.
std::vector<Request> by_clusters() {
  std::vector<Request> all{ask("graph_mst_cycles"), ask("graph_mst_sparsified"),
                           ask("graph_mst_clusters")};
  for (const int size : {1, 2, 3, 5}) all.push_back(ask("graph_mst_clusters", "cluster", size));
  return all;
}

// The objects of a scene of one axis as edges between random ones of these vertices.
Scene as_graph(Scene scene, std::uint64_t seed, int vertices) {
  Random random(seed);
  for (SceneObject& object : scene.objects) {
    const int u = random.between(0, vertices - 1), v = random.between(1, vertices - 1);
    object.ends = {"v" + std::to_string(u), "v" + std::to_string((u + v) % vertices)};
  }
  return scene;
}

// k bundles of parallel edges in a row, in each the weights i^2 - i t.
Scene bundles(int k, int edges) {
  std::vector<Trajectory> t;
  for (int b = 0; b < k; ++b) {
    for (int i = 0; i < edges; ++i) t.push_back(path({{i * i, -i}}));
  }
  Scene scene = scene_of(t, -1, Rational(2 * edges));
  for (int i = 0; i < k * edges; ++i) {
    scene.objects[static_cast<std::size_t>(i)].ends = {"v" + std::to_string(i / edges),
                                                       "v" + std::to_string(i / edges + 1)};
  }
  return scene;
}

// Every edge of a bundle is the lightest in turn: n - 1 changes; all pairs exchange in the list.
TEST(GraphMst, ParallelEdges) {
  for (const int n : {2, 3, 5, 8}) {
    SCOPED_TRACE(n);
    const TwinRun run(bundles(1, n), engines()), twin(bundles(1, n), engines(), "sturm");
    const auto edges = static_cast<std::uint64_t>(n);
    EXPECT_EQ(run.ledger(0).external, edges - 1);
    EXPECT_EQ(run.ledger(0).failures, edges * (edges - 1) / 2);
    EXPECT_EQ(run.ledger(1).failures, edges - 1);
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
  const TwinRun three(bundles(3, 4), engines());  // at the same instants
  EXPECT_EQ(three.ledger(0).external, 9u);
  EXPECT_EQ(three.ledger(1).external, 9u);
  EXPECT_EQ(three.sink.log.lines, TwinRun(bundles(3, 4), engines(), "sturm").sink.log.lines);
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 6);
    const TwinRun run(as_graph(lattice_scene(seed, n, 1), seed, 3 + static_cast<int>(seed % 4)),
                      engines());
    external += run.ledger().external;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(seeds) / 2);
}

TEST(GraphMst, TinyLattices) { on_lattices(200); }

TEST(SlowGraphMst, TinyLattices) { on_lattices(5000); }

TEST(GraphMst, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = as_graph(random_flights(seed, 12, 1, degree, seed % 2 == 0), seed, 5);
      const TwinRun run(scene, engines()), twin(scene, engines(), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(40u));
  EXPECT_GT(updates, test::seen_in_fewer(60u));
}

TEST(GraphMst, ManyClusters) {
  std::uint64_t external = 0, updates = 0, sizes = 0;
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 2u : 12u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = as_graph(random_flights(seed, 32, 1, 1 + static_cast<int>(seed % 2), seed % 3 != 0), seed, 16);
    const TwinRun run(scene, by_clusters());
    external += run.ledger().external;
    updates += run.ledger().motion_updates;
    sizes += run.ledger().insertions + run.ledger().erasures;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, kSanitized ? 5u : 50u);
  EXPECT_GT(updates + sizes, 50u);
}

// Ties of many edges, in clusters of one to five vertices.
TEST(GraphMst, LatticesInClusters) {
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 10u : 60u); ++seed) {
    SCOPED_TRACE(seed);
    const TwinRun run(as_graph(lattice_scene(seed, 20, 1), seed, 9), by_clusters());
    if (testing::Test::HasFailure()) return;
  }
}

// A forest of two parts, and an edge that joins them for a while.
TEST(GraphMst, PartsThatAreNotConnected) {
  Scene scene = scene_of({path({{1}}), path({{2}}), path({{5, -1}}), path({{3}})}, 0, Rational(9));
  scene.objects[0].ends = {"a", "b"};
  scene.objects[1].ends = {"c", "d"};
  scene.objects[2].ends = {"a", "b"};
  scene.objects[3].ends = {"b", "c"};
  scene.objects[3].motion.pieces[0].from = Rational(1);
  scene.objects[3].motion.pieces[0].to = Rational(6);
  const TwinRun run(scene, engines());
  EXPECT_EQ(run.begins_with, (Ids{0, 1}));
  EXPECT_EQ(run.attribute(), (Ids{1, 2}));
  EXPECT_EQ(run.ledger().external, 1u);
  EXPECT_EQ(run.ledger().insertions, 1u);
}

TEST(GraphMst, TiesGoToTheSmallerObject) {
  std::vector<Trajectory> t(6, path({{1, 1}}));
  const TwinRun run(as_graph(scene_of(t, 0, Rational(2)), 1, 2), engines());
  EXPECT_EQ(run.attribute(), Ids{0});
  // 0 becomes heavier, and is level with 1 again from 3 on.
  Scene scene = as_graph(scene_of(t, 0, Rational(5)), 1, 2);
  auto& pieces = scene.objects[0].motion.pieces;
  pieces[0].to = Rational(1);
  pieces.push_back({Rational(1), Rational(2), path({{0, 2}})});
  pieces.push_back({Rational(2), Rational(3), path({{4}})});
  pieces.push_back({Rational(3), std::nullopt, path({{1, 1}})});
  const TwinRun parting(scene, engines());
  EXPECT_EQ(parting.attribute(), Ids{0});
  EXPECT_EQ(parting.ledger().external, 2u);
}

TEST(GraphMst, NoEdgeToTwo) {
  for (int n = 0; n <= 2; ++n) {
    std::vector<Trajectory> t(static_cast<std::size_t>(n), path({{0, 1}}));
    const TwinRun run(as_graph(scene_of(t, 0, Rational(3)), 1, 2), engines());
    EXPECT_EQ(run.attribute().size(), n == 0 ? 0u : 1u);
  }
}

TEST(GraphMst, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      const Scene scene = as_graph(random_flights(seed, 10, 1, 2, seed % 2 == 0), seed, 4);
      const TwinRun run(scene, engines(), arithmetic);
      EXPECT_TRUE(run.ledger().corrupt || run.attribute().size() <= 3) << arithmetic;
    }
  }
}

}  // namespace graph_mst_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest circle and the farthest-point triangulation over every hull: exact counts, and
// agreement with the brute-force circle instant by instant.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/structures/extent/circle_support.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace min_circle_test {

using Values = std::vector<std::vector<ObjectId>>;

// Every structure of both kinds, over every hull.
void expect_agreement(const Scene& scene) {
  const LayeredRun brute_force(scene, "min_circle_2_brute_force");
  const LayeredRun edges(scene, "farthest_delaunay_2");
  for (const std::string& hull : kHulls) {
    SCOPED_TRACE(hull);
    const LayeredRun circle(scene, "min_circle_2", hull);
    EXPECT_EQ(circle.sink.history, brute_force.sink.history);
    EXPECT_EQ(circle.external(), brute_force.external());
    if (hull == "convex_hull_2") continue;
    const LayeredRun other(scene, "farthest_delaunay_2", hull);
    EXPECT_EQ(other.sink.history, edges.sink.history);
    EXPECT_EQ(other.external(), edges.external());
  }
}

// Over hulls of directions, whose error the audits check: one history for each k.
std::uint64_t expect_agreement_of_directions(const Scene& scene) {
  std::uint64_t external = 0;
  for (const std::vector<std::string>& hulls : kHullsOfDirections) {
    for (const char* structure : {"min_circle_2", "farthest_delaunay_2"}) {
      SCOPED_TRACE(std::string(structure) + " over " + hulls[0]);
      const LayeredRun first(scene, structure, hulls[0]);
      external += first.external();
      for (std::size_t i = 1; i < hulls.size(); ++i) {
        const LayeredRun other(scene, structure, hulls[i]);
        EXPECT_EQ(other.sink.history, first.sink.history) << hulls[i];
        EXPECT_EQ(other.external(), first.external()) << hulls[i];
      }
    }
  }
  return external;
}

TEST(MinCircle, OverHullsOfDirections) {
  std::uint64_t external = expect_agreement_of_directions(see_saw(3, 3)) +
                           expect_agreement_of_directions(remainders(10)) +
                           expect_agreement_of_directions(through_origin(8, Rational(-1)));
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 2u : 16u); ++seed) {
    SCOPED_TRACE(seed);
    external += expect_agreement_of_directions(circle_lattice(seed, seed % 4 == 0 ? 2 : 1));
    external += expect_agreement_of_directions(random_flights(seed, 8, 2, 1, seed % 4 != 0));
  }
  EXPECT_GT(external, kSanitized ? 60u : 400u);
}

TEST(MinCircle, SeeSawChangesAsOftenAsCounted) {
  for (const auto& [n, m] : std::vector<std::pair<int, int>>{
           {2, 2}, {3, 2}, {2, 3}, {3, 3}, {3, 4}, {4, 3}, {4, 4}, {5, 4}}) {
    SCOPED_TRACE(std::to_string(n) + ", " + std::to_string(m));
    const Scene scene = see_saw(n, m);
    const auto changes = static_cast<std::uint64_t>(3 * n * m - n - m - 1);
    EXPECT_EQ(LayeredRun(scene, "min_circle_2_brute_force").external(), changes);
    for (const std::string& hull : kHulls) {
      EXPECT_EQ(LayeredRun(scene, "min_circle_2", hull).external(), changes) << hull;
      const LayeredRun edges(scene, "farthest_delaunay_2", hull);
      EXPECT_EQ(edges.external(), static_cast<std::uint64_t>((n - 1) * (m - 1))) << hull;
      EXPECT_EQ(edges.events_of("flip"), edges.external()) << hull;
    }
  }
}

TEST(MinCircle, ReferenceCounts) {
  struct Row {
    int n;
    std::uint64_t circle, flips, diagonals;
  };
  for (const Row& row : {Row{4, 1, 1, 4}, Row{6, 1, 1, 3}, Row{8, 2, 3, 6}, Row{10, 2, 7, 13}}) {
    SCOPED_TRACE(row.n);
    const Scene scene = remainders(row.n);
    EXPECT_EQ(LayeredRun(scene, "min_circle_2_brute_force").external(), row.circle);
    for (const std::string& hull : kHulls) {
      EXPECT_EQ(LayeredRun(scene, "min_circle_2", hull).external(), row.circle) << hull;
      const LayeredRun edges(scene, "farthest_delaunay_2", hull);
      EXPECT_EQ(edges.external(), row.diagonals) << hull;
      EXPECT_EQ(edges.events_of("flip"), row.flips) << hull;
    }
  }
}

// A triangle: no flip and no hull change, and the circle changes where an angle is right.
TEST(MinCircle, PassesBetweenATriangleAndItsSides) {
  const Scene scene = scene_of({path({{0}, {0}}), path({{4}, {0}}), path({{-2, 1}, {1}})}, 0,
                               Rational(8));
  const Values values{{1, 2}, {0, 1, 2}, {0, 1}, {0, 1, 2}, {0, 2}};
  EXPECT_EQ(LayeredRun(scene, "min_circle_2_brute_force").values(), values);
  for (const std::string& hull : kHulls) {
    const LayeredRun circle(scene, "min_circle_2", hull);
    EXPECT_EQ(circle.values(), values) << hull;
    EXPECT_EQ(circle.ledger().failures, 4u) << hull;
    EXPECT_EQ(circle.simulator.ledger(0).external, 0u) << hull;
    EXPECT_EQ(LayeredRun(scene, "farthest_delaunay_2", hull).external(), 0u) << hull;
  }
}

// A point comes through a vertex of a square, crosses it, and leaves through the opposite vertex.
TEST(MinCircle, ThroughVertices) {
  const Scene scene = scene_of({path({{1}, {0}}), path({{0}, {1}}), path({{-1}, {0}}),
                                path({{0}, {-1}}), path({{-3, 1}, {0}})},
                               0, Rational(6));
  expect_agreement(scene);
  EXPECT_EQ(LayeredRun(scene, "min_circle_2").values(), (Values{{0, 4}, {0, 1, 2, 3}, {2, 4}}));
}

// All points meet at 0 and part again: nothing changes, and nothing differs in a start at 0.
TEST(MinCircle, ThroughOnePoint) {
  for (const int start : {-1, 0}) {
    const Scene scene = through_origin(8, Rational(start));
    expect_agreement(scene);
    EXPECT_EQ(LayeredRun(scene, "min_circle_2").values(), (Values{{0, 2}}));
  }
}

TEST(MinCircle, ASquareThatDrifts) {
  const Scene scene = scene_of({path({{0, 3}, {0, 2}}), path({{1, 3}, {0, 2}}),
                                path({{1, 3}, {1, 2}}), path({{0, 3}, {1, 2}})},
                               0, Rational(5));
  expect_agreement(scene);
  EXPECT_EQ(LayeredRun(scene, "min_circle_2").values(), (Values{{0, 1, 2, 3}}));
  EXPECT_EQ(LayeredRun(scene, "farthest_delaunay_2").values(),
            (Values{{0, 1, 0, 2, 0, 3, 1, 2, 2, 3}}));
}

// Twelve points stay on one circle: the fan of the smallest id, and all are on the circle.
TEST(MinCircle, ManyOnOneCircleForEver) {
  std::vector<Trajectory> t;
  for (const auto& [x, y] : std::vector<std::pair<int, int>>{
           {3, 4}, {5, 0}, {-4, 3}, {0, -5}, {4, 3}, {-3, -4}, {0, 5}, {4, -3}, {-5, 0}}) {
    t.push_back(path({{x, 1}, {y, 2}}));
  }
  expect_agreement(scene_of(t, 0, Rational(3)));
  const Values edges = LayeredRun(scene_of(t, 0, Rational(3)), "farthest_delaunay_2").values();
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(std::count(edges[0].begin(), edges[0].end(), 0u), 8);
  // One of them leaves the circle, with a new flight plan.
  for (std::size_t leaving = 0; leaving < t.size(); ++leaving) {
    Scene scene = scene_of(t, 0, Rational(3));
    auto& pieces = scene.objects[leaving].motion.pieces;
    pieces[0].to = Rational(1);
    pieces.push_back({Rational(1), std::nullopt,
                      continued(t[leaving], path({{0, 2}, {0, -1}}), Rational(1))});
    SCOPED_TRACE(leaving);
    expect_agreement(scene);
  }
}

TEST(MinCircle, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    SCOPED_TRACE(n);
    expect_agreement(scene);
  }
  // All equal; all identically on one line, and passing; two pairs of equal points.
  expect_agreement(scene_of(std::vector<Trajectory>(4, path({{1, 1}, {2}})), 0, Rational(2)));
  expect_agreement(scene_of({path({{0, 1}, {0, 1}}), path({{3}, {3}}), path({{5, -1}, {5, -1}}),
                             path({{4, 1}, {4, 1}})},
                            0, Rational(9)));
  expect_agreement(scene_of({path({{0, 1}, {0}}), path({{0, 1}, {0}}), path({{5}, {1}}),
                             path({{5}, {1}}), path({{2}, {-1, 1}})},
                            0, Rational(9)));
}

// External events of `linear` lattices of linear motion, and of a third as many of degree 2 and of degree 3.
std::uint64_t run_lattices(std::uint64_t linear) {
  std::uint64_t external = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? linear : linear / 3); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = circle_lattice(1000 * static_cast<std::uint64_t>(degree) + seed, degree);
      expect_agreement(scene);
      external += LayeredRun(scene, "min_circle_2").external();
      if (::testing::Test::HasFailure()) return external;
    }
  }
  return external;
}

TEST(MinCircle, RandomLattices) { EXPECT_GT(run_lattices(36), test::seen_in_fewer(60u)); }

TEST(SlowMinCircle, RandomLattices) { EXPECT_GT(run_lattices(150), 250u); }

// Flight plans, points that come and go, and pairs that move alike.
TEST(MinCircle, RandomFlights) {
  std::uint64_t external = 0;
  for (const int degree : {1, 2, 3}) {
    const std::uint64_t seeds = (degree == 1 ? 20 : 8);
    for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = random_flights(seed, 8, 2, degree, seed % 4 != 0);
      expect_agreement(scene);
      external += LayeredRun(scene, "min_circle_2").external();
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(50u));
}

}  // namespace min_circle_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
// The closest pair and the closest pair of two colours: among Delaunay edges and among all pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace pairs_test {

using Ids = std::vector<ObjectId>;

std::vector<Request> pairs_in(int dimension) {
  if (dimension == 2) {
    return {ask("closest_pair_delaunay"),   ask("closest_pair_all"),
            ask("closest_pair_range_tree"), ask("closest_pair_range_tree", "cones", 4),
            ask("closest_pair_cones"),      ask("closest_pair_local"),
            ask("closest_pair_bins")};
  }
  if (dimension == 3) return {ask("closest_pair_delaunay"), ask("closest_pair_all")};
  return {ask("closest_pair_all")};
}
std::vector<Request> colours_in(int dimension) {
  if (dimension > 1) return {ask("bichromatic_pair_delaunay"), ask("bichromatic_pair_all")};
  return {ask("bichromatic_pair_all")};
}

// "red" and "blue" by two named colours; others have "green".
std::vector<Request> red_and_blue() {
  std::vector<Request> requests = colours_in(2);
  for (Request& request : requests) request.colours = {"red", "blue"};
  return requests;
}
Scene coloured(Scene scene, std::uint64_t seed) {
  Random random(seed);
  for (SceneObject& object : scene.objects) {
    const char* const names[] = {"red", "blue", "green"};
    object.colour = names[random.between(0, 2)];
  }
  scene.objects[0].colour = "red";
  if (scene.objects.size() > 1) scene.objects[1].colour = "blue";
  return scene;
}

struct Counted {
  int n, dimension;
  std::uint64_t seed, pair, colours;
};

const Counted kCounted[] = {{6, 2, 1, 4, 5}, {8, 2, 1, 5, 3}, {10, 2, 2, 8, 6}, {12, 2, 3, 7, 5},
                            {6, 3, 1, 4, 3}, {7, 3, 2, 7, 5}, {8, 3, 1, 5, 4}};

TEST(Pairs, ReferenceCounts) {
  for (const Counted& one : kCounted) {
    SCOPED_TRACE(std::to_string(one.n) + " points in " + std::to_string(one.dimension) + " axes");
    const Scene scene = reference_scene(one.n, one.dimension, one.seed);
    const TwinRun run(scene, pairs_in(one.dimension));
    EXPECT_EQ(run.ledger().external, one.pair);
    const TwinRun colours(scene, colours_in(one.dimension));
    EXPECT_EQ(colours.ledger().external, one.colours);
    if (one.n > 8 || one.dimension == 3) continue;
    for (const TwinRun* exact : {&run, &colours}) {
      const TwinRun twin(scene, exact->scene.maintain, "sturm");
      EXPECT_EQ(exact->sink.log.lines, twin.sink.log.lines);
    }
  }
}

// S(6, 2, 1): 3-4, 0-1, 3-4, 1-2, 1-3.
TEST(Pairs, SequenceOfTheClosestPairs) {
  struct Change {
    Ids before, after;
    int instant;  // in units of 1 / 100000, rounded down
  };
  const std::vector<Change> changes{{{3, 4}, {0, 1}, 3230},
                                    {{0, 1}, {3, 4}, 67130},
                                    {{3, 4}, {1, 2}, 102425},
                                    {{1, 2}, {1, 3}, 267272}};
  const Scene scene = reference_scene(6, 2, 1);
  for (const Request& request : pairs_in(2)) {
    SCOPED_TRACE(request.structure);
    const std::vector<Recorded> found = external_events(scene, request);
    ASSERT_EQ(found.size(), changes.size());
    for (std::size_t i = 0; i < changes.size(); ++i) {
      Ids ids = changes[i].before;
      ids.insert(ids.end(), changes[i].after.begin(), changes[i].after.end());
      EXPECT_EQ(found[i].ids, ids);
      RootCounters counters;
      RealRoot at = instant_of(found[i], {scene, {}, 1, 0, false, {}, ""});
      const Integer unit(100000);
      RealRoot low(Rational(Integer(changes[i].instant), unit)),
          high(Rational(Integer(changes[i].instant + 1), unit));
      EXPECT_LT(compare(low, at, counters), 0);
      EXPECT_LT(compare(at, high, counters), 0);
    }
  }
}

// Those in space are with the trees (proximity_in_space_test.cpp).
TEST(SlowPairs, ReferenceCountsInSturm) {
  for (const Counted& one : kCounted) {
    if (one.n <= 8 || one.dimension == 3) continue;
    SCOPED_TRACE(one.n);
    const Scene scene = reference_scene(one.n, one.dimension, one.seed);
    for (const auto& requests : {pairs_in(2), colours_in(2)}) {
      EXPECT_EQ(TwinRun(scene, requests).sink.log.lines,
                TwinRun(scene, requests, "sturm").sink.log.lines);
    }
  }
}

TEST(Pairs, TinyLattices) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(60u); ++seed) {
    SCOPED_TRACE(seed);
    const int dimension = 1 + static_cast<int>(seed % 3);
    const Scene scene = lattice_scene(seed, 5 + static_cast<int>(seed % 4), dimension);
    external += TwinRun(scene, pairs_in(dimension)).ledger().external;
    external += TwinRun(scene, colours_in(dimension)).ledger().external;
  }
  EXPECT_GT(external, test::seen_in_fewer(50u));
}

TEST(SlowPairs, TinyLattices) {
  for (std::uint64_t seed = 1; seed <= 450; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = lattice_scene(seed, 5 + static_cast<int>(seed % 5), 2);
    const TwinRun pairs(scene, pairs_in(2)), two(coloured(scene, seed), red_and_blue());
    if (HasFailure()) return;
  }
}

TEST(Pairs, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = coloured(random_flights(seed, 8, 2, degree, seed % 2 == 0), seed);
      const TwinRun run(scene, red_and_blue()), twin(scene, red_and_blue(), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      const TwinRun pairs(scene, pairs_in(2));
      external += run.ledger().external + pairs.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(15u));
  EXPECT_GT(updates, test::seen_in_fewer(20u));
}

// n points pass along a row of m of the other colour: all mn pairs are the closest in turn.
TEST(Pairs, WorstCaseOfTwoColours) {
  for (const auto& [m, n] : {std::pair{2, 2}, {3, 2}, {3, 3}, {4, 3}}) {
    SCOPED_TRACE(std::to_string(m) + " at rest, " + std::to_string(n) + " that pass");
    std::vector<Trajectory> t;
    for (int j = 0; j < m; ++j) t.push_back(path({{j}, {0}}));
    const Rational tenth(Integer(1), Integer(10)), end(Integer(2 * n * m - 1), Integer(2));
    for (int i = 0; i < n; ++i) t.push_back(path({{-m * i, 1}, {tenth}}));
    Scene scene = scene_of(t, 0, end);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      scene.objects[i].colour = static_cast<int>(i) < m ? "red" : "blue";
    }
    const TwinRun run(scene, red_and_blue());
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n * m - 1));
    EXPECT_EQ(run.sink.log.lines, TwinRun(scene, red_and_blue(), "sturm").sink.log.lines);
  }
}

// Groups of equal points of both colours: the smallest red with the smallest blue.
TEST(Pairs, EqualPointsOfBothColours) {
  Scene scene =
      scene_of({path({{0}, {0}}), path({{5, 1}, {5}}), path({{9}, {1, 2}}), path({{9}, {1, 2}}),
                path({{5, 1}, {5}}), path({{5, 1}, {5}}), path({{9}, {1, 2}})},
               0, Rational(9));
  const char* const colours[] = {"red", "red", "blue", "blue", "red", "blue", "red"};
  for (std::size_t i = 0; i < 7; ++i) scene.objects[i].colour = colours[i];
  const TwinRun run(scene, red_and_blue());
  EXPECT_EQ(run.attribute(), (Ids{1, 5}));
  EXPECT_EQ(run.ledger().external, 0u);
  // Without colours, places: 0, 2, 4, 6 against 1, 3, 5.
  const TwinRun places(scene, colours_in(2));
  EXPECT_EQ(places.attribute(), (Ids{1, 4}));
}

// In its quadrant around the first point the second one is behind the third one along x + y; turned by a half
// turn, in the quadrant around the second point the first one is; so in the quadrants beside these.
TEST(Pairs, SecondInItsQuadrant) {
  const Rational tenth(Integer(1), Integer(10)), low(Integer(1), Integer(100));
  const std::array<std::array<Rational, 2>, 4> points{{{Rational(0), Rational(0)},
                                                       {Rational(1), tenth},
                                                       {low, Rational(1) + Rational(4) * low},
                                                       {Rational(-5), Rational(-9)}}};
  for (const int across : {1, -1}) {
    for (const int turn : {1, -1}) {
      std::array<std::size_t, 4> order{0, 1, 2, 3};  // by id
      do {
        std::vector<Trajectory> t;
        Ids pair;
        for (ObjectId id = 0; id < 4; ++id) {
          const auto& [x, y] = points[order[id]];
          t.push_back(path({{Rational(across * turn) * x}, {Rational(turn) * y}}));
          if (order[id] < 2) pair.push_back(id);
        }
        const TwinRun run(
            scene_of(t, 0, Rational(1)),
            {ask("closest_pair_range_tree"), ask("closest_pair_range_tree", "cones", 4)});
        EXPECT_EQ(run.attribute(), pair);
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
}

TEST(Pairs, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    EXPECT_EQ(TwinRun(scene, pairs_in(2)).attribute().size(), n < 2 ? 0u : 2u);
    EXPECT_EQ(TwinRun(scene, colours_in(2)).attribute().size(), n < 2 ? 0u : 2u);
  }
}

TEST(Pairs, FromNothingToNothing) {
  const Scene scene = from_nothing_to_nothing();
  for (const auto& requests : {pairs_in(2), colours_in(2)}) {
    const TwinRun run(scene, requests);
    EXPECT_EQ(run.begins_with, Ids{});
    EXPECT_EQ(run.attribute(), Ids{});
    EXPECT_EQ(run.ledger().insertions, 7u);
  }
}

TEST(Pairs, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    const TwinRun run(in_units_of(size), colours_in(2));
    EXPECT_GT(run.ledger().external, 0u);
  }
}

TEST(Pairs, EndInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
      const TwinRun flights(random_flights(seed, 9, 2, 1, seed % 2 == 0), colours_in(2),
                            arithmetic);
      const TwinRun lattice(lattice_scene(seed, 8, 2), pairs_in(2), arithmetic);
      EXPECT_TRUE(lattice.ledger().corrupt || lattice.attribute().size() == 2) << arithmetic;
    }
  }
}

// Structures of some objects only: as if the others were not in the scene.
TEST(Pairs, OfSomeObjects) {
  for (std::uint64_t seed = 1; seed <= test::fewer(20u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = coloured(random_flights(seed, 10, 2, 1, seed % 2 == 0), seed);
    Scene few = scene;
    few.objects.clear();
    std::vector<ObjectId> kept;
    for (ObjectId i = 0; i < scene.objects.size(); ++i) {
      if (scene.objects[i].colour == "green") continue;
      few.objects.push_back(scene.objects[i]);
      kept.push_back(i);
    }
    std::vector<Request> part = pairs_in(2);
    for (Request& request : part) {
      request.of = {Subset::Kind::kColours, {}, {"red", "blue"}};
    }
    part.push_back(ask("emst_list"));
    part.back().of = {Subset::Kind::kObjects, kept, {}};
    const TwinRun alone(few, {ask("closest_pair_delaunay")});
    part.pop_back();
    const TwinRun run(scene, part);
    Ids pair;
    for (const ObjectId id : alone.attribute()) pair.push_back(kept[id]);
    EXPECT_EQ(run.attribute(), pair);
    EXPECT_EQ(run.ledger().external, alone.ledger().external);
    EXPECT_EQ(run.ledger().motion_updates, alone.ledger().motion_updates);
    EXPECT_EQ(run.ledger().insertions, alone.ledger().insertions);
    Request tree = ask("emst_list"), other = ask("emst_cycles");
    tree.of = other.of = {Subset::Kind::kObjects, kept, {}};
    const TwinRun trees(scene, {tree, other}), trees_alone(few, {ask("emst_list")});
    EXPECT_EQ(trees.ledger().external, trees_alone.ledger().external);
    EXPECT_EQ(trees.ledger().failures, trees_alone.ledger().failures);
  }
}

}  // namespace pairs_test
}  // namespace kinex::test

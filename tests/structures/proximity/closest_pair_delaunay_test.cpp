// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_delaunay.h"

#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/proximity/closest_pair_support.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace closest_pair_delaunay_test {

using Ids = std::vector<ObjectId>;

TEST(ClosestPair, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 12u : 5u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = random_flights(seed, 9, 2, degree, seed % 2 == 0);
      const PairRun run(scene), twin(scene, "sturm");
      EXPECT_EQ(run.lines(false), twin.lines(false));
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(30u));
  EXPECT_GT(updates, test::seen_in_fewer(60u));
}

TEST(ClosestPair, OrdinaryScenes) {
  std::uint64_t external = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      Random random(seed);
      std::vector<Trajectory> t;
      for (int i = 0; i < 16; ++i) t.push_back(random.small_path(2, degree, 1000));
      const PairRun run(scene_of(t, -1, Rational(1)));
      external += run.ledger().external;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(40u));
}

TEST(ClosestPair, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    const PairRun run(scene);
    EXPECT_EQ(run.pair().size(), n < 2 ? 0u : 2u);
  }
  // Three on a line: the middle one goes from one to the other.
  const PairRun line(
      scene_of({path({{0}, {0}}), path({{1, 1}, {0}}), path({{10}, {0}})}, 0, Rational(8)));
  EXPECT_EQ(line.begins_with, (Ids{0, 1}));
  EXPECT_EQ(line.lines(true), std::vector<std::string>{"replace 0 1 1 2 !"});
}

// They come one by one and leave one by one.
TEST(ClosestPair, FromNothingToNothing) {
  const Scene scene = from_nothing_to_nothing();
  const PairRun run(scene);
  EXPECT_EQ(run.begins_with, Ids{});
  EXPECT_EQ(run.pair(), Ids{});
  EXPECT_EQ(run.ledger().insertions, 7u);
  EXPECT_EQ(run.ledger().erasures, 7u);
}

// Of pairs at identically equal distances the smallest: a lattice that drifts.
TEST(ClosestPair, TiesGoToTheSmallestPair) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 16; ++i) t.push_back(path({{(15 - i) % 4, 1}, {(15 - i) / 4, 2}}));
  const PairRun run(scene_of(t, 0, Rational(5)));
  EXPECT_EQ(run.pair(), (Ids{0, 1}));
  EXPECT_EQ(run.ledger().external, 0u);
  // 0 and 1 part at 2: the next pair in order is 0 and 4.
  Scene scene = scene_of(t, 0, Rational(5));
  scene.objects[1].motion.pieces[0].to = Rational(2);
  scene.objects[1].motion.pieces.push_back({Rational(2), std::nullopt, path({{2, 1}, {1, 3}})});
  const PairRun parting(scene);
  EXPECT_EQ(parting.pair(), (Ids{0, 4}));
}

TEST(ClosestPair, CoincidentPoints) {
  // 2 and 3 are identically equal, then 1 and 4; the pair (1, 4) is smaller.
  const PairRun same(scene_of({path({{0}, {0}}), path({{5, 1}, {5}}), path({{9}, {1, 2}}),
                               path({{9}, {1, 2}}), path({{5, 1}, {5}})},
                              0, Rational(9)));
  EXPECT_EQ(same.pair(), (Ids{1, 4}));
  EXPECT_EQ(same.ledger().external, 0u);
  // All are one point.
  const PairRun all(scene_of(std::vector<Trajectory>(5, path({{1, 1}, {2}})), 0, Rational(2)));
  EXPECT_EQ(all.pair(), (Ids{0, 1}));
  // Two meet for an instant in which they are the closest.
  const PairRun meet(
      scene_of({path({{0, 1}, {0}}), path({{4, -1}, {0}}), path({{0}, {9}}), path({{3}, {9}})}, 0,
               Rational(4)));
  EXPECT_EQ(meet.begins_with, (Ids{2, 3}));
  EXPECT_EQ(meet.lines(true).size(), 2u);
  EXPECT_EQ(meet.lines(true).back(), "replace 0 1 2 3 !");
  EXPECT_EQ(meet.pair(), (Ids{2, 3}));
}

// A point that is hidden behind one vertex goes on with another: no edge changes.
TEST(ClosestPair, HiddenPointsChangeTheirVertex) {
  Scene scene = scene_of({path({{0}, {0}}), path({{10, -1}, {0}}), path({{0}, {0}}),
                          path({{3}, {7}}), path({{4}, {-9}})},
                         0, Rational(20));
  // 0 and 1 meet at 10, where 2, hidden behind 0, goes on with 1.
  scene.objects[2].motion.pieces[0].to = Rational(10);
  scene.objects[2].motion.pieces.push_back({Rational(10), std::nullopt, path({{10, -1}, {0}})});
  const PairRun run(scene);
  EXPECT_EQ(run.begins_with, (Ids{0, 2}));
  EXPECT_EQ(run.pair(), (Ids{1, 2}));
  EXPECT_EQ(run.ledger().external, 1u);
}

// Twelve points meet at one instant of time and space, or on one line, or on one circle.
TEST(ClosestPair, SimultaneousEvents) {
  std::uint64_t shared = 0, external = 0;
  for (int kind = 0; kind < 3; ++kind) {
    SCOPED_TRACE(kind);
    std::vector<Trajectory> t;
    for (int i = 0; i < 12; ++i) {
      const int u = (i * 7) % 12 - 6, v = (i * 5) % 12 - 5;
      if (kind == 0) {
        t.push_back(path({{0, u}, {0, v}}));
      } else if (kind == 1) {
        t.push_back(path({{3 * i, u}, {0, v}}));
      } else {
        const Rational a(Integer(i), Integer(4));
        const Rational all = Rational(1) + a * a;
        t.push_back(path(
            {{(Rational(1) - a * a) / all, Rational(u)}, {Rational(2) * a / all, Rational(v)}}));
      }
    }
    const PairRun run(scene_of(t, -1, Rational(1)));
    shared += run.simulator.ledger(0).simultaneous_groups;
    external += run.ledger().external;
  }
  EXPECT_GT(shared, 0u);
  EXPECT_GT(external, 1u);
}

// All points are on one line at one instant: the triangulation is mended when it is over, and the
// pair changes at most once.
TEST(ClosestPair, AllOnOneLineForAnInstant) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(40u); ++seed) {
    SCOPED_TRACE(seed);
    const PairRun run(on_a_line_for_an_instant(seed, 5, 20));
    external += run.ledger().external;
  }
  EXPECT_GT(external, test::seen_in_fewer(40u));
}

TEST(ClosestPair, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    const PairRun run(in_units_of(size));
    EXPECT_GT(run.ledger().external, 0u);
  }
}

TEST(ClosestPair, Jumps) {
  const Scene scene = one_jumps(2, 7);
  const PairRun run(scene);
  EXPECT_EQ(run.begins_with, (Ids{0, 1}));
  EXPECT_EQ(run.pair(), (Ids{2, 3}));
  EXPECT_EQ(run.ledger().external, 0u);
}

TEST(ClosestPair, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (const int degree : {1, 2}) {
      for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
        const PairRun run(random_flights(seed, 9, 2, degree, seed % 2 == 0), arithmetic);
        EXPECT_TRUE(run.ledger().corrupt || run.pair().size() <= 2) << arithmetic;
      }
    }
  }
}

// m points at rest at a distance of 10 from each other; n points pass over them, one after another:
// each makes its nearest point of the row, m in all, and then the row's first two the closest pair.
TEST(ClosestPair, WorstCase) {
  for (const int m : {2, 3, 5}) {
    for (const int n : {1, 2, 4}) {
      SCOPED_TRACE(std::to_string(m) + " at rest, " + std::to_string(n) + " that pass");
      std::vector<Trajectory> t;
      for (int i = 0; i < m; ++i) t.push_back(path({{10 * i}, {0}}));
      const int gap = 10 * m + 17;
      for (int j = 0; j < n; ++j) t.push_back(path({{-20 - j * gap, 1}, {1}}));
      const PairRun run(scene_of(t, 0, Rational(gap * (n + 1))));
      EXPECT_EQ(run.begins_with, (Ids{0, 1}));
      EXPECT_EQ(run.pair(), (Ids{0, 1}));
      EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n * (m + 1)));
    }
  }
}

}  // namespace closest_pair_delaunay_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2 with many events at one instant, or identical ties.
#include <algorithm>
#include <set>

#include "tests/sanitized.h"
#include "tests/structures/test_scenes.h"
#include "tests/structures/triangulation/delaunay_2_support.h"

namespace kinex::delaunay_2_test {
namespace delaunay_2_degenerate_test {

// Runs with audits between all instants; rebuilds are noted in the test's record.
void run_clean(const std::vector<Trajectory>& motions, const Rational& start, const Rational& end,
               std::uint64_t most_rebuilds) {
  World world(scene_of(motions, start, end));
  world.run().expect_clean();
  EXPECT_LE(world.ledger().rebuilds, most_rebuilds) << world.reasons();
  ::testing::Test::RecordProperty("rebuilds", world.reasons());
  ::testing::Test::RecordProperty("processed", std::to_string(world.ledger().processed));
  ::testing::Test::RecordProperty("reinsertions", std::to_string(world.structure().reinsertions()));
}

std::vector<Rational> steps(std::int64_t first, std::int64_t last, std::int64_t parts) {
  std::vector<Rational> times;
  for (std::int64_t i = first; i <= last; ++i) times.push_back(fraction(i, parts));
  return times;
}

// (a + ib) (1 + it)^2: a rotation by twice the arctangent of t, times 1 + t^2.
Trajectory rotating(std::int64_t a, std::int64_t b, int direction = 1) {
  const std::int64_t d = direction;
  return moving({Rational(a), Rational(-2 * d * b), Rational(-a)},
                {Rational(b), Rational(2 * d * a), Rational(-b)});
}

const std::vector<std::pair<int, int>>& circle_of_25() {
  static const std::vector<std::pair<int, int>> points{{25, 0},  {24, 7},    {20, 15}, {15, 20},
                                                       {7, 24},  {0, 25},    {-7, 24}, {-20, 15},
                                                       {-25, 0}, {-15, -20}, {0, -25}, {20, -15}};
  return points;
}

std::vector<Trajectory> moving_grid(int k, std::uint64_t seed, int speed) {
  Random random(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < k; ++i) {
    for (int j = 0; j < k; ++j) {
      motions.push_back(
          integers(i, random.between(-speed, speed), j, random.between(-speed, speed)));
    }
  }
  random.shuffle(motions);
  return motions;
}

TEST(Delaunay2Degenerate, GridsWithIntegerVelocities) {
  for (std::uint64_t seed = 0; seed < test::fewer(12u); ++seed) {
    const int k = 2 + static_cast<int>(seed % 5);
    run_clean(moving_grid(k, seed, 1 + static_cast<int>(seed % 3)), 0, 4, 1000);
  }
}

TEST(Delaunay2Degenerate, GridsWithIntegerVelocitiesAreStaticAtAllTimes) {
  for (std::uint64_t seed = 0; seed < test::fewer(6u); ++seed) {
    expect_same_as_static(moving_grid(3 + static_cast<int>(seed % 3), 50 + seed, 2), 0,
                          steps(1, 18, 6));
  }
}

TEST(Delaunay2Degenerate, CocircularPointsThatExpand) {
  Random random(1);
  for (int round = 0; round < 4; ++round) {
    std::vector<Trajectory> motions;
    for (const auto& [a, b] : circle_of_25()) motions.push_back(integers(a, a, b, b));
    random.shuffle(motions);
    World world(scene_of(motions, 0, 3));
    world.run().expect_clean();
    EXPECT_EQ(world.ledger().processed, 0u);
    // A fan from the smallest id: 0 is a neighbour of all others.
    const Attribute edges = world.structure().attribute();
    EXPECT_EQ(edges.ids.size() / 2, 2 * 12 - 3u);
    for (ObjectId i = 1; i < 12; ++i) {
      EXPECT_EQ(edges.ids[2 * (i - 1)], 0u);
      EXPECT_EQ(edges.ids[2 * (i - 1) + 1], i);
    }
    // Others that cross the circle.
    for (int i = 0; i < 6; ++i) {
      motions.push_back(integers(random.between(-30, 30), random.between(-60, 60),
                                 random.between(-30, 30), random.between(-60, 60)));
    }
    random.shuffle(motions);
    run_clean(motions, 0, 2, 1);
    expect_same_as_static(motions, 0, steps(1, 8, 4));
  }
}

TEST(Delaunay2Degenerate, RigidRotationHasNoEvents) {
  std::vector<Trajectory> motions;
  for (const auto& [a, b] : circle_of_25()) motions.push_back(rotating(a, b));
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) motions.push_back(rotating(2 * i, 2 * j));
  }
  Random(4).shuffle(motions);
  World world(scene_of(motions, -3, 3));
  world.run().expect_clean();
  EXPECT_EQ(world.ledger().processed, 0u);
  expect_same_as_static(motions, -3, steps(-5, 5, 2));
}

TEST(Delaunay2Degenerate, CounterRotatingRings) {
  std::vector<Trajectory> motions;
  for (const auto& [a, b] : circle_of_25()) motions.push_back(rotating(a, b));
  for (const auto& [a, b] : circle_of_25()) motions.push_back(rotating(2 * a, 2 * b, -1));
  motions.push_back(integers(0, 0, 0, 0));
  Random(5).shuffle(motions);
  run_clean(motions, fraction(-1, 2), fraction(1, 2), 0);
  expect_same_as_static(motions, -1, steps(-3, 4, 4));
}

TEST(Delaunay2Degenerate, EverythingThroughOnePoint) {
  Random random(6);
  for (int round = 0; round < 6; ++round) {
    std::vector<Trajectory> motions;
    for (int i = 0; i < 14; ++i) {
      // (t - 1/2) v, and for some (t - 1/2)^2 w beside it
      const std::int64_t vx = random.between(-9, 9), vy = random.between(-9, 9);
      const std::int64_t wx = round < 2 ? 0 : random.between(-9, 9);
      const std::int64_t wy = round < 2 ? 0 : random.between(-9, 9);
      const bool slow = round >= 4 && i % 3 == 0;  // turns back
      const auto axis = [&](std::int64_t v, std::int64_t w) {
        const Rational a = slow ? Rational(0) : Rational(v), b(w);
        return Coefficients{b * fraction(1, 4) - a * fraction(1, 2), a - b, b};
      };
      motions.push_back(moving(axis(vx, wx), axis(vy, wy)));
    }
    run_clean(motions, 0, 1, round < 2 ? 0 : 3);
    expect_same_as_static(motions, 0, steps(1, 8, 8));
  }
}

TEST(Delaunay2Degenerate, PairsThatMeet) {
  Random random(7);
  for (int round = 0; round < 10; ++round) {
    std::vector<Trajectory> motions = random_motions(12, 300 + static_cast<unsigned>(round));
    // Partners that meet their point at 1/2 (all at once) or at different times.
    for (int i = 0; i < 6; ++i) {
      const Rational t = round % 2 == 0 ? fraction(1, 2) : fraction(i + 1, 8);
      Trajectory partner = motions[static_cast<std::size_t>(i)];
      for (Coefficients& c : partner.coordinates) {
        c.resize(2);
        const Rational dv = fraction(random.between(-100, 100), 100);
        c[0] -= dv * t;
        c[1] += dv;
      }
      motions.push_back(partner);
    }
    random.shuffle(motions);
    run_clean(motions, 0, 1, 4);
    if (round < 4) expect_same_as_static(motions, 0, steps(1, 16, 16));
  }
}

TEST(Delaunay2Degenerate, SeveralMeetAtOnePlace) {
  Random random(8);
  for (int round = 0; round < 6; ++round) {
    std::vector<Trajectory> motions = random_motions(14, 400 + static_cast<unsigned>(round));
    for (int i = 0; i < 3 + round; ++i) {
      Coefficients axis[2];
      for (Coefficients& c : axis) {
        const Rational v = fraction(random.between(-5, 5), 4);
        c = {fraction(1, 2) - v * fraction(1, 3), v};
      }
      motions.push_back(moving(axis[0], axis[1]));
    }
    random.shuffle(motions);
    run_clean(motions, 0, 1, 4);
    expect_same_as_static(motions, 0, steps(1, 6, 6));
  }
}

TEST(Delaunay2Degenerate, DuplicatesThatMoveTogether) {
  Random random(9);
  std::vector<Trajectory> motions = random_motions(12, 500);
  for (int i = 0; i < 8; ++i) motions.push_back(motions[static_cast<std::size_t>(i / 2)]);
  random.shuffle(motions);
  World world(scene_of(motions, 0, 1));
  world.run().expect_clean();
  EXPECT_EQ(world.ledger().rebuilds, 0u);
  const Attribute edges = world.structure().attribute();
  const std::set<ObjectId> seen(edges.ids.begin(), edges.ids.end());
  EXPECT_EQ(seen.size(), 12u);
  for (ObjectId i = 0; i < motions.size(); ++i) {
    EXPECT_EQ(seen.count(i), world.structure().representative(i) == i ? 1u : 0u);
    EXPECT_LE(world.structure().representative(i), i);
  }
  expect_same_as_static(motions, 0, steps(1, 8, 8));
}

TEST(Delaunay2Degenerate, PointsThatTouchAndTurnBack) {
  Random random(10);
  for (int round = 0; round < 4; ++round) {
    std::vector<Trajectory> motions = random_motions(12, 600 + static_cast<unsigned>(round), 2);
    for (int i = 0; i < 5; ++i) {  // a(t) + (t - s)^2 w
      const Rational s = fraction(i + 1, 7);
      Trajectory partner = motions[static_cast<std::size_t>(i)];
      for (Coefficients& c : partner.coordinates) {
        c.resize(3);
        const Rational w = fraction(random.between(-50, 50), 10);
        c[0] += w * s * s;
        c[1] -= Rational(2) * w * s;
        c[2] += w;
      }
      motions.push_back(partner);
    }
    run_clean(motions, 0, 1, 0);
  }
  // The same on a line with others: a certificate that only touches zero does not fail.
  std::vector<Trajectory> touch{integers(0, 0, 0, 0), integers(10, 0, 0, 0), integers(5, 0, 9, 0),
                                moving({Rational(4)}, {Rational(1), Rational(-2), Rational(1)})};
  World world(scene_of(touch, 0, 2));
  world.run().expect_clean();
  EXPECT_EQ(world.ledger().processed, 0u);
}

TEST(Delaunay2Degenerate, AllOnOneLineAtOneInstant) {
  Random random(11);
  for (int round = 0; round < 6; ++round) {
    std::vector<Trajectory> motions;
    for (int i = 0; i < 9 + round; ++i) {
      const std::int64_t v = random.between(-50, 50);
      motions.push_back(moving({Rational(i * 7), Rational(round < 3 ? 0 : random.between(-2, 2))},
                               {fraction(-v, 2), Rational(v)}));
    }
    random.shuffle(motions);
    run_clean(motions, 0, 1, 1);
    expect_same_as_static(motions, 0, steps(1, 8, 8));
  }
}

TEST(Delaunay2Degenerate, SomeInteriorPointsOnOneLineAtOneInstant) {
  Random random(12);
  for (int round = 0; round < 6; ++round) {
    std::vector<Trajectory> motions = random_motions(10, 700 + static_cast<unsigned>(round));
    for (int i = 0; i < 6; ++i) {
      const Rational v = fraction(random.between(-50, 50), 100);
      motions.push_back(moving({fraction(i + 1, 8)}, {fraction(1, 2) - v * fraction(1, 2), v}));
    }
    random.shuffle(motions);
    run_clean(motions, 0, 1, 2);
    expect_same_as_static(motions, 0, steps(1, 8, 8));
  }
}

TEST(Delaunay2Degenerate, AllOnOneLineForEver) {
  Random random(13);
  for (const int n : {1, 2, 3, 5, 9}) {
    std::vector<Trajectory> slanted, vertical, turning, repeated;
    for (int i = 0; i < n; ++i) {
      const std::int64_t s = random.between(-20, 20), v = random.between(-9, 9);
      slanted.push_back(integers(s, v, 2 * s + 1, 2 * v));
      vertical.push_back(integers(3, 0, s, v));
      turning.push_back(rotating(s, -2 * s));
      repeated.push_back(integers(s / 8, 1, s / 8, 1));
    }
    for (const auto& motions : {slanted, vertical, turning, repeated}) {
      World world(scene_of(motions, -2, 3));
      world.run().expect_clean();
      EXPECT_TRUE(world.structure().on_line());
      EXPECT_EQ(world.ledger().rebuilds, 0u);
      expect_same_as_static(motions, -2, steps(-3, 5, 2));
    }
  }
}

TEST(Delaunay2Degenerate, ThreePointsCrossTheirLine) {
  const std::vector<Trajectory> motions{integers(0, 0, 0, 0), integers(4, 0, 0, 0),
                                        integers(1, 1, 2, -1)};
  run_clean(motions, 0, 5, 1);
  expect_same_as_static(motions, 0, steps(1, 5, 1));
}

TEST(Delaunay2Degenerate, ALatticeIsReached) {
  Random random(14);
  for (int round = 0; round < 4; ++round) {
    std::vector<Trajectory> motions;
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) {
        const auto axis = [&](std::int64_t at) {
          const Rational v = fraction(random.between(-300, 300), 100);
          return Coefficients{Rational(at) - v, v};
        };
        Coefficients x = axis(i), y = axis(j);
        motions.push_back(moving(x, y));
      }
    }
    run_clean(motions, 0, 2, 40);
    expect_same_as_static(motions, 0, steps(3, 8, 4));
  }
}

TEST(Delaunay2Degenerate, DegenerateAtTheStart) {
  Random random(15);
  for (int round = 0; round < 24; ++round) {
    std::vector<Trajectory> motions;
    for (int i = 0; i < 16; ++i) {
      std::int64_t x = 0, y = 0;      // round % 6 == 0: all at one place
      if (round % 6 == 1) x = i;      // on one line
      if (round % 6 == 2) y = i % 3;  // on one line, several at each place
      if (round % 6 == 3) x = i % 4, y = i / 4;
      if (round % 6 == 4) x = i % 2, y = (i / 2) % 2;
      if (round % 6 == 5) {
        x = circle_of_25()[static_cast<std::size_t>(i % 12)].first;
        y = circle_of_25()[static_cast<std::size_t>(i % 12)].second;
      }
      const std::int64_t speed = round < 12 ? 2 : 1000;
      motions.push_back(
          integers(x, random.between(-speed, speed), y, random.between(-speed, speed)));
    }
    World world(scene_of(motions, 0, 2));
    world.run().expect_clean();
    if (round < 12) expect_same_as_static(motions, 0, {fraction(1, 1000000), 1, 2});
  }
}

TEST(Delaunay2Degenerate, LargeAndSmallNumbersInOnePoint) {
  const Rational large = *Rational::parse("1e150"), small = *Rational::parse("1e-150");
  for (int round = 0; round < 6; ++round) {
    Random random(200 + static_cast<unsigned>(round));
    std::vector<Trajectory> motions;
    const int degree = 1 + round % 2;
    for (std::int64_t i = 0; i < (degree == 1 ? 12 : 7); ++i) {
      Coefficients axis[2];
      for (int a = 0; a < 2; ++a) {
        for (int k = 0; k <= degree; ++k) {
          const bool big = ((i >> ((a + k + round) % 3)) & 1) != 0;
          axis[a].push_back(Rational(random.between(-2, 2)) * (big ? large : small));
        }
      }
      motions.push_back(moving(axis[0], axis[1]));
    }
    motions.push_back(motions[2]);
    World world(scene_of(motions, -2, 2));
    world.without_twin("halving an interval down to 1e-300 takes minutes");
    world.run().expect_clean();
    EXPECT_LE(world.ledger().rebuilds, 2u) << world.reasons();
    EXPECT_GT(world.ledger().processed, 0u);
  }
}

TEST(Delaunay2Degenerate, AddedCommonMotionChangesNothing) {
  const std::vector<Trajectory> motions = moving_grid(4, 90, 2);
  std::vector<Trajectory> carried = motions;
  for (Trajectory& m : carried) {
    for (Coefficients& c : m.coordinates) c.resize(3);
    m.coordinates[0][1] += fraction(5, 3);
    m.coordinates[1][2] += fraction(-7, 2);
  }
  World a(scene_of(motions, 0, 3)), b(scene_of(carried, 0, 3));
  a.run().expect_clean();
  b.run().expect_clean();
  EXPECT_EQ(a.recorder.events, b.recorder.events);
  EXPECT_EQ(a.structure().attribute(), b.structure().attribute());
}

TEST(Delaunay2Degenerate, ReferenceArithmeticAgrees) {
  std::vector<std::vector<Trajectory>> scenes{moving_grid(3, 91, 2), moving_grid(3, 92, 1)};
  std::vector<Trajectory> rings;
  for (int i = 0; i < 12; i += 3) {
    const auto& [a, b] = circle_of_25()[static_cast<std::size_t>(i)];
    rings.push_back(rotating(a, b));
    rings.push_back(rotating(2 * a, 2 * b, -1));
  }
  scenes.push_back(rings);
  for (const auto& motions : scenes) {
    World exact(scene_of(motions, 0, 2)), sturm(scene_of(motions, 0, 2), "sturm");
    sturm.recorder.instants = exact.recorder.instants;
    exact.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(exact.recorder.events, sturm.recorder.events);
    EXPECT_EQ(exact.ledger().rebuilds, sturm.ledger().rebuilds);
  }
}

TEST(Delaunay2Degenerate, InexactArithmeticsNeverFallOver) {
  for (const std::string_view arithmetic : {"double", "gsl", "mpfr:4", "mpfr:12", "mpfr:60"}) {
    for (std::uint64_t seed = 0; seed < test::fewer(8u); ++seed) {
      World world(scene_of(moving_grid(2 + static_cast<int>(seed % 5), seed, 2), 0, 4), arithmetic,
                  AuditLevel::kNone);
      world.run();
      EXPECT_EQ(world.status, RunStatus::kDone) << arithmetic;
    }
  }
}

// Coefficients -1, 0 and 1 only: many points meet and line up at t = 0. The hull after points were
// taken out and put in there once wound around twice (seed 10).
TEST(Delaunay2Degenerate, SmallestCoefficientsOfDegree2) {
  for (const std::uint64_t seed : {1, 10, 33, 90}) {
    SCOPED_TRACE(seed);
    kinex::test::Random random(seed);
    std::vector<Trajectory> motions;
    for (int i = 0; i < 12; ++i) motions.push_back(random.small_path(2, 2, 1));
    World world(scene_of(motions, -3, 3));
    world.run().expect_clean();
  }
}

// Points that meet in threes at t = 1. While they are taken out, the surroundings of a hole have a triangle
// on the three corners of the last ear.
TEST(Delaunay2Degenerate, AHoleWhoseSurroundingsAreFoldedOverIt) {
  const std::vector<Trajectory> motions{
      integers(1, -1, 2, 1),  integers(2, 0, 2, 0), integers(1, 0, 1, -1), integers(1, -1, 2, -1),
      integers(1, 0, 2, 1), integers(1, -1, 1, -1), integers(1, 0, 2, 0)};
  for (const std::string_view arithmetic : {"exact", "sturm"}) {
    World world(scene_of(motions, -3, 3), arithmetic);
    world.run().expect_clean();
  }
}

}  // namespace delaunay_2_degenerate_test
}  // namespace kinex::delaunay_2_test

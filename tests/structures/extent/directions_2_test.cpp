// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/directions_2.h"

#include <algorithm>
#include <string>
#include <vector>

#include "predicates/points/unit_directions.h"
#include "structures/registry.h"
#include "tests/sanitized.h"
#include "tests/structures/extent/directions_support.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace directions_2_test {

using Ids = std::vector<ObjectId>;

// By the dual hulls, or tournaments, and by tournaments in any case: the same changes.
void run_both(const Scene& scene, int k, std::uint64_t* external = nullptr) {
  SCOPED_TRACE("k = " + std::to_string(k));
  const DirectionsRun run(scene, "directions_2", k), other(scene, "directions_2_tournament", k);
  EXPECT_EQ(run.changes(), other.changes());
  EXPECT_EQ(run.begins_with, other.begins_with);
  if (external != nullptr) *external += run.ledger().external;
}

TEST(Directions, AreUnitVectorsInTheirOrder) {
  for (const int k : {1, 2, 3, 7, 60}) {
    std::vector<DirectionVector> u = unit_directions_2(k);
    ASSERT_EQ(u.size(), static_cast<std::size_t>(2 * k));
    u.push_back({-u[0][0], -u[0][1]});
    for (std::size_t i = 0; i + 1 < u.size(); ++i) {
      EXPECT_EQ(u[i][0] * u[i][0] + u[i][1] * u[i][1], Rational(1));
      // The cosine of the angle to the next one is at least (k^2 - 1) / (k^2 + 1).
      const Rational cosine = u[i][0] * u[i + 1][0] + u[i][1] * u[i + 1][1];
      EXPECT_GE(cosine * Rational(k * k + 1), Rational(k * k - 1));
      EXPECT_GT(u[i][0] * u[i + 1][1] - u[i][1] * u[i + 1][0], Rational(0));
    }
  }
}

TEST(Directions, RandomLattices) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(150u); ++seed) {
    SCOPED_TRACE(seed);
    run_both(direction_lattice(seed, 1), static_cast<int>(seed % 4) + 1, &external);
  }
  EXPECT_GT(external, test::seen_in_fewer(1000u));
}

TEST(Directions, RandomLatticesOfHigherDegree) {
  std::uint64_t external = 0;
  for (const int degree : {2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(30u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const DirectionsRun run(direction_lattice(seed, degree), "directions_2", static_cast<int>(seed % 3) + 1);
      external += run.ledger().external;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(300u));
}

TEST(Directions, RandomFlights) {
  std::uint64_t external = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      run_both(random_flights(seed, 9, 2, degree, seed % 2 == 0), 2, &external);
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(100u));
}

// Along two axes every one of the n points is extreme for some time: 2kn = 2n changes for k = 1.
TEST(Directions, TheBoundOnLinearMotionIsReached) {
  for (const int n : {3, 4, 6, 8}) {
    SCOPED_TRACE(n);
    const DirectionsRun run(dual_circles(n), "directions_2", 1);
    EXPECT_EQ(run.ledger().failures, static_cast<std::uint64_t>(2 * n));
    EXPECT_EQ(run.ledger().max_live, 4u);
    run_both(dual_circles(n), 3);
  }
}

// The square of the distance of two objects at the snapshot's time.
Rational squared(const Snapshot& now, ObjectId a, const std::vector<Rational>& centre) {
  Rational sum;
  for (int axis = 0; axis < 2; ++axis) {
    const Rational d = now.position(a, axis) - centre[static_cast<std::size_t>(axis)];
    sum += d * d;
  }
  return sum;
}

// The centre of the least circle around these objects: of all circles on two or three of them that
// hold all, the smallest.
std::vector<Rational> circle_around(const Snapshot& now, const Ids& ids) {
  std::vector<Rational> best;
  Rational least;
  const auto offer = [&](std::vector<Rational> centre) {
    Rational radius;
    for (const ObjectId id : ids) radius = std::max(radius, squared(now, id, centre));
    if (!best.empty() && !(radius < least)) return;
    best = std::move(centre);
    least = radius;
  };
  const auto at = [&](ObjectId id, int axis) { return now.position(id, axis); };
  const Rational half = Rational(1) / Rational(2);
  for (const ObjectId a : ids) {
    for (const ObjectId b : ids) {
      offer({(at(a, 0) + at(b, 0)) * half, (at(a, 1) + at(b, 1)) * half});
      for (const ObjectId c : ids) {
        const Rational bx = at(b, 0) - at(a, 0), by = at(b, 1) - at(a, 1);
        const Rational cx = at(c, 0) - at(a, 0), cy = at(c, 1) - at(a, 1);
        const Rational d = Rational(2) * (bx * cy - by * cx);
        if (d.is_zero()) continue;
        const Rational bb = bx * bx + by * by, cc = cx * cx + cy * cy;
        offer({at(a, 0) + (cy * bb - by * cc) / d, at(a, 1) + (bx * cc - cx * bb) / d});
      }
    }
  }
  return best;
}

// The least circle around the polygon, grown by sqrt(1 + 1/k^2) about its centre, holds all points.
TEST(Directions, GuaranteeForTheCircle) {
  for (const int k : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      Random random(seed);
      std::vector<Trajectory> t;
      for (int i = 0; i < 12; ++i) t.push_back(random.small_path(2, 1, 100));
      const Scene scene = asking_along(scene_of(t, 0, Rational(3)), "directions_2", k);
      Simulator simulator(scene, planned_arithmetic("exact", scene), Trial::options({}));
      add_structures(simulator, scene);
      simulator.start();
      for (int i = 1; i < 9; ++i) {
        const Rational time = Rational(i) / Rational(3);
        simulator.run_until(time);
        const Snapshot now = simulator.snapshot(time);
        const Ids ids = simulator.structure(0).attribute().ids;
        const std::vector<Rational> centre = circle_around(now, ids);
        Rational inner, all;
        for (const ObjectId id : ids) inner = std::max(inner, squared(now, id, centre));
        for (ObjectId id = 0; id < 12; ++id) all = std::max(all, squared(now, id, centre));
        EXPECT_LE(all * Rational(k * k), inner * Rational(k * k + 1)) << k << ", seed " << seed;
      }
    }
  }
}

TEST(Directions, ReferenceScenes) {
  for (const int n : {4, 6, 8, 10}) {
    SCOPED_TRACE(n);
    for (const int k : {1, 2, 4}) run_both(remainders(n), k);
  }
}

TEST(Directions, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    for (const int k : {1, 4}) run_both(scene, k);
    // The third one is on the hull, but in none of the four directions of the axes.
    EXPECT_EQ(DirectionsRun(scene, "directions_2", 1).begins_with.size(),
              static_cast<std::size_t>(std::min(n, 2)));
    EXPECT_EQ(DirectionsRun(scene, "directions_2", 9).begins_with.size(),
              static_cast<std::size_t>(n));
  }
}

// Three points on a line along the axes, or across every second direction: the one in the middle
// has the smallest id, is extreme across the line, and is no vertex.
TEST(Directions, PointsOfAnEdgeAreNoVertices) {
  const Scene upright = scene_of(
      {path({{2, 1}, {0}}), path({{2, 1}, {3}}), path({{2, 1}, {-4}}), path({{-1}, {0}})}, 0, 2);
  for (const char* structure : {"directions_2", "directions_2_tournament"}) {
    EXPECT_EQ(DirectionsRun(upright, structure, 1).begins_with, (Ids{1, 3, 2}));
    // Without the fourth all are identically on one line.
    Scene line = upright;
    line.objects.pop_back();
    EXPECT_EQ(DirectionsRun(line, structure, 1).begins_with, (Ids{1, 2}));
    EXPECT_EQ(DirectionsRun(line, structure, 5).begins_with, (Ids{1, 2}));
    // The one in the middle goes on along the line, and becomes its end.
    Scene along = upright;
    along.objects[0].motion.pieces[0].trajectory = path({{2, 1}, {0, 5}});
    const DirectionsRun run(along, structure, 1);
    EXPECT_EQ(run.ids(), (Ids{0, 3, 2}));
    EXPECT_EQ(run.changes(), (std::vector<std::string>{"leave 1 !", "enter 0 2 3 !"}));
  }
}

TEST(Directions, EqualPoints) {
  const DirectionsRun all(scene_of(std::vector<Trajectory>(5, path({{1, 1}, {2, -3}})), 0, 4),
                          "directions_2", 4);
  EXPECT_EQ(all.begins_with, Ids{0});
  EXPECT_EQ(all.ledger().failures, 0u);
  // Through one point at one instant.
  std::vector<Trajectory> t;
  for (int i = 0; i < 9; ++i) t.push_back(path({{0, i - 4}, {0, (i * 5) % 9 - 4}}));
  for (const int k : {1, 2, 5}) run_both(scene_of(t, -1, 1), k);
  for (const int k : {1, 2, 5}) run_both(scene_of(t, 0, 1), k);  // and from there on
}

TEST(Directions, Jumps) {
  const Scene scene = one_jumps(2, 2);
  run_both(scene, 2);
  const DirectionsRun run(scene, "directions_2", 2);
  EXPECT_EQ(run.begins_with, (Ids{0, 2, 3}));
  EXPECT_EQ(run.ids(), (Ids{0, 1, 3}));
  EXPECT_EQ(run.ledger().external, 0u);
}

TEST(Directions, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    run_both(in_units_of(size), 3);
  }
}

TEST(Directions, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (const int degree : {1, 2}) {
      for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
        const DirectionsRun run(random_flights(seed, 9, 2, degree, seed % 2 == 0), "directions_2",
                                2, arithmetic);
        EXPECT_TRUE(run.ledger().corrupt || run.ids().size() <= 8) << arithmetic;
      }
    }
  }
}

TEST(Directions, AreReadAsAHull) {
  const DirectionsRun run(remainders(8), "directions_2", 4);
  const auto& source = dynamic_cast<const HullSource&>(run.simulator.structure(run.id));
  EXPECT_EQ(source.ring().cycle(), run.ids());
  EXPECT_EQ(source.ring().size(), run.ids().size());
}

TEST(Directions, TheNumberOfDirectionsIsChecked) {
  const Scene scene = remainders(4);
  const auto refused = [&](const Rational& k) {
    Scene asked = asking_along(scene, "directions_2", 1);
    asked.maintain[0].parameters[0].value = k;
    try {
      Simulator simulator(asked, planned_arithmetic("exact", asked), Trial::options({}));
      add_structures(simulator, asked);
    } catch (const std::invalid_argument&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refused(1));
  EXPECT_FALSE(refused(60));
  for (const Rational& k : {Rational(0), Rational(-1), Rational(1) / Rational(2), Rational(61)}) {
    EXPECT_TRUE(refused(k)) << k.to_string();
  }
}

}  // namespace directions_2_test
}  // namespace kinex::test

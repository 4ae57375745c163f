// SPDX-License-Identifier: GPL-3.0-or-later
// The diameter in space by directions, against all pairs.
#include "predicates/points/unit_directions_3.h"
#include "structures/extent/extent_guarantees_audit.h"
#include "tests/sanitized.h"
#include "tests/structures/extent/directions_support.h"

namespace kinex::test {
namespace extent_directions_3_test {

Rational product(const DirectionVector& u, const DirectionVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

TEST(UnitDirections3, AreUnitVectorsCloseToEverything) {
  const std::vector<std::size_t> sizes{3, 27, 27, 75, 75, 75};
  Random random(11);
  for (int k = 1; k <= 6; ++k) {
    const std::vector<DirectionVector> all = unit_directions_3(k);
    // For k = 5 vectors of two axes are the same.
    if (k != 5) {
      EXPECT_EQ(all.size(), sizes[static_cast<std::size_t>(k - 1)]) << k;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(product(all[i], all[i]), Rational(1));
      for (std::size_t j = 0; j < i; ++j) EXPECT_LT(product(all[i], all[j]), Rational(1));
    }
    for (int trial = 0; trial < test::fewer(100); ++trial) {
      const DirectionVector v{Rational(random.between(-9, 9)), Rational(random.between(-9, 9)),
                              Rational(random.between(-9, 9))};
      Rational best(0);
      for (const DirectionVector& u : all) best = std::max(best, product(u, v) * product(u, v));
      const Rational least = Rational(1) - Rational(1) / Rational(k * k);
      EXPECT_GE(best, least * least * product(v, v)) << k;
    }
  }
}

Scene lattice_in_space(std::uint64_t seed, int degree) {
  Random random(seed);
  std::vector<Trajectory> t;
  const int n = random.between(2, 7);
  for (int i = 0; i < n; ++i) t.push_back(random.small_path(3, degree, degree == 1 ? 2 : 1));
  return scene_of(t, -2, Rational(3));
}

TEST(ExtentDirections3, RandomLattices) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(24u); ++seed) {
    SCOPED_TRACE(seed);
    const DirectionsRun run(lattice_in_space(seed, 1), "diameter_directions", 2);
    external += run.ledger().external;
  }
  EXPECT_GT(external, test::seen_in_fewer(20u));
}

TEST(SlowExtentDirections3, RandomLattices) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const DirectionsRun run(lattice_in_space(seed, 1 + static_cast<int>(seed % 2)),
                            "diameter_directions", 2 + static_cast<int>(seed % 5));
  }
}

TEST(ExtentDirections3, PlansThatChange) {
  for (std::uint64_t seed = 1; seed <= test::fewer(3u); ++seed) {
    SCOPED_TRACE(seed);
    const DirectionsRun run(random_flights(seed, 6, 3, 1 + static_cast<int>(seed % 2), true),
                            "diameter_directions", 2);
  }
}

TEST(ExtentDirections3, FewPoints) {
  for (int n = 0; n <= 3; ++n) {
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{i, 1 - i}, {-i, i * i}, {0, i}}));
    Scene scene = scene_of(t, -2, Rational(2));
    scene.dimension = 3;
    const DirectionsRun run(scene, "diameter_directions", 2);
    EXPECT_EQ(run.simulator.structure(run.id).attribute().ids.size(), n < 2 ? 0u : 2u);
  }
}

// The distance of the pair that is found against that of the farthest pair, at rational times.
TEST(ExtentDirections3, AgainstAllPairs) {
  for (const int k : {3, 6}) {
    Scene scene = lattice_in_space(5, 1);
    Random random(3);
    for (int i = 0; i < 12; ++i) {
      scene.objects.push_back(moving("q" + std::to_string(i), random.small_path(3, 1, 9)));
    }
    scene.maintain = {{"diameter_directions", "directions", {}, {}, {{"k", Rational(k)}}},
                      {"diameter_all_pairs", "pairs", {}}};
    Simulator simulator(scene, planned_arithmetic("exact", scene), {});
    add_structures(simulator, scene);
    simulator.start();
    const Rational inner = Rational(1) - Rational(1) / Rational(k * k);
    for (int i = -19; i < 30; ++i) {
      simulator.run_until(Rational(Integer(i), Integer(10)));
      const Snapshot now = simulator.snapshot(simulator.reached());
      const Rational near = squared_diameter(now, simulator.structure(0).attribute().ids);
      const Rational farthest = squared_diameter(now, simulator.structure(1).attribute().ids);
      EXPECT_LE(near, farthest);
      EXPECT_GE(near, inner * inner * farthest);
    }
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
  }
}

}  // namespace extent_directions_3_test
}  // namespace kinex::test

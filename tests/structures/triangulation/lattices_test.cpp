// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations on lattices where degenerate instants are common, audited after every event and compared
// with `sturm`: in space, and with weights.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace lattices_test {

// Random points of {0, 1, 2}^d with velocities in {-1, 0, 1}^d; integer weights up to `most` either way that
// change by as much.
Scene weighted_lattice(std::uint64_t seed, int n, int dimension, int most = 1) {
  Scene scene = lattice_scene(seed, n, dimension);
  scene.extents = Extents::kWeight;
  Random random(seed + 1000000);
  for (SceneObject& object : scene.objects) {
    object.motion.pieces[0].trajectory.coordinates.push_back(
        {Rational(random.between(-most, most)), Rational(random.between(-most, most))});
  }
  return scene;
}

void expect_clean(const Scene& scene, const std::string& structure) {
  Trial trial(scene, structure);
  trial.to_end();
  EXPECT_EQ(trial.simulator.violations(), std::vector<std::string>{});
}

using Lattice = std::pair<std::uint64_t, int>;

// Each seed is wrong without one of the rules: a tie has a certificate of its own (1039); what was sewn does
// not go round an edge twice with what is around it (56, 1098); certificates on the hull fail at touches (278),
// and so do the others (759, 858).
TEST(Delaunay3Lattices, EveryRuleIsNeeded) {
  for (const auto& [seed, n] : std::vector<Lattice>{
           {1039, 7}, {1039, 8}, {56, 9}, {1098, 9}, {278, 7}, {759, 9}, {858, 7}, {858, 8}}) {
    SCOPED_TRACE(std::to_string(seed) + ", n = " + std::to_string(n));
    expect_clean(lattice_scene(seed, n, 3), "delaunay_3");
    expect_clean(weighted_lattice(seed, n, 3, 0), "regular_3");
  }
}

// Three certificates of one polynomial touch zero at t = 1 and fail at t = 2: each is handled at both, though the
// first one is certified anew, to t = 2, before the others are handled at t = 1.
TEST(Regular3Lattices, CertificatesOfOnePolynomialTouchOneAfterTheOther) {
  for (const char* arithmetic : {"exact", "sturm"}) {
    const Scene scene = weighted_lattice(64, 5, 3);
    Trial trial(scene, "regular_3", arithmetic);
    trial.to_end();
    EXPECT_EQ(trial.simulator.violations(), std::vector<std::string>{});
    EXPECT_EQ(
        std::count(trial.sink.lines.begin(), trial.sink.lines.end(), "regular_3 touch 0 1 2 3 4"),
        3);
  }
}

// KINEX_LATTICE_SEEDS: how many seeds, of `sizes` scenes each.
void scan(const std::string& structure, std::uint64_t usual, int least, int sizes,
          const std::function<Scene(std::uint64_t, int)>& scene_of) {
  const char* wanted = std::getenv("KINEX_LATTICE_SEEDS");
  const std::uint64_t seeds = wanted == nullptr ? usual : std::strtoull(wanted, nullptr, 10);
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds) && !testing::Test::HasFailure(); ++seed) {
    for (int n = least; n < least + sizes; ++n) {
      SCOPED_TRACE(std::to_string(seed) + ", n = " + std::to_string(n));
      expect_clean(scene_of(seed, n), structure);
    }
  }
}

TEST(SlowLattices, Delaunay3) {
  scan("delaunay_3", 40, 5, 5, [](std::uint64_t seed, int n) { return lattice_scene(seed, n, 3); });
}
TEST(SlowLattices, Regular2) {
  scan("regular_2", 60, 5, 5,
       [](std::uint64_t seed, int n) { return weighted_lattice(seed, n, 2); });
}
TEST(SlowLattices, Regular3) {
  scan("regular_3", 20, 5, 5,
       [](std::uint64_t seed, int n) { return weighted_lattice(seed, n, 3); });
}

}  // namespace lattices_test
}  // namespace kinex::test

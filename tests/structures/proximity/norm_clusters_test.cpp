// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning trees in the maximum norm and in that of a polygon by clusters of the points:
// audited after every instant against all pairs, and the changes are those by the list.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace norm_clusters_test {

using Ids = std::vector<ObjectId>;

// By the list, and by clusters of the usual size or of this many points.
std::vector<Request> trees(const std::string& group, int size) {
  std::vector<Request> all{ask(group + "_list"), ask(group + "_clusters")};
  if (size > 0) all[1] = ask(group + "_clusters", "cluster", size);
  return all;
}

const std::string kNorms[] = {"mst_maximum_norm", "mst_polygon"};

TEST(NormClusters, ReferenceCounts) {
  const std::uint64_t swaps[2][2] = {{10, 7}, {19, 13}};  // by points, then by norm
  for (const int i : {0, 1}) {
    for (const int norm : {0, 1}) {
      if (i > 0 && norm > 0) continue;
      const Scene scene = reference_scene(6 + 2 * i, 2, 1);
      const TwinRun run(scene, trees(kNorms[norm], 2 - i));
      EXPECT_EQ(run.ledger(1).external, swaps[i][norm]);
    }
  }
}

// Lengths that are identically equal, and many exchanges at one instant.
TEST(NormClusters, TinyLattices) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
    SCOPED_TRACE(seed);
    const int size = static_cast<int>(seed % 4), n = 5 + static_cast<int>(seed % 3);
    external += TwinRun(lattice_scene(seed, n, 2), trees(kNorms[0], size)).ledger().external;
    if (seed % 4 == 0) TwinRun(lattice_scene(seed, n, 2), trees(kNorms[1], size));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(16u));
}

// Of one norm, each seed in turn with clusters of the usual size and of 1, 2 and 3 points.
void on_lattices(const std::string& norm, std::uint64_t seeds) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const int size = static_cast<int>(seed % 4), few = static_cast<int>(seed % 3);
    const int n = seed % 9 == 0 ? 8 + static_cast<int>(seed % 2) : 5 + few;
    external += TwinRun(lattice_scene(seed, n, 2), trees(norm, size)).ledger().external;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, 2 * seeds);
}

TEST(SlowNormClusters, TinyLatticesInTheMaximumNorm) { on_lattices(kNorms[0], 600); }

TEST(SlowNormClusters, TinyLatticesInThatOfAPolygon) { on_lattices(kNorms[1], 220); }

// Points come and go, and have new flight plans.
TEST(NormClusters, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2}) {
    const Scene scene = random_flights(static_cast<std::uint64_t>(degree), 8, 2, degree, degree == 2);
    const TwinRun run(scene, trees(kNorms[0], degree)),
        twin(scene, trees(kNorms[0], degree), "sturm");
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
    external += run.ledger().external;
    updates += run.ledger().motion_updates;
  }
  EXPECT_GT(external, 4u);
  EXPECT_GT(updates, 2u);
}

// New flight plans under which lengths are identically equal that were not, and the reverse.
TEST(NormClusters, LengthsThatBecomeEqual) {
  Scene scene = scene_of(
      {path({{0}, {0}}), path({{4, 1}, {1}}), path({{-5}, {2}}), path({{1}, {7}})}, 0, Rational(6));
  auto& pieces = scene.objects[1].motion.pieces;
  pieces[0].to = Rational(1);
  pieces.push_back({Rational(1), Rational(3), path({{5}, {1}})});
  pieces.push_back({Rational(3), std::nullopt, path({{8, -1}, {1}})});
  for (const std::string& norm : kNorms) {
    for (const int size : {0, 1, 2}) TwinRun(scene, trees(norm, size));
  }
}

TEST(NormClusters, NothingAndTies) {
  for (const std::string& norm : kNorms) {
    const TwinRun none(from_nothing_to_nothing(), trees(norm, 0));
    EXPECT_EQ(none.attribute(1), Ids{});
    const TwinRun all(scene_of(std::vector<Trajectory>(4, path({{1, 1}, {2}})), 0, Rational(2)),
                      trees(norm, 1));
    EXPECT_EQ(all.attribute(1), (Ids{0, 1, 1, 2, 2, 3}));
  }
}

}  // namespace norm_clusters_test
}  // namespace kinex::test

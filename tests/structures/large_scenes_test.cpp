// SPDX-License-Identifier: GPL-3.0-or-later
// Objects at rest cost nothing: by the ledger, not by the clock.
#include <cstdint>
#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace large_scenes_test {

// Failure times computed of polynomials that are not constant.
std::uint64_t moving_polynomials(const Trial& run) {
  const auto& solved = run.simulator.arithmetic().counters().polynomials_solved;
  std::uint64_t sum = 0;
  for (std::size_t degree = 1; degree < solved.size(); ++degree) sum += solved[degree];
  return sum;
}

std::uint64_t comparisons(const Trial& run) {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : run.simulator.arithmetic().counters().comparisons) {
    sum += count;
  }
  return sum;
}

std::vector<Trajectory> standing(std::uint64_t seed, int n, int size) {
  Random random(seed);
  std::vector<Trajectory> paths;
  for (int i = 0; i < n; ++i) {
    paths.push_back(path({{random.between(0, size)}, {random.between(0, size)}}));
  }
  return paths;
}

void expect_no_work(const Scene& scene, const std::string& structure, const Key& key = {}) {
  SCOPED_TRACE(structure + " of " + std::to_string(scene.objects.size()));
  Trial run(scene, structure, "exact", AuditLevel::kEnd, key);
  EXPECT_EQ(run.simulator.queue().size(), 0u);
  run.to_end().expect_clean();
  if (structure != "maximum_dual_hull") {  // there is no next winner
    EXPECT_GT(run.ledger().live, 0u);
  }
  EXPECT_EQ(run.ledger().processed, 0u);
  EXPECT_EQ(run.simulator.ledger().max_queue, 0u);  // nothing was ever scheduled
  EXPECT_EQ(moving_polynomials(run), 0u);           // or solved
  EXPECT_EQ(comparisons(run), 0u);
  EXPECT_EQ(run.simulator.arithmetic().counters().roots_made_exact, 0u);
}

Key distance_to(ObjectId object) {
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = object;
  return key;
}

constexpr int kMany = kSanitized ? 10000 : 100000;
constexpr const char* kOneDimensional[] = {"sorted_list",        "maximum_tournament",
                                           "minimum_tournament", "maximum_heap",
                                           "minimum_heap",       "maximum_hanger"};

TEST(LargeScenes, StandingPointsAreNeverScheduled) {
  const Scene scene = scene_of(standing(1, kMany, 1 << 24), 0, Rational(1000));
  expect_no_work(scene, "delaunay_2");
  for (const char* structure : kOneDimensional) {
    expect_no_work(scene, structure);
    expect_no_work(scene, structure, distance_to(17));
  }
  expect_no_work(scene, "maximum_dual_hull");
}

TEST(LargeScenes, StandingPointsInOnePlaceOrOnAGridAreNeverScheduled) {
  // About ten points at every place of a grid.
  const Scene scene = scene_of(standing(2, kMany, 99), 0, Rational(1000));
  expect_no_work(scene, "delaunay_2");
  expect_no_work(scene, "sorted_list");
  expect_no_work(scene, "sorted_list", distance_to(0));
  expect_no_work(scene, "maximum_tournament", distance_to(0));
}

// One moves among n at rest: only certificates with it are solved and scheduled.
TEST(LargeScenes, OneMovesAmongManyThatStand) {
  const int n = 10000;
  std::vector<Trajectory> paths = standing(3, n, 1 << 20);
  paths.push_back(path({{-(1 << 18), 3 << 19}, {1 << 18, 1 << 17}}));
  const ObjectId mover = n;
  const Scene scene = scene_of(paths, 0, Rational(1));
  for (const std::string structure :
       {"delaunay_2", "sorted_list", "maximum_tournament", "minimum_heap"}) {
    SCOPED_TRACE(structure);
    Trial run(scene, structure, "exact", AuditLevel::kEnd);
    const std::uint64_t at_start = run.simulator.live_certificates(0, mover);
    EXPECT_LE(moving_polynomials(run), at_start);
    EXPECT_LE(run.simulator.queue().size(), at_start);
    const std::uint64_t built = run.ledger().certificates_created;
    run.to_end().expect_clean();
    const std::uint64_t renewed = run.ledger().certificates_created - built;
    EXPECT_LE(moving_polynomials(run), at_start + renewed);
    EXPECT_LE(run.simulator.ledger().max_queue, run.ledger().max_per_object);
    EXPECT_LE(run.simulator.queue().size(), run.simulator.live_certificates(0, mover));
    if (structure == "delaunay_2") {
      EXPECT_GT(run.ledger().processed, 300u);
      EXPECT_EQ(run.ledger().rebuilds, 0u);
      EXPECT_LE(renewed, 5 * run.ledger().processed);
      EXPECT_LT(run.ledger().processed, 2000u);  // about sqrt(n) triangles on its way
    }
    if (structure == "sorted_list") {
      EXPECT_GT(run.ledger().processed, 9000u);
      EXPECT_LE(renewed, 3 * run.ledger().processed);
    }
  }
}

// The same around a moving object: every distance changes, and all certificates are scheduled.
TEST(LargeScenes, AMovingReferenceMovesEverything) {
  std::vector<Trajectory> paths = standing(4, 1000, 1 << 20);
  paths.push_back(path({{0, 1}, {0}}));
  const Scene scene = scene_of(paths, 0, Rational(1));
  Trial run(scene, "sorted_list", "exact", AuditLevel::kEnd, distance_to(1000));
  EXPECT_GT(moving_polynomials(run), 900u);
  run.to_end().expect_clean();
}

}  // namespace large_scenes_test
}  // namespace kinex::test

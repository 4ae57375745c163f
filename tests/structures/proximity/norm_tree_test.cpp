// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning tree in the maximum norm by two engines in one run, over either structure of
// octants: each is audited after every instant against all pairs, and all report the same changes.
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/proximity/fresh_runs.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace norm_tree_test {

using Ids = std::vector<ObjectId>;

Request over(const char* engine, const char* octants) {
  Request request = ask(engine);
  request.label = std::string(engine) + " over " + octants;
  request.over = {ask(octants)};
  return request;
}

// Both engines, over both structures of octants.
std::vector<Request> trees() {
  return {over("mst_maximum_norm_list", "octants_local"),
          over("mst_maximum_norm_cycles", "octants_local"),
          over("mst_maximum_norm_list", "octants_listed"),
          over("mst_maximum_norm_cycles", "octants_listed")};
}

// One engine over each.
std::vector<Request> two_trees() {
  return {over("mst_maximum_norm_list", "octants_listed"),
          over("mst_maximum_norm_cycles", "octants_local")};
}

TEST(NormTree, ReferenceCounts) {
  struct Counted {
    int n;
    std::uint64_t seed, swaps, instants;
  };
  for (const Counted& one : {Counted{6, 1, 10, 10}, {8, 1, 19, 17}}) {
    SCOPED_TRACE(one.n);
    const Scene scene = reference_scene(one.n, 2, one.seed);
    const TwinRun run(scene, trees());
    EXPECT_EQ(run.ledger().external, one.swaps);
    std::set<std::string> instants;
    for (const std::string& line : run.changes(0)) instants.insert(line.substr(0, line.find(' ')));
    EXPECT_EQ(instants.size(), one.instants);
    EXPECT_EQ(TwinRun(scene, two_trees()).sink.log.lines,
              TwinRun(scene, two_trees(), "sturm").sink.log.lines);
  }
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5);
    external += TwinRun(lattice_scene(seed, n, 2), two_trees()).ledger().external;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, 2 * test::seen_in_fewer(seeds));
}

TEST(NormTree, TinyLattices) { on_lattices(100); }

TEST(SlowNormTree, TinyLattices) { on_lattices(750); }

TEST(NormTree, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 1u : degree == 1 ? 4u : 2u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = random_flights(seed, 9, 2, degree, seed % 2 == 0);
      const TwinRun run(scene, two_trees()), twin(scene, two_trees(), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, kSanitized ? 10u : 50u);
  EXPECT_GT(updates, kSanitized ? 5u : 15u);
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(NormTree, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 1; seed <= test::fewer(2u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_flights(seed, 9, 2, 2, true, plan_instants(seed));
    runs.expect_to_go_on(scene, trees(), seed);
  }
  runs.expect_changes();
}

TEST(NormTree, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    const TwinRun run(scene, trees());
    EXPECT_EQ(run.attribute().size(), n < 2 ? 0u : 2u * static_cast<std::size_t>(n - 1));
  }
}

TEST(NormTree, FromNothingToNothing) {
  const TwinRun run(from_nothing_to_nothing(), trees());
  EXPECT_EQ(run.begins_with, Ids{});
  EXPECT_EQ(run.attribute(), Ids{});
  EXPECT_EQ(run.ledger().insertions, 7u);
}

// Identically equal lengths are in the order after a turn: of a grid that is turned by a little,
// counter-clockwise, all edges along y come first or last alike.
TEST(NormTree, Ties) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 9; ++i) t.push_back(path({{i % 3, 1}, {i / 3, 2}}));
  const TwinRun grid(scene_of(t, 0, Rational(5)), trees());
  EXPECT_EQ(grid.attribute().size(), 16u);
  EXPECT_EQ(grid.ledger(0).external, 0u);
  // Identically equal points are a path by ids.
  const TwinRun all(scene_of(std::vector<Trajectory>(4, path({{1, 1}, {2}})), 0, Rational(2)),
                    trees());
  EXPECT_EQ(all.attribute(), (Ids{0, 1, 1, 2, 2, 3}));
}

// A pair that goes from one octant to the next has the other coordinate for its length: here the
// two are the only edge, then two edges exchange their order because of it.
TEST(NormTree, AnEdgeThatChangesItsOctant) {
  // |01| = max(4, 2 + t), |02| = max(5, ..): at t = 3 the second edge is the shorter one.
  const TwinRun run(scene_of({path({{0}, {0}}), path({{4}, {2, 1}}), path({{-5}, {0}}),
                              path({{-2}, {-4}})},
                             0, Rational(9)),
                    trees());
  EXPECT_EQ(run.begins_with, (Ids{0, 1, 0, 3, 2, 3}));
  EXPECT_EQ(run.attribute(), (Ids{0, 1, 0, 3, 2, 3}));
  EXPECT_EQ(run.ledger(0).external, 0u);
}

// New flight plans under which lengths are identically equal that were not, and the reverse.
TEST(NormTree, LengthsThatBecomeEqual) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4, 1}, {1}}), path({{-5}, {2}}),
                          path({{1}, {7}})},
                         0, Rational(6));
  auto& pieces = scene.objects[1].motion.pieces;
  pieces[0].to = Rational(1);
  pieces.push_back({Rational(1), Rational(3), path({{5}, {1}})});
  pieces.push_back({Rational(3), std::nullopt, path({{8, -1}, {1}})});
  const TwinRun run(scene, trees()), twin(scene, trees(), "sturm");
  EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
}

TEST(NormTree, PointsMeetAndJump) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4}, {1}}), path({{9}, {3}}), path({{2}, {8}}),
                          path({{8, -1}, {2}}), path({{0, 1}, {2}})},
                         0, Rational(8));
  scene.jumps = true;
  jump(scene, 2, 1, path({{2}, {7}}));
  const TwinRun run(scene, trees());
  EXPECT_EQ(run.attribute().size(), 10u);
  // All points pass through one at t = 0.
  std::vector<Trajectory> t;
  for (int i = 0; i < 8; ++i) t.push_back(path({{0, (i * 7) % 12 - 6}, {0, (i * 5) % 12 - 5}}));
  const TwinRun meet(scene_of(t, -1, Rational(1)), trees());
  EXPECT_EQ(meet.attribute().size(), 14u);
}

TEST(NormTree, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    const TwinRun run(in_units_of(size), trees());
    EXPECT_GT(run.ledger().external, 0u);
  }
}

TEST(NormTree, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      const TwinRun flights(random_flights(seed, 9, 2, 1, seed % 2 == 0), two_trees(), arithmetic);
      const TwinRun lattice(lattice_scene(seed, 8, 2), two_trees(), arithmetic);
      EXPECT_TRUE(flights.ledger().corrupt || flights.attribute().size() <= 16) << arithmetic;
    }
  }
}

// ---- metamorphic

std::string edge(const Image& image, ObjectId a, ObjectId b) {
  return std::to_string(std::min(image.old_id(a), image.old_id(b))) + "-" +
         std::to_string(std::max(image.old_id(a), image.old_id(b)));
}

// The edges that are exchanged, in old ids. Where an instant exchanges several, their pairing depends
// on the ids and on the direction of time.
std::vector<Moment> moments(const Image& image, const std::string& structure) {
  return moments_of(external_events(image.scene, ask(structure)), image,
                    [&](const Recorded& event) -> std::optional<std::string> {
                      std::string gone = edge(image, event.ids[0], event.ids[1]);
                      std::string came = edge(image, event.ids[2], event.ids[3]);
                      if (image.reverses_time()) std::swap(gone, came);
                      return gone + " for " + came;
                    });
}

// Time stretched, scenes mirrored, carried along, enlarged: the same tree.
TEST(NormTree, Metamorphic) {
  std::size_t seen = 0;
  for (const int degree : {1, 2}) {
    Random random(static_cast<std::uint64_t>(degree) + 50);
    std::vector<Trajectory> paths;
    for (int i = 0; i < 8; ++i) paths.push_back(random.small_path(2, degree, 3000));
    const Scene scene = scene_of(paths, -2, Rational(2));
    const Rational third(Integer(1), Integer(3));
    for (const char* structure : {"mst_maximum_norm_list", "mst_maximum_norm_cycles"}) {
      const auto expected = moments({scene, {}, 1, 0, false, {}, "the same"}, structure);
      seen += expected.size();
      for (const Image& image :
           {in_time(scene, {}, Rational(2) * third, third), mirrored(scene, {}, 0),
            mirrored(scene, {}, 1), scaled(scene, {}, Rational(7) * third),
            carried(scene, {}, path({{1000, -third}, {5, third, -7}}))}) {
        SCOPED_TRACE(image.how);
        expect_same_moments(expected, moments(image, structure));
      }
    }
  }
  EXPECT_GT(seen, 30u);
}

}  // namespace norm_tree_test
}  // namespace kinex::test

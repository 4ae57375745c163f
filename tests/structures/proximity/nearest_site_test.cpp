// SPDX-License-Identifier: GPL-3.0-or-later
// The site nearest to a moving query, against the smallest squared distance by a tournament of all
// sites: the same changes at the same instants.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace nearest_site_test {

using Ids = std::vector<ObjectId>;

std::vector<Request> nearest_to(ObjectId query) {
  Request delaunay = ask("nearest_site"), tournament = ask("minimum_tournament");
  delaunay.query = query == 0 ? kNoObject : query;
  tournament.key.kind = Key::Kind::kSquaredDistance;
  tournament.key.object = query;
  return {delaunay, tournament};
}

TEST(NearestSite, ReferenceCounts) {
  struct Row {
    int n, dimension;
    std::uint64_t seed, changes;
  };
  for (const Row& row : {Row{6, 2, 1, 1}, Row{8, 2, 1, 2}, Row{10, 2, 2, 4}, Row{12, 2, 3, 3},
                         Row{6, 3, 1, 1}, Row{7, 3, 2, 3}, Row{8, 3, 1, 1}}) {
    SCOPED_TRACE(std::to_string(row.n) + " in " + std::to_string(row.dimension) + " axes");
    const Scene scene = reference_scene(row.n, row.dimension, row.seed);
    const TwinRun run(scene, nearest_to(0)), twin(scene, nearest_to(0), "sturm");
    EXPECT_EQ(run.simulator.structure(0).name(), row.dimension == 2 ? "delaunay_2" : "delaunay_3");
    EXPECT_EQ(run.ledger().external, row.changes);
    EXPECT_EQ(run.ledger().failures, row.changes);  // no failure is in vain
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

void on_lattices(std::uint64_t seeds, int dimension) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5);
    const TwinRun run(lattice_scene(seed, n, dimension),
                      nearest_to(static_cast<ObjectId>(seed % 3)));
    external += run.ledger().external;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(seeds) / 2);
}

TEST(NearestSite, TinyLattices) { on_lattices(120, 2); }
TEST(NearestSite, TinyLatticesInSpace) { on_lattices(24, 3); }

TEST(SlowNearestSite, TinyLattices) {
  on_lattices(2000, 2);
  on_lattices(400, 3);
}

// The query stays; sites come, go and change their motions.
TEST(NearestSite, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const auto& [degree, dimension] : {std::pair{1, 2}, {2, 2}, {3, 2}, {1, 3}, {2, 3}}) {
    const std::uint64_t seeds = dimension == 3 ? (degree == 1 ? 2 : 1) : degree == 1 ? 10 : 4;
    for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", " + std::to_string(dimension) +
                   " axes, seed " + std::to_string(seed));
      Scene scene = random_flights(seed, 9, dimension, degree, seed % 2 == 0);
      scene.objects[4].motion = {};
      Trajectory query = path({{-3, 4}, {1, 2, -1}});
      if (dimension == 3) query = path({{-3, 4}, {1, 2, -1}, {2, -1}});
      scene.objects[4].motion.pieces.push_back({std::nullopt, std::nullopt, query});
      const TwinRun run(scene, nearest_to(4)), twin(scene, nearest_to(4), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(20u));
  EXPECT_GT(updates, test::seen_in_fewer(40u));
}

// The query comes, goes and jumps; there is no tournament for that.
TEST(NearestSite, TheQueryComesAndGoes) {
  for (std::uint64_t seed = 1; seed <= test::fewer(14u); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = random_flights(seed, 8, seed <= 12 ? 2 : 3, 1, true);
    for (ObjectId query = 0; query < 8; ++query) {
      Request request = ask("nearest_site");
      request.query = query == 0 ? kNoObject : query;
      const TwinRun run(scene, {request});
    }
  }
  Scene scene = scene_of({path({{0}, {0}}), path({{1}, {0}}), path({{9}, {0}})}, 0, Rational(4));
  scene.jumps = true;
  jump(scene, 0, 2, path({{8}, {0}}));
  const TwinRun run(scene, {ask("nearest_site")});
  EXPECT_EQ(run.begins_with, Ids{1});
  EXPECT_EQ(run.attribute(), Ids{2});
  EXPECT_EQ(run.ledger().external, 0u);
}

TEST(NearestSite, NoSiteToThree) {
  for (int n = 0; n <= 4; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 0 ? 3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    EXPECT_EQ(TwinRun(scene, {ask("nearest_site")}).attribute().size(), n < 2 ? 0u : 1u);
  }
}

// Sites at identically equal distances: the smallest id; also after new motions.
TEST(NearestSite, Ties) {
  // A query at the centre of a circle of four sites that travels with it.
  std::vector<Trajectory> t{path({{0, 1}, {0, 2}})};
  for (const auto& [x, y] : {std::pair{3, 4}, {-4, 3}, {5, 0}, {-3, -4}}) {
    t.push_back(path({{x, 1}, {y, 2}}));
  }
  const TwinRun circle(scene_of(t, 0, Rational(5)), nearest_to(0));
  EXPECT_EQ(circle.attribute(), Ids{1});
  EXPECT_EQ(circle.ledger().external, 0u);
  // 1 leaves at 2: the next is 2. 1 comes back at 3 and stays.
  Scene scene = scene_of(t, 0, Rational(5));
  auto& pieces = scene.objects[1].motion.pieces;
  pieces[0].to = Rational(2);
  pieces.push_back({Rational(2), Rational(3), path({{-1, 3}, {0, 4}})});
  pieces.push_back({Rational(3), Rational(4), path({{11, -1}, {12, 0}})});
  pieces.push_back({Rational(4), std::nullopt, path({{3, 1}, {4, 2}})});
  const TwinRun parting(scene, nearest_to(0));
  EXPECT_EQ(parting.attribute(), Ids{1});
  EXPECT_GT(parting.ledger().external, 0u);
}

// In space: the centre of a sphere of eight sites; and sites of one plane, on a circle or not.
TEST(NearestSite, TiesInSpace) {
  std::vector<Trajectory> t{path({{0, 1}, {0, 2}, {0, -1}})};
  for (int corner = 0; corner < 8; ++corner) {
    t.push_back(
        path({{corner & 1 ? 1 : -1, 1}, {corner & 2 ? 1 : -1, 2}, {corner & 4 ? 1 : -1, -1}}));
  }
  Scene scene = scene_of(t, 0, Rational(5));
  EXPECT_EQ(TwinRun(scene, nearest_to(0)).attribute(), Ids{1});
  // Each goes away when the next one has become the smallest, the last one stays.
  for (ObjectId site = 1; site < 8; ++site) {
    auto& pieces = scene.objects[site].motion.pieces;
    const Rational leaves(Integer(static_cast<std::int64_t>(site)), Integer(2));
    pieces[0].to = leaves;
    Trajectory away = pieces[0].trajectory;
    away.coordinates[0][0] *= Rational(100);
    pieces.push_back({leaves, std::nullopt, away});
  }
  scene.jumps = true;
  const TwinRun parting(scene, nearest_to(0));
  EXPECT_EQ(parting.attribute(), Ids{8});
}

TEST(NearestSite, SitesOfOnePlaneInSpace) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = lattice_scene(seed, 7, 2);
    scene.dimension = 3;
    for (SceneObject& object : scene.objects) {
      auto& axes = object.motion.pieces[0].trajectory.coordinates;
      axes.push_back(axes[0]);
    }
    // The query crosses the plane.
    auto& axes = scene.objects[3].motion.pieces[0].trajectory.coordinates;
    for (auto& axis : axes) axis.resize(2);
    axes[2][0] += Rational(1);
    axes[2][1] += Rational(2);
    external += TwinRun(scene, nearest_to(3)).ledger().external;
  }
  EXPECT_GT(external, test::seen_in_fewer(6u));
}

TEST(NearestSite, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    const TwinRun run(in_units_of(size), nearest_to(3));
    EXPECT_GT(run.ledger().external, 0u);
  }
}

TEST(NearestSite, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      const TwinRun lattice(lattice_scene(seed, 8, 2), {ask("nearest_site")}, arithmetic);
      EXPECT_TRUE(lattice.ledger().corrupt || lattice.attribute().size() <= 1) << arithmetic;
    }
  }
}

}  // namespace nearest_site_test
}  // namespace kinex::test

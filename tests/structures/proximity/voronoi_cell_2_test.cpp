// SPDX-License-Identifier: GPL-3.0-or-later
// The neighbours of a site in the Voronoi diagram, each run audited after every instant against the
// cell by its definition, and against the edges of the triangulation that it reads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "structures/registry.h"
#include "tests/sanitized.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/proximity/fresh_runs.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace voronoi_cell_2_test {

using Ids = std::vector<ObjectId>;

Request cell_of(ObjectId site) {
  Request request = ask("voronoi_cell_2");
  request.query = site == 0 ? kNoObject : site;
  return request;
}

std::uint64_t count(const TwinRun& run, const std::string& kind) {
  const auto& kinds = run.ledger().by_kind;
  const auto found = kinds.find(kind);
  return found == kinds.end() ? 0 : found->second;
}

// Events "leave" and "enter" of the cell of object 0, counted by brute force over exact positions
// between all critical times, by another program.
TEST(VoronoiCell2, ReferenceCounts) {
  struct Counted {
    int n;
    std::uint64_t seed, leave, enter;
  };
  for (const Counted& one : {Counted{6, 1, 4, 5}, {8, 1, 4, 4}, {10, 2, 9, 9}, {12, 3, 6, 5}}) {
    SCOPED_TRACE(one.n);
    const Scene scene = reference_scene(one.n, 2, one.seed);
    const TwinRun run(scene, {cell_of(0)}), twin(scene, {cell_of(0)}, "sturm");
    EXPECT_EQ(count(run, "leave"), one.leave);
    EXPECT_EQ(count(run, "enter"), one.enter);
    EXPECT_EQ(run.ledger().external, one.leave + one.enter);
    EXPECT_EQ(run.ledger().max_live, 0u);
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

// Every cell of a scene: a site is a neighbour of its neighbours.
TEST(VoronoiCell2, CellsOfAScene) {
  const Scene scene = reference_scene(9, 2, 5);
  std::vector<Request> requests{ask("delaunay_2")};
  for (ObjectId site = 0; site < 9; ++site) {
    requests.push_back(cell_of(site));
    requests.back().label = "cell of " + std::to_string(site);
  }
  const Scene asking = TwinRun::asking(scene, requests);
  Simulator simulator(asking, planned_arithmetic("exact", asking),
                      Trial::options(AuditLevel::kEvents));
  add_structures(simulator, asking);
  simulator.start();
  for (int t = 1; t <= 10; ++t) {
    simulator.run_until(Rational(t));
    Ids edges;
    for (ObjectId a = 0; a < 9; ++a) {
      Ids around = simulator.structure(static_cast<StructureId>(a + 1)).attribute().ids;
      EXPECT_EQ(around.front(), *std::min_element(around.begin(), around.end()));
      std::sort(around.begin(), around.end());
      for (const ObjectId b : around) {
        if (a < b) edges.insert(edges.end(), {a, b});
      }
    }
    EXPECT_EQ(edges, simulator.structure(0).attribute().ids) << t;
  }
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0, turns = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5);
    const TwinRun run(lattice_scene(seed, n, 2), {cell_of(static_cast<ObjectId>(seed % 3))});
    external += run.ledger().external;
    turns += count(run, "turn");
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, 2 * test::seen_in_fewer(seeds));
  EXPECT_GT(turns, test::seen_in_fewer(seeds) / 20);
}

TEST(VoronoiCell2, TinyLattices) { on_lattices(150); }

// All four points are neighbours before and after: another one is inside, and no edge changes.
TEST(VoronoiCell2, NoEdgeChangesButTheOrder) {
  const TwinRun run(lattice_scene(21546, 5, 2), {cell_of(0)});
  EXPECT_GT(count(run, "turn"), 0u);
}

TEST(SlowVoronoiCell2, TinyLattices) { on_lattices(2000); }

TEST(VoronoiCell2, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 10u : 4u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = random_flights(seed, 9, 2, degree, seed % 2 == 0);
      const TwinRun run(scene, {cell_of(4)}), twin(scene, {cell_of(4)}, "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(100u));
  EXPECT_GT(updates, test::seen_in_fewer(40u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(VoronoiCell2, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_flights(seed, 9, 2, 2, true, plan_instants(seed));
    runs.expect_to_go_on(scene, {cell_of(3)}, seed);
  }
  runs.expect_changes();
}

TEST(VoronoiCell2, NoSiteToFour) {
  const Ids expected[] = {{}, {}, {1}, {1, 2}, {1, 3, 2}};
  for (int n = 0; n <= 4; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    const int x[] = {0, 4, -3, 1}, y[] = {0, 1, 2, 5};
    for (int i = 0; i < n; ++i) t.push_back(path({{x[i]}, {y[i]}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    EXPECT_EQ(TwinRun(scene, {cell_of(0)}).attribute(), expected[n]);
  }
}

// The site comes, goes and jumps; sites come and go one by one.
TEST(VoronoiCell2, SitesThatComeAndGo) {
  const TwinRun all(from_nothing_to_nothing(), {cell_of(3)});
  EXPECT_EQ(all.begins_with, Ids{});
  EXPECT_EQ(all.attribute(), Ids{});
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
    for (ObjectId site = 0; site < 8; ++site) {
      const TwinRun run(random_flights(seed, 8, 2, 1, true), {cell_of(site)});
    }
  }
  Scene scene = one_jumps(3, 4);
  scene.jumps = true;
  const TwinRun jumps(scene, {cell_of(2)});
  EXPECT_EQ(jumps.begins_with, (Ids{1, 3}));
  EXPECT_EQ(jumps.attribute(), (Ids{0, 1, 3}));
  EXPECT_EQ(jumps.ledger().external, 0u);
}

// The order around the site, four sites at its corners that turn into a square and on.
TEST(VoronoiCell2, Ties) {
  // A rigid grid: of each square the diagonal of the smallest corner.
  std::vector<Trajectory> t;
  for (int i = 0; i < 9; ++i) t.push_back(path({{i % 3, 1}, {i / 3, 2}}));
  const Scene grid = scene_of(t, 0, Rational(5));
  EXPECT_EQ(TwinRun(grid, {cell_of(4)}).attribute(), (Ids{0, 1, 5, 8, 7, 3}));
  EXPECT_EQ(TwinRun(grid, {cell_of(8)}).attribute(), (Ids{4, 5, 7}));
  EXPECT_EQ(TwinRun(grid, {cell_of(6)}).attribute(), (Ids{3, 7}));
  // Equal sites have one cell; none of them is a neighbour of another.
  std::vector<Trajectory> equal{path({{1}, {1}}), path({{5}, {1}}), path({{1}, {1}}),
                                path({{2}, {4}})};
  for (const ObjectId site : {0, 2}) {
    EXPECT_EQ(TwinRun(scene_of(equal, 0, Rational(1)), {cell_of(site)}).attribute(), (Ids{1, 3}));
  }
  EXPECT_EQ(TwinRun(scene_of(equal, 0, Rational(1)), {cell_of(1)}).attribute(), (Ids{0, 3}));
  // On a line the neighbours are those before and behind.
  std::vector<Trajectory> line;
  for (const int x : {3, 1, 9, 5}) line.push_back(path({{x, 1}, {2 * x, 2}}));
  EXPECT_EQ(TwinRun(scene_of(line, 0, Rational(1)), {cell_of(0)}).attribute(), (Ids{1, 3}));
  EXPECT_EQ(TwinRun(scene_of(line, 0, Rational(1)), {cell_of(2)}).attribute(), Ids{3});
}

// Two neighbours change their order around the site when they pass each other: a turn, or out and in.
TEST(VoronoiCell2, NeighboursThatPassEachOther) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4, 1}, {0, 1}}), path({{6, -1}, {2, -1}}),
                          path({{-5}, {1}}), path({{0}, {-6}}), path({{-1}, {7}})},
                         0, Rational(2));
  const TwinRun run(scene, {cell_of(0)});
  EXPECT_NE(run.begins_with, run.attribute());
  EXPECT_GT(run.ledger().external, 0u);
}

TEST(VoronoiCell2, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    const TwinRun run(in_units_of(size), {cell_of(3)});
    EXPECT_GT(run.ledger().external, 0u);
  }
}

TEST(VoronoiCell2, TheSiteIsAmongItsSites) {
  Scene scene = reference_scene(6, 2, 1);
  const StructureInfo& info = *find_structure_info("voronoi_cell_2");
  Request request = cell_of(4);
  request.of = {Subset::Kind::kObjects, {1, 2, 4, 5}, {}};
  EXPECT_FALSE(refusal_of_objects(info, request, scene));
  const TwinRun run(scene, {request});
  EXPECT_EQ(run.attribute().size() <= 3, true);
  request.of.objects = {1, 2, 5};
  const auto refusal = refusal_of_objects(info, request, scene);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->problem.find("o4"), std::string::npos);
}

TEST(VoronoiCell2, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      const TwinRun lattice(lattice_scene(seed, 8, 2), {cell_of(2)}, arithmetic);
      EXPECT_TRUE(lattice.ledger().corrupt || lattice.attribute().size() <= 7) << arithmetic;
    }
  }
}

// ---- metamorphic

// The neighbours of the first object that come and go, in old ids.
std::vector<Moment> moments(const Image& image) {
  ObjectId site = 0;
  while (image.old_id(site) != 0) ++site;
  return moments_of(external_events(image.scene, cell_of(site)), image,
                    [&](const Recorded& event) -> std::optional<std::string> {
                      const bool enters = (event.kind == 1) != image.reverses_time();
                      return (enters ? "enter " : "leave ") +
                             std::to_string(image.old_id(event.ids[0]));
                    });
}

// Time reversed and stretched, mirrored, turned, carried along, enlarged: the same neighbours.
TEST(VoronoiCell2, Metamorphic) {
  for (const int degree : {1, 2}) {
    Random random(static_cast<std::uint64_t>(degree) + 30);
    std::vector<Trajectory> paths;
    for (int i = 0; i < 8; ++i) paths.push_back(random.small_path(2, degree, 3000));
    paths[0] = path({{10, 3}, {-20, 5}});
    const Scene scene = scene_of(paths, -2, Rational(2));
    const Rational third(Integer(1), Integer(3));
    const auto expected = moments({scene, {}, 1, 0, false, {}, "the same"});
    EXPECT_GT(expected.size(), 5u);
    for (const Image& image :
         {in_time(scene, {}, -1, 0), in_time(scene, {}, Rational(-2) * third, third),
          mirrored(scene, {}, 0), mirrored(scene, {}, 1), turned(scene, {}),
          scaled(scene, {}, Rational(7) * third),
          carried(scene, {}, path({{1000, -third}, {5, third, -7}})),
          permuted(scene, {}, {0, 3, 6, 1, 4, 7, 2, 5})}) {
      SCOPED_TRACE(image.how);
      expect_same_moments(expected, moments(image));
    }
  }
}

}  // namespace voronoi_cell_2_test
}  // namespace kinex::test

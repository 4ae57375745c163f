// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3: counts found by brute force, random flights, tiny lattices, worst cases.
#include "tests/sanitized.h"
#include "tests/structures/triangulation/delaunay_3_support.h"

namespace kinex::delaunay_3_test {
namespace delaunay_3_test {

using test::lattice_scene;
using test::Random;
using test::random_flights;
using test::reference_scene;
using test::scene_of;

TEST(Delaunay3, ReferenceCounts) {
  struct Row {
    int n;
    std::uint64_t seed;
    std::uint64_t inner_2_3, hull_2_3, inner_3_2, hull_3_2;
  };
  for (const Row& row : {Row{6, 1, 2, 4, 3, 4}, Row{7, 2, 9, 7, 8, 10}, Row{8, 1, 5, 9, 5, 9}}) {
    SCOPED_TRACE(row.n);
    const Scene scene = reference_scene(row.n, 3, row.seed);
    World world(scene), sturm(scene, "sturm");
    world.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(world.count("flip_2_3"), row.inner_2_3);
    EXPECT_EQ(world.count("flip_3_2"), row.inner_3_2);
    EXPECT_EQ(world.count("enter") + world.count("hull_2_3"), row.hull_2_3);
    EXPECT_EQ(world.count("leave") + world.count("hull_3_2"), row.hull_3_2);
    EXPECT_EQ(world.count("retile") + world.count("blocked"), 0u);
    EXPECT_EQ(world.lines(), sturm.lines());
  }
}

TEST(Delaunay3, RandomFlights) {
  std::uint64_t events = 0, updates = 0;
  for (const int degree : {1, 2}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 6u : 4u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      World world(random_flights(seed, 8, 3, degree, seed % 2 == 0));
      world.run().expect_clean();
      events += world.ledger().external;
      updates += world.ledger().motion_updates;
    }
  }
  EXPECT_GT(events, test::seen_in_fewer(100u));
  EXPECT_GT(updates, test::seen_in_fewer(10u));
}

// Points of {0, 1, 2}^3 with velocities in {-1, 0, 1}^3: most instants are degenerate.
void tiny_lattices(std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed < first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = lattice_scene(seed, 5 + static_cast<int>(seed % 5), 3);
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.cells(), static_cells(scene, *scene.end));
  }
}
TEST(Delaunay3, TinyLattices) { tiny_lattices(0, 20); }
TEST(SlowDelaunay3, TinyLattices) { tiny_lattices(20, 600); }

TEST(Delaunay3, ReferenceArithmeticAgreesOnLattices) {
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = lattice_scene(seed, 7, 3);
    World world(scene, "exact", AuditLevel::kNone), sturm(scene, "sturm", AuditLevel::kNone);
    world.run();
    sturm.run();
    EXPECT_EQ(world.lines(), sturm.lines());
  }
}

std::vector<std::array<std::int64_t, 3>> unit_cube() {
  std::vector<std::array<std::int64_t, 3>> points;
  for (int i = 0; i < 8; ++i) points.push_back({i / 4, i / 2 % 2, i % 2});
  return points;
}

// The cells, and the facets of the hull, those of one cell only: a cell with the vertex at infinity each.
std::set<std::vector<ObjectId>> with_ghosts(const std::vector<ObjectId>& ids) {
  std::set<std::vector<ObjectId>> all, hull;
  for (std::size_t i = 0; i < ids.size(); i += 4) {
    const std::vector<ObjectId> cell(ids.begin() + static_cast<std::ptrdiff_t>(i),
                                     ids.begin() + static_cast<std::ptrdiff_t>(i + 4));
    all.insert(cell);
    for (std::ptrdiff_t out = 0; out < 4; ++out) {
      std::vector<ObjectId> facet = cell;
      facet.erase(facet.begin() + out);
      if (const auto [place, fresh] = hull.insert(facet); !fresh) hull.erase(place);
    }
  }
  all.insert(hull.begin(), hull.end());
  return all;
}

// From the start to the end of the run, at one instant, as many cells give way to as many others, ghosts
// counted, by one sew. If these are all cells, they are built anew instead.
void expect_given_way(const Scene& scene, std::size_t cells, bool all) {
  World world(scene), sturm(scene, "sturm");
  world.start();
  const auto before = with_ghosts(world.cells());
  world.run_until(*scene.end).expect_clean();
  sturm.run().expect_clean();
  EXPECT_EQ(world.lines(), sturm.lines());
  EXPECT_EQ(world.cells(), sturm.cells());
  const auto after = with_ghosts(world.cells());
  EXPECT_EQ(world.simulator().ledger().instants, 1u);
  EXPECT_EQ(before.size(), after.size());
  const auto gone = std::count_if(before.begin(), before.end(),
                                  [&](const auto& cell) { return after.count(cell) == 0; });
  EXPECT_EQ(static_cast<std::size_t>(gone), cells);
  EXPECT_EQ(all, cells == before.size());
  EXPECT_EQ(world.ledger().rebuilds, all ? 1u : 0u);
  EXPECT_EQ(world.structure().sews(), all ? 0u : 1u);
  EXPECT_EQ(world.structure().largest_sew(), all ? 0u : cells);
  for (const BoundCheck& bound : world.simulator().bounds(0)) {
    if (bound.id == "delaunay_3.largest_sew") {
      EXPECT_EQ(bound.observed, Integer(static_cast<std::int64_t>(all ? 0 : cells)));
      return;
    }
  }
  ADD_FAILURE() << "no largest sew";
}

TEST(Delaunay3, ShearedCubes) {
  std::vector<Trajectory> once, twice;
  for (const auto& p : unit_cube()) {
    once.push_back(integers(p, {p[1], 0, 0}));
    twice.push_back(integers(p, {p[1] + p[2], p[2], 0}));
  }
  for (auto& m : {&once}) {
    World world(scene_of(*m, -2, Rational(2)));
    world.run_until(-1);
    EXPECT_EQ(world.cells().size(), 4 * 6u);
    world.run_until(2).expect_clean();
    EXPECT_EQ(world.simulator().ledger().instants, 1u);
    EXPECT_EQ(world.cells().size(), 4 * 6u);
    expect_given_way(scene_of(*m, -2, Rational(2)), 10, false);
  }
  World world(scene_of(twice, -1, Rational(1)));
  world.run().expect_clean();
  EXPECT_EQ(world.simulator().ledger().instants, 1u);
  EXPECT_EQ(world.cells().size(), 4 * 6u);
  expect_given_way(scene_of(twice, -1, Rational(1)), 18, true);
}

// The square of the octahedron has another diagonal: four cells around it for four.
TEST(Delaunay3, OctahedronIsSewn) {
  std::vector<Trajectory> motions;
  for (const std::array<std::int64_t, 3> p :
       {std::array<std::int64_t, 3>{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
    motions.push_back(integers(p, {0, 0, 0}));
  }
  motions.push_back(integers({0, 0, 1}, {0, 0, 1}));
  motions.push_back(integers({0, 0, -1}, {0, 0, 0}));
  const Rational half(Integer(1), Integer(2));
  World world(scene_of(motions, -half, half));
  world.run().expect_clean();
  for (const std::string& line : world.lines()) ::testing::Test::RecordProperty("event", line);
  EXPECT_EQ(world.cells().size(), 4 * 4u);
  expect_given_way(scene_of(motions, -half, half), 4, false);
}

// A point passes by two skew curves. Of four points each: all 17 cells that are there without it give way, and
// come back.
TEST(Delaunay3, SkewCurves) {
  for (const auto& [m, flips] : {std::pair(2, 6), std::pair(3, 20), std::pair(4, 38)}) {
    SCOPED_TRACE(m);
    std::vector<Trajectory> motions;
    for (int i = 0; i < m; ++i) {
      motions.push_back(integers({40 * i - 20 * (m - 1), i * i, -80 - i * i * i}, {0, 0, 0}));
      motions.push_back(integers({i * i, 40 * i - 20 * (m - 1) + 3, 80 + i * i * i}, {0, 0, 0}));
    }
    motions.push_back(integers({1, 2, 0}, {0, 0, 1}));
    const Scene scene = scene_of(motions, -10000000, Rational(10000000));
    World world(scene), sturm(scene, "sturm");
    world.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(world.lines(), sturm.lines());
    EXPECT_EQ(world.ledger().external, static_cast<std::uint64_t>(flips));
    EXPECT_EQ(world.count("retile"), 0u);
    if (m < 4) continue;
    EXPECT_EQ(world.count("flip_2_3"), 17u);
    EXPECT_EQ(world.count("flip_3_2"), 17u);
    EXPECT_EQ(world.count("enter") + world.count("hull_2_3"), 2u);
    EXPECT_EQ(world.count("leave") + world.count("hull_3_2"), 2u);
  }
}

// The same with one of the curves a line: with three points of it and more the passage blocks the flips in the
// plane of the line and of the point that passes, and one sew makes the cells around it. A second point that
// passes later, far behind the first, needs none.
TEST(Delaunay3, ASkewLine) {
  for (const auto& [m, passages] : {std::pair(2, 1), {3, 1}, {4, 1}, {3, 2}}) {
    SCOPED_TRACE(std::to_string(m) + ", " + std::to_string(passages));
    std::vector<Trajectory> motions;
    for (int i = 0; i < m; ++i) {
      motions.push_back(integers({40 * i - 20 * (m - 1), 0, -80}, {0, 0, 0}));
      motions.push_back(integers({i * i, 40 * i - 20 * (m - 1) + 3, 80 + i * i * i}, {0, 0, 0}));
    }
    for (int i = 0; i < passages; ++i) motions.push_back(integers({1, 2, -1000000 * i}, {0, 0, 1}));
    const Scene scene = scene_of(motions, -10000000, Rational(10000000));
    World world(scene), sturm(scene, "sturm");
    world.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(world.lines(), sturm.lines());
    EXPECT_EQ(world.cells(), sturm.cells());
    const std::uint64_t sews = m > 2 ? 1 : 0;
    EXPECT_EQ(world.ledger().rebuilds, 0u);
    EXPECT_EQ(world.structure().sews(), sews);
    EXPECT_EQ(world.count("retile"), sews);
    EXPECT_EQ(world.structure().largest_sew(), m > 2 ? static_cast<std::size_t>(m + 2) : 0u);
  }
}

// Four points are in one plane at t = 1 alone: all four facets touch zero, and none changes its sign.
TEST(Delaunay3, TouchesAreNoChanges) {
  World world(lattice_scene(215, 4, 3));
  world.run().expect_clean();
  EXPECT_EQ(world.count("touch"), 4u);
  EXPECT_EQ(world.ledger().failures, 4u);
  EXPECT_EQ(world.ledger().external, 0u);
}

TEST(Delaunay3, FewPointsAndOnePlane) {
  for (int n = 0; n <= 5; ++n) {
    Scene scene = reference_scene(std::max(n, 1), 3, 7);
    scene.objects.resize(static_cast<std::size_t>(n));
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.structure().flat(), n < 4);
  }
  std::vector<Trajectory> plane, line, place;
  Random random(3);
  for (int i = 0; i < 7; ++i) {
    const std::int64_t x = random.between(-9, 9), y = random.between(-9, 9),
                       v = random.between(-3, 3);
    plane.push_back(integers({x, y, x + y}, {v, 1, v + 1}));
    line.push_back(integers({x, 2 * x, 1}, {v, 2 * v, 0}));
    place.push_back(integers({1, 2, 3}, {1, 0, 0}));
  }
  for (const auto* motions : {&plane, &line, &place}) {
    World world(scene_of(*motions, -2, Rational(2)));
    world.run().expect_clean();
    EXPECT_TRUE(world.structure().flat());
    EXPECT_TRUE(world.cells().empty());
  }
}

TEST(Delaunay3, EqualPointsAreHidden) {
  Scene scene = reference_scene(6, 3, 1);
  for (int i = 0; i < 3; ++i) {
    scene.objects.push_back(scene.objects[static_cast<std::size_t>(i)]);
    scene.objects.back().id = "twin " + std::to_string(i);
  }
  World world(scene), alone(reference_scene(6, 3, 1));
  world.run().expect_clean();
  alone.run();
  EXPECT_EQ(world.cells(), alone.cells());
  EXPECT_EQ(world.structure().representative(7), 1u);
}

TEST(Delaunay3, InexactArithmeticsNeverFallOver) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:12", "mpfr:60"}) {
    for (std::uint64_t seed = 0; seed < test::fewer(3u); ++seed) {
      World world(lattice_scene(seed, 5 + static_cast<int>(seed % 5), 3), arithmetic,
                  AuditLevel::kNone);
      world.run();
      EXPECT_EQ(world.status, RunStatus::kDone) << arithmetic;
    }
  }
}

// Signs that contradict each other put every cell in conflict with a point: no ghost would be left.
TEST(Delaunay3, InexactSignsDoNotTakeAwayEveryCell) {
  const Rational far = *Rational::parse("8499999999999999000000000000000");
  const Rational farther = *Rational::parse("8499999999999999999999000000000");
  const Rational odd(std::int64_t{-9007199254740993});
  const Scene huge =
      scene_of({moving({0}, {1}, {0}), moving({0}, {0}, {1}), moving({far}, {farther}, {0}),
                moving({0, -1}, {0}, {0}), moving({0}, {odd}, {0})},
               -10, Rational(-6));
  const Scene level = scene_of(
      {moving({2}, {2}, {1, -1}), moving({Rational(19, 7), -1}, {1, -1}, {0}),
       moving({2}, {2}, {0}), moving({2}, {3, -1}, {-1, 1}), moving({4}, {-1, 1}, {-2, 1})},
      0, Rational(4));
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:24", "mpfr:60"}) {
    for (const Scene& scene : {huge, level}) {
      World world(scene, arithmetic, AuditLevel::kNone);
      world.run();
      EXPECT_EQ(world.status, RunStatus::kDone) << arithmetic;
    }
  }
  World(huge).run().expect_clean();
  World(level).run().expect_clean();
}

}  // namespace delaunay_3_test
}  // namespace kinex::delaunay_3_test

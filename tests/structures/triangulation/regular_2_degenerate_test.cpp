// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: ties of every kind, equal points, points on one line, flight plans, lives, arithmetics.
#include <algorithm>
#include <set>

#include "tests/sanitized.h"
#include "tests/structures/triangulation/regular_support.h"

namespace kinex::regular_test {
namespace regular_2_degenerate_test {

using World = RegularWorld<Regular2>;
using test::path;

// Points of random linear motion on a lattice, identically lifted to one plane that moves; the last
// `above` of them 1 above it.
Scene in_one_lifted_plane(std::uint64_t seed, int n, int above) {
  test::Random random(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    Coefficients x{random.between(-2, 2), random.between(-1, 1)};
    Coefficients y{random.between(-2, 2), random.between(-1, 1)};
    const int height = i < n - above ? 0 : 1;
    motions.push_back(lifted_to(x, y, {x[0] - y[0] + Rational(height), x[1] - y[1] + Rational(2)}));
  }
  return weighted_scene(motions, -3, Rational(3));
}

// Which three points make a triangle, and which points are hidden, follows from ids and orientations
// alone: they change as points cross lines, without any change in height.
TEST(Regular2, PointsInOneLiftedPlane) {
  std::uint64_t events = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(30u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = in_one_lifted_plane(seed, 6, seed % 2 == 0 ? 2 : 0);
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.cells(), static_cells<Regular2>(scene, *scene.end));
    events += world.ledger().external;
  }
  EXPECT_GT(events, test::seen_in_fewer(200u));
}

// On the line y = 0 of the hull one point passes another while a third one crosses the line: the
// orientation of the two and the third touches zero only.
TEST(Regular2, PointsPassOnALineOfTheHull) {
  for (const int at : {-1, 0, 1, 2}) {
    SCOPED_TRACE(at);
    const Scene scene = weighted_scene({path({{-3}, {0}, {0}}), path({{0, 1}, {0}, {0}}),
                                        path({{0}, {0}, {0}}), path({{at}, {0, -1}, {0}})},
                                       -1, Rational(1));
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.cells(), static_cells<Regular2>(scene, *scene.end));
  }
}

TEST(Regular2, EqualPoints) {
  // Objects 6 .. 8 move as 0 .. 2; the weight is smaller, equal, larger.
  Scene scene = weighted_reference(6, 1, true);
  for (int i = 0; i < 3; ++i) {
    scene.objects.push_back(scene.objects[static_cast<std::size_t>(i)]);
    scene.objects.back().id = "twin " + std::to_string(i);
    scene.objects.back().motion.pieces[0].trajectory.coordinates[2][0] += Rational(i - 1);
  }
  World world(scene);
  world.run_until(0);
  const auto either = [&world](ObjectId one, ObjectId other) {
    return world.structure().is_vertex(one) + world.structure().is_vertex(other);
  };
  for (int t = 0; t <= 10; ++t) {
    world.run_until(t);
    EXPECT_FALSE(world.structure().is_vertex(6));
    EXPECT_FALSE(world.structure().is_vertex(7));
    EXPECT_FALSE(world.structure().is_vertex(2));
    EXPECT_LE(either(0, 6), 1);
  }
  world.expect_clean();
  EXPECT_GT(world.ledger().external, 5u);
}

TEST(Regular2, FewPointsAndOneLine) {
  for (int n = 0; n <= 4; ++n) {
    Scene scene = weighted_reference(4, 7, true);
    scene.objects.resize(static_cast<std::size_t>(n));
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.structure().flat(), n < 3);
    EXPECT_EQ(world.structure().edges().size(), n < 2 ? 0u : n == 2 ? 1u : n == 3 ? 3u : 6u);
  }
  std::vector<Trajectory> line, place;
  for (int i = 0; i < 7; ++i) {
    line.push_back(path({{i, i % 3}, {2 * i, 2 * (i % 3)}, {i % 4}}));
    place.push_back(path({{1, 1}, {2}, {i % 4, 1}}));
  }
  for (const auto* motions : {&line, &place}) {
    World world(weighted_scene(*motions, -2, Rational(2)));
    world.run().expect_clean();
    EXPECT_TRUE(world.structure().flat());
    EXPECT_TRUE(world.cells().empty());
    EXPECT_EQ(world.structure().hidden().size(), 7u);
  }
}

// The grid {0, 1, 2}^2 is sheared: at t = 0 each of its four unit squares has its other diagonal, at t = -1 and t = 1
// each of two.
TEST(Regular2, AShearedGrid) {
  std::vector<Trajectory> motions;
  for (int i = 0; i < 9; ++i) motions.push_back(path({{i / 3, i % 3}, {i % 3}}));
  const Scene scene = test::scene_of(motions, -2, Rational(2));
  World world(scene), sturm(scene, "sturm");
  const auto cells_at = [&world](const Rational& t) {
    std::set<std::array<ObjectId, 3>> cells;
    const std::vector<ObjectId> ids = world.run_until(t).cells();
    for (std::size_t i = 0; i < ids.size(); i += 3) cells.insert({ids[i], ids[i + 1], ids[i + 2]});
    return cells;
  };
  auto before = cells_at(fraction(-3, 2));
  for (const auto& [t, given_way] : {std::pair(-1, 4), {0, 8}, {1, 4}}) {
    auto after = cells_at(Rational(t) + fraction(1, 2));
    const auto gone = std::count_if(before.begin(), before.end(),
                                    [&](const auto& cell) { return after.count(cell) == 0; });
    EXPECT_EQ(gone, given_way) << t;
    before = std::move(after);
  }
  world.run().expect_clean();
  EXPECT_EQ(world.simulator().ledger().instants, 3u);
  EXPECT_EQ(world.structure().sews(), 0u);
  sturm.run().expect_clean();
  EXPECT_EQ(world.lines(), sturm.lines());
}

// At 1 a point leaves the line of all others; from 2 on it is identically on the line.
TEST(Regular2, APointLeavesTheCommonLine) {
  std::vector<Trajectory> line;
  for (int i = 0; i < 5; ++i) line.push_back(path({{i}, {0}, {i % 2}}));
  Scene scene = weighted_scene(line, 0, Rational(3));
  MotionPiece& piece = scene.objects[2].motion.pieces[0];
  const Trajectory rest = piece.trajectory;
  scene.objects[2].motion.pieces = {{Rational(0), Rational(1), rest},
                                    {Rational(1), fraction(3, 2), path({{2}, {-1, 1}, {0}})},
                                    {fraction(3, 2), Rational(2), path({{2}, {2, -1}, {0}})},
                                    {Rational(2), Rational(3), rest}};
  World world(scene);
  EXPECT_TRUE(world.structure().flat());
  world.run_until(fraction(5, 4));
  EXPECT_FALSE(world.structure().flat());
  EXPECT_FALSE(world.cells().empty());
  world.run().expect_clean();
  EXPECT_TRUE(world.structure().flat());
}

// Flight plans on small integers, weights included: pieces that join, and lives.
Scene weighted_flights(std::uint64_t seed, int n, int degree, bool lives) {
  Scene scene = test::random_flights(seed, n, 3, degree, lives);
  scene.dimension = 2;
  scene.extents = Extents::kWeight;
  return scene;
}
void flights(std::uint64_t first, std::uint64_t last) {
  std::uint64_t updates = 0, comings = 0, hidden = 0;
  for (std::uint64_t seed = first; seed < first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = weighted_flights(seed, 7 + static_cast<int>(seed % 3),
                                         1 + static_cast<int>(seed % 2), seed % 4 < 2);
    World world(scene);
    for (int t = 1; t <= 4; ++t) {
      world.run_until(t);
      hidden += world.structure().hidden().size();
    }
    world.expect_clean();
    updates += world.ledger().motion_updates;
    comings += world.ledger().insertions + world.ledger().erasures;
  }
  EXPECT_GT(updates, test::seen_in_fewer(last - first));
  EXPECT_GT(comings, test::seen_in_fewer(last - first) / 2);
  EXPECT_GT(hidden, test::seen_in_fewer(last - first));
}
TEST(Regular2, FlightPlans) { flights(1, 21); }
TEST(SlowRegular2, FlightPlans) { flights(21, 300); }

TEST(Regular2, ChangesFromOutside) {
  for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
    SCOPED_TRACE(seed);
    come_and_go<Regular2>(seed, 2);
  }
}

TEST(Regular2, ReferenceArithmeticAgreesOnLattices) {
  for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = weighted_lattice(seed, 7, seed % 2 == 0);
    World world(scene, "exact", AuditLevel::kNone), sturm(scene, "sturm", AuditLevel::kNone);
    world.run();
    sturm.run();
    EXPECT_EQ(world.lines(), sturm.lines());
  }
}

TEST(Regular2, TwinsInLargeScenes) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    World world(weighted_twins(30, seed, 2));
    world.run().expect_clean();
  }
}

// They end; where nothing is degenerate and numbers are precise they agree.
TEST(Regular2, InexactArithmeticsEnd) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:12", "mpfr:60"}) {
    for (std::uint64_t seed = 0; seed < test::fewer(12u); ++seed) {
      SCOPED_TRACE(std::string(arithmetic) + ", seed " + std::to_string(seed));
      World world(weighted_lattice(seed, 5 + static_cast<int>(seed % 5), seed % 2 == 0), arithmetic,
                  AuditLevel::kNone);
      world.run();
      EXPECT_EQ(world.status, RunStatus::kDone);
    }
  }
  for (const bool linear : {false, true}) {
    const Scene scene = weighted_reference(10, 2, linear);
    World exact(scene);
    exact.run();
    for (const char* arithmetic : {"double", "mpfr:200"}) {
      World world(scene, arithmetic, AuditLevel::kNone);
      world.run();
      EXPECT_FALSE(world.ledger().corrupt);
      EXPECT_EQ(world.cells(), exact.cells()) << arithmetic;
    }
  }
}

}  // namespace regular_2_degenerate_test
}  // namespace kinex::regular_test

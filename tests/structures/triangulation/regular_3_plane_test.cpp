// SPDX-License-Identifier: GPL-3.0-or-later
// Regular3 of points that are all in one plane: its triangulation there, compared with regular_2 and audited after
// every event.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/planes_in_space.h"
#include "tests/structures/triangulation/regular_support.h"

namespace kinex::regular_test {
namespace regular_3_plane_test {

using test::fewer;
using test::path;
using test::Turn;
using World = RegularWorld<Regular3>;
using PlaneWorld = RegularWorld<Regular2>;
using Edges = std::vector<std::array<ObjectId, 2>>;

// A turn that keeps angles, and the factor of lengths.
struct Placement {
  const Turn* turn;
  Coefficients length;
};
const Placement kFlat{&test::kFlat, {1}}, kUpright{&test::kUpright, {1}},
    kSideways{&test::kSideways, {1}}, kOblique{&test::kOblique, {3}},
    kTurning{&test::kTurning, {1, 0, 1}};

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients result;
  test::add_product(result, a, b);
  return result;
}

// The scene of the plane, in space: radii grow as lengths do, weights as their squares.
Scene placed(const Scene& flat, const Placement& placement) {
  Scene scene = test::in_space(flat, *placement.turn);
  Coefficients factor = placement.length;
  if (flat.extents == Extents::kWeight) factor = product(factor, factor);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    for (std::size_t p = 0; p < scene.objects[i].motion.pieces.size(); ++p) {
      auto& axes = scene.objects[i].motion.pieces[p].trajectory.coordinates;
      axes.push_back(product(flat.objects[i].motion.pieces[p].trajectory.coordinates[2], factor));
      scene.objects[i].motion.pieces[p].trajectory = path(axes);
    }
  }
  return scene;
}

// Of the plane, with radii instead of weights: 0 .. most.
Scene with_radii(Scene flat, int most, std::uint64_t seed) {
  test::Random random(seed);
  flat.extents = Extents::kRadius;
  for (SceneObject& object : flat.objects) {
    auto& axes = object.motion.pieces[0].trajectory.coordinates;
    axes[2] = {random.between(0, most)};
    object.motion.pieces[0].trajectory = path(axes);
  }
  return flat;
}

// Without names of the plane, marks of external events, and failures of witnesses.
std::vector<std::string> changes(const std::vector<std::string>& lines) {
  std::vector<std::string> result;
  for (std::string line : lines) {
    if (line.starts_with("plane_")) line.erase(0, 6);
    if (line.ends_with(" !")) line.resize(line.size() - 2);
    if (!line.starts_with("witness")) result.push_back(line);
  }
  return result;
}

// The edges and the hidden points are those of regular_2 in the plane, at many times.
void expect_those_of_the_plane(const Scene& flat, const Placement& placement) {
  World world(placed(flat, placement));
  PlaneWorld plane(flat, "exact", AuditLevel::kNone);
  for (Rational t = flat.start; t < *flat.end; t += Rational(Integer(3), Integer(17))) {
    world.run_until(t);
    plane.run_until(t);
    ASSERT_TRUE(world.structure().flat());
    if (!world.structure().planar()) continue;
    ASSERT_EQ(world.structure().edges(), plane.structure().edges()) << t.to_string();
    ASSERT_EQ(world.structure().hidden(), plane.structure().hidden()) << t.to_string();
    ASSERT_EQ(world.structure().has_all_pairs(), plane.structure().flat()) << t.to_string();
  }
  world.run().expect_clean();
  EXPECT_EQ(world.ledger().external, 0u);
}

// The circle of 0, 1 and 2 has the centre (2, 2) and the square of its radius is 8: the power of 3 at (1, 1) is
// -6. It shows with more weight than -6.
TEST(Regular3Plane, CountedByHand) {
  const auto flat = [](Coefficients weight) {
    return weighted_scene({path({{0}, {0}, {0}}), path({{4}, {0}, {0}}), path({{0}, {4}, {0}}),
                           path({{1}, {1}, std::move(weight)})},
                          0, Rational(5));
  };
  const Edges three{{0, 1}, {0, 2}, {1, 2}}, six{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  for (const Placement& placement : {kFlat, kUpright, kSideways, kOblique}) {
    World shows(placed(flat({-10, 1}), placement));
    EXPECT_EQ(shows.structure().edges(), three);
    EXPECT_EQ(shows.structure().hidden(), std::vector<ObjectId>{3});
    EXPECT_FALSE(shows.structure().is_vertex(3));
    EXPECT_EQ(shows.ledger().live, 10u);
    shows.run().expect_clean();
    EXPECT_EQ(shows.lines(), std::vector<std::string>{"plane_show 3 0 1 2"});
    EXPECT_EQ(shows.structure().edges(), six);
    EXPECT_TRUE(shows.structure().is_vertex(3));
    EXPECT_EQ(shows.ledger().live, 9u);
    World hides(placed(flat({-2, -1}), placement));
    hides.run().expect_clean();
    EXPECT_EQ(hides.lines(), std::vector<std::string>{"plane_hide 3 0 1 2"});
    EXPECT_EQ(hides.structure().edges(), three);
    EXPECT_EQ(hides.ledger().live, 10u);
  }
}

TEST(Regular3Plane, TheSameEventsAsInThePlane) {
  std::uint64_t shows = 0, hides = 0, witnesses = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    Scene flat = weighted_reference(6 + static_cast<int>(seed), seed, seed % 2 == 0);
    if (seed > 2) flat = with_radii(flat, 30, seed);
    const Placement placement =
        std::array{kFlat, kUpright, kOblique, kSideways}[static_cast<std::size_t>(seed % 4)];
    World world(placed(flat, placement));
    PlaneWorld plane(flat, "exact", AuditLevel::kNone);
    world.run().expect_clean();
    plane.run();
    EXPECT_EQ(changes(world.lines()), changes(plane.lines()));
    EXPECT_FALSE(world.lines().empty());
    EXPECT_EQ(world.ledger().external, 0u);
    EXPECT_EQ(world.ledger().rebuilds, 0u);
    if (seed % 2 == 1) expect_those_of_the_plane(flat, placement);
    shows += world.count("plane_show");
    hides += world.count("plane_hide");
    witnesses += world.count("plane_witness");
  }
  EXPECT_GT(shows, 2u);
  EXPECT_GT(hides, 2u);
  EXPECT_GT(witnesses, 2u);
}

// A plane whose axes are of different lengths, and no weights at all.
TEST(Regular3Plane, StretchedAndWithoutWeights) {
  const Scene flat = weighted_reference(8, 3, true);
  World stretched(placed(flat, {&test::kStretched, {1}}));
  stretched.run().expect_clean();
  EXPECT_GT(changes(stretched.lines()).size(), 10u);
  Scene bare = test::in_space(flat, test::kOblique);
  bare.extents = Extents::kNone;
  World world(bare);
  world.run().expect_clean();
  EXPECT_GT(world.count("plane_flip"), 5u);
  EXPECT_TRUE(world.structure().hidden().empty());
}

// It is built anew where it stands upright on x and y, and changes where the others do.
TEST(Regular3Plane, ThePlaneTurns) {
  for (const std::uint64_t seed : {1u, 3u}) {
    SCOPED_TRACE(seed);
    Scene flat = weighted_reference(7, seed, false);
    if (seed == 3) flat = with_radii(flat, 30, seed);
    flat.start = -4;
    flat.end = Rational(5);
    expect_those_of_the_plane(flat, kTurning);
    World world(placed(flat, kTurning), "exact", AuditLevel::kNone);
    PlaneWorld still(flat, "exact", AuditLevel::kNone);
    world.run();
    still.run();
    EXPECT_EQ(world.ledger().rebuilds, 2u);
    EXPECT_EQ(world.ledger().rebuild_reasons.count(
                  "in projection all points of the plane are on one line"),
              1u);
    std::vector<std::string> lines;
    for (std::string& line : changes(world.lines())) {
      if (!line.starts_with("rebuild")) lines.push_back(std::move(line));
    }
    EXPECT_EQ(lines, changes(still.lines()));
  }
}

// Points of {0, 1, 2}^2 with weights in 0 .. 4 and velocities in {-1, 0, 1}: most instants are degenerate.
void tiny_lattices(std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed < first + fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    Scene flat = weighted_lattice(seed, 5 + static_cast<int>(seed % 5), seed % 2 == 0);
    if (seed % 5 == 4) flat = with_radii(flat, 2, seed);
    expect_those_of_the_plane(flat, seed % 3 == 0 ? kFlat : seed % 3 == 1 ? kOblique : kUpright);
    if (testing::Test::HasFailure()) return;
  }
}
TEST(Regular3Plane, TinyLattices) { tiny_lattices(0, 15); }
TEST(SlowRegular3Plane, TinyLattices) { tiny_lattices(15, 600); }

void turning_lattices(std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed < first + fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    expect_those_of_the_plane(weighted_lattice(seed, 5 + static_cast<int>(seed % 3), false),
                              kTurning);
    if (testing::Test::HasFailure()) return;
  }
}
TEST(Regular3Plane, TurningLattices) { turning_lattices(0, 4); }
TEST(SlowRegular3Plane, TurningLattices) { turning_lattices(4, 60); }

// Objects of one line have all pairs for edges, as of regular_2. At t = 0 all are on one line, and are not elsewhere.
TEST(Regular3Plane, OneLine) {
  std::vector<Trajectory> line, pencil;
  for (const auto& [x, slope] : {std::pair(0, 1), {3, -2}, {7, 4}, {12, -1}, {20, 3}}) {
    line.push_back(path({{x, slope}, {2 * x, 2 * slope}, {slope}}));
    pencil.push_back(path({{x}, {0, slope}, {2 * slope}}));
  }
  for (const Placement& placement : {kFlat, kUpright, kOblique}) {
    World world(placed(weighted_scene(line, 0, Rational(5)), placement));
    EXPECT_TRUE(world.structure().planar());
    EXPECT_TRUE(world.structure().has_all_pairs());
    world.run().expect_clean();
    EXPECT_EQ(world.structure().edges().size(), 10u);
    EXPECT_EQ(world.ledger().max_live, 0u);
    const Scene meet = weighted_scene(pencil, -5, Rational(6));
    expect_those_of_the_plane(meet, placement);
    World through(placed(meet, placement), "exact", AuditLevel::kNone);
    through.run();
    EXPECT_EQ(through.ledger().rebuilds, 1u);
  }
}

// Flight plans change in the plane; objects come and go, and some fly together.
TEST(Regular3Plane, FlightPlans) {
  std::uint64_t updates = 0, comings = 0;
  for (std::uint64_t seed = 1; seed <= std::max(2u, fewer(4u)); ++seed) {
    SCOPED_TRACE(seed);
    Scene flat = test::random_flights(seed, 8, 3, 1 + static_cast<int>(seed % 2), seed % 2 == 0);
    flat.dimension = 2;
    flat.extents = Extents::kWeight;
    const Placement& placement = seed % 4 < 2 ? kFlat : kOblique;
    expect_those_of_the_plane(flat, placement);
    World world(placed(flat, placement), "exact", AuditLevel::kNone),
        sturm(placed(flat, placement), "sturm", AuditLevel::kNone);
    world.run();
    sturm.run();
    EXPECT_EQ(world.lines(), sturm.lines());
    updates += world.ledger().motion_updates;
    comings += world.ledger().insertions + world.ledger().erasures;
  }
  EXPECT_GT(updates, test::seen_in_fewer(6u));
  EXPECT_GT(comings, 0u);
}

// Objects come and go at random instants of a run on a lattice, here and in the plane.
TEST(Regular3Plane, ChangesFromOutside) {
  for (std::uint64_t seed = 1; seed <= fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Placement& placement = seed % 2 == 0 ? kSideways : kOblique;
    const Scene flat = weighted_lattice(seed, 8, true),
                others = weighted_lattice(seed + 1000, 8, true);
    const Scene there = placed(others, placement);
    const auto motion = [](const Scene& scene, ObjectId object) {
      return scene.objects[object].motion.pieces[0].trajectory;
    };
    World world(placed(flat, placement));
    PlaneWorld plane(flat, "exact", AuditLevel::kNone);
    test::Random random(seed);
    std::vector<bool> alive(8, true);
    for (int i = 1; i < 30; ++i) {
      const Rational t = Rational(-3) + fraction(i, 5);
      const auto object = static_cast<ObjectId>(random.between(0, 7));
      if (alive[object]) {
        world.simulator().schedule_erasure(t, object);
        plane.simulator().schedule_erasure(t, object);
      } else {
        world.simulator().schedule_insertion(t, object, motion(there, object));
        plane.simulator().schedule_insertion(t, object, motion(others, object));
      }
      alive[object] = !alive[object];
      world.run_until(t);
      plane.run_until(t);
      if (!world.structure().planar()) continue;
      ASSERT_EQ(world.structure().edges(), plane.structure().edges()) << t.to_string();
      ASSERT_EQ(world.structure().hidden(), plane.structure().hidden()) << t.to_string();
    }
    world.expect_clean();
  }
}

// A point comes that is outside of the plane, and goes; another one leaves the plane by a new motion, and comes back
// by one more.
TEST(Regular3Plane, PointsOutside) {
  const Scene flat = weighted_reference(7, 3, true);
  Scene scene = placed(flat, kOblique);
  SceneObject outside = test::moving("outside", path({{50, 1}, {50}, {900, -2}, {10}}));
  outside.motion.pieces[0].from = Rational(2);
  outside.motion.pieces[0].to = Rational(4);
  scene.objects.push_back(outside);
  auto& pieces = scene.objects[2].motion.pieces;
  const Trajectory within = pieces[0].trajectory;
  const auto beside = [&within](int offset, int slope) {
    Trajectory motion = within;
    motion.coordinates[0].resize(2);
    motion.coordinates[0][0] += Rational(offset);
    motion.coordinates[0][1] += Rational(slope);
    return path(motion.coordinates);
  };
  pieces[0].to = Rational(6);
  pieces.push_back({Rational(6), Rational(7), beside(-6, 1)});
  pieces.push_back({Rational(7), Rational(8), beside(8, -1)});
  pieces.push_back({Rational(8), std::nullopt, within});
  World world(scene), sturm(scene, "sturm");
  PlaneWorld plane(flat, "exact", AuditLevel::kNone);
  const auto expect_plane = [&](const Rational& t) {
    world.run_until(t);
    plane.run_until(t);
    EXPECT_TRUE(world.structure().planar()) << t.to_string();
    EXPECT_EQ(world.structure().edges(), plane.structure().edges()) << t.to_string();
    EXPECT_EQ(world.structure().hidden(), plane.structure().hidden()) << t.to_string();
  };
  expect_plane(1);
  world.run_until(3);
  EXPECT_FALSE(world.structure().flat());
  EXPECT_FALSE(world.cells().empty());
  expect_plane(5);
  for (const char* t : {"13/2", "15/2"}) {
    world.run_until(*Rational::parse(t));
    EXPECT_FALSE(world.structure().flat());
  }
  expect_plane(9);
  expect_plane(10);
  world.expect_clean();
  sturm.run().expect_clean();
  EXPECT_EQ(world.lines(), sturm.lines());
}

// The last one comes to the plane x = 0 at t = 2.
TEST(Regular3Plane, TheLastPointArrives) {
  const Scene flat = weighted_reference(6, 2, true);
  Scene scene = placed(flat, kUpright);
  auto& pieces = scene.objects[5].motion.pieces;
  const Trajectory within = pieces[0].trajectory;
  auto axes = within.coordinates;
  axes[0] = {2, -1};
  pieces[0] = {std::nullopt, Rational(2), path(axes)};
  pieces.push_back({Rational(2), std::nullopt, within});
  World world(scene), sturm(scene, "sturm");
  PlaneWorld plane(flat, "exact", AuditLevel::kNone);
  world.run_until(1);
  EXPECT_FALSE(world.structure().flat());
  for (int t = 2; t <= 10; ++t) {
    world.run_until(t);
    plane.run_until(t);
    EXPECT_TRUE(world.structure().planar());
    EXPECT_EQ(world.structure().edges(), plane.structure().edges()) << t;
    EXPECT_EQ(world.structure().hidden(), plane.structure().hidden()) << t;
  }
  world.expect_clean();
  sturm.run().expect_clean();
  EXPECT_EQ(world.lines(), sturm.lines());
}

// Objects of a lattice in the plane z = 0, some of which leave it at a time and are back later; others come and go.
Scene excursions(std::uint64_t seed, int n) {
  test::Random random(seed);
  Scene scene = placed(weighted_lattice(seed, n, seed % 2 == 0), kFlat);
  for (SceneObject& object : scene.objects) {
    auto& pieces = object.motion.pieces;
    const Trajectory within = pieces[0].trajectory;
    if (random.chance(30)) pieces[0].from = fraction(random.between(-6, 0), 4);
    if (!random.chance(50)) continue;
    const int away = random.between(1, 4), length = random.between(1, 2);
    const auto beside = [&within](const Rational& z, int slope) {
      auto axes = within.coordinates;
      axes[2] = {z, slope};
      return path(axes);
    };
    const Rational begin = fraction(away, 2), end = begin + Rational(2 * length);
    const Rational middle = begin + Rational(length);
    pieces[0].to = begin;
    pieces.push_back({begin, middle, beside(-begin, 1)});
    if (random.chance(60)) {
      pieces.push_back({middle, end, beside(end, -1)});
      pieces.push_back({end, std::nullopt, within});
    } else {
      pieces.back().to = random.chance(50) ? std::optional<Rational>(middle) : std::nullopt;
    }
  }
  scene.end = Rational(7);
  return scene;
}

// As a structure that is built at the time.
void go_out_and_come_back(std::uint64_t first, std::uint64_t last) {
  std::uint64_t planar = 0, spatial = 0;
  for (std::uint64_t seed = first; seed < first + fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = excursions(seed, 5 + static_cast<int>(seed % 4));
    World world(scene);
    for (int i = 0; i < 20; ++i) {
      const Rational t = Rational(-3) + fraction(i, 2);
      world.run_until(t);
      Scene fresh = scene;
      fresh.start = t;
      World other(fresh, "exact", AuditLevel::kNone);
      ASSERT_EQ(world.structure().edges(), other.structure().edges()) << t.to_string();
      ASSERT_EQ(world.structure().hidden(), other.structure().hidden()) << t.to_string();
      ASSERT_EQ(world.cells(), other.cells()) << t.to_string();
      planar += world.structure().planar();
      spatial += !world.structure().flat();
    }
    world.run().expect_clean();
  }
  EXPECT_GT(planar, test::seen_in_fewer(last - first));
  EXPECT_GT(spatial, test::seen_in_fewer(last - first));
}
TEST(Regular3Plane, Excursions) { go_out_and_come_back(0, 6); }
TEST(SlowRegular3Plane, Excursions) { go_out_and_come_back(6, 200); }

TEST(Regular3Plane, ReferenceArithmeticAgreesOnLattices) {
  for (std::uint64_t seed = 1; seed <= fewer(4u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = placed(weighted_lattice(seed, 7, false), seed % 2 == 0 ? kFlat : kTurning);
    World world(scene, "exact", AuditLevel::kNone), sturm(scene, "sturm", AuditLevel::kNone);
    world.run();
    sturm.run();
    EXPECT_EQ(world.lines(), sturm.lines());
  }
}

TEST(Regular3Plane, TwinsInLargeScenes) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    World world(placed(weighted_twins(30, seed, 2), kFlat));
    world.run().expect_clean();
  }
}

TEST(Regular3Plane, InexactArithmeticsNeverFallOver) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:12", "mpfr:60"}) {
    for (std::uint64_t seed = 0; seed < fewer(2u); ++seed) {
      const Scene flat = weighted_lattice(seed, 5 + static_cast<int>(seed % 5), seed % 2 == 0);
      for (const Placement& placement : {kFlat, kTurning}) {
        World world(placed(flat, placement), arithmetic, AuditLevel::kNone);
        world.run();
        EXPECT_EQ(world.status, RunStatus::kDone) << arithmetic;
      }
    }
  }
}

}  // namespace regular_3_plane_test
}  // namespace kinex::regular_test

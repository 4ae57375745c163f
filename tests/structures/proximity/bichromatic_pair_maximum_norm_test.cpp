// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest two points of different colours in the maximum norm, against all pairs at exact positions
// between all critical instants. Here ties are decided by points that are turned and moved by small
// rational numbers, where the structure and its audit compare in parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/metamorphic_scenes.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace bichromatic_pair_maximum_norm_test {

using Ids = std::vector<ObjectId>;

Request nearest() { return ask("bichromatic_pair_maximum_norm"); }
Request red_and_blue() {
  Request request = nearest();
  request.colours = {"red", "blue"};
  return request;
}
Scene coloured(Scene scene, std::uint64_t seed) {
  Random random(seed);
  for (SceneObject& object : scene.objects) {
    const char* const names[] = {"red", "blue", "green"};
    object.colour = names[random.between(0, 2)];
  }
  scene.objects[0].colour = "red";
  if (scene.objects.size() > 1) scene.objects[1].colour = "blue";
  return scene;
}

// ---- all pairs at exact positions, for colours by place

Rational power_of_tenth(int exponent) {
  Rational result(1);
  for (int i = 0; i < exponent; ++i) result *= fraction(1, 10);
  return result;
}

Ids by_brute_force(const Scene& scene, const Rational& t) {
  const Rational turn = power_of_tenth(20), step = power_of_tenth(60);
  std::vector<std::array<Rational, 2>> points;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Trajectory& path = scene.objects[i].motion.pieces[0].trajectory;
    const Rational x = path.position(0, t), y = path.position(1, t);
    const Rational id(static_cast<int>(i));
    points.push_back({x - turn * y + Rational(2) * step * id, y + turn * x + step * id});
  }
  Rational least;
  Ids best;
  for (ObjectId a = 0; a < points.size(); ++a) {
    for (ObjectId b = a + 1; b < points.size(); b += 2) {
      Rational length;
      for (const std::size_t axis : {0u, 1u}) {
        const Rational d = points[b][axis] - points[a][axis];
        length = std::max(length, d.sign() < 0 ? -d : d);
      }
      if (!best.empty() && !(length < least)) continue;
      least = length;
      best = {a, b};
    }
  }
  return best;
}

// Between any two instants at which lengths of linear motion may change their order, ascending.
std::vector<Rational> between_instants(const Scene& scene) {
  std::set<Rational> critical{scene.start, *scene.end};
  std::vector<std::array<Rational, 2>> coordinates;  // a + b t: all dx and dy
  for (std::size_t a = 0; a < scene.objects.size(); ++a) {
    for (std::size_t b = a + 1; b < scene.objects.size(); ++b) {
      for (const int axis : {0, 1}) {
        const auto place = [&](std::size_t i, int t) {
          return scene.objects[i].motion.pieces[0].trajectory.position(axis, Rational(t));
        };
        const Rational at_zero = place(b, 0) - place(a, 0);
        coordinates.push_back({at_zero, place(b, 1) - place(a, 1) - at_zero});
      }
    }
  }
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    for (std::size_t j = i; j < coordinates.size(); ++j) {
      for (const int sign : {-1, 1}) {
        const Rational a = coordinates[i][0] + Rational(sign) * coordinates[j][0];
        const Rational b = coordinates[i][1] + Rational(sign) * coordinates[j][1];
        if (b.is_zero()) continue;
        const Rational root = -a / b;
        if (scene.start < root && root < *scene.end) critical.insert(root);
      }
    }
  }
  std::vector<Rational> middles;
  for (auto one = critical.begin(), next = std::next(one); next != critical.end(); ++one, ++next) {
    middles.push_back((*one + *next) * fraction(1, 2));
  }
  return middles;
}

// Runs a scene whose colours are by place; the number of changes, by brute force.
std::uint64_t changes_of(const Scene& given) {
  const Scene scene = TwinRun::asking(given, {nearest()});
  Simulator simulator(scene, planned_arithmetic("exact", scene),
                      Trial::options(AuditLevel::kEvents));
  add_structures(simulator, scene);
  simulator.start();
  const StructureId id = asked_structure(scene);
  std::uint64_t changes = 0;
  Ids last;
  for (const Rational& t : between_instants(scene)) {
    simulator.run_until(t);
    const Ids pair = by_brute_force(scene, t);
    EXPECT_EQ(simulator.structure(id).attribute().ids, pair) << "at " << t.to_string();
    if (!last.empty() && pair != last) ++changes;
    last = pair;
  }
  EXPECT_EQ(simulator.ledger(id).external, changes);
  simulator.run_until(std::nullopt);  // what happens at the end is not between any instants
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
  EXPECT_EQ(simulator.ledger(id).rebuilds, 0u);
  for (const BoundCheck& bound : simulator.bounds(id)) EXPECT_TRUE(bound.holds) << bound.id;
  return changes;
}

// ---- counts

struct Counted {
  int n;
  std::uint64_t seed, changes;
};
const Counted kCounted[] = {{6, 1, 4}, {8, 1, 6}, {10, 2, 7}, {12, 3, 4}};

TEST(BichromaticPairMaximumNorm, ReferenceCounts) {
  for (const Counted& one : kCounted) {
    SCOPED_TRACE(one.n);
    const Scene scene = reference_scene(one.n, 2, one.seed);
    if (one.n > 8) {
      EXPECT_EQ(TwinRun(scene, {nearest()}).ledger().external, one.changes);
      continue;
    }
    EXPECT_EQ(changes_of(scene), one.changes);
    EXPECT_EQ(TwinRun(scene, {nearest()}).sink.log.lines,
              TwinRun(scene, {nearest()}, "sturm").sink.log.lines);
  }
}

TEST(SlowBichromaticPairMaximumNorm, ReferenceCounts) {
  for (const Counted& one : kCounted) {
    if (one.n <= 8) continue;
    SCOPED_TRACE(one.n);
    EXPECT_EQ(changes_of(reference_scene(one.n, 2, one.seed)), one.changes);
  }
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    external += changes_of(lattice_scene(seed, 4 + static_cast<int>(seed % 5), 2));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(seeds));
}

TEST(BichromaticPairMaximumNorm, TinyLattices) { on_lattices(60); }

TEST(SlowBichromaticPairMaximumNorm, TinyLattices) { on_lattices(900); }

// m at rest at (j, 0), n that pass at (t - m i, 1/10). A pair's length is max(|t - m i - j|, 1/10). No two
// are 1/10 at once, and of the others the order is that of |t - m i - j|: all mn pairs are nearest in turn,
// in the Euclidean norm and in this one.
TEST(BichromaticPairMaximumNorm, AllPairsInTurn) {
  for (const auto& [m, n] : {std::pair{2, 2}, {3, 2}, {3, 3}, {4, 3}}) {
    SCOPED_TRACE(std::to_string(m) + " at rest, " + std::to_string(n) + " that pass");
    std::vector<Trajectory> t;
    for (int j = 0; j < m; ++j) t.push_back(path({{j}, {0}}));
    for (int i = 0; i < n; ++i) t.push_back(path({{-m * i, 1}, {fraction(1, 10)}}));
    Scene scene = scene_of(t, 0, fraction(2 * n * m - 1, 2));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      scene.objects[i].colour = static_cast<int>(i) < m ? "red" : "blue";
    }
    const TwinRun run(scene, {red_and_blue()});
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n * m - 1));
    EXPECT_EQ(run.begins_with, (Ids{0, static_cast<ObjectId>(m)}));
    EXPECT_EQ(run.attribute(),
              (Ids{static_cast<ObjectId>(m - 1), static_cast<ObjectId>(m + n - 1)}));
  }
}

// ---- flight plans, insertions, erasures, a third colour

TEST(BichromaticPairMaximumNorm, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = coloured(random_flights(seed, 9, 2, degree, seed % 2 == 0), seed);
      const TwinRun run(scene, {red_and_blue()}), twin(scene, {red_and_blue()}, "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(15u));
  EXPECT_GT(updates, test::seen_in_fewer(20u));
}

// Points of a lattice change their velocities at lattice times, where lengths come to be identically equal
// and cease to be.
TEST(BichromaticPairMaximumNorm, NewPlansOnLattices) {
  std::uint64_t updates = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(24u); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = lattice_scene(seed, 5 + static_cast<int>(seed % 4), 2);
    Random random(seed);
    for (SceneObject& object : scene.objects) {
      for (int t = -2; t <= 2; t += random.between(1, 4)) {
        std::vector<MotionPiece>& pieces = object.motion.pieces;
        const Trajectory next = path({{0, random.between(-1, 1)}, {0, random.between(-1, 1)}});
        pieces.back().to = Rational(t);
        pieces.push_back(
            {Rational(t), std::nullopt, continued(pieces.back().trajectory, next, Rational(t))});
      }
    }
    const TwinRun run(scene, {nearest()}), twin(scene, {nearest()}, "sturm");
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
    updates += run.ledger().motion_updates;
    if (HasFailure()) return;
  }
  EXPECT_GT(updates, test::seen_in_fewer(150u));
}

TEST(BichromaticPairMaximumNorm, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    EXPECT_EQ(TwinRun(scene, {nearest()}).attribute().size(), n < 2 ? 0u : 2u);
  }
}

TEST(BichromaticPairMaximumNorm, FromNothingToNothing) {
  const TwinRun run(from_nothing_to_nothing(), {nearest()});
  EXPECT_EQ(run.begins_with, Ids{});
  EXPECT_EQ(run.attribute(), Ids{});
  EXPECT_EQ(run.ledger().insertions, 7u);
}

// ---- ties

// Equal points of both colours: those whose ids differ least, then the smallest.
TEST(BichromaticPairMaximumNorm, EqualPointsOfBothColours) {
  Scene scene = scene_of(std::vector<Trajectory>(7, path({{5, 1}, {5}})), 0, Rational(9));
  const char* const colours[] = {"red", "red", "green", "blue", "green", "green", "red"};
  for (std::size_t i = 0; i < 7; ++i) scene.objects[i].colour = colours[i];
  const TwinRun run(scene, {red_and_blue()});
  EXPECT_EQ(run.attribute(), (Ids{1, 3}));
  EXPECT_EQ(run.ledger().external, 0u);
  scene.objects[4].colour = "red";
  EXPECT_EQ(TwinRun(scene, {red_and_blue()}).attribute(), (Ids{3, 4}));
}

// All are level with the red point along one side of the square around it: turned counter-clockwise, the
// right side comes nearer at its upper end.
TEST(BichromaticPairMaximumNorm, ManyOnOneSide) {
  Scene scene = scene_of({path({{1}, {-1}}), path({{1}, {0}}), path({{0, 0}, {0}}),
                          path({{1}, {fraction(1, 2)}}), path({{1}, {-fraction(1, 2)}})},
                         0, Rational(1));
  for (std::size_t i = 0; i < 5; ++i) scene.objects[i].colour = i == 2 ? "red" : "blue";
  EXPECT_EQ(TwinRun(scene, {red_and_blue()}).attribute(), (Ids{2, 3}));
}

// New flight plans under which lengths are identically equal that were not, and the reverse.
TEST(BichromaticPairMaximumNorm, LengthsThatBecomeEqual) {
  Scene scene = scene_of(
      {path({{0}, {0}}), path({{4, 1}, {1}}), path({{-5}, {2}}), path({{1}, {7}})}, 0, Rational(6));
  auto& pieces = scene.objects[1].motion.pieces;
  pieces[0].to = Rational(1);
  pieces.push_back({Rational(1), Rational(3), path({{5}, {1}})});
  pieces.push_back({Rational(3), std::nullopt, path({{8, -1}, {1}})});
  const TwinRun run(scene, {nearest()}), twin(scene, {nearest()}, "sturm");
  EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
}

// ---- numbers

TEST(BichromaticPairMaximumNorm, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    EXPECT_GT(TwinRun(in_units_of(size), {nearest()}).ledger().external, 0u);
  }
}

TEST(BichromaticPairMaximumNorm, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
      const TwinRun flights(random_flights(seed, 9, 2, 1, seed % 2 == 0), {nearest()}, arithmetic);
      const TwinRun lattice(lattice_scene(seed, 8, 2), {nearest()}, arithmetic);
      EXPECT_TRUE(flights.ledger().corrupt || flights.attribute().size() <= 2) << arithmetic;
      EXPECT_TRUE(lattice.ledger().corrupt || lattice.attribute().size() == 2) << arithmetic;
    }
  }
}

}  // namespace bichromatic_pair_maximum_norm_test
}  // namespace kinex::test

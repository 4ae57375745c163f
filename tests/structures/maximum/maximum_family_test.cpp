// SPDX-License-Identifier: GPL-3.0-or-later
// Every structure that maintains a maximum gives the same maximum, which changes at the same
// instants: on worst cases, random motion, degenerate motion, and through changes.
#include "tests/structures/maximum/maximum_family.h"

#include <algorithm>

#include "structures/maximum/maximum_dual_hull.h"
#include "structures/maximum/maximum_envelope.h"
#include "tests/sanitized.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace maximum_family_test {

Key distance_to(ObjectId object) {
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = object;
  return key;
}

// In both exact arithmetics, maximum and minimum. Returns the number of changes of the maximum.
std::size_t expect_family(const Scene& scene, const Key& key = {}) {
  std::size_t count = 0;
  for (const bool minimum : {false, true}) {
    FamilyRun exact(scene, key, minimum, "exact");
    exact.simulator->run_until({});
    exact.expect_agreement();
    FamilyRun sturm(scene, key, minimum, "sturm", AuditLevel::kEnd);
    sturm.simulator->run_until({});
    sturm.expect_agreement();
    EXPECT_EQ(exact.simulator->ledger().instants, sturm.simulator->ledger().instants);
    const StructureId last = exact.members().back();
    EXPECT_EQ(exact.changes->of(last), sturm.changes->of(last));
    if (!minimum) count = exact.changes->of(last).size();
  }
  return count;
}

TEST(MaximumFamily, HasAllItsMembers) {
  const Scene lines = steep_lines(3), curves = weaving_curves(3, 2);
  EXPECT_EQ(
      maximum_family(lines, {}, false),
      (std::vector<std::string>{"maximum_tournament", "maximum_heap", "maximum_hanger",
                                "maximum_envelope", "maximum_dual_hull", "maximum_sorted_list"}));
  EXPECT_EQ(maximum_family(curves, {}, true).size(), 5u);
  EXPECT_EQ(maximum_family(lines, distance_to(0), false).size(), 5u);
}

TEST(MaximumFamily, WorstCases) {
  for (const int n : {1, 2, 7, 16, 40}) {
    EXPECT_EQ(expect_family(steep_lines(n)), static_cast<std::size_t>(n - 1));
  }
  for (int k = 1; k <= 5; ++k) {
    EXPECT_EQ(expect_family(bit_reversed_lines(k)), (std::size_t{1} << k) - 1);
  }
  // Any two cross d times, all near d roots: there the first and the last win alternately.
  for (std::size_t d = 2; d <= 5; ++d) {
    EXPECT_EQ(expect_family(weaving_curves(5, static_cast<int>(d))), d);
  }
  // f_i(t) = i t^2 - 4^i: the envelope has 2n - 1 pieces, as many as any two that cross twice can
  // have.
  std::vector<Trajectory> t;
  for (int i = 0; i < 12; ++i)
    t.push_back(
        path({{-Rational(Integer::power_of_two(2 * static_cast<unsigned long>(i))), 0, i}}));
  EXPECT_EQ(expect_family(scene_of(t, -4096, Rational(4096))), 22u);
}

TEST(MaximumFamily, ManyAtOneInstant) {
  EXPECT_EQ(expect_family(pencil(1)), 0u);
  for (const int n : {2, 3, 9, 16}) EXPECT_EQ(expect_family(pencil(n)), 1u);
  // Tangents of a parabola meet in pairs and more.
  std::vector<Trajectory> t;
  for (int i = 0; i < 24; ++i)
    t.push_back(path({{-((5 * i) % 24) * ((5 * i) % 24), (5 * i) % 24}}));
  EXPECT_EQ(expect_family(scene_of(t, 0, std::nullopt)), 23u);
}

// 2, 1 + t and 2 t at 1, in all orders: the middle one is never the maximum.
TEST(MaximumFamily, ThreeLinesThroughOnePoint) {
  const std::vector<Trajectory> lines{path({{2}}), path({{1, 1}}), path({{0, 2}})};
  std::vector<ObjectId> place{0, 1, 2};  // of each line
  do {
    std::vector<Trajectory> t(3);
    for (std::size_t i = 0; i < 3; ++i) t[place[i]] = lines[i];
    const Scene scene = scene_of(t, 0, Rational(2));
    EXPECT_EQ(expect_family(scene), 1u);
    for (const bool minimum : {false, true}) {
      FamilyRun run(scene, {}, minimum, "exact");
      run.simulator->run_until({});
      const Change change{1, minimum ? place[2] : place[0], minimum ? place[0] : place[2]};
      for (const StructureId id : run.members()) {
        EXPECT_EQ(run.changes->of(id), std::vector<Change>{change}) << run.simulator->label(id);
      }
    }
  } while (std::next_permutation(place.begin(), place.end()));
}

// Objects on a grid, by their x, with velocities on a grid: three and more meet at each of few
// instants, some identically; some turn there.
TEST(MaximumFamily, GridsThatMeet) {
  std::size_t changes = 0;
  for (int shift = 0; shift < 5; ++shift) {
    SCOPED_TRACE("shift " + std::to_string(shift));
    std::vector<Trajectory> t;
    for (int i = 0; i < 20; ++i) {
      const int x = i % 4, v = (i / 4 + shift * i) % 5 - 2;
      t.push_back(path({{-x * (v < 0 ? -1 : 1), v}}));
    }
    Scene scene = scene_of(t, -2, Rational(4));
    changes += expect_family(scene);
    for (std::size_t i = 0; i < t.size(); i += 3) {  // those are at rest from 1 on
      Rational at(0);
      for (const Rational& c : t[i].coordinates[0]) at += c;
      std::vector<MotionPiece>& pieces = scene.objects[i].motion.pieces;
      pieces[0].to = Rational(1);
      Trajectory rest;
      rest.coordinates = {{at}};
      pieces.push_back({Rational(1), std::nullopt, rest});
    }
    changes += expect_family(scene);
  }
  EXPECT_GT(changes, 10u);
}

// Structures with one certificate have one event per change, however many objects meet.
TEST(MaximumFamily, NobodyPassesThroughWhereOnlyTheLastCounts) {
  for (const int n : {2, 3, 9, 16, 33}) {
    const Scene scene = pencil(n);
    for (const bool minimum : {false, true}) {
      FamilyRun run(scene, {}, minimum, "exact");
      run.simulator->run_until({});
      for (const StructureId id : run.members()) {
        const std::string& name = run.simulator->label(id);
        if (name.find("envelope") == std::string::npos && name.find("dual") == std::string::npos) {
          continue;
        }
        EXPECT_EQ(run.simulator->ledger(id).processed, 1u) << name << " of " << n;
      }
    }
  }
}

// Small coefficients: equal motions, equal slopes, three and more that meet.
TEST(MaximumFamily, RandomDegenerateMotion) {
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 8u : 40u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int degree = static_cast<int>(seed % 4);
    std::vector<Trajectory> t;
    for (int i = 0; i < 14; ++i)
      t.push_back(random.small_path(1, degree, 1 + static_cast<int>(seed % 3)));
    expect_family(scene_of(t, -3, Rational(3)));
  }
}

TEST(MaximumFamily, FlightPlansInsertionsAndErasures) {
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 10u : 60u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_family(random_flights(seed, 12, 1, 1 + static_cast<int>(seed % 3), true));
    expect_family(random_flights(seed, 12, 1, 1, seed % 2 == 0));
  }
}

// Segments that touch, begin and end where others do. Level lines at 0 .. 3, and guests that rise
// from one to the next and vanish, or turn round, exactly there.
TEST(MaximumFamily, SegmentsThatMeetAtTheirEnds) {
  Scene scene = scene_of({path({{0}}), path({{1}}), path({{2}}), path({{3}})}, 0, Rational(12));
  const auto on = [&scene](std::size_t i, int from, int to, Trajectory along) {
    MotionPiece& piece = scene.objects[i].motion.pieces.back();
    piece = {Rational(from), Rational(to), std::move(along)};
  };
  on(1, 1, 3, path({{1}}));
  on(2, 3, 5, path({{2}}));  // comes where 1 goes
  on(3, 5, 7, path({{3}}));
  // From below to 3 at 6, where it is equal to 3 for an instant, and back again.
  scene.objects.push_back(moving("touches", path({{-3, 1}})));
  scene.objects[4].motion.pieces[0].to = Rational(6);
  scene.objects[4].motion.pieces.push_back({Rational(6), Rational(12), path({{9, -1}})});
  // Is at 0 at 9, with 0 and "touches", and goes above both there.
  scene.objects.push_back(moving("rises", path({{-9, 1}})));
  // Comes at 10, where "rises" is the maximum, equal to it at that instant, and grows faster.
  scene.objects.push_back(moving("late", path({{-19, 2}})));
  scene.objects[6].motion.pieces[0].from = Rational(10);
  expect_family(scene);
  // 0 until 1 comes, 1 until it goes at 3; "touches" is as high as 0 at 3, and above it then, but
  // below 2; from 5 on 3, which is touched and not passed at 6, and goes at 7; then "touches" from
  // 2 down to 0 at 9, where "rises" wins, until "late" comes above it at 10 and is overtaken.
  FamilyRun run(scene, Key{}, false, "exact");
  const auto winner_at = [&run](int numerator, int denominator) {
    run.simulator->run_until(Rational(Integer(numerator), Integer(denominator)));
    return run.simulator->structure(run.members().front()).attribute().ids.at(0);
  };
  const std::vector<std::pair<int, ObjectId>> expected{{1, 0},  {3, 1},  {5, 1},  {7, 2},
                                                       {9, 2},  {11, 3}, {13, 3}, {15, 4},
                                                       {17, 4}, {19, 5}, {21, 6}, {23, 6}};
  for (const auto& [halves, winner] : expected) {
    EXPECT_EQ(winner_at(halves, 2), winner) << halves << "/2";
  }
}

TEST(MaximumFamily, OtherKeys) {
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 4u : 20u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int degree = 1 + static_cast<int>(seed % 2);
    const Scene scene = random_flights(seed, 9, 2, degree, true);
    Key key;
    key.axis = 1;
    expect_family(scene, key);
    key = {};
    key.kind = Key::Kind::kDirection;
    key.direction = {Rational(-2), *Rational::parse("3/7")};
    expect_family(scene, key);
    expect_family(random_flights(seed, 9, 2, degree, false), distance_to(4));
  }
}

// Numbers that no machine integer holds.
TEST(MaximumFamily, HugeAndTinyNumbers) {
  for (std::uint64_t seed = 1; seed <= test::fewer(10u); ++seed) {
    Random random(seed);
    std::vector<Trajectory> t;
    for (int i = 0; i < 12; ++i) {
      Trajectory p = random.small_path(1, 1, 1000);
      for (Rational& c : p.coordinates[0]) c *= *Rational::parse(i % 3 == 0 ? "1e40" : "1e-40");
      t.push_back(p);
    }
    expect_family(scene_of(t, -1, Rational(2)));
  }
}

// Pairs that cross within 2^-200 of one another.
TEST(MaximumFamily, CloseInstants) {
  std::vector<Trajectory> t;
  const Rational tiny(Integer(1), Integer::power_of_two(200));
  for (int i = 0; i < 10; ++i) t.push_back(path({{-tiny * Rational(i * i), i}}));
  EXPECT_EQ(expect_family(scene_of(t, -1, Rational(1))), 9u);
}

TEST(MaximumFamily, InexactArithmeticsEnd) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:60"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(25u); ++seed) {
      const int degree = 1 + static_cast<int>(seed % 3);
      const Scene scene = random_flights(seed, 12, 1, degree, seed % 2 == 0);
      FamilyRun run(scene, {}, seed % 5 == 0, arithmetic, AuditLevel::kNone);
      run.simulator->run_until({});
      EXPECT_EQ(run.simulator->reached(), Rational(4)) << arithmetic << " " << seed;
    }
    for (const Scene& scene : {pencil(20), weaving_curves(9, 3), steep_lines(30)}) {
      FamilyRun run(scene, {}, false, arithmetic, AuditLevel::kNone);
      run.simulator->run_until({});
    }
  }
}

// ---- single structures

// The vertices of the upper hull of (slope, height), by brute force over exact rationals.
std::vector<ObjectId> static_hull(const Simulator& simulator, bool minimum) {
  struct Point {
    Rational x, y;
    ObjectId id;
  };
  std::vector<Point> points;
  const Snapshot at0 = simulator.snapshot(Rational(0)), at1 = simulator.snapshot(Rational(1));
  for (ObjectId id = 0; id < simulator.scene().objects.size(); ++id) {
    if (!at0.alive(id)) continue;
    const Rational sign(minimum ? -1 : 1);
    points.push_back(
        {sign * (at1.position(id, 0) - at0.position(id, 0)), sign * at0.position(id, 0), id});
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? b.y < a.y : a.id < b.id;
  });
  std::vector<Point> hull;
  for (const Point& p : points) {
    if (!hull.empty() && hull.back().x == p.x) continue;
    while (hull.size() >= 2) {
      const Point &a = hull[hull.size() - 2], &b = hull.back();
      if (((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)).sign() < 0) break;
      hull.pop_back();
    }
    hull.push_back(p);
  }
  std::vector<ObjectId> ids;
  for (const Point& p : hull) ids.push_back(p.id);
  return ids;
}

// Through insertions, erasures and changes of motion the tree of bridges is the hull, and shallow.
TEST(MaximumDualHull, KeepsTheHull) {
  for (const bool minimum : {false, true}) {
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 3u : 8u); ++seed) {
      Random random(seed);
      const int size = seed % 3 == 0 ? 3 : 1000, n = 90;
      std::vector<Trajectory> t;
      for (int i = 0; i < n; ++i) t.push_back(random.small_path(1, 1, size));
      const Scene scene = scene_of(t, 0, std::nullopt);
      Simulator simulator(scene, make_arithmetic("exact", scene));
      const StructureId id = simulator.reserve();
      auto made = std::make_unique<MaximumDualHull>(
          simulator.kernel(), id, Key{}, scene, minimum ? Extremum::kMinimum : Extremum::kMaximum);
      const MaximumDualHull& structure = *made;
      simulator.add(id, std::move(made), "hull");
      simulator.start();
      std::vector<bool> alive(n, true);
      for (int step = 1; step <= 150; ++step) {
        // Twice as many leave as come, then the reverse; sorted slopes now and then.
        const bool shrink = step <= 80;
        for (int k = 0; k < 3; ++k) {
          const auto object = static_cast<ObjectId>(random.between(0, n - 1));
          const Trajectory next = random.small_path(1, 1, size);
          if (!alive[object]) {
            if (shrink && k > 0) continue;
            simulator.schedule_insertion(Rational(step), object, next);
            alive[object] = true;
          } else if (random.chance(40)) {
            const Rational at = simulator.snapshot(Rational(step)).position(object, 0);
            Trajectory turned = next;
            turned.coordinates[0].resize(2);
            turned.coordinates[0][0] = at - turned.coordinates[0][1] * Rational(step);
            turned.normalise();
            simulator.schedule_update(Rational(step), object, turned);
            continue;
          } else if (shrink || k == 0) {
            simulator.schedule_erasure(Rational(step), object);
            alive[object] = false;
          }
          simulator.run_until(Rational(step));
        }
        simulator.run_until(Rational(step));
        ASSERT_EQ(structure.hull().complaint(), "") << seed << " at " << step;
        ASSERT_EQ(structure.hull().vertices(), static_hull(simulator, minimum))
            << seed << " at " << step;
        EXPECT_LE(structure.hull().height(), 12u);
      }
      EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    }
  }
}

// Slopes in ascending order, one by one: a tree without balance would be a list.
TEST(MaximumDualHull, StaysBalanced) {
  const int n = 600;
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) t.push_back(path({{-i * i, i}}));
  Scene scene = scene_of(t, 0, std::nullopt);
  for (int i = 1; i < n; ++i)
    scene.objects[static_cast<std::size_t>(i)].motion.pieces[0].from =
        Rational(Integer(i), Integer(n));
  Simulator simulator(scene, make_arithmetic("exact", scene));
  const StructureId id = simulator.reserve();
  auto made =
      std::make_unique<MaximumDualHull>(simulator.kernel(), id, Key{}, scene, Extremum::kMaximum);
  const MaximumDualHull& structure = *made;
  simulator.add(id, std::move(made), "hull");
  simulator.start();
  simulator.run_until(Rational(1));
  EXPECT_EQ(structure.hull().size(), static_cast<std::size_t>(n));
  EXPECT_LE(structure.hull().height(), 17u);  // log of 600 to the base 3/2, and one
  EXPECT_EQ(structure.hull().vertices().size(), static_cast<std::size_t>(n));
  // Signs per insertion: polylogarithmic.
  std::uint64_t signs = 0;
  for (const PredicateCounters& p : simulator.arithmetic().counters().by_predicate) {
    for (const std::uint64_t k : p.signs) signs += k;
  }
  EXPECT_LE(signs / n, 400u);
}

TEST(MaximumDualHull, RefusesWhatIsNotLinear) {
  const Scene curves = weaving_curves(3, 2), lines = steep_lines(3);
  const auto make = [](const Scene& scene, const Key& key) {
    Simulator simulator(scene, make_arithmetic("exact", scene));
    const StructureId id = simulator.reserve();
    return make_structure({"maximum_dual_hull", "hull", key}, scene, simulator.kernel(), id);
  };
  EXPECT_THROW(make(curves, {}), std::invalid_argument);
  EXPECT_THROW(make(lines, distance_to(0)), std::invalid_argument);
  FamilyRun run(lines, {}, false, "exact");
  EXPECT_THROW(run.simulator->schedule_update(Rational(1), 0, path({{0, 0, 1}})),
               std::invalid_argument);
}

// One certificate, one event per change, whatever the order below.
TEST(Maximum, SomeHaveOneCertificate) {
  const Scene scene = steep_lines(30);
  FamilyRun run(scene, {}, false, "exact", AuditLevel::kEnd);
  run.simulator->run_until({});
  for (const StructureId id : run.members()) {
    const std::string& name = run.simulator->label(id);
    if (name != "maximum_envelope" && name != "maximum_dual_hull") continue;
    const StructureLedger& ledger = run.simulator->ledger(id);
    EXPECT_EQ(ledger.processed, 29u) << name;
    EXPECT_EQ(ledger.internal, 0u) << name;
    EXPECT_EQ(ledger.max_live, 1u) << name;
    EXPECT_EQ(ledger.certificates_created, 29u) << name;
  }
}

}  // namespace maximum_family_test
}  // namespace kinex::test

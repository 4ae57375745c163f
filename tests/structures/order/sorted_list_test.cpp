// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/order/sorted_list.h"

#include <algorithm>
#include <stdexcept>

#include "tests/sanitized.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace sorted_list_test {

constexpr const char* kName = "sorted_list";

const BoundCheck& bound_of(const std::vector<BoundCheck>& bounds, const std::string& id) {
  return *std::find_if(bounds.begin(), bounds.end(),
                       [&](const BoundCheck& b) { return b.id == id; });
}

TEST(SortedList, EveryPairOfLinesCrossesOnce) {
  for (const int n : {2, 3, 8, 15, 40}) {
    const Scene scene = steep_lines(n);
    Trial run(scene, kName);
    run.to_end().expect_clean();
    const std::uint64_t all = static_cast<std::uint64_t>(n * (n - 1) / 2);
    EXPECT_EQ(run.ledger().processed, all) << n;
    EXPECT_EQ(run.ledger().external, all);
    EXPECT_EQ(run.ledger().by_kind.at("swap"), all);
    EXPECT_EQ(run.ledger().simultaneous_groups, 0u);
    EXPECT_EQ(run.ledger().max_live, static_cast<std::uint64_t>(n - 1));
    EXPECT_LE(run.ledger().max_per_object, 2u);
    EXPECT_LE(run.ledger().created_per_event.max, 3u);
    const BoundCheck swaps = bound_of(run.simulator.bounds(0), "sorted_list.swaps");
    EXPECT_EQ(swaps.bound, swaps.observed);
  }
}

TEST(SortedList, EveryPairOfCurvesCrossesDegreeTimes) {
  for (const auto& [n, d] :
       {std::pair{5, 2}, std::pair{6, 3}, std::pair{4, 4}, std::pair{12, 2}, std::pair{9, 5}}) {
    const Scene scene = weaving_curves(n, d);
    Trial run(scene, kName);
    run.to_end().expect_clean();
    EXPECT_EQ(run.ledger().processed, static_cast<std::uint64_t>(d * n * (n - 1) / 2))
        << n << " " << d;
    const BoundCheck swaps = bound_of(run.simulator.bounds(0), "sorted_list.swaps");
    EXPECT_EQ(swaps.bound, swaps.observed);
  }
}

TEST(SortedList, AllMeetAtOneInstant) {
  const int n = 12;
  const Scene scene = pencil(n);
  Trial run(scene, kName);
  run.to_end().expect_clean();
  EXPECT_EQ(run.ledger().processed, static_cast<std::uint64_t>(n * (n - 1) / 2));
  EXPECT_EQ(run.ledger().simultaneous_groups, 1u);
  EXPECT_EQ(run.ledger().largest_group, run.ledger().processed);
  EXPECT_EQ(run.simulator.ledger().instants, 1u);
}

TEST(SortedList, TouchingIsNoEvent) {
  // (t - 1)^2 and (t - 2)^4 touch 0 and turn back; (t - 3)^3 goes through.
  const Scene scene = scene_of(
      {path({{0}}), path({{1, -2, 1}}), path({{16, -32, 24, -8, 1}}), path({{27, -27, 9, -1}})}, 0,
      Rational(10));
  Trial run(scene, kName);
  run.run_until(Rational(Integer(5), Integer(2)));
  EXPECT_EQ(run.ids().front(), 0u);
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids().front(), 3u);
}

TEST(SortedList, AuditsKeepClearOfTouchingPoints) {
  // Half way between start and end 0 touches 1, where positions alone would put 0 first; 2 and 3
  // are identically equal.
  const Scene scene =
      scene_of({path({{0, 0, 1}}), path({{0}}), path({{5}}), path({{5}})}, -1, Rational(1));
  Trial run(scene, kName);
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{1, 0, 2, 3}));
  run.to_end().expect_clean();
}

TEST(SortedList, InstantsBeyondTheDoubles) {
  // -t and -t^2 pass the others at 1e400, 1e500, and at their square roots.
  const Scene scene =
      scene_of({path({{0, -1}}), path({{0, 0, -1}}), path({{*Rational::parse("-1e400")}}),
                path({{*Rational::parse("-1e500")}})},
               2, std::nullopt);
  Trial run(scene, kName);
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{3, 2, 1, 0}));
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{1, 0, 3, 2}));
  EXPECT_EQ(run.ledger().processed, 4u);
  EXPECT_GT(run.simulator.reached(), *Rational::parse("1e500"));
  for (const char* arithmetic : {"double", "gsl", "mpfr:20"}) {
    Trial inexact(scene, kName, arithmetic);
    inexact.to_end();
  }
}

TEST(SortedList, StartsDegenerate) {
  // All at 0 when the scene starts: the order is that of the velocities, then of the ids.
  const Scene scene = scene_of(
      {path({{0, 2}}), path({{0, -1}}), path({{0, 2}}), path({{0, 0, -1}})}, 0, Rational(1));
  Trial run(scene, kName);
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{1, 3, 0, 2}));
  // -t and -t^2 meet at the end, which is read from the right.
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{3, 1, 0, 2}));
  EXPECT_EQ(run.ledger().processed, 1u);
}

TEST(SortedList, EqualMotionsStandInTheOrderOfIds) {
  // Two equal pairs that pass through each other.
  const Scene scene =
      scene_of({path({{0, 1}}), path({{2, -1}}), path({{0, 1}}), path({{2, -1}})}, 0, Rational(3));
  Trial run(scene, kName);
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{0, 2, 1, 3}));
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{1, 3, 0, 2}));
  EXPECT_EQ(run.ledger().processed, 4u);
}

TEST(SortedList, ObjectsThatBecomeEqualArePutInOrder) {
  Scene scene = scene_of({path({{0, 1}}), path({{0, 1}}), path({{2}})}, 0, Rational(4));
  // At 1 the last, which is in front of none, takes over the place and speed of the others.
  scene.objects[0].motion.pieces[0].trajectory = path({{2, -1}});
  scene.objects[2].motion.pieces = {{std::nullopt, Rational(1), path({{0, 1}})},
                                    {Rational(1), std::nullopt, path({{2, -1}})}};
  Trial run(scene, kName);
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{1, 2, 0}));
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{0, 2, 1}));
  EXPECT_EQ(run.ledger().motion_updates, 1u);
}

TEST(SortedList, Keys) {
  const Scene scene =
      scene_of({path({{0, 1}, {0}}), path({{3}, {1}}), path({{0}, {5, -1}}), path({{0}, {0}})}, 0,
               Rational(8));
  Key y;
  y.axis = 1;
  Trial by_y(scene, kName, "exact", AuditLevel::kEvents, y);
  by_y.to_end().expect_clean();
  EXPECT_EQ(by_y.ids(), (std::vector<ObjectId>{2, 0, 3, 1}));
  Key direction;
  direction.kind = Key::Kind::kDirection;
  direction.direction = {Rational(-1), Rational(Integer(1), Integer(2))};
  Trial along(scene, kName, "exact", AuditLevel::kEvents, direction);
  along.to_end().expect_clean();
  EXPECT_EQ(along.ids(), (std::vector<ObjectId>{0, 1, 2, 3}));
  Key distance;
  distance.kind = Key::Kind::kSquaredDistance;
  distance.object = 3;
  Trial around(scene, kName, "exact", AuditLevel::kEvents, distance);
  EXPECT_EQ(around.ids(), (std::vector<ObjectId>{0, 1, 2}));
  around.to_end().expect_clean();
  EXPECT_EQ(around.ids(), (std::vector<ObjectId>{2, 1, 0}));
}

TEST(SortedList, TheReferenceMustStay) {
  const Scene scene = scene_of({path({{0, 1}}), path({{3}}), path({{5}})}, 0, Rational(8));
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = 1;
  Trial run(scene, kName, "exact", AuditLevel::kEvents, key);
  run.erase(Rational(1), 1);
  EXPECT_THROW(run.to_end(), std::invalid_argument);
  key.object = 3;
  EXPECT_THROW(Trial(scene, kName, "exact", AuditLevel::kEvents, key), std::invalid_argument);
  key.kind = Key::Kind::kCoordinate;
  key.axis = 1;
  EXPECT_THROW(Trial(scene, kName, "exact", AuditLevel::kEvents, key), std::invalid_argument);
}

TEST(SortedList, AMovingReferenceReschedulesAll) {
  Scene scene = scene_of({path({{0}}), path({{4}}), path({{9, -1}})}, 0, Rational(6));
  scene.objects[2].motion.pieces = {{std::nullopt, Rational(2), path({{9, -1}})},
                                    {Rational(2), std::nullopt, path({{11, -2}})}};
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = 2;
  Trial run(scene, kName, "exact", AuditLevel::kEvents, key);
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{0, 1}));
  EXPECT_EQ(run.ledger().processed, 1u);
}

TEST(SortedList, RandomFlights) {
  for (std::uint64_t seed = 1; seed <= test::fewer(60u); ++seed) {
    const Scene scene = random_flights(seed, 9, 1, 1 + static_cast<int>(seed % 3), seed % 2 == 0);
    Trial run(scene, kName);
    SCOPED_TRACE("seed " + std::to_string(seed));
    run.to_end().expect_clean();
  }
}

TEST(SortedList, RandomFlightsAroundAnObject) {
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  for (std::uint64_t seed = 1; seed <= test::fewer(30u); ++seed) {
    Scene scene = random_flights(seed, 7, 2, 1 + static_cast<int>(seed % 2), seed % 2 == 0);
    key.object = static_cast<ObjectId>(scene.objects.size());
    scene.objects.push_back(moving("centre", path({{1, -1}, {0, 1}})));
    Trial run(scene, kName, "exact", AuditLevel::kEvents, key);
    SCOPED_TRACE("seed " + std::to_string(seed));
    run.to_end().expect_clean();
  }
}

TEST(SortedList, ReferenceArithmeticGivesTheSameLog) {
  for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
    const Scene scene = random_flights(seed, 7, 1, 1 + static_cast<int>(seed % 3), true);
    Trial exact(scene, kName), sturm(scene, kName, "sturm");
    exact.to_end();
    sturm.to_end().expect_clean();
    EXPECT_EQ(exact.sink.lines, sturm.sink.lines) << "seed " << seed;
  }
}

TEST(SortedList, InexactArithmeticsEnd) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(15u); ++seed) {
      const Scene scene = random_flights(seed, 9, 1, 1 + static_cast<int>(seed % 3), seed % 2 == 0);
      Trial run(scene, kName, arithmetic);
      run.to_end();
      EXPECT_EQ(run.simulator.reached(), Rational(4)) << arithmetic << " seed " << seed;
    }
    const Scene scene = pencil(10);
    Trial run(scene, kName, arithmetic);
    run.to_end();
  }
}

TEST(SortedList, InsertionsSearchInLogarithmicTime) {
  const int n = 512;
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) t.push_back(path({{i}}));
  Scene scene = scene_of(t, 0, Rational(10));
  scene.objects.push_back(moving("late", path({{Rational(Integer(1), Integer(2))}})));
  scene.objects.back().motion.pieces[0].from = Rational(1);
  Trial run(scene, kName, "exact", AuditLevel::kNone);
  const auto signs = [&run] {
    std::uint64_t sum = 0;
    for (const auto& p : run.simulator.arithmetic().counters().by_predicate) {
      for (const std::uint64_t s : p.signs) sum += s;
    }
    return sum;
  };
  const std::uint64_t before = signs();
  const std::uint64_t created = run.ledger().certificates_created;
  run.to_end();
  EXPECT_LE(signs() - before, 40u);
  EXPECT_EQ(run.ledger().certificates_created - created, 2u);
  EXPECT_TRUE(run.simulator.audit());
}

TEST(OrderTree, FollowsAList) {
  Random random(7);
  OrderTree tree;
  std::vector<OrderTree::Place> list, spare;
  for (OrderTree::Place p = 0; p < 20; ++p) list.push_back(p);
  tree.build(list);
  OrderTree::Place next = 20;
  for (int step = 0; step < 3000; ++step) {
    if (random.chance(list.size() > 40 ? 30 : 60)) {
      OrderTree::Place p = next;
      if (spare.empty()) {
        ++next;
      } else {
        p = spare.back();
        spare.pop_back();
      }
      const int at = random.between(0, static_cast<int>(list.size()));
      tree.insert_after(at == 0 ? OrderTree::kNone : list[static_cast<std::size_t>(at - 1)], p);
      list.insert(list.begin() + at, p);
    } else if (!list.empty()) {
      const int at = random.between(0, static_cast<int>(list.size()) - 1);
      tree.erase(list[static_cast<std::size_t>(at)]);
      spare.push_back(list[static_cast<std::size_t>(at)]);
      list.erase(list.begin() + at);
    }
    ASSERT_EQ(tree.in_order(), list);
    ASSERT_TRUE(tree.consistent());
  }
}

}  // namespace sorted_list_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "structures/maximum/maximum_heap.h"
#include "structures/maximum/maximum_tournament.h"
#include "tests/sanitized.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace maximum_test {

constexpr std::array<const char*, 6> kAll{"maximum_tournament", "minimum_tournament",
                                          "maximum_heap",       "minimum_heap",
                                          "maximum_hanger",     "minimum_hanger"};

const BoundCheck* bound_of(const std::vector<BoundCheck>& bounds, const std::string& id) {
  const auto at = std::find_if(bounds.begin(), bounds.end(), [&](const BoundCheck& b) {
    return b.id.find(id) != std::string::npos;
  });
  return at == bounds.end() ? nullptr : &*at;
}

TEST(MaximumTournament, WorstCase) {
  const std::array<std::uint64_t, 8> expected{0, 1, 5, 17, 49, 129, 321, 769};
  for (int k = 1; k <= 6; ++k) {
    const Scene scene = bit_reversed_lines(k);
    Trial run(scene, "maximum_tournament");
    run.to_end().expect_clean();
    const std::uint64_t n = std::uint64_t{1} << k;
    EXPECT_EQ(run.ledger().processed, expected[static_cast<std::size_t>(k)]);
    EXPECT_EQ(run.ledger().external, n - 1);
    EXPECT_EQ(run.ledger().max_live, n - 1);
    EXPECT_LE(run.ledger().max_per_object, static_cast<std::uint64_t>(k));
    const auto bounds = run.simulator.bounds(0);
    EXPECT_EQ(bound_of(bounds, ".events")->bound, bound_of(bounds, ".events")->observed);
    EXPECT_EQ(bound_of(bounds, ".external")->bound, bound_of(bounds, ".external")->observed);
  }
}

TEST(MaximumTournament, WorstCaseOf256) {
  const Scene scene = bit_reversed_lines(8);
  Trial run(scene, "maximum_tournament", "exact", AuditLevel::kEnd);
  run.to_end().expect_clean();
  EXPECT_EQ(run.ledger().processed, 1793u);
  EXPECT_EQ(run.ledger().external, 255u);
}

TEST(MaximumHeap, WorstCase) {
  for (const auto& [n, events] :
       {std::pair{7, 10u}, std::pair{15, 34u}, std::pair{31, 98u}, std::pair{63, 258u},
        std::pair{100, 480u}, std::pair{127, 642u}, std::pair{255, 1538u}}) {
    const Scene scene = steep_lines(n);
    Trial run(scene, "maximum_heap", "exact", n <= 15 ? AuditLevel::kEvents : AuditLevel::kEnd);
    run.to_end().expect_clean();
    EXPECT_EQ(run.ledger().processed, events);
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n - 1));
    EXPECT_LE(run.ledger().max_per_object, 3u);
    EXPECT_LE(run.ledger().created_per_event.max, 5u);
    const auto bounds = run.simulator.bounds(0);
    EXPECT_EQ(bound_of(bounds, ".events")->bound, bound_of(bounds, ".events")->observed);
  }
}

// f_i(t) = i t - i^2: the tangents of a parabola, any two of which meet at an integer i + j. The
// maximum changes n - 1 times, each time alone, while much happens at one instant below.
TEST(Maximum, TangentsMeetManyAtATime) {
  for (const char* name : {"maximum_tournament", "maximum_heap", "maximum_hanger"}) {
    for (const int n : {4, 8, 31, 64}) {
      std::vector<Trajectory> t;
      for (int i = 0; i < n; ++i)
        t.push_back(path({{-((5 * i) % n) * ((5 * i) % n), (5 * i) % n}}));
      const Scene scene = scene_of(t, 0, std::nullopt);
      Trial run(scene, name);
      SCOPED_TRACE(std::string(name) + " of " + std::to_string(n));
      run.to_end().expect_clean();
      EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n - 1));
      if (n > 8) {
        EXPECT_GT(run.ledger().simultaneous_groups, 0u);
      }
    }
  }
}

TEST(MaximumTournament, ANewWinnerGoesUpWithoutFurtherFailures) {
  // 0 overtakes 1, the winner of all eight, in the match at the bottom.
  std::vector<Trajectory> t{path({{0, 1}}), path({{1}})};
  for (int i = 2; i < 8; ++i) t.push_back(path({{-i}}));
  const Scene scene = scene_of(t, 0, Rational(2));
  Trial run(scene, "maximum_tournament");
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), std::vector<ObjectId>{0});
  EXPECT_EQ(run.ledger().processed, 1u);
  EXPECT_EQ(run.ledger().external, 1u);
  EXPECT_EQ(run.ledger().created_per_event.max, 3u);
}

TEST(Maximum, SeveralBecomeEqualAtOnce) {
  for (const char* name : {"maximum_tournament", "maximum_heap", "maximum_hanger"}) {
    // At 1 the last three meet and go on together.
    Scene scene = scene_of({path({{0}}), path({{1}}), path({{2}}), path({{3}})}, 0, Rational(2));
    for (ObjectId i = 1; i < 4; ++i) {
      const int v = static_cast<int>(i);
      scene.objects[i].motion.pieces = {{std::nullopt, Rational(1), path({{v, 4 - v}})},
                                        {Rational(1), std::nullopt, path({{4}})}};
    }
    Trial run(scene, name);
    SCOPED_TRACE(name);
    EXPECT_EQ(run.ids(), std::vector<ObjectId>{3});
    run.to_end().expect_clean();
    EXPECT_EQ(run.ids(), std::vector<ObjectId>{1});
  }
}

TEST(Maximum, MinimumIsTheMirrorImage) {
  Scene scene = bit_reversed_lines(5);
  for (SceneObject& object : scene.objects) {
    for (Rational& c : object.motion.pieces[0].trajectory.coordinates[0]) c = -c;
  }
  Trial run(scene, "minimum_tournament");
  run.to_end().expect_clean();
  EXPECT_EQ(run.ledger().processed, 129u);
  EXPECT_EQ(run.ledger().external, 31u);
}

TEST(Maximum, AllMeetAtOneInstant) {
  for (const char* name : kAll) {
    const Scene scene = pencil(16);
    Trial run(scene, name);
    SCOPED_TRACE(name);
    run.to_end().expect_clean();
    EXPECT_EQ(run.ledger().simultaneous_groups, 1u);
    EXPECT_GE(run.ledger().external, 1u);
  }
}

TEST(Maximum, TouchingIsNoEvent) {
  for (const char* name : {"minimum_tournament", "minimum_heap", "minimum_hanger"}) {
    const Scene scene =
        scene_of({path({{0}}), path({{1, -2, 1}}), path({{4, -4, 1}})}, 0, Rational(5));
    Trial run(scene, name);
    run.to_end().expect_clean();
    EXPECT_EQ(run.ids(), std::vector<ObjectId>{0});
    EXPECT_EQ(run.ledger().external, 0u);
  }
}

TEST(Maximum, OfEqualKeysTheSmallestIdWins) {
  for (const char* name : kAll) {
    // 2, 4 and 5 are equal and best at the start; at 1 object 1 joins them, at 2 object 0 does.
    const int s = std::string(name).substr(0, 3) == "min" ? -1 : 1;
    const auto flip = [s](int a, int b) { return path({{s * a, s * b}}); };
    Scene scene = scene_of({flip(3, 1), flip(4, 1), flip(5, 0), flip(0, 0), flip(5, 0), flip(5, 0)},
                           0, Rational(4));
    scene.objects[1].motion.pieces = {{std::nullopt, Rational(1), flip(4, 1)},
                                      {Rational(1), std::nullopt, flip(5, 0)}};
    scene.objects[0].motion.pieces = {{std::nullopt, Rational(2), flip(3, 1)},
                                      {Rational(2), std::nullopt, flip(5, 0)}};
    Trial run(scene, name);
    SCOPED_TRACE(name);
    EXPECT_EQ(run.ids(), std::vector<ObjectId>{2});
    run.run_until(Rational(1));
    EXPECT_EQ(run.ids(), std::vector<ObjectId>{1});
    run.to_end();
    EXPECT_EQ(run.ids(), std::vector<ObjectId>{0});
    EXPECT_EQ(run.simulator.violations(), std::vector<std::string>{});
  }
}

TEST(Maximum, RandomFlights) {
  for (const char* name : kAll) {
    for (std::uint64_t seed = 1; seed <= test::fewer(40u); ++seed) {
      const Scene scene =
          random_flights(seed, 11, 1, 1 + static_cast<int>(seed % 3), seed % 2 == 0);
      Trial run(scene, name);
      SCOPED_TRACE(std::string(name) + " seed " + std::to_string(seed));
      run.to_end().expect_clean();
    }
  }
}

TEST(Maximum, RandomScenesWithoutChangesKeepTheBounds) {
  for (const char* name : kAll) {
    for (std::uint64_t seed = 1; seed <= test::fewer(40u); ++seed) {
      Random random(seed);
      std::vector<Trajectory> t;
      const int degree = 1 + static_cast<int>(seed % 3);
      for (int i = 0; i < 13; ++i) t.push_back(random.small_path(1, degree, 3));
      const Scene scene = scene_of(t, -3, Rational(3));
      Trial run(scene, name);
      SCOPED_TRACE(std::string(name) + " seed " + std::to_string(seed));
      run.to_end().expect_clean();
      const auto bounds = run.simulator.bounds(0);
      EXPECT_NE(bound_of(bounds, ".external"), nullptr);
      EXPECT_NE(bound_of(bounds, ".events"), nullptr);
    }
  }
}

TEST(Maximum, ReferenceArithmeticGivesTheSameLog) {
  for (const char* name : kAll) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      const Scene scene = random_flights(seed, 7, 1, 1 + static_cast<int>(seed % 3), true);
      Trial exact(scene, name), sturm(scene, name, "sturm");
      exact.to_end();
      sturm.to_end().expect_clean();
      EXPECT_EQ(exact.sink.lines, sturm.sink.lines) << name << " seed " << seed;
    }
  }
}

TEST(Maximum, InexactArithmeticsEnd) {
  for (const char* name : kAll) {
    for (const char* arithmetic : {"double", "gsl", "mpfr:4"}) {
      for (std::uint64_t seed = 1; seed <= test::fewer(10u); ++seed) {
        const Scene scene =
            random_flights(seed, 9, 1, 1 + static_cast<int>(seed % 3), seed % 2 == 0);
        Trial run(scene, name, arithmetic);
        run.to_end();
        EXPECT_EQ(run.simulator.reached(), Rational(4)) << name << " " << arithmetic << " " << seed;
      }
    }
  }
}

// A change of motion, an insertion and an erasure touch O(log n) certificates.
TEST(Maximum, ChangesAreLocal) {
  const int n = 1000;
  for (const char* name : kAll) {
    Random random(5);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{random.between(-100000, 100000)}}));
    Scene scene = scene_of(t, 0, std::nullopt);
    for (int i = 0; i < 20; ++i) {
      scene.objects.push_back(moving(std::string("late").append(std::to_string(i)),
                                     path({{random.between(-100000, 100000)}})));
      scene.objects.back().motion.pieces[0].from = Rational(1 + i);
    }
    Trial run(scene, name, "exact", AuditLevel::kEnd);
    for (int i = 0; i < 20; ++i) {
      run.erase(Rational(Integer(2 * i + 1), Integer(2)), static_cast<ObjectId>(40 * i + 3));
    }
    std::uint64_t last = run.ledger().certificates_created;
    for (int half = 1; half <= 40; ++half) {
      run.run_until(Rational(Integer(half), Integer(2)));
      EXPECT_LE(run.ledger().certificates_created - last, 48u) << name << " at " << half << "/2";
      last = run.ledger().certificates_created;
    }
    EXPECT_EQ(run.ledger().insertions, 20u);
    EXPECT_EQ(run.ledger().erasures, 20u);
    run.to_end().expect_clean();
    EXPECT_LE(run.ledger().max_per_object, 10u);
  }
}

TEST(Maximum, EmptyAndBack) {
  for (const char* name : {"maximum_tournament", "minimum_heap", "maximum_hanger", "sorted_list"}) {
    const Scene scene = scene_of({path({{0, 1}}), path({{1}}), path({{2, -1}})}, 0, std::nullopt);
    Trial run(scene, name);
    SCOPED_TRACE(name);
    for (ObjectId i = 0; i < 3; ++i) run.erase(Rational(1 + static_cast<int>(i)), i);
    run.run_until(Rational(4));
    EXPECT_TRUE(run.ids().empty());
    for (ObjectId i = 0; i < 3; ++i) {
      run.insert(Rational(5), i, path({{static_cast<int>(i), -1}}));
    }
    run.to_end().expect_clean();
    EXPECT_EQ(run.ids().front(), std::string(name).substr(0, 3) == "max" ? 2u : 0u);
  }
}

TEST(DavenportSchinzel, KnownValues) {
  EXPECT_EQ(davenport_schinzel_bound(0, Integer(9)), Integer(1));
  EXPECT_EQ(davenport_schinzel_bound(1, Integer(9)), Integer(9));
  EXPECT_EQ(davenport_schinzel_bound(2, Integer(9)), Integer(17));
  EXPECT_EQ(davenport_schinzel_bound(3, Integer(5)), Integer(17));
  EXPECT_EQ(davenport_schinzel_bound(3, Integer(8)), Integer(32));
  EXPECT_EQ(davenport_schinzel_bound(4, Integer(3)), Integer(13));
  EXPECT_EQ(davenport_schinzel_bound(4, Integer(1)), Integer(1));
  EXPECT_EQ(davenport_schinzel_bound(3, Integer(0)), Integer(0));
  // n (4 + 2 ceil(log2(n / 8))).
  EXPECT_EQ(davenport_schinzel_bound(3, Integer(9)), Integer(54));
  EXPECT_EQ(davenport_schinzel_bound(3, Integer(16)), Integer(96));
  EXPECT_EQ(davenport_schinzel_bound(3, Integer(17)), Integer(136));
}

TEST(PairSignChanges, CountsJointPieces) {
  EXPECT_EQ(pair_sign_changes({}, 2), Integer(0));
  EXPECT_EQ(pair_sign_changes({1}, 2), Integer(0));
  EXPECT_EQ(pair_sign_changes({1, 1, 1}, 2), Integer(6));
  // Pairs with 3, 4 and 6 joint pieces: 2 * 13 - 3.
  EXPECT_EQ(pair_sign_changes({1, 3, 4}, 1), Integer(23));
  // One more motion of 2 pieces: 4, 5 and 7.
  EXPECT_EQ(pair_sign_changes({1, 3, 4}, 1, 2), Integer(29));
}

}  // namespace maximum_test
}  // namespace kinex::test

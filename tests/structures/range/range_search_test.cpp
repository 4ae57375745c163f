// SPDX-License-Identifier: GPL-3.0-or-later
// Queries: every tree finds what a scan of exact positions and CGAL's Kd_tree find.
#include "structures/parts/range_search.h"

#include "structures/range/pseudo_kd_tree_2.h"
#include "tests/sanitized.h"
#include "tests/structures/range/range_run.h"

namespace kinex::test {
namespace range_search_test {

// A box whose sides pass through points, through nothing, or are the same.
ExactBox some_box(Random& random, const Snapshot& now) {
  std::vector<ObjectId> alive;
  for (ObjectId id = 0; id < now.objects(); ++id) {
    if (now.alive(id)) alive.push_back(id);
  }
  ExactBox box;
  for (const int axis : {0, 1}) {
    const auto side = [&]() -> Rational {
      if (alive.empty() || random.chance(30)) {
        return Rational(Integer(random.between(-12, 12)), Integer(random.between(1, 3)));
      }
      return now.position(
          alive[static_cast<std::size_t>(random.between(0, static_cast<int>(alive.size()) - 1))],
          axis);
    };
    Rational low = side(), high = random.chance(10) ? low : side();
    if (high < low && random.chance(90)) std::swap(low, high);
    box[static_cast<std::size_t>(axis)] = {low, high};
  }
  if (random.chance(5))
    box = {{{Rational(-1000), Rational(1000)}, {Rational(-1000), Rational(1000)}}};
  return box;
}

void search_all_the_time(Scene scene, std::uint64_t seed, int times, int boxes) {
  const Rational end = *scene.end;
  SearchedRun run(std::move(scene));
  Random random(seed);
  for (int i = 0; i <= times; ++i) {
    run.simulator.run_until(end * Rational(Integer(i), Integer(times)));
    const Snapshot now = run.simulator.snapshot(run.simulator.reached());
    for (int k = 0; k < boxes; ++k) run.expect_right(some_box(random, now));
    if (testing::Test::HasFailure()) return;
  }
  run.expect_bounds();
  const auto asked = static_cast<std::uint64_t>((times + 1) * boxes);
  EXPECT_GT(run.stayed, asked / 4);
}

TEST(RangeSearch, RandomFlights) {
  for (std::uint64_t seed = 1; seed <= test::fewer(24u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int degree = 1 + static_cast<int>(seed % 3);
    search_all_the_time(random_flights(seed, 3 + static_cast<int>(seed), 2, degree, seed % 2 == 0),
                        seed, 32, 6);
  }
}

// Every time is an instant at which points meet, and at which plans change, too.
TEST(RangeSearch, RightAfterAnInstant) {
  Scene scene = scene_of({path({{0, 1}, {0}}), path({{4, -1}, {0}}), path({{2}, {-2, 1}}),
                          path({{2}, {2, -1}}), path({{2}, {0}})},
                         0, Rational(4));
  SearchedRun run(scene);
  const Rational two(2);
  run.simulator.run_until(two);
  const std::vector<ObjectId> all{0, 1, 2, 3, 4};
  // All are at (2, 0) now. Right after now 1 and 3 have left to the left and down.
  EXPECT_EQ(run.answers({{{two, two}, {Rational(0), Rational(0)}}})[0], std::vector<ObjectId>{4});
  EXPECT_EQ(run.answers({{{two, Rational(3)}, {Rational(0), Rational(1)}}})[1],
            (std::vector<ObjectId>{0, 2, 4}));
  EXPECT_EQ(run.answers({{{Rational(1), Rational(3)}, {Rational(-1), Rational(1)}}})[2], all);
}

TEST(RangeSearch, Remainders) {
  const auto answers = [](int n) {
    SearchedRun run(remainders(n));
    std::vector<std::vector<ObjectId>> result;
    for (const int t : {3, 6, 9}) {
      run.simulator.run_until(Rational(t));
      const auto found =
          run.answers({{{Rational(20), Rational(80)}, {Rational(20), Rational(80)}}});
      for (const auto& answer : found) EXPECT_EQ(answer, found[0]);
      result.push_back(found[0]);
    }
    return result;
  };
  using Answers = std::vector<std::vector<ObjectId>>;
  EXPECT_EQ(answers(6), (Answers{{1, 3}, {3}, {}}));
  EXPECT_EQ(answers(8), (Answers{{1, 3, 7}, {3, 7}, {7}}));
}

TEST(RangeSearch, SidesAndCornersBelongToTheBox) {
  SearchedRun run(scene_of(
      {path({{0}, {0}}), path({{1}, {0}}), path({{1}, {1}}), path({{2}, {1}}), path({{1}, {1}})}, 0,
      Rational(1)));
  const auto answer = [&](int x1, int x2, int y1, int y2) {
    const auto found = run.answers({{{Rational(x1), Rational(x2)}, {Rational(y1), Rational(y2)}}});
    for (const auto& other : found) EXPECT_EQ(other, found[0]);
    return found[0];
  };
  EXPECT_EQ(answer(0, 1, 0, 1), (std::vector<ObjectId>{0, 1, 2, 4}));
  EXPECT_EQ(answer(1, 1, 1, 1), (std::vector<ObjectId>{2, 4}));
  EXPECT_EQ(answer(1, 0, 0, 1), std::vector<ObjectId>{});
  EXPECT_EQ(answer(3, 4, 0, 1), std::vector<ObjectId>{});
  EXPECT_EQ(answer(-9, -8, 0, 1), std::vector<ObjectId>{});
  EXPECT_EQ(answer(-9, 9, -9, 9), (std::vector<ObjectId>{0, 1, 2, 3, 4}));
}

// 4 (log2 n + 1) signs at most; everything and nothing are cheap.
TEST(RangeSearch, CostsOfAGrid) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) t.push_back(path({{32 * i + j}, {32 * j + i}}));
  }
  SearchedRun run(scene_of(t, 0, Rational(1)));
  Random random(7);
  for (int k = 0; k < 200; ++k) {
    ExactBox box;
    for (auto& [low, high] : box) {
      int a = random.between(-10, 1030), b = random.between(-10, 1030);
      if (b < a) std::swap(a, b);
      low = Rational(a), high = Rational(b);
    }
    run.expect_right(box);
    for (const QueryCounts& counts : run.counts) EXPECT_LE(counts.signs, 44u);
  }
  run.expect_bounds();
  run.expect_right({{{Rational(-5), Rational(2000)}, {Rational(-5), Rational(2000)}}});
  EXPECT_LE(run.counts[1].nodes, 2 * 1024u);
  EXPECT_LE(run.counts[2].nodes, 2 * 1024u);
  run.expect_right({{{Rational(3000), Rational(4000)}, {Rational(-5), Rational(2000)}}});
  EXPECT_EQ(run.counts[1].nodes, 0u);
}

TEST(RangeSearch, InexactArithmeticsAnswer) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:24", "sturm"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      SearchedRun run(random_flights(seed, 9, 2, 2, seed % 2 == 0), arithmetic);
      for (int i = 0; i <= 16; ++i) {
        run.simulator.run_until(Rational(Integer(i), Integer(4)));
        const auto found =
            run.answers({{{Rational(-1), Rational(2)}, {Rational(-2), Rational(1)}}});
        for (const auto& answer : found) EXPECT_EQ(answer, found[0]) << arithmetic;
      }
    }
  }
}

}  // namespace range_search_test
}  // namespace kinex::test

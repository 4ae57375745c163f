// SPDX-License-Identifier: GPL-3.0-or-later
// The tree over trajectories: the dual points in general position, halving lines, and queries.
#include "structures/range/trajectory_tree.h"

#include "structures/range/halving_line.h"
#include "tests/sanitized.h"
#include "tests/structures/range/range_run.h"

namespace kinex::test {
namespace trajectory_tree_test {

std::vector<Request> linear_trees() {
  return {{"trajectory_tree", "trajectory_tree", {}}, {"rank_kd_tree_2", "rank_kd_tree_2", {}}};
}

// Few slopes and heights: many points coincide, or are on a line.
std::vector<Trajectory> small_lines(Random& random, int n, int size) {
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    t.push_back(path({{random.between(-size, size), random.between(-size, size)},
                      {random.between(-size, size), random.between(-size, size)}}));
  }
  return t;
}

struct Plane {  // dual points of the x coordinates
  explicit Plane(const std::vector<Trajectory>& t)
      : run(scene_of(t, 0, Rational(1)), "exact", linear_trees()),
        points(run.simulator.kernel(), 0, 2) {}
  SearchedRun run;
  DualPoints points;
};

// Knuth, "Axioms and hulls" (1992): the five axioms of counter-clockwise triples.
TEST(DualPoints, AreInGeneralPosition) {
  for (std::uint64_t seed = 1; seed <= test::fewer(60u); ++seed) {
    Random random(seed);
    const int n = 6;
    Plane plane(small_lines(random, n, 1 + static_cast<int>(seed % 3) / 2));
    const auto left = [&](int a, int b, int c) {
      return plane.points.is_left(static_cast<ObjectId>(a), static_cast<ObjectId>(b),
                                  static_cast<ObjectId>(c));
    };
    std::array<int, 6> p{};
    for (int i = 0; i < n; ++i) p[static_cast<std::size_t>(i)] = i;
    do {
      const auto [a, b, c, t, s, unused] = p;
      EXPECT_EQ(left(a, b, c), left(b, c, a));
      EXPECT_NE(left(a, b, c), left(a, c, b));
      if (left(t, b, c) && left(a, t, c) && left(a, b, t)) {
        EXPECT_TRUE(left(a, b, c));
      }
      if (left(t, s, a) && left(t, s, b) && left(t, s, c) && left(t, a, b) && left(t, b, c)) {
        EXPECT_TRUE(left(t, a, c)) << seed;
      }
      static_cast<void>(unused);
    } while (!testing::Test::HasFailure() && std::next_permutation(p.begin(), p.end()));
  }
}

// After halving, the line through the last points of the first halves has these on its left.
TEST(HalvingLine, HalvesBothSets) {
  for (std::uint64_t seed = 1; seed <= test::fewer(120u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int n = 2 + static_cast<int>(seed) * (seed % 10 == 0 ? 3 : 1);
    Plane plane(small_lines(random, n, 1 + static_cast<int>(seed % 7)));
    std::vector<ObjectId> all;
    for (ObjectId id = 0; id < static_cast<ObjectId>(n); ++id) all.push_back(id);
    std::sort(all.begin(), all.end(),
              [&](ObjectId a, ObjectId b) { return plane.points.precedes(a, b); });
    const std::span<ObjectId> a(all.data(), first_half(all.size()));
    const std::span<ObjectId> b(all.data() + a.size(), all.size() - a.size());
    halve_both(plane.points, a, b);
    const std::size_t i = first_half(a.size()) - 1, j = first_half(b.size()) - 1;
    for (const auto& [set, last] : {std::pair(a, i), std::pair(b, j)}) {
      for (std::size_t k = 0; k < set.size(); ++k) {
        if (k == last) continue;
        EXPECT_EQ(plane.points.is_left(a[i], b[j], set[k]), k < last);
      }
    }
    std::sort(all.begin(), all.end());
    EXPECT_EQ(std::unique(all.begin(), all.end()), all.end());
  }
}

// A box with sides through points, or elsewhere.
ExactBox small_box(Random& random, const Snapshot& now) {
  ExactBox box;
  for (const int axis : {0, 1}) {
    const auto side = [&]() -> Rational {
      const auto id = static_cast<ObjectId>(random.between(0, static_cast<int>(now.objects()) - 1));
      if (random.chance(30) || !now.alive(id)) {
        return Rational(Integer(random.between(-20, 20)), Integer(random.between(1, 3)));
      }
      return now.position(id, axis);
    };
    Rational low = side(), high = random.chance(10) ? low : side();
    if (high < low && random.chance(95)) std::swap(low, high);
    box[static_cast<std::size_t>(axis)] = {low, high};
  }
  return box;
}

void search_all_the_time(Scene scene, std::uint64_t seed, int times, int boxes) {
  const Rational end = *scene.end;
  SearchedRun run(std::move(scene), "exact", linear_trees());
  Random random(seed);
  for (int i = 0; i <= times; ++i) {
    run.simulator.run_until(end * Rational(Integer(i), Integer(times)));
    const Snapshot now = run.simulator.snapshot(run.simulator.reached());
    for (int k = 0; k < boxes; ++k) run.expect_right(small_box(random, now));
    if (testing::Test::HasFailure()) return;
  }
  run.expect_bounds();
}

void search_lattices(std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed <= first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int n = 1 + static_cast<int>(seed % 120);
    const int size = 1 + static_cast<int>(seed % 9);
    search_all_the_time(scene_of(small_lines(random, n, size), 0, Rational(6)), seed, 6, 4);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(TrajectoryTree, LatticesAtAnyTime) { search_lattices(1, 60); }
TEST(SlowTrajectoryTree, LatticesAtAnyTime) { search_lattices(61, 500); }

TEST(TrajectoryTree, PlansThatChange) {
  for (std::uint64_t seed = 1; seed <= test::fewer(24u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    search_all_the_time(random_flights(seed, 3 + 2 * static_cast<int>(seed), 2, 1, seed % 2 == 0),
                        seed, 16, 4);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(TrajectoryTree, AuditedRuns) {
  for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RangeRun run(random_flights(seed, 2 + 2 * static_cast<int>(seed), 2, 1, seed % 2 == 0), "exact",
                 AuditLevel::kEvents, linear_trees());
    run.run_until(std::nullopt).expect_clean();
    EXPECT_EQ(run.ledger("trajectory_tree").external, 0u);
    EXPECT_EQ(run.ledger("trajectory_tree").max_live, 0u);
    if (testing::Test::HasFailure()) return;
  }
}

// Points that are special in the dual plane: parallel lines, lines through one point, equal ones.
TEST(TrajectoryTree, SpecialTrajectories) {
  for (const int kind : {0, 1, 2, 3}) {
    SCOPED_TRACE("kind " + std::to_string(kind));
    std::vector<Trajectory> t;
    for (int i = 0; i < 90; ++i) {
      const int a = i * 7 % 31, b = i * 11 % 17;
      if (kind == 0) t.push_back(path({{a, 2}, {b, -1}}));   // one velocity
      if (kind == 1) t.push_back(path({{-a, a}, {-b, b}}));  // all meet at (0, 0) at 1
      if (kind == 2) t.push_back(path({{3, 1}, {i % 2 == 0 ? 1 : 2}}));
      if (kind == 3) t.push_back(path({{a - 15}, {2 * a - 30}}));  // at rest, on a line
    }
    search_all_the_time(scene_of(t, 0, Rational(2)), 5, 8, 12);
  }
}

// All points of the dual plane are on their hull, below in one axis and above in the other: chains of more
// vertices than are compared at once.
TEST(TrajectoryTree, LongHulls) {
  for (const int sign : {1, -1}) {
    std::vector<Trajectory> t;
    for (int i = -100; i < 100; ++i) t.push_back(path({{sign * i * i, i}, {-sign * i * i, i}}));
    search_all_the_time(scene_of(t, -3, Rational(3)), 7, 6, 20);
  }
}

TEST(TrajectoryTree, FewPoints) {
  for (int n = 0; n <= 3; ++n) {
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{i, 1 - i}, {-i, i * i}}));
    Scene scene = scene_of(t, -3, Rational(3));
    scene.dimension = 2;
    SearchedRun run(scene, "exact", linear_trees());
    const ExactBox all{{{Rational(-99), Rational(99)}, {Rational(-99), Rational(99)}}};
    EXPECT_EQ(run.answers(all)[1].size(), static_cast<std::size_t>(n));
    EXPECT_EQ(run.answers(all)[0], run.answers(all)[1]);
  }
}

// A change makes the tree stale, and only a query builds it.
TEST(TrajectoryTree, IsBuiltWhenAsked) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4}, {1}}), path({{2}, {2}})}, 0, Rational(4));
  scene.jumps = true;
  scene.objects[2].motion.pieces[0].to = Rational(1);
  scene.objects[2].motion.pieces.push_back({Rational(1), std::nullopt, path({{9}, {-3}})});
  SearchedRun run(scene, "exact", {linear_trees()[0]});
  const auto& tree = dynamic_cast<const TrajectoryTree&>(run.simulator.structure(0));
  const ExactBox box{{{Rational(3), Rational(9)}, {Rational(-3), Rational(1)}}};
  EXPECT_EQ(tree.builds(), 0u);
  EXPECT_EQ(run.answers(box)[0], std::vector<ObjectId>{1});
  EXPECT_EQ(run.answers(box)[0], std::vector<ObjectId>{1});
  EXPECT_EQ(tree.builds(), 1u);
  run.simulator.run_until(Rational(2));
  EXPECT_EQ(run.answers(box)[0], (std::vector<ObjectId>{1, 2}));
  EXPECT_EQ(tree.builds(), 2u);
}

TEST(TrajectoryTree, HardBoundsOfQueries) {
  // A leaf; two lines through two leaves, and through four.
  constexpr std::uint64_t leaf = ConjugationTrees::kLeaf;
  EXPECT_EQ(ConjugationTrees::most_looked_at(0), 1u);
  EXPECT_EQ(ConjugationTrees::most_looked_at(leaf), 1 + leaf);
  EXPECT_EQ(ConjugationTrees::most_looked_at(leaf + 1), 1 + 2 * (2 + leaf + 1));
  EXPECT_EQ(ConjugationTrees::most_looked_at(2 * leaf), 1 + 2 * (2 + 2 * leaf));
  EXPECT_EQ(ConjugationTrees::most_looked_at(2 * leaf + 1), 1 + 2 * (2 + 2 * (2 + leaf + 1)));
  // n^0.695: four times the points cost less than 2.7 times as much.
  std::uint64_t last = TrajectoryTree::most_looked_at(1 << 20);
  for (int power = 22; power <= 60; power += 2) {
    const std::uint64_t next = ConjugationTrees::most_looked_at(std::uint64_t{1} << power);
    if (power > 22) {
      EXPECT_LT(static_cast<double>(next), 2.7 * static_cast<double>(last));
    }
    last = next;
  }
  EXPECT_GE(TrajectoryTree::most_looked_at(1000), ConjugationTrees::most_looked_at(1000));
}

TEST(TrajectoryTree, NeedsLinearMotion) {
  const Scene scene = scene_of({path({{0, 1, 1}, {0}}), path({{1}, {1}})}, 0, Rational(1));
  const StructureInfo* info = find_structure_info("trajectory_tree");
  ASSERT_NE(info, nullptr);
  const std::optional<Refusal> refusal = refusal_of(*info, scene);
  ASSERT_TRUE(refusal.has_value());
  EXPECT_EQ(refusal->problem, "needs linear motions, the scene has motions of degree 2");
  EXPECT_NE(refusal->remedy.find("rank_kd_tree_2"), std::string::npos) << refusal->remedy;
}

TEST(TrajectoryTree, InexactArithmeticsAnswer) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:24", "mpfr:4", "sturm"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(3u); ++seed) {
      SearchedRun run(random_flights(seed, 20, 2, 1, seed % 2 == 0), arithmetic, linear_trees());
      for (int i = 0; i <= 16; ++i) {
        run.simulator.run_until(Rational(Integer(i), Integer(4)));
        run.answers({{{Rational(-1), Rational(2)}, {Rational(-2), Rational(1)}}});
      }
    }
  }
}

}  // namespace trajectory_tree_test
}  // namespace kinex::test

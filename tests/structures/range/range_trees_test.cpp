// SPDX-License-Identifier: GPL-3.0-or-later
// The trees for range search under motion: exact counts, and audits after every event.
#include "structures/range/pseudo_kd_tree_2.h"
#include "tests/sanitized.h"
#include "tests/structures/range/range_run.h"

namespace kinex::test {
namespace range_trees_test {

const std::vector<std::string> kLabels{"range_tree_2", "rank_kd_tree_2", "median", "pseudo",
                                       "loose"};

TEST(RangeTrees, Remainders) {
  for (const auto& [n, x, y, changes] : {std::array{6, 1, 4, 1}, std::array{8, 4, 13, 5}}) {
   for (const char* arithmetic : {"exact", "sturm"}) {
    RangeRun run(remainders(n), arithmetic);
    run.run_until(std::nullopt).expect_clean();
    const StructureLedger& range = run.ledger("range_tree_2");
    EXPECT_EQ(range.by_kind.at("swap_x"), static_cast<std::uint64_t>(x));
    EXPECT_EQ(range.by_kind.at("swap_y"), static_cast<std::uint64_t>(y));
    EXPECT_EQ(range.external, static_cast<std::uint64_t>(x + y));
    EXPECT_EQ(run.ledger("rank_kd_tree_2").external, static_cast<std::uint64_t>(changes)) << n;
   }
  }
}

// All pairs change places on both axes: j t - (2n)^j in x, and in y by other powers.
Scene steep_plane(int n) {
  std::vector<Trajectory> t;
  Integer p(1), q(3);
  for (int j = 0; j < n; ++j, p = p * Integer(2 * n), q = q * Integer(2 * n + 1)) {
    t.push_back(path({{Rational(-p), Rational(j)}, {Rational(-q), Rational(j)}}));
  }
  return scene_of(t, 0, std::nullopt);
}

TEST(RangeTrees, AllPairsChangePlaces) {
  for (const int n : {2, 3, 5, 8, 17, 24}) {
    RangeRun run(steep_plane(n), "exact", n < 10 ? AuditLevel::kEvents : AuditLevel::kEnd);
    run.run_until(std::nullopt).expect_clean();
    EXPECT_EQ(run.ledger("range_tree_2").external, static_cast<std::uint64_t>(n * (n - 1)));
    EXPECT_EQ(run.ledger("range_tree_2").max_live, 0u);
  }
}

TEST(RangeTrees, RandomFlights) {
  for (std::uint64_t seed = 1; seed <= test::fewer(30u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RangeRun run(random_flights(seed, 2 + static_cast<int>(seed), 2, 1 + static_cast<int>(seed % 3),
                                seed % 2 == 0));
    run.run_until(std::nullopt).expect_clean();
    if (testing::Test::HasFailure()) return;
  }
}

// 3 to 9 points with tiny coordinates and velocities: ties and meetings everywhere. The runs in
// `sturm` are audited, too; they end with the same trees after as many events.
void run_lattices(std::uint64_t first, std::uint64_t last) {
  std::uint64_t changes = 0, settled = 0;
  for (std::uint64_t seed = first; seed <= first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int n = random.between(3, 9), size = random.between(1, 4);
    const int degree = seed % 4 == 0 ? random.between(2, 3) : 1;
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(random.small_path(2, degree, size));
    const Scene scene = scene_of(t, -3, Rational(3));
    RangeRun run(scene), twin(scene, "sturm");
    for (RangeRun* one : {&run, &twin}) one->run_until(std::nullopt).expect_clean();
    for (const std::string& label : kLabels) {
      EXPECT_EQ(run.ids(label), twin.ids(label)) << label;
      EXPECT_EQ(run.ledger(label).external, twin.ledger(label).external) << label;
    }
    changes += run.ledger("range_tree_2").external;
    const auto& kinds = run.ledger("rank_kd_tree_2").by_kind;
    settled += kinds.contains("settled") ? kinds.at("settled") : 0;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(changes, 10 * test::seen_in_fewer(last - first));
  EXPECT_GT(settled, test::seen_in_fewer(last - first));
}

TEST(RangeTrees, RandomLattices) { run_lattices(1, 80); }
TEST(SlowRangeTrees, RandomLattices) { run_lattices(81, 800); }

TEST(RangeTrees, BuiltAnew) {
  for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
    Scene scene = random_flights(seed, 9, 2, 2, seed % 2 == 0);
    scene.maintain = all_trees();
    Simulator simulator(scene, planned_arithmetic("exact", scene),
                        RangeRun::options(AuditLevel::kEvents));
    EventReplay replay(simulator);
    replay.rebuild_at_random(seed, 3);
    replay.add_structures(scene);
    simulator.set_sink(&replay);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{}) << seed;
    EXPECT_GT(replay.counts["rebuild"], 0u);
  }
}

TEST(RangeTrees, FewPoints) {
  for (int n = 0; n <= 3; ++n) {
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{i, 1 - i}, {-i, i * i}}));
    Scene scene = scene_of(t, -3, Rational(3));
    scene.dimension = 2;
    RangeRun run(scene);
    run.run_until(std::nullopt).expect_clean();
    EXPECT_EQ(run.ids("rank_kd_tree_2").size(), static_cast<std::size_t>(n));
    EXPECT_EQ(run.ids("range_tree_2").size(), static_cast<std::size_t>(2 * n));
  }
}

TEST(RangeTrees, EqualPointsAreInTheOrderOfTheirIds) {
  std::vector<Trajectory> t(7, path({{1, 1}, {2, -1}}));
  t[3] = path({{0}, {9}});
  RangeRun run(scene_of(t, 0, Rational(9)));
  run.run_until(std::nullopt).expect_clean();
  const std::vector<ObjectId> by_x{3, 0, 1, 2, 4, 5, 6}, by_y{0, 1, 2, 4, 5, 6, 3};
  std::vector<ObjectId> both = by_x;
  both.insert(both.end(), by_y.begin(), by_y.end());
  EXPECT_EQ(run.ids("range_tree_2"), both);
}

// All orders are reversed at one instant, on both axes.
TEST(RangeTrees, AnInstantIsOneChangeOfAKdTree) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 16; ++i) t.push_back(path({{0, (i * 7) % 16}, {0, (i * 5) % 16}}));
  RangeRun run(scene_of(t, -1, Rational(1)));
  run.run_until(std::nullopt).expect_clean();
  EXPECT_EQ(run.ledger("range_tree_2").external, 240u);
  for (const std::string& label : {kLabels[1], kLabels[2], kLabels[3]}) {
    EXPECT_EQ(run.ledger(label).external, 1u) << label;
    EXPECT_EQ(run.ledger(label).by_kind.at("settled"), 1u) << label;
  }
}

// Points that appear one after another at one end of the order, and disappear again: labels are
// spread, doubled and made fewer.
TEST(RangeTrees, ComingAndGoing) {
  Scene scene = scene_of({path({{0}, {0}})}, 0, Rational(200));
  for (int i = 1; i < 70; ++i) {
    SceneObject object = moving(name_of(static_cast<std::size_t>(i)), path({{-i}, {i % 7, 0}}));
    object.motion.pieces[0].from = Rational(i);
    object.motion.pieces[0].to = Rational(i % 3 == 0 ? 200 : 190 - i);
    scene.objects.push_back(std::move(object));
  }
  RangeRun run(scene);
  run.run_until(Rational(80));
  EXPECT_EQ(run.ids("rank_kd_tree_2").size(), 70u);
  run.run_until(std::nullopt).expect_clean();
  EXPECT_EQ(run.ids("rank_kd_tree_2").size(), run.ids("median").size());
}

TEST(RangeTrees, JumpsAreErasuresAndInsertions) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4}, {1}}), path({{2}, {2}})}, 0, Rational(4));
  scene.jumps = true;
  scene.objects[2].motion.pieces[0].to = Rational(1);
  scene.objects[2].motion.pieces.push_back({Rational(1), std::nullopt, path({{9}, {-3}})});
  RangeRun run(scene);
  run.run_until(std::nullopt).expect_clean();
  EXPECT_EQ(run.ids("range_tree_2"), (std::vector<ObjectId>{0, 1, 2, 2, 0, 1}));
  EXPECT_EQ(run.ledger("range_tree_2").external, 0u);
}

// Exact medians are rebuilt all the time, loose ones seldom.
TEST(RangeTrees, DeltaSavesRebuilding) {
  std::vector<std::uint64_t> rebuilt;
  for (const int quarter : {0, 1}) {
    std::vector<Trajectory> t;
    for (int i = 0; i < 150; ++i) {
      t.push_back(path({{i * 7 % 151, i * 13 % 31 - 15}, {i * 11 % 149, i * 5 % 37 - 18}}));
    }
    Scene scene = scene_of(t, 0, Rational(12));
    scene.maintain = {
        {"pseudo_kd_tree_2", "tree", {}, {}, {{"delta", Rational(Integer(quarter), Integer(4))}}}};
    Simulator simulator(scene, planned_arithmetic("exact", scene), {});
    add_structures(simulator, scene);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    rebuilt.push_back(dynamic_cast<const PseudoKdTree2&>(simulator.structure(2)).points_rebuilt());
  }
  EXPECT_GT(rebuilt[0], 2 * rebuilt[1]);
  EXPECT_GT(rebuilt[0], 100u);
}

}  // namespace range_trees_test
}  // namespace kinex::test

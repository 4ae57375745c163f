// SPDX-License-Identifier: GPL-3.0-or-later
// ChangingExtremum, by a structure whose set of pairs changes at every failure: audited by brute
// force after every instant.
#include "structures/parts/changing_extremum.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "tests/sanitized.h"
#include "tests/structures/parts/shifting_pairs.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace changing_extremum_test {

struct Shift {
  Shift(Scene given, const std::string& arithmetic, std::uint64_t seed, int shift)
      : scene(std::move(given)),
        simulator(scene, make_arithmetic(arithmetic, scene), Trial::options(AuditLevel::kEvents)),
        sink(simulator) {
    const StructureId id = simulator.reserve();
    auto made =
        std::make_unique<ShiftingPairs>(simulator.kernel(), id, scene.dimension, seed, shift);
    structure = made.get();
    simulator.add(id, std::move(made), "shifting_pairs");
    simulator.set_sink(&sink);
    simulator.start();
    simulator.run_until(std::nullopt);
    if (arithmetic == "double") return;
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    EXPECT_EQ(simulator.ledger(0).rebuilds, 0u);
    for (const BoundCheck& bound : simulator.bounds(0)) {
      EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                               << bound.bound.to_string();
    }
  }
  Scene scene;
  Simulator simulator;
  LogSink sink;
  const ShiftingPairs* structure;
};

TEST(ChangingExtremum, IsRightThroughFlightPlansAndTies) {
  std::uint64_t failures = 0, ties = 0;
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const int degree : {1, 2}) {
      for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
        SCOPED_TRACE(std::to_string(dimension) + " axes, degree " + std::to_string(degree) +
                     ", seed " + std::to_string(seed));
        const Scene scene = random_flights(seed, 9, dimension, degree, seed % 2 == 0);
        const Shift run(scene, "exact", seed, 1 + static_cast<int>(seed % 3));
        const StructureLedger& ledger = run.simulator.ledger(0);
        failures += ledger.failures;
        const auto tied = ledger.by_kind.find("tie");
        if (tied != ledger.by_kind.end()) ties += tied->second;
        EXPECT_EQ(run.structure->line().failures, ledger.failures);
        EXPECT_EQ(run.structure->line().created, ledger.certificates_created);
        EXPECT_EQ(run.structure->line().retracted, ledger.certificates_retracted);
      }
    }
  }
  EXPECT_GT(failures, test::seen_in_fewer(100u));
  EXPECT_GT(ties, 0u);
}

// Also as many numbers, in the same order: nothing depends on addresses or on the arithmetic.
TEST(ChangingExtremum, RepeatsItself) {
  const Scene scene = random_flights(3, 12, 2, 2, true);
  const Shift first(scene, "exact", 5, 2), again(scene, "exact", 5, 2), other(scene, "sturm", 5, 2);
  EXPECT_GT(first.sink.lines.size(), 25u);
  EXPECT_EQ(first.sink.lines, again.sink.lines);
  EXPECT_EQ(first.sink.lines, other.sink.lines);
}

TEST(ChangingExtremum, EndsInAnInexactArithmetic) {
  for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
    const Shift run(random_flights(seed, 9, 2, 2, true), "double", seed, 2);
    EXPECT_GT(run.structure->toggles(), 0u);
  }
}

// Points at rest: an owner that only changes its set.
class Resting {
 public:
  explicit Resting(int n)
      : scene_(points(n)),
        simulator_(scene_, make_arithmetic("exact", scene_), {}),
        id_(simulator_.reserve()),
        pairs_(simulator_.kernel(), id_, "pairs", PairDistances(simulator_.kernel(), 1)) {}
  // One point after another, farther and farther apart: pair (i, i + 1) has length i + 1.
  static Scene points(int n) {
    std::vector<Trajectory> t;
    for (int i = 0, x = 0; i < n; x += ++i) t.push_back(path({{Rational(x)}}));
    return scene_of(t, 0, Rational(1));
  }
  static auto tied() {
    return [](const auto&, const auto&) { FAIL() << "no two pairs are tied"; };
  }

  Scene scene_;
  Simulator simulator_;
  StructureId id_;
  ChangingExtremum<PairDistances> pairs_;
};

TEST(ChangingExtremum, AnExchangeRenewsOnePath) {
  Resting rest(66);
  auto& pairs = rest.pairs_;
  for (ObjectId i = 1; i < 65; ++i) EXPECT_TRUE(pairs.come({i, i + 1}));
  EXPECT_EQ(pairs.front(), nullptr);
  pairs.apply(Resting::tied());
  ASSERT_NE(pairs.front(), nullptr);
  EXPECT_EQ(*pairs.front(), (PairDistances::Value{1, 2}));
  EXPECT_EQ(pairs.slots().line().live, 63u);
  for (ObjectId i = 1; i < 64; ++i) {
    const std::uint64_t before = pairs.slots().line().created;
    EXPECT_TRUE(pairs.go({i, i + 1}));
    EXPECT_TRUE(pairs.come({i - 1, i + 1}));
    pairs.apply(Resting::tied());
    EXPECT_LE(pairs.slots().line().created - before, 6u);  // 64 leaves
    EXPECT_TRUE(pairs.go({i - 1, i + 1}));
    pairs.apply(Resting::tied());
    ASSERT_NE(pairs.front(), nullptr);
    EXPECT_EQ(*pairs.front(), (PairDistances::Value{i + 1, i + 2}));
    EXPECT_EQ(pairs.slots().line().live, 63u - i);
  }
}

TEST(ChangingExtremum, WhatGoesAndComesBackCostsNothing) {
  Resting rest(20);
  auto& pairs = rest.pairs_;
  for (ObjectId i = 0; i < 19; ++i) pairs.come({i, i + 1});
  EXPECT_FALSE(pairs.come({3, 4}));
  EXPECT_FALSE(pairs.go({3, 5}));
  pairs.apply(Resting::tied());
  const std::uint64_t created = pairs.slots().line().created;
  EXPECT_EQ(created, 18u);
  EXPECT_TRUE(pairs.go({3, 4}));
  EXPECT_FALSE(pairs.has({3, 4}));
  EXPECT_TRUE(pairs.come({3, 5}));
  EXPECT_TRUE(pairs.come({3, 4}));
  EXPECT_TRUE(pairs.go({3, 5}));
  pairs.apply(Resting::tied());
  EXPECT_EQ(pairs.slots().line().created, created);
  EXPECT_EQ(pairs.slots().line().retracted, 0u);
  EXPECT_TRUE(pairs.has({3, 4}));
  // As a whole: the same set, but two go and one comes.
  std::vector<PairDistances::Value> values = pairs.values();
  values.erase(values.begin());
  values.back() = {17, 19};
  pairs.assign(values);
  EXPECT_EQ(pairs.values(), values);
  pairs.apply(Resting::tied());
  ASSERT_NE(pairs.front(), nullptr);
  EXPECT_EQ(*pairs.front(), (PairDistances::Value{1, 2}));
  EXPECT_EQ(pairs.slots().line().live, values.size() - 1);
  AuditReport report;
  pairs.check(report, "pairs");
  EXPECT_EQ(report.violations, std::vector<std::string>{});
}

TEST(ChangingExtremum, EmptiesAndFillsAgain) {
  Resting rest(6);
  auto& pairs = rest.pairs_;
  for (int round = 0; round < 3; ++round) {
    for (ObjectId i = 0; i < 5; ++i) pairs.come({i, i + 1});
    pairs.apply(Resting::tied());
    EXPECT_EQ(*pairs.front(), (PairDistances::Value{0, 1}));
    pairs.assign({});
    pairs.apply(Resting::tied());
    EXPECT_EQ(pairs.front(), nullptr);
    EXPECT_EQ(pairs.slots().line().live, 0u);
  }
}

}  // namespace changing_extremum_test
}  // namespace kinex::test

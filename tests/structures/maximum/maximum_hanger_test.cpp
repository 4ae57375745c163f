// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_hanger.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace maximum_hanger_test {

// q(k): the probability that two neighbours of the order with k objects above are parent and child.
std::vector<double> parent_and_child(std::size_t n) {
  std::vector<double> q{1.0};
  for (std::size_t k = 1; k < n; ++k) {
    double sum = 0, binomial = std::exp2(-static_cast<double>(k));  // C(k-1, j) / 2^k
    for (std::size_t j = 0; j < k; ++j) {
      sum += binomial * q[j];
      binomial = binomial * static_cast<double>(k - 1 - j) / static_cast<double>(j + 1);
    }
    q.push_back(sum);
  }
  return q;
}

// The sum of q over all crossings of lines in the scene's time, from their coefficients.
double expected_events(const Scene& scene) {
  const std::vector<double> q = parent_and_child(scene.objects.size());
  const auto line = [&](std::size_t i) -> const Trajectory& {
    return scene.objects[i].motion.pieces[0].trajectory;
  };
  double sum = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational gap = line(i).position(0, 0) - line(j).position(0, 0);
      const Rational closing = line(i).position(0, 1) - line(j).position(0, 1) - gap;
      if (closing.is_zero()) continue;
      const Rational t = -gap / closing;
      if (!(scene.start < t && t < *scene.end)) continue;
      const Rational height = line(i).position(0, t);
      std::size_t above = 0;
      for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        if (k != i && k != j && height < line(k).position(0, t)) ++above;
      }
      sum += q[above];
    }
  }
  return sum;
}

Scene random_lines(std::uint64_t seed, int n) {
  Random random(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    const int a = random.between(0, 1 << 20), b = random.between(0, 1 << 20);
    t.push_back(path({{a, b - a}}));
  }
  return scene_of(t, 0, Rational(1));
}

struct Hanging {
  Hanging(const Scene& scene, std::uint64_t seed)
      : simulator(scene, make_arithmetic("exact", scene)) {
    const StructureId id = simulator.reserve();
    auto made = std::make_unique<MaximumHanger>(simulator.kernel(), id, Key{}, scene,
                                                Extremum::kMaximum, seed);
    hanger = made.get();
    simulator.add(id, std::move(made), "hanger");
    simulator.start();
  }
  Simulator simulator;
  const MaximumHanger* hanger = nullptr;
};

TEST(MaximumHanger, ChancesAreThoseOfSmallTrees) {
  const std::vector<double> q = parent_and_child(40);
  EXPECT_DOUBLE_EQ(q[1], 0.5);    // both to the same side of one object
  EXPECT_DOUBLE_EQ(q[2], 0.375);  // 1/4 beside the second object, 1/8 below it
  for (std::size_t k = 1; k < 40; ++k) {
    EXPECT_GT(q[k] * static_cast<double>(k + 1), 0.5) << k;
    EXPECT_LT(q[k] * static_cast<double>(k + 1), 1.5) << k;
  }
}

// The number of events has the expectation that the header states: over many seeds of the coins,
// and so, too, over scenes of exchangeable objects and the fixed seed.
TEST(MaximumHanger, EventsHaveTheStatedExpectation) {
  const int trials = kSanitized ? 60 : 400;
  for (const bool same_scene : {true, false}) {
    double sum = 0, squares = 0;
    const Scene fixed = random_lines(3, 24);
    const double expected_fixed = expected_events(fixed);
    EXPECT_GT(expected_fixed, 10);
    for (int trial = 1; trial <= trials; ++trial) {
      const auto seed = static_cast<std::uint64_t>(trial);
      const Scene scene = same_scene ? fixed : random_lines(1000 + seed, 24);
      Hanging run(scene, seed);
      run.simulator.run_until({});
      const double off = static_cast<double>(run.simulator.ledger(0).processed) -
                         (same_scene ? expected_fixed : expected_events(scene));
      sum += off;
      squares += off * off;
    }
    const double mean = sum / trials;
    const double error = std::sqrt((squares / trials - mean * mean) / (trials - 1));
    EXPECT_LT(std::fabs(mean), 4 * error) << "same scene: " << same_scene;
    EXPECT_LT(error, 0.1 * expected_fixed);
  }
}

// Insertions and erasures, and events before them, leave a tree that is as random as a new one.
TEST(MaximumHanger, ChangesKeepTheDistribution) {
  const int trials = kSanitized ? 60 : 400;
  double sum = 0, squares = 0;
  for (int trial = 1; trial <= trials; ++trial) {
    const auto seed = static_cast<std::uint64_t>(trial);
    Scene scene = random_lines(2000 + seed, 24);
    scene.end = Rational(2);
    Hanging run(scene, seed);
    // The first third is there from the start, the second one comes back, the last one goes.
    for (ObjectId i = 8; i < 16; ++i) {
      run.simulator.schedule_erasure(Rational(Integer(1), Integer(3)), i);
      run.simulator.schedule_insertion(Rational(Integer(2), Integer(3)), i,
                                       scene.objects[i].motion.pieces[0].trajectory);
    }
    for (ObjectId i = 16; i < 24; ++i) run.simulator.schedule_erasure(Rational(1), i);
    run.simulator.run_until(Rational(1));
    const double before = static_cast<double>(run.simulator.ledger(0).processed);
    Scene rest = scene;
    rest.start = Rational(1);
    rest.objects.resize(16);
    run.simulator.run_until({});
    const double off = static_cast<double>(run.simulator.ledger(0).processed) - before -
                       expected_events(rest);
    sum += off;
    squares += off * off;
  }
  const double mean = sum / trials;
  const double error = std::sqrt((squares / trials - mean * mean) / (trials - 1));
  EXPECT_LT(std::fabs(mean), 4 * error);
}

TEST(MaximumHanger, TheTreeIsShallow) {
  const Scene scene = random_lines(1, 4000);
  Hanging run(scene, MaximumHanger::kSeed);
  EXPECT_LE(run.hanger->depth(),
            30u);  // expected about log2 n + O(sqrt(log n)) on the longest path
  EXPECT_GE(run.hanger->depth(), 12u);
}

TEST(MaximumHanger, SameInputSameTree) {
  const Scene scene = random_flights(4, 12, 1, 2, true);
  Trial a(scene, "maximum_hanger"), b(scene, "maximum_hanger");
  a.to_end().expect_clean();
  b.to_end().expect_clean();
  EXPECT_EQ(a.sink.lines, b.sink.lines);
  // Other coins, other trees: the internal events differ for some seed.
  const Scene lines = random_lines(9, 64);
  std::set<std::uint64_t> counts;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Hanging run(lines, seed);
    run.simulator.run_until({});
    counts.insert(run.simulator.ledger(0).internal);
  }
  EXPECT_GT(counts.size(), 1u);
}

}  // namespace maximum_hanger_test
}  // namespace kinex::test

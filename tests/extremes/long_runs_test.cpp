// SPDX-License-Identifier: GPL-3.0-or-later
// Long runs: millions of events in one simulation, and very many flight-plan updates of one object:
// no drift (audits against positions at the end), no leak (bytes after a tenth of the run and at
// its end), no growing cost (of exact work, by the ledger).
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/scene_run.h"
#include "tests/extremes/crowds.h"
#include "tests/extremes/extreme.h"
#include "tests/extremes/verdict.h"
#include "tests/structures/test_scenes.h"

namespace kinex::extremes {
namespace long_runs_test {

using test::path;
using test::Random;

// n objects that cross a line of 2^30 places at constant speeds in t = 0 .. 1.
Scene crossing(int n) {
  Random random(21);
  std::vector<Trajectory> paths;
  for (int i = 0; i < n; ++i) {
    const int from = random.between(0, 1 << 30), to = random.between(0, 1 << 30);
    paths.push_back(path({{from, to - from}}));
  }
  Scene scene = test::scene_of(paths, 0, Rational(1));
  scene.maintain.push_back({"sorted_list", "sorted_list", {}});
  return scene;
}

// Pairs that stand in one order at the start and in the other at the end.
std::uint64_t inversions(const Scene& scene) {
  std::vector<std::pair<Rational, Rational>> ends;
  for (const SceneObject& object : scene.objects) {
    const Trajectory& t = object.motion.pieces[0].trajectory;
    ends.emplace_back(t.position(0, 0), t.position(0, 1));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Rational> later;
  for (const auto& end : ends) later.push_back(end.second);
  std::vector<Rational> ranks = later;
  std::sort(ranks.begin(), ranks.end());
  std::vector<std::uint64_t> tree(ranks.size() + 1, 0);  // how many have a rank up to i, by Fenwick
  std::uint64_t sum = 0;
  for (std::size_t i = later.size(); i-- > 0;) {
    const auto place = std::lower_bound(ranks.begin(), ranks.end(), later[i]) - ranks.begin();
    for (auto k = static_cast<std::size_t>(place); k > 0; k -= k & (~k + 1)) sum += tree[k];
    for (auto k = static_cast<std::size_t>(place) + 1; k < tree.size(); k += k & (~k + 1))
      ++tree[k];
  }
  return sum;
}

std::uint64_t total(const StageCounts& counts) {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts) sum += count;
  return sum;
}

std::uint64_t bytes(const Simulator& s) {
  return s.bytes() + s.arithmetic().bytes() + s.structure(0).bytes();
}

struct Cost {
  std::uint64_t events = 0, comparisons = 0, refinements = 0, exact = 0;
};

Cost cost_of(const Simulator& s) {
  const ArithmeticCounters& counters = s.arithmetic().counters();
  return {s.ledger().events, total(counters.comparisons), counters.refinements,
          counters.roots_made_exact};
}

void expect_steady_run(const Scene& scene, std::uint64_t expected) {
  const auto s = lab::make_simulator(scene, "exact", {});
  s->start();
  Cost before;
  std::vector<Cost> tenths;
  std::uint64_t early = 0;
  for (int k = 1; k <= 10; ++k) {
    ASSERT_EQ(s->run_until(Rational(Integer(k), Integer(10))), RunStatus::kDone);
    const Cost now = cost_of(*s);
    tenths.push_back({now.events - before.events, now.comparisons - before.comparisons,
                      now.refinements - before.refinements, now.exact - before.exact});
    before = now;
    if (k == 2) early = bytes(*s);
  }
  EXPECT_EQ(s->ledger().events, expected);
  EXPECT_EQ(s->ledger(0).external, expected);
  EXPECT_EQ(s->violations(), std::vector<std::string>{});
  EXPECT_GT(s->ledger(0).audit_checks, 0u);
  EXPECT_LE(bytes(*s), early + early / 4);
  // What an event costs in exact work, in the second tenth and in the ninth.
  const Cost &a = tenths[1], &b = tenths[8];
  EXPECT_LE(b.comparisons * a.events, (2 * a.comparisons + a.events / 100 + 10) * b.events);
  EXPECT_LE(b.refinements * a.events, (2 * a.refinements + a.events / 100 + 10) * b.events);
  EXPECT_LE(b.exact * a.events, (2 * a.exact + a.events / 100 + 10) * b.events);
}

TEST(LongRun, AMillionSwaps) {
  const Scene scene = crossing(2000);
  const std::uint64_t expected = inversions(scene);
  EXPECT_GT(expected, 950000u);
  expect_steady_run(scene, expected);
}

TEST(SlowLongRun, TenMillionSwaps) {
  const Scene scene = crossing(6400);
  const std::uint64_t expected = inversions(scene);
  EXPECT_GT(expected, 10000000u);
  expect_steady_run(scene, expected);
}

// Two rings of m points each that turn against each other: m^2 / 2 flips; see make.py.
void expect_flips(int half) {
  Scene scene = make_crowd("counter-rotating-rings n=" + std::to_string(2 * half));
  const auto h = static_cast<std::uint64_t>(half);
  expect_steady_run(scene, h * h / 2);
}

TEST(SlowLongRun, FlipsOfTwoRings) { expect_flips(400); }

// ---- one object with very many flight plans

// It moves to and fro between 0 and 8 past an object at rest at 1/3; every 1/16 it gets a velocity
// of -3 .. 3, in sixteenths of dyadic places. `from_outside`: updates are scheduled as the run
// goes.
void expect_bounded(int updates, bool from_outside) {
  Random random(31);
  Scene scene = test::scene_of({path({{Rational(Integer(1), Integer(3))}}), path({{4}})}, 0,
                               Rational(Integer(updates), Integer(16)));
  scene.maintain.push_back({"sorted_list", "sorted_list", {}});
  std::vector<MotionPiece> pieces;
  std::uint64_t crossings = 0;
  Rational place(4);
  const Rational rest(Integer(1), Integer(3)), tick(Integer(1), Integer(16));
  for (int k = 0; k < updates; ++k) {
    int v = random.between(-3, 3);
    if (place < Rational(-2)) v = 3;
    if (Rational(2) < place) v = -3;
    const Rational from = Rational(k) * tick, to = from + tick;
    pieces.push_back({from, to, path({{place - Rational(v) * from, v}})});
    const Rational next = place + Rational(v) * tick;
    if ((place < rest) != (next < rest)) ++crossings;  // never at 1/3: places are dyadic
    place = next;
  }
  const std::vector<MotionPiece> given = pieces;
  if (!from_outside) scene.objects[1].motion.pieces = std::move(pieces);
  const auto s = lab::make_simulator(scene, "exact", {});
  s->start();
  std::uint64_t early = 0, early_bits = 0;
  for (int k = 1; k <= updates; ++k) {
    const Rational now = Rational(k) * tick;
    if (from_outside && k == 1) s->schedule_update(0, 1, given[0].trajectory);
    ASSERT_EQ(s->run_until(now), RunStatus::kDone);
    if (from_outside && k < updates) {
      s->schedule_update(now, 1, given[static_cast<std::size_t>(k)].trajectory);
    }
    if (k == updates / 10) {
      early = bytes(*s);
      early_bits = s->arithmetic().counters().max_bits;
    }
  }
  EXPECT_EQ(s->ledger(0).external, crossings);
  EXPECT_GT(crossings, static_cast<std::uint64_t>(updates) / 100);
  EXPECT_GE(s->ledger(0).motion_updates, static_cast<std::uint64_t>(updates) - 1);
  EXPECT_EQ(s->violations(), std::vector<std::string>{});
  EXPECT_LE(bytes(*s), early + early / 4);
  // Times grow by log2(10) bits between a tenth of the run and its end.
  EXPECT_LE(s->arithmetic().counters().max_bits, early_bits + 8);
  EXPECT_LE(s->arithmetic().counters().max_bits, 64u);
}

TEST(LongRun, AHundredThousandPlannedUpdatesOfOneObject) { expect_bounded(100000, false); }
TEST(LongRun, AHundredThousandUpdatesFromOutside) { expect_bounded(100000, true); }

// The large crowds are not on the page of verdicts. Runs in doubles end there; those in mpfr take more
// than minutes, and their verdict is not known.
TEST(SlowExtremes, LargeCrowdsEnd) {
  for (const Extreme& extreme : read_extremes()) {
    if (extreme.crowd.empty()) continue;
    const Scene scene = extreme.scene();
    if (extreme.page && scene.objects.size() <= kMostPageObjects) continue;
    const LoggedRun exact = run_logged(scene, "exact", 0);
    for (const char* arithmetic : {"double", "gsl"}) {
      EXPECT_NE(judge(scene, exact, arithmetic), RunVerdict::kEndless)
          << extreme.name << " in " << arithmetic;
    }
  }
}

}  // namespace long_runs_test
}  // namespace kinex::extremes

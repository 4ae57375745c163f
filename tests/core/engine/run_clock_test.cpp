// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/run_clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/engine/simulator.h"

#include "tests/core/engine/plain_list.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace run_clock_test {

double cpu() { return seconds_now().cpu; }

void burn(double seconds) {
  const double begin = cpu();
  while (cpu() - begin < seconds) {
  }
}

// A list of n points that all pass each other: n (n - 1) / 2 events.
Scene crossing(int n) {
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) motions.push_back(path({{i, 2 * (n - i)}}));
  return scene_of(motions, 0, Rational(2));
}

template <class Work>
struct Sink final : EventSink {
  explicit Sink(Work w) : work(std::move(w)) {}
  void event(const Event&, Arithmetic&) override { work(); }
  Work work;
};

struct ClockedRun {
  explicit ClockedRun(const Scene& scene) : simulator(scene, make_arithmetic("exact", scene)) {
    simulator.add(0, std::make_unique<PlainList>(simulator.kernel(), simulator.reserve()), "list");
  }
  template <class Work>
  void with(Work work) {
    Sink<Work> sink(std::move(work));
    simulator.set_sink(&sink);
    simulator.start();
    simulator.run_until(std::nullopt);
    simulator.set_sink(nullptr);
  }
  Simulator simulator;
};

TEST(RunClock, WhatTheSinkTakesIsChargedApart) {
  const Scene scene = crossing(10);
  ClockedRun run(scene);
  double burnt = 0;
  run.with([&] {
    const double begin = cpu();
    burn(1e-3);
    burnt += cpu() - begin;
  });
  EXPECT_GE(burnt, 45e-3);
  EXPECT_GT(run.simulator.seconds_report(), 0.9 * burnt);
  EXPECT_LT(run.simulator.seconds_report(), 1.1 * burnt);
  EXPECT_LT(run.simulator.seconds_simulate(), 0.5 * burnt);
  EXPECT_LT(run.simulator.ledger(0).seconds, 0.5 * burnt);
}

TEST(RunClock, WaitingIsWallTimeOnly) {
  const Scene scene = crossing(10);
  ClockedRun run(scene);
  run.with([] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); });
  EXPECT_GE(run.simulator.seconds(RunPhase::kReport).wall, 90e-3);
  EXPECT_LT(run.simulator.seconds_report(), 45e-3);
  EXPECT_LT(run.simulator.seconds_simulate(), 45e-3);
}

TEST(RunClock, WithoutASinkNothingIsReported) {
  const Scene scene = crossing(10);
  ClockedRun run(scene);
  run.simulator.start();
  run.simulator.run_until(std::nullopt);
  EXPECT_EQ(run.simulator.seconds_report(), 0.0);
  EXPECT_GT(run.simulator.seconds_setup(), 0.0);
  EXPECT_GT(run.simulator.seconds_simulate(), 0.0);
  EXPECT_GT(run.simulator.seconds_audit(), 0.0);
  EXPECT_GT(run.simulator.ledger(0).seconds, 0.0);
  const double all = run.simulator.seconds_setup() + run.simulator.seconds_simulate();
  EXPECT_LE(run.simulator.ledger(0).seconds, all);
}

// Short calls are sampled: their sum is estimated, even if their cost is periodic.
// Other programs take the processor away at any time, which only ever spoils a measurement: one
// attempt of five has to succeed.
TEST(RunClock, ShortCallsAreSampled) {
  for (const int rhythm : {1, 2, 7, 16}) {
    const auto steps = [rhythm](int i) { return i % rhythm == 0 ? 8000 : 500; };
    const auto burn = [](int count) {
      volatile double sink = 1;
      for (int k = 0; k < count; ++k) sink = sink * 1.0000001;
    };
    double reported = 0, simulated = 0, burnt = 0;
    const auto as_measured = [&] {
      return reported > 0.5 * burnt && reported < 2.0 * burnt && simulated < burnt;
    };
    for (int attempt = 0; attempt < 5 && !as_measured(); ++attempt) {
      RunClock clock;
      {
        const RunClock::Scope scope(clock, RunPhase::kSimulate);
        for (int i = 0; i < 8000; ++i) clock.report([&] { burn(steps(i)); });
      }
      const double begin = cpu();
      for (int i = 0; i < 8000; ++i) burn(steps(i));
      burnt = cpu() - begin;
      reported = clock.seconds(RunPhase::kReport).cpu;
      simulated = clock.seconds(RunPhase::kSimulate).cpu;
    }
    EXPECT_TRUE(as_measured()) << "rhythm " << rhythm << ": " << reported << " s reported and "
                               << simulated << " s simulated of " << burnt << " s";
  }
}

// CPU time is divided among the structures as the wall time of each stretch.
TEST(RunClock, StructuresShareAStretch) {
  RunClock clock;
  const double begin = cpu();
  for (int i = 0; i < 20; ++i) {
    clock.charge(0);
    burn(1e-3);
    clock.charge(3);
    burn(3e-3);
    if (i % 5 == 4) clock.charge(RunClock::kNoStructure);
    if (i % 5 == 4) burn(2e-3);
  }
  const double all = cpu() - begin;
  EXPECT_EQ(clock.structure_seconds(1), 0.0);
  EXPECT_EQ(clock.structure_seconds(9), 0.0);
  const double sum = clock.structure_seconds(0) + clock.structure_seconds(3);
  EXPECT_GT(sum, 0.8 * (all - 8e-3));
  EXPECT_LT(sum, all - 8e-3 + 4e-3);
  EXPECT_GT(clock.structure_seconds(3), clock.structure_seconds(0));
}

TEST(RunClock, PhasesNest) {
  RunClock clock;
  {
    const RunClock::Scope run(clock, RunPhase::kSimulate);
    burn(2e-3);
    {
      const RunClock::Scope audit(clock, RunPhase::kAudit);
      burn(5e-3);
    }
    burn(2e-3);
    EXPECT_GE(clock.seconds(RunPhase::kSimulate).cpu, 4e-3);  // so far
  }
  burn(5e-3);
  EXPECT_GE(clock.seconds(RunPhase::kAudit).cpu, 5e-3);
  EXPECT_GE(clock.seconds(RunPhase::kSimulate).cpu, 4e-3);
  EXPECT_LT(clock.seconds(RunPhase::kSimulate).cpu, 8e-3);
  EXPECT_LT(clock.seconds(RunPhase::kSetup).cpu, 1e-3);
}

}  // namespace run_clock_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are stopped: between two instants, within one, and during set-up.
#include "core/numbers/stop.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/rational_sturm.h"
#include "core/numbers/real_root.h"
#include "tests/core/engine/plain_list.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace stop_test {

// Waits until the grace of a deadline is over.
void work_until_stopped(Deadline& deadline) {
  for (;;) deadline.look();
}

TEST(Deadline, NeverStopsUnlessItIsToldTo) {
  Deadline never;
  EXPECT_FALSE(never.running());
  EXPECT_FALSE(never.due());
  never.look();
  Deadline far(1e6, nullptr);
  EXPECT_TRUE(far.running());
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(far.due());
  far.look();
}

TEST(Deadline, AsksFirstAndThrowsLater) {
  Deadline deadline(1e-9, nullptr);
  deadline.look();  // in its grace
  EXPECT_TRUE(deadline.due());
  EXPECT_FALSE(deadline.interrupted());
  EXPECT_THROW(work_until_stopped(deadline), Stopped);
  EXPECT_THROW(
      for (;;) deadline.poll(), Stopped);
}

TEST(Deadline, IsInterruptedByTheFlag) {
  std::atomic<bool> flag = false;
  Deadline deadline(0, &flag);
  deadline.look();
  EXPECT_FALSE(deadline.due());
  flag = true;
  deadline.look();
  EXPECT_TRUE(deadline.due());
  EXPECT_TRUE(deadline.interrupted());
  EXPECT_THROW(work_until_stopped(deadline), Stopped);
}

TEST(Deadline, DoesNotStopWhatItIsPausedFor) {
  Deadline deadline(1e-9, nullptr);
  EXPECT_THROW(work_until_stopped(deadline), Stopped);
  deadline.pause();
  deadline.look();
  EXPECT_FALSE(deadline.due());
  deadline.resume();
  EXPECT_THROW(deadline.look(), Stopped);
}

// Long computations of the exact arithmetics poll it themselves.
TEST(Deadline, IsLookedAtByIsolationGcdsAndSturmSequences) {
  std::atomic<bool> flag = true;
  Deadline deadline(0, &flag);
  EXPECT_THROW(work_until_stopped(deadline), Stopped);
  const Polynomial p({Integer(-7), Integer(3), Integer(-5), Integer(1)});
  RootCounters counters;
  const auto roots = isolate_real_roots(p, counters);
  counters.deadline = &deadline;
  EXPECT_THROW(isolate_real_roots(p, counters), Stopped);
  RealRoot root = roots.at(0).root;
  EXPECT_THROW(root.refine(counters), Stopped);
  EXPECT_THROW(gcd(p, p.derivative(), &deadline), Stopped);
  SturmWork work;
  work.deadline = &deadline;
  const RationalPolynomial q({Rational(-7), Rational(3), Rational(-5), Rational(1)});
  EXPECT_THROW(RationalSturm(q, work), Stopped);
}

// ---- runs

// Crosses all others, one after another.
Scene crossing() {
  std::vector<Trajectory> objects{path({{0, 1}})};
  for (int i = 1; i <= 6; ++i) objects.push_back(path({{i}}));
  return scene_of(std::move(objects), 0, Rational(10));
}

enum class Trouble { kNone, kLong, kMemory };

// Fails at the event of this number.
class TroubledSink final : public EventSink {
 public:
  TroubledSink(Deadline& deadline, int number, Trouble trouble)
      : deadline_(deadline), number_(number), trouble_(trouble) {}
  void event(const Event&, Arithmetic&) override {
    ++events;
    if (events != number_) return;
    if (trouble_ == Trouble::kLong) work_until_stopped(deadline_);
    if (trouble_ == Trouble::kMemory) throw std::bad_alloc();
  }
  void instant_ended() override { settled = events; }
  void instant_abandoned() override {
    events = settled;
    abandoned = true;
  }
  int events = 0, settled = 0;
  bool abandoned = false;

 private:
  Deadline& deadline_;
  int number_;
  Trouble trouble_;
};

struct StoppedRun {
  explicit StoppedRun(const std::string& arithmetic, SimulatorOptions options, int number,
                      Trouble trouble)
      : scene(crossing()),
        simulator(scene, make_arithmetic(arithmetic, scene), options),
        sink(simulator.deadline(), number, trouble) {
    simulator.add(simulator.reserve(), std::make_unique<PlainList>(simulator.kernel(), 0), "list");
    simulator.set_sink(&sink);
    started = simulator.start();
    status = simulator.run_until(std::nullopt);
  }
  const StructureLedger& ledger() const { return simulator.ledger(0); }
  // The counts are those of n events.
  void expect_counts(std::uint64_t n) const {
    EXPECT_EQ(static_cast<std::uint64_t>(sink.events), n);
    EXPECT_EQ(ledger().external, n);
    EXPECT_EQ(ledger().processed, n);
    EXPECT_EQ(ledger().internal, 0u);
    EXPECT_EQ(ledger().failures, n);
    EXPECT_EQ(ledger().by_kind.at("swap"), n);
    EXPECT_EQ(simulator.ledger().events, n);
    EXPECT_EQ(simulator.ledger().instants, n);
  }
  Scene scene;
  Simulator simulator;
  TroubledSink sink;
  bool started;
  RunStatus status;
};

class StoppedRuns : public testing::TestWithParam<const char*> {};

TEST_P(StoppedRuns, EndBetweenTwoInstantsIfTheyCan) {
  std::atomic<bool> flag = true;
  SimulatorOptions options;
  options.interrupt = &flag;
  const StoppedRun run(GetParam(), options, 0, Trouble::kNone);
  EXPECT_TRUE(run.started);
  EXPECT_EQ(run.status, RunStatus::kInterrupted);
  EXPECT_FALSE(run.simulator.is_broken());
  EXPECT_LT(run.sink.events, 6);
  run.expect_counts(static_cast<std::uint64_t>(run.sink.events));
}

TEST_P(StoppedRuns, TakeBackAnInstantThatTakesTooLong) {
  SimulatorOptions options;
  options.max_seconds = 0.5;
  const StoppedRun run(GetParam(), options, 4, Trouble::kLong);
  EXPECT_TRUE(run.started);
  EXPECT_EQ(run.status, RunStatus::kLimit);
  EXPECT_TRUE(run.simulator.is_broken());
  EXPECT_TRUE(run.simulator.is_torn());
  EXPECT_FALSE(run.simulator.out_of_memory());
  EXPECT_TRUE(run.sink.abandoned);
  run.expect_counts(3);
  // The fourth swap is at 4.
  EXPECT_LE(Rational(3), run.simulator.reached());
  EXPECT_LT(run.simulator.reached(), Rational(4));
}

TEST_P(StoppedRuns, TakeBackAnInstantInWhichMemoryEnds) {
  const StoppedRun run(GetParam(), {}, 2, Trouble::kMemory);
  EXPECT_EQ(run.status, RunStatus::kLimit);
  EXPECT_TRUE(run.simulator.out_of_memory());
  run.expect_counts(1);
}

TEST_P(StoppedRuns, CannotGoOnInTheMidstOfAnInstant) {
  StoppedRun run(GetParam(), {}, 2, Trouble::kMemory);
  EXPECT_EQ(run.simulator.run_until(std::nullopt), RunStatus::kLimit);
  run.expect_counts(1);
}

INSTANTIATE_TEST_SUITE_P(Arithmetics, StoppedRuns,
                         testing::Values("exact", "sturm", "double", "gsl", "mpfr:64"));

// Its construction does not end.
class EndlessList final : public PlainList {
 public:
  using PlainList::PlainList;
  void build(std::span<const ObjectId> objects) override {
    for (;;) PlainList::build(objects.first(0)), kernel_->poll();
  }
};

TEST(StoppedRun, IsStoppedWhileItIsBuilt) {
  const Scene scene = crossing();
  std::atomic<bool> flag = true;
  SimulatorOptions options;
  options.interrupt = &flag;
  Simulator simulator(scene, make_arithmetic("exact", scene), options);
  simulator.add(simulator.reserve(), std::make_unique<EndlessList>(simulator.kernel(), 0), "list");
  EXPECT_FALSE(simulator.start());
  EXPECT_TRUE(simulator.is_torn());
  EXPECT_EQ(simulator.run_until(std::nullopt), RunStatus::kInterrupted);
  EXPECT_EQ(simulator.reached(), scene.start);
}

// Its audit does not end.
class UncheckableList final : public PlainList {
 public:
  using PlainList::PlainList;
  void check_invariants(AuditReport&) const override {
    for (;;) kernel_->poll();
  }
};

TEST(StoppedRun, IsStoppedInAnAudit) {
  const Scene scene = crossing();
  SimulatorOptions options;
  options.max_seconds = 0.2;
  Simulator simulator(scene, make_arithmetic("exact", scene), options);
  simulator.add(simulator.reserve(), std::make_unique<UncheckableList>(simulator.kernel(), 0),
                "list");
  EXPECT_TRUE(simulator.start());
  EXPECT_EQ(simulator.run_until(std::nullopt), RunStatus::kLimit);
  EXPECT_FALSE(simulator.is_torn());
  EXPECT_EQ(simulator.reached(), Rational(10));
  EXPECT_EQ(simulator.ledger(0).processed, 6u);
}

}  // namespace stop_test
}  // namespace kinex::test

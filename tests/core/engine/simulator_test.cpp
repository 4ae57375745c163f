// SPDX-License-Identifier: GPL-3.0-or-later
// Runs: the order of things, changes of the scene, steps and limits.
#include "core/engine/simulator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/core/engine/simulator_fixture.h"

namespace kinex::test {
namespace simulator_test {

using testing::ElementsAre;

Rational ratio(int a, int b) { return Rational(Integer(a), Integer(b)); }

TEST(Simulator, HandlesFailuresUpToAndAtT) {
  const Scene scene =
      scene_of({path({{0, 1}}), path({{1}}), path({{2}}), path({{3}})}, 0, Rational(5));
  Fixture f(scene);
  f.simulator.run_until(ratio(1, 2));
  EXPECT_EQ(f.ledger().processed, 0u);
  f.simulator.run_until(Rational(1));  // at exactly 1: read from the right
  EXPECT_EQ(f.ids(), (std::vector<ObjectId>{1, 0, 2, 3}));
  EXPECT_EQ(f.simulator.reached(), Rational(1));
  f.simulator.run_until(Rational(1));
  f.simulator.run_until(ratio(5, 2));
  EXPECT_EQ(f.ids(), (std::vector<ObjectId>{1, 2, 0, 3}));
  EXPECT_EQ(f.simulator.run_until(std::nullopt), RunStatus::kDone);
  EXPECT_EQ(f.ledger().processed, 3u);
  EXPECT_EQ(f.simulator.ledger().instants, 3u);
  EXPECT_GT(f.simulator.ledger().peak_bytes, 0u);
  EXPECT_EQ(f.simulator.ledger().max_queue, 1u);
  EXPECT_THROW(f.simulator.run_until(Rational(4)), std::invalid_argument);
  EXPECT_THROW(f.simulator.run_until(Rational(6)), std::invalid_argument);
  f.expect_clean();
}

TEST(Simulator, FailuresAtTheEndOfTheSceneAreHandled) {
  // They cross at exactly 2, the scene's end.
  const Scene scene = scene_of({path({{-2, 0, 1}}), path({{2}})}, 0, Rational(2));
  Fixture f(scene);
  f.simulator.run_until(std::nullopt);
  EXPECT_EQ(f.ids(), (std::vector<ObjectId>{1, 0}));
  f.expect_clean();
}

TEST(Simulator, TheLastAuditKeepsClearOfWhatComesAfterTheEnd) {
  // They cross after the end, at 1 + 2^-70: not scheduled.
  const Rational later = Rational(1) + Rational(Integer(1), Integer::power_of_two(70));
  const Scene scene = scene_of({path({{0, 1}}), path({{later}})}, 0, Rational(1));
  for (const AuditLevel level : {AuditLevel::kEnd, AuditLevel::kEvents}) {
    SimulatorOptions options;
    options.audit = level;
    Fixture f(scene, options);
    f.simulator.run_until(std::nullopt);
    EXPECT_GT(f.ledger().audit_checks, 0u);
    f.expect_clean();
  }
}

TEST(Simulator, ASceneWithoutEndRunsToTheLastEvent) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}}), path({{100}})}, 0, std::nullopt);
  Fixture f(scene);
  f.simulator.run_until(std::nullopt);
  EXPECT_EQ(f.ledger().processed, 2u);
  EXPECT_LT(Rational(100), f.simulator.reached());
  f.simulator.schedule_update(f.simulator.reached(), 1,
                              continued(path({{1}}), path({{0, 2}}), f.simulator.reached()));
  f.simulator.run_until(std::nullopt);
  EXPECT_EQ(f.ledger().processed, 4u);
  f.expect_clean();
}

TEST(Simulator, OrderOfThingsAtOneInstant) {
  // At 2: 0 and 1 meet; 3 turns towards 4, with which it has coincided; 5 disappears, 6 appears.
  Scene scene = scene_of({path({{0, 1}}), path({{2}}), path({{5}}), path({{7, 1}}), path({{7, 1}}),
                          path({{20}}), path({{30}})},
                         0, Rational(3));
  scene.objects[3].motion.pieces = {{std::nullopt, Rational(2), path({{7, 1}})},
                                    {Rational(2), std::nullopt, path({{5, 2}})}};
  scene.objects[5].motion.pieces[0].to = Rational(2);
  scene.objects[6].motion.pieces[0].from = Rational(2);
  Fixture f(scene);
  f.simulator.run_until(std::nullopt);
  EXPECT_THAT(f.list->calls, ElementsAre("motions 3", "failed 0 1 shared", "failed 3 4 shared",
                                         "settled", "erase 5", "insert 6"));
  EXPECT_EQ(f.simulator.ledger().instants, 1u);
  EXPECT_EQ(f.ledger().simultaneous_groups, 1u);
  EXPECT_EQ(f.ledger().by_kind.at("motion"), 1u);
  EXPECT_EQ(f.ledger().by_kind.at("insert"), 1u);
  EXPECT_EQ(f.ledger().by_kind.at("erase"), 1u);
  f.expect_clean();
}

TEST(Simulator, SharedInstantsAreKnownBeforeTheFirstFailure) {
  const Scene scene = scene_of(
      {path({{0, 1}}), path({{1}}), path({{5, 1}}), path({{6}}), path({{9, 1}}), path({{11}})}, 0,
      Rational(4));
  Fixture f(scene);
  f.simulator.run_until(std::nullopt);
  EXPECT_THAT(f.list->calls,
              ElementsAre("failed 0 1 shared", "failed 2 3 shared", "settled", "failed 4 5"));
  EXPECT_EQ(f.ledger().simultaneous_groups, 1u);
  EXPECT_EQ(f.ledger().largest_group, 2u);
  EXPECT_EQ(f.simulator.ledger().instants, 2u);
}

TEST(Simulator, ABounceIsNoFailure) {
  // 0 comes down on 1 and turns back at the instant of contact.
  Scene scene = scene_of({path({{0}}), path({{2, -1}})}, 0, Rational(4));
  scene.objects[1].motion.pieces = {{std::nullopt, Rational(2), path({{2, -1}})},
                                    {Rational(2), std::nullopt, path({{-2, 1}})}};
  Fixture f(scene);
  f.simulator.run_until(std::nullopt);
  EXPECT_EQ(f.ledger().processed, 0u);
  EXPECT_EQ(f.ledger().motion_updates, 1u);
  EXPECT_THAT(f.list->calls, ElementsAre("motions 1", "settled"));
  f.expect_clean();
}

TEST(Simulator, JumpsAreErasuresAndInsertions) {
  Scene scene = scene_of({path({{0}}), path({{2}}), path({{4}})}, 0, Rational(4));
  scene.objects[0].motion.pieces = {{std::nullopt, Rational(1), path({{0}})},
                                    {Rational(1), std::nullopt, path({{3}})}};
  Fixture f(scene);
  f.simulator.schedule_update(Rational(2), 1, path({{9}}));
  f.simulator.run_until(std::nullopt);
  EXPECT_THAT(f.list->calls, ElementsAre("erase 0", "insert 0", "erase 1", "insert 1"));
  EXPECT_EQ(f.ids(), (std::vector<ObjectId>{0, 2, 1}));
  f.simulator.bounds(0);
  EXPECT_TRUE(f.list->last_context.dynamic);
  EXPECT_EQ(f.list->last_context.pieces, (std::vector<int>{2, 2, 1}));
  f.expect_clean();
}

TEST(Simulator, ChangesFromOutsideTakeThePlaceOfThePlan) {
  Scene scene = scene_of({path({{0}}), path({{1}})}, 0, Rational(9));
  scene.objects[0].motion.pieces = {{std::nullopt, Rational(4), path({{0}})},
                                    {Rational(4), Rational(6), path({{-4, 1}})},
                                    {Rational(6), Rational(8), path({{2}})}};
  Fixture f(scene);
  f.simulator.schedule_update(Rational(5), 0, path({{-9, 2}}));
  f.simulator.run_until(Rational(8));  // nothing happens at 6 and 8
  EXPECT_TRUE(f.simulator.alive(0));
  EXPECT_EQ(f.simulator.snapshot(Rational(8)).position(0, 0), Rational(7));
  f.simulator.schedule_erasure(Rational(8), 0);
  f.simulator.schedule_insertion(Rational(9), 0, path({{0}}));
  f.simulator.run_until(ratio(17, 2));
  EXPECT_FALSE(f.simulator.alive(0));
  EXPECT_FALSE(f.simulator.snapshot(Rational(8)).alive(0));
  f.simulator.run_until(std::nullopt);
  EXPECT_EQ(f.ids(), (std::vector<ObjectId>{0, 1}));
  EXPECT_EQ(f.ledger().motion_updates, 2u);
  f.expect_clean();
}

TEST(Simulator, RefusesWhatMakesNoSense) {
  const Scene scene = scene_of({path({{0}}), path({{1}})}, 0, Rational(9));
  Fixture f(scene);
  f.simulator.run_until(Rational(2));
  EXPECT_THROW(f.simulator.schedule_erasure(Rational(1), 0), std::invalid_argument);
  EXPECT_THROW(f.simulator.schedule_erasure(Rational(10), 0), std::invalid_argument);
  EXPECT_THROW(f.simulator.schedule_erasure(Rational(3), 2), std::invalid_argument);
  EXPECT_THROW(f.simulator.schedule_update(Rational(3), 0, path({{1}, {2}})),
               std::invalid_argument);
  f.simulator.schedule_insertion(Rational(3), 0, path({{1}}));
  EXPECT_THROW(f.simulator.run_until(Rational(3)), std::invalid_argument);
  Fixture g(scene);
  g.simulator.schedule_erasure(Rational(1), 0);
  g.simulator.schedule_update(Rational(2), 0, path({{1}}));
  EXPECT_THROW(g.simulator.run_until(Rational(3)), std::invalid_argument);
}

TEST(Simulator, StepsGiveTheSameRunAsOneStep) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = random_flights(seed, 8, 1, 1 + static_cast<int>(seed % 3), true);
    SimulatorOptions quiet;
    quiet.audit = AuditLevel::kEnd;
    Fixture once(scene, quiet), steps(scene, quiet);
    SimulatorOptions limited = quiet;
    limited.max_events = 1;
    Fixture stopped(scene, limited);
    once.simulator.run_until(std::nullopt);
    for (int k = 0; k <= 28; ++k) steps.simulator.run_until(ratio(k, 7));
    EXPECT_EQ(once.list->calls, steps.list->calls);
    if (once.ledger().processed > 0) {
      EXPECT_EQ(stopped.simulator.run_until(std::nullopt), RunStatus::kLimit);
      EXPECT_GE(stopped.ledger().processed, 1u);
      EXPECT_TRUE(stopped.simulator.audit());
    }
    once.expect_clean();
    steps.expect_clean();
  }
}

TEST(Simulator, ALimitOfEventsStopsTheRun) {
  const Scene scene = steep_lines(16);
  SimulatorOptions options;
  options.max_events = 50;
  Fixture f(scene, options);
  EXPECT_EQ(f.simulator.run_until(std::nullopt), RunStatus::kLimit);
  EXPECT_EQ(f.ledger().processed, 50u);
  const Rational stopped_at = f.simulator.reached();
  EXPECT_EQ(f.simulator.run_until(std::nullopt), RunStatus::kLimit);
  EXPECT_EQ(f.ledger().processed, 50u);
  EXPECT_LE(stopped_at, f.simulator.reached());
}

TEST(Simulator, ProgressMayStopTheRun) {
  std::vector<Trajectory> cubes;  // any two of them cross once
  for (int j = 0; j < 150; ++j) cubes.push_back(path({{Rational(j * j * j), Rational(-j)}}));
  const Scene scene = scene_of(cubes, 0, std::nullopt);
  SimulatorOptions options;
  int calls = 0;
  options.progress = [&calls](const Simulator&) { return ++calls != 1; };
  Fixture f(scene, options);
  EXPECT_EQ(f.simulator.run_until(std::nullopt), RunStatus::kInterrupted);
  EXPECT_EQ(calls, 1);
  EXPECT_GE(f.ledger().processed, 4096u);
  EXPECT_LT(f.ledger().processed, 8192u + 150u);
  EXPECT_EQ(f.simulator.run_until(std::nullopt), RunStatus::kDone);
  EXPECT_GT(calls, 1);
  EXPECT_EQ(f.ledger().processed, 150u * 149u / 2);
  f.expect_clean();
}

}  // namespace simulator_test
}  // namespace kinex::test

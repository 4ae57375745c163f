// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "core/repeated_object.h"
#include "tests/core/plain_list.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Calls = std::vector<std::string>;

template <class List = PlainList>
struct Fixture {
  explicit Fixture(const Scene& scene, SimulatorOptions options = every(),
                   const std::string& arithmetic = "exact")
      : simulator(scene, make_arithmetic(arithmetic, scene), std::move(options)) {
    auto made = std::make_unique<List>(simulator.kernel(), simulator.reserve());
    list = made.get();
    simulator.add(0, std::move(made), "list");
    simulator.start();
  }
  static SimulatorOptions every() {
    SimulatorOptions options;
    options.audit = AuditLevel::kEvents;
    return options;
  }
  const StructureLedger& ledger() const { return simulator.kernel().ledger(0); }
  std::vector<ObjectId> ids() const { return list->attribute().ids; }
  void expect_clean() const { EXPECT_EQ(simulator.violations(), Calls{}); }

  Simulator simulator;
  List* list;
};

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

TEST(Simulator, ProgressMayStopTheRun) {
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

// ---- the guard

// Never swaps its first two objects: claims again that they are in order.
class Stubborn final : public PlainList {
 public:
  using PlainList::PlainList;
  bool learns = true;
  void certificate_failed(CertificateId failed) override {
    kernel_->replace(failed, Query(less_, {order_[0], order_[1]}), 0);
    kernel_->report(id_, 0, {}, false);
  }
  void rebuild() override {
    if (learns) return PlainList::rebuild();
    const std::vector<ObjectId> same = order_;
    PlainList::rebuild();
    order_ = same;
    certify();
  }
};

// The events that carry a difference: kind, gone, came.
class DifferenceSink final : public EventSink {
 public:
  explicit DifferenceSink(const Simulator& simulator) : simulator_(simulator) {}
  void event(const Event& event, Arithmetic&) override {
    if (!event.has_difference()) return;
    std::string line(simulator_.event_kinds(event.structure)[event.kind]);
    for (const ObjectId id : event.gone) line += " -" + std::to_string(id);
    for (const ObjectId id : event.came) line += " +" + std::to_string(id);
    lines.push_back(line + (event.external ? " !" : ""));
  }
  Calls lines;

 private:
  const Simulator& simulator_;
};

TEST(Simulator, TheGuardRebuilds) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(4));
  Fixture<Stubborn> f(scene);
  DifferenceSink sink(f.simulator);
  f.simulator.set_sink(&sink);
  f.simulator.run_until(std::nullopt);
  EXPECT_THAT(sink.lines, ElementsAre("rebuild -0 -1 +1 +0 !"));
  EXPECT_EQ(f.ledger().external, 1u);
  EXPECT_EQ(f.ledger().rebuilds, 1u);
  EXPECT_EQ(f.ledger().rebuild_reasons.at("guard"), 1u);
  EXPECT_EQ(f.ledger().by_kind.at("rebuild"), 1u);
  EXPECT_EQ(f.ledger().internal, 1000u + 64 + 1);
  EXPECT_EQ(f.ledger().processed, f.ledger().internal + 1);
  EXPECT_EQ(f.ledger().records, f.ledger().internal + 1);
  EXPECT_EQ(f.ids(), (std::vector<ObjectId>{1, 0}));
  f.expect_clean();
}

TEST(Simulator, TheGuardGivesUpOnBugs) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(4));
  Fixture<Stubborn> f(scene);
  f.list->learns = false;
  EXPECT_THROW(f.simulator.run_until(std::nullopt), std::logic_error);
  for (const char* arithmetic : {"double", "gsl", "mpfr:53"}) {
    Fixture<Stubborn> g(scene, {}, arithmetic);
    g.list->learns = false;
    EXPECT_EQ(g.simulator.run_until(std::nullopt), RunStatus::kDone);
    EXPECT_TRUE(g.ledger().corrupt);
    EXPECT_EQ(g.ledger().live, 0u);
    EXPECT_FALSE(g.simulator.audit());
  }
}

// Throws at its first failure.
class Fragile final : public PlainList {
 public:
  using PlainList::PlainList;
  void certificate_failed(CertificateId) override { throw std::logic_error("cannot happen"); }
};

TEST(Simulator, ABrokenInvariantIsABugOrCorruption) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(4));
  Fixture<Fragile> f(scene);
  EXPECT_THROW(f.simulator.run_until(std::nullopt), std::logic_error);
  Fixture<Fragile> g(scene, {}, "double");
  g.simulator.run_until(std::nullopt);
  EXPECT_EQ(g.ledger().corruption, "cannot happen (at t = 1)");
}

// Names a new object twice.
class Doubling final : public PlainList {
 public:
  using PlainList::PlainList;
  void insert(ObjectId object) override {
    PlainList::insert(object);
    kernel_->create(id_, Query(less_, {object, object}), 0);
  }
};

TEST(Simulator, ARepeatedObjectIsABugInAnExactArithmeticAndCorruptionInOthers) {
  const Scene scene = scene_of({path({{0}}), path({{1}}), path({{2}})}, 0, Rational(4));
  const std::string message =
      "structure list asks for a certificate difference(o2, o2), which names an object twice";
  for (const char* arithmetic : {"exact", "sturm", "double", "gsl", "mpfr:53"}) {
    Fixture<Doubling> f(scene, {}, arithmetic);
    f.simulator.schedule_erasure(Rational(1), 2);
    f.simulator.schedule_insertion(Rational(2), 2, path({{5}}));
    if (!f.simulator.kernel().is_exact()) {
      f.simulator.run_until(std::nullopt);
      EXPECT_EQ(f.ledger().corruption, message + " (at t = 2)") << arithmetic;
      continue;
    }
    try {
      f.simulator.run_until(std::nullopt);
      ADD_FAILURE() << arithmetic;
    } catch (const RepeatedObject& error) {
      EXPECT_EQ(error.what(), message);
    }
    EXPECT_FALSE(f.ledger().corrupt);
  }
}

// Keeps its certificates when an object leaves.
class Clinging final : public PlainList {
 public:
  using PlainList::PlainList;
  void erase(ObjectId) override {}
};

TEST(Simulator, NothingMayReferToAnErasedObject) {
  const Scene scene = scene_of({path({{0}}), path({{1}})}, 0, Rational(4));
  Fixture<Clinging> f(scene);
  f.simulator.schedule_erasure(Rational(1), 1);
  EXPECT_THROW(f.simulator.run_until(std::nullopt), std::logic_error);
}

// ---- audits find violations

// Exchanges its first two objects without reporting it.
class Lying final : public PlainList {
 public:
  using PlainList::PlainList;
  bool with_certificate = false;
  void lie() {
    std::swap(order_[0], order_[1]);
    if (with_certificate) {
      kernel_->queue().certificate(certificates_[0]).query = Query(less_, {order_[0], order_[1]});
    }
  }
};

TEST(Simulator, AuditsSeeAWrongAttribute) {
  const Scene scene = scene_of({path({{0}}), path({{1}}), path({{2}})}, 0, Rational(4));
  Fixture<Lying> f(scene);
  EXPECT_TRUE(f.simulator.audit());
  f.list->lie();
  EXPECT_FALSE(f.simulator.audit());
  EXPECT_EQ(f.ledger().audit_violations, 1u);
  EXPECT_THAT(f.simulator.violations().at(0), HasSubstr("list: order"));
}

TEST(Simulator, AuditsSayWhen) {
  const Scene scene = scene_of({path({{0}}), path({{1}}), path({{2}})}, 0, ratio(3, 2));
  Fixture<Lying> f(scene);
  f.simulator.run_until(Rational(1));
  f.list->lie();
  f.simulator.run_until(Rational(1));
  EXPECT_FALSE(f.simulator.audit());
  EXPECT_EQ(f.simulator.violations().back(), "list: order (t = 5/4 (1.25))");
  // A time after the end is used to audit the state right after it, and is not reported.
  f.simulator.run_until(std::nullopt);
  EXPECT_EQ(f.simulator.violations().back(),
            "list: order (right after the scene's end, which is t = 3/2 (1.5))");
}

// Messages do not show names of hundreds of digits.
TEST(Simulator, TimesInMessagesAreShort) {
  const Rational late = Rational(1) + Rational(Integer(1), Integer::power_of_two(2000));
  const Scene scene = scene_of({path({{0}}), path({{1}})}, 0, late);
  Fixture<Lying> f(scene);
  f.list->lie();
  f.simulator.run_until(std::nullopt);
  EXPECT_EQ(f.simulator.violations().back(),
            "list: order (right after the scene's end, which is t = about 1)");
  try {
    f.simulator.run_until(Rational(0));
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "the run has reached about 1 and cannot go back to 0");
  }
  try {
    f.simulator.schedule_erasure(late + late, 0);
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "no change can be made at about 2");
  }
}

TEST(Simulator, AuditsSeeANegativeCertificate) {
  const Scene scene = scene_of({path({{0}}), path({{1}}), path({{2}})}, 0, Rational(4));
  Fixture<Lying> f(scene);
  f.list->with_certificate = true;
  f.list->lie();
  EXPECT_FALSE(f.simulator.audit());
  EXPECT_THAT(f.simulator.violations().at(0),
              HasSubstr("negative right after now: difference(o1, o0)"));
}

// ---- composition

// The first object of a list that it watches.
class First final : public PlainList {
 public:
  First(Kernel& kernel, StructureId id, const PlainList* watched)
      : PlainList(kernel, id), watched_(watched) {}
  void build(std::span<const ObjectId>) override { look(); }
  void insert(ObjectId) override {}
  void erase(ObjectId) override {}
  void watched_changed(const Event* event) override {
    calls.push_back(event == nullptr ? "anew" : "event");
    look();
  }
  Attribute attribute() const override { return {Attribute::Shape::kObject, order_}; }
  void audit(const Snapshot&, AuditReport& report) const override {
    const std::vector<ObjectId> all = watched_->attribute().ids;
    report.check(all.empty() ? order_.empty() : order_ == std::vector<ObjectId>{all[0]},
                 [] { return std::string("not the first"); });
  }

 private:
  void look() {
    const std::vector<ObjectId> all = watched_->attribute().ids;
    if (all.empty()) {
      order_.clear();
    } else if (order_.empty() || order_[0] != all[0]) {
      order_ = {all[0]};
      kernel_->report(id_, 0, {all[0]}, true);
    }
  }
  const PlainList* watched_;
};

struct Composition {
  template <class Watched = PlainList>
  static std::unique_ptr<Composition> make(const Scene& scene,
                                           const std::string& arithmetic = "exact") {
    auto c = std::make_unique<Composition>();
    c->simulator =
        std::make_unique<Simulator>(scene, make_arithmetic(arithmetic, scene), Fixture<>::every());
    Simulator& s = *c->simulator;
    auto list = std::make_unique<Watched>(s.kernel(), s.reserve());
    PlainList* watched = list.get();
    s.add(0, std::move(list), "list");
    auto first = std::make_unique<First>(s.kernel(), s.reserve(), watched);
    c->first = first.get();
    s.add(1, std::move(first), "first", {0});
    s.start();
    return c;
  }
  std::unique_ptr<Simulator> simulator;
  First* first = nullptr;
};

TEST(Simulator, WatchersAreToldOfEveryChange) {
  // The list swaps at 1 (0, 1) and 2 (0, 2); 1 is erased at 3 and inserted at 4.
  const Scene scene = scene_of({path({{0, 1}}), path({{1}}), path({{2}})}, 0, Rational(6));
  const auto c = Composition::make(scene);
  c->simulator->schedule_erasure(Rational(3), 1);
  c->simulator->schedule_insertion(Rational(4), 1, path({{-1}}));
  c->simulator->run_until(std::nullopt);
  EXPECT_THAT(c->first->calls, ElementsAre("event", "event", "anew", "anew"));
  EXPECT_EQ(c->simulator->kernel().ledger(1).by_kind.at("swap"), 4u);
  EXPECT_EQ(c->simulator->kernel().ledger(1).failures, 0u);
  EXPECT_EQ(c->simulator->kernel().ledger(1).external, 4u);
  EXPECT_EQ(c->simulator->kernel().ledger(1).processed, 4u);
  EXPECT_EQ(c->simulator->violations(), Calls{});
}

// Reports its swaps only when the instant is over.
class Late final : public PlainList {
 public:
  using PlainList::PlainList;
  void build(std::span<const ObjectId> objects) override {
    PlainList::build(objects);
    told_ = attribute();
  }
  void certificate_failed(CertificateId failed) override {
    const std::uint32_t i = kernel_->tag(failed);
    std::swap(order_[i], order_[i + 1]);
    certify();
    kernel_->report(id_, 0, {}, false);
    kernel_->set_instant_shared(id_, true);
  }
  void instant_over() override {
    calls.push_back("over");
    const AttributeDifference change = difference_between(told_, attribute());
    told_ = attribute();
    kernel_->report_settled(id_, change.gone, change.came);
  }

 private:
  Attribute told_;
};

TEST(Simulator, WhatChangedIsToldWhenTheInstantIsOver) {
  // All three meet at 1: three swaps, one difference.
  const Scene scene = scene_of({path({{0, 1}}), path({{1}}), path({{2, -1}})}, 0, Rational(6));
  const auto c = Composition::make<Late>(scene);
  DifferenceSink sink(*c->simulator);
  c->simulator->set_sink(&sink);
  c->simulator->run_until(std::nullopt);
  EXPECT_THAT(sink.lines, ElementsAre("settled -0 -1 -2 +2 +1 +0 !"));
  const StructureLedger& l = c->simulator->kernel().ledger(0);
  EXPECT_EQ(l.failures, 3u);
  EXPECT_EQ(l.internal, 3u);
  EXPECT_EQ(l.external, 1u);
  EXPECT_EQ(l.processed, 4u);
  EXPECT_EQ(l.records, 4u);
  EXPECT_EQ(l.by_kind.at("settled"), 1u);
  EXPECT_EQ(c->first->attribute().ids, (std::vector<ObjectId>{2}));
  EXPECT_THAT(c->first->calls, ElementsAre("event"));
  EXPECT_EQ(c->simulator->violations(), Calls{});
}

TEST(Simulator, WatchersAreToldOfRebuilds) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(6));
  const auto c = Composition::make<Stubborn>(scene);
  c->simulator->run_until(std::nullopt);
  EXPECT_THAT(c->first->calls, ElementsAre("anew"));
  EXPECT_EQ(c->simulator->violations(), Calls{});
}

TEST(Simulator, CorruptionSpreadsToWatchers) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(6));
  const auto c = Composition::make<Fragile>(scene, "double");
  c->simulator->run_until(std::nullopt);
  EXPECT_TRUE(c->simulator->kernel().ledger(1).corrupt);
  EXPECT_TRUE(c->first->calls.empty());
}

}  // namespace
}  // namespace kinex::test

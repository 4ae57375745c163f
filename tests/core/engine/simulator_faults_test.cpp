// SPDX-License-Identifier: GPL-3.0-or-later
// Incorrect structures: the guard, corruption, audits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "core/engine/repeated_object.h"
#include "tests/core/engine/simulator_fixture.h"

namespace kinex::test {
namespace simulator_faults_test {

using testing::ElementsAre;
using testing::HasSubstr;

// ---- the guard

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

// Puts a repair off until the instant is settled, and claims then what has failed.
class Postponing final : public PlainList {
 public:
  using PlainList::PlainList;
  int settled = 0;
  void certificate_failed(CertificateId failed) override {
    failed_ = failed;
    kernel_->replace(failed, Query(less_, {order_[1], order_[0]}), 0);  // which holds
    kernel_->report(id_, 0, {}, false);
    kernel_->settle_later(id_);
  }
  void instant_settled() override {
    ++settled;
    kernel_->replace(failed_, Query(less_, {order_[0], order_[1]}), 0);
  }

 private:
  CertificateId failed_ = kNoCertificate;
};

// Rounds of settling may each read a whole structure: far fewer are allowed than repairs.
TEST(Simulator, InexactInstantsAreNotSettledForEver) {
  const Scene scene = scene_of({path({{0, 1}}), path({{1}})}, 0, Rational(4));
  for (const char* arithmetic : {"double", "gsl", "mpfr:53"}) {
    Fixture<Postponing> f(scene, {}, arithmetic);
    EXPECT_EQ(f.simulator.run_until(std::nullopt), RunStatus::kDone);
    EXPECT_EQ(f.ledger().corruption, "no end of repairs at one instant (at t = 1)") << arithmetic;
    EXPECT_EQ(f.list->settled, 64 + 1) << arithmetic;
    EXPECT_EQ(f.ledger().live, 0u);
  }
}

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
  Fixture<Clinging> g(scene, {}, "double");
  g.simulator.schedule_erasure(Rational(1), 1);
  EXPECT_EQ(g.simulator.run_until(std::nullopt), RunStatus::kDone);
  EXPECT_EQ(g.ledger().corruption, "it kept a certificate of an erased object (at t = 1)");
  EXPECT_EQ(g.ledger().live, 0u);
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
      EventQueue& queue = static_cast<Scheduler*>(kernel_)->queue();
      queue.set_query(certificates_[0], Query(less_, {order_[0], order_[1]}));
    }
  }
};

TEST(Simulator, AuditsSeeAWrongAttribute) {
  const Scene scene = scene_of({path({{0}}), path({{1}}), path({{2}})}, 0, Rational(4));
  Fixture<Lying> f(scene);
  EXPECT_TRUE(f.simulator.audit());
  f.list->lie();
  EXPECT_FALSE(f.simulator.audit());
  EXPECT_EQ(f.ledger().audit_violations, 2u);
  EXPECT_THAT(f.simulator.violations().at(0), HasSubstr("list: order"));
  EXPECT_THAT(f.simulator.violations().at(1), HasSubstr("no external event was reported"));
}

TEST(Simulator, AuditsSayWhen) {
  const Scene scene =
      scene_of({path({{0}}), path({{1}}), path({{2}})}, 0, Rational(Integer(3), Integer(2)));
  Fixture<Lying> f(scene);
  f.simulator.run_until(Rational(1));
  f.list->lie();
  f.simulator.run_until(Rational(1));
  EXPECT_FALSE(f.simulator.audit());
  EXPECT_EQ(f.simulator.violations().at(0), "list: order (t = 5/4 (1.25))");
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
  EXPECT_EQ(f.simulator.violations().at(0),
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

}  // namespace simulator_faults_test
}  // namespace kinex::test

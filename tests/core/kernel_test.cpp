// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>

#include "tests/core/fake_arithmetic.h"

namespace kinex::test {
namespace {

struct Fixture {
  explicit Fixture(std::size_t objects = 10) {
    auto made = std::make_unique<FakeArithmetic>();
    arithmetic = made.get();
    kernel = std::make_unique<Kernel>(std::move(made), objects);
    a = kernel->add_structure();
    b = kernel->add_structure();
  }
  void fails(std::initializer_list<ObjectId> ids, int t) {
    arithmetic->times[Query(0, ids).ids] = t;
  }

  FakeArithmetic* arithmetic;
  std::unique_ptr<Kernel> kernel;
  StructureId a = 0, b = 0;
};

TEST(Kernel, SchedulesWhatFails) {
  Fixture f;
  f.fails({0, 1}, 5);
  const auto never = f.kernel->create(f.a, Query(0, {1, 0}), 7);
  const auto later = f.kernel->create(f.a, Query(0, {0, 1}), 8);
  EXPECT_EQ(never.outlook, Outlook::kNever);
  EXPECT_EQ(later.outlook, Outlook::kFails);
  EXPECT_EQ(f.kernel->queue().size(), 1u);
  EXPECT_EQ(f.kernel->queue().top(), later.id);
  EXPECT_EQ(f.kernel->tag(never.id), 7u);
  f.kernel->set_tag(never.id, 9);
  EXPECT_EQ(f.kernel->tag(never.id), 9u);
  // The one never fails any more, the other does: ids and tags.
  EXPECT_EQ(f.kernel->replace(later.id, Query(0, {1, 2}), 1), Outlook::kNever);
  EXPECT_TRUE(f.kernel->queue().empty());
  EXPECT_EQ(f.kernel->replace(never.id, Query(0, {0, 1}), 2), Outlook::kFails);
  EXPECT_EQ(f.kernel->query(never.id), Query(0, {0, 1}));
  EXPECT_EQ(f.kernel->tag(never.id), 2u);
  f.fails({0, 1}, 3);
  f.kernel->unschedule(never.id);
  EXPECT_TRUE(f.kernel->queue().empty());
  f.kernel->reschedule(never.id);
  EXPECT_EQ(f.kernel->queue().top_lo(), 3);
  f.kernel->retract(never.id);
  f.kernel->retract(later.id);
  EXPECT_THROW(f.kernel->retract(later.id), std::logic_error);
  EXPECT_EQ(f.arithmetic->numbers, 0);
  EXPECT_EQ(f.kernel->queue().live(), 0u);
}

TEST(Kernel, LedgerCountsCertificates) {
  Fixture f;
  const auto c = f.kernel->create(f.a, Query(0, {0, 1}), 0).id;
  f.kernel->create(f.a, Query(0, {0, 2, 3}), 0);
  f.kernel->create(f.b, Query(0, {0, 4}), 0);
  f.kernel->replace(c, Query(0, {0, 5}), 0);
  f.kernel->retract(c);
  const StructureLedger& a = f.kernel->ledger(f.a);
  EXPECT_EQ(a.certificates_created, 3u);
  EXPECT_EQ(a.certificates_retracted, 2u);
  EXPECT_EQ(a.live, 1u);
  EXPECT_EQ(a.max_live, 2u);
  EXPECT_EQ(a.max_per_object, 2u);
  EXPECT_EQ(f.kernel->ledger(f.b).max_per_object, 1u);
  EXPECT_EQ(f.kernel->live_certificates(f.a, 0), 1u);
  EXPECT_EQ(f.kernel->live_certificates(f.a, 5), 0u);
  EXPECT_EQ(f.kernel->live_certificates(f.b, 0), 1u);
}

TEST(Kernel, AnEventIsCountedOnceAndLargestNumbersAreTakenAfterIt) {
  Fixture f;
  f.fails({0, 1}, 1);
  const auto failed = f.kernel->create(f.a, Query(0, {0, 1}), 0).id;
  f.kernel->queue().pop();
  f.kernel->begin_event(f.a, failed);
  // For a moment object 0 is in three.
  const auto x = f.kernel->create(f.a, Query(0, {0, 2}), 0).id;
  f.kernel->create(f.a, Query(0, {0, 3}), 0);
  f.kernel->retract(x);
  f.kernel->report(f.a, 4, {0, 1, 3}, true);
  EXPECT_EQ(f.kernel->last_event().kind, 4);
  EXPECT_EQ(f.kernel->last_event().count, 3);
  EXPECT_EQ(f.kernel->last_event().certificate, Query(0, {0, 1}));
  f.kernel->end_event();
  const StructureLedger& a = f.kernel->ledger(f.a);
  EXPECT_EQ(a.failures, 1u);
  EXPECT_EQ(a.processed, 1u);
  EXPECT_EQ(a.external, 1u);
  EXPECT_EQ(a.internal, 0u);
  EXPECT_EQ(a.live, 1u);  // the failed one was retracted
  EXPECT_EQ(a.max_live, 1u);
  EXPECT_EQ(a.max_per_object, 1u);
  EXPECT_EQ(a.created_per_event.histogram[2], 1u);
  EXPECT_EQ(a.retracted_per_event.histogram[2], 1u);
  // A change that comes after the failures of an instant is an event too; a tie put right is not.
  f.kernel->report(f.a, 1, {2}, true);
  EXPECT_EQ(f.kernel->last_event().certificate.arity, 0);
  f.kernel->report(f.a, 2, {2}, false);
  EXPECT_EQ(a.failures, 1u);
  EXPECT_EQ(a.processed, 2u);
  EXPECT_EQ(a.external, 2u);
  EXPECT_EQ(a.internal, 0u);
}

TEST(Kernel, EveryChangeThatAFailureReportsIsAnExternalEvent) {
  Fixture f;
  f.fails({0, 1}, 1);
  const auto failed = f.kernel->create(f.a, Query(0, {0, 1}), 0).id;
  f.kernel->queue().pop();
  f.kernel->begin_event(f.a, failed);
  f.kernel->report(f.a, 0, {0}, false);
  f.kernel->report(f.a, 1, {0}, true);
  f.kernel->report(f.a, 1, {1}, true);
  f.kernel->report(f.b, 1, {3}, true);  // it watches a
  f.kernel->end_event();
  const StructureLedger &a = f.kernel->ledger(f.a), &b = f.kernel->ledger(f.b);
  EXPECT_EQ(a.failures, 1u);
  EXPECT_EQ(a.external, 2u);
  EXPECT_EQ(a.internal, 0u);
  EXPECT_EQ(a.processed, 2u);
  EXPECT_EQ(a.created_per_event.events, 1u);
  EXPECT_EQ(b.failures, 0u);
  EXPECT_EQ(b.external, 1u);
  EXPECT_EQ(b.processed, 1u);
}

TEST(Kernel, AReplacedCertificateSurvivesItsEvent) {
  Fixture f;
  f.fails({0, 1}, 1);
  const auto failed = f.kernel->create(f.a, Query(0, {0, 1}), 0).id;
  f.kernel->queue().pop();
  f.kernel->begin_event(f.a, failed);
  f.kernel->replace(failed, Query(0, {1, 0}), 0);
  f.kernel->end_event();
  EXPECT_TRUE(f.kernel->queue().certificate(failed).live);
  EXPECT_EQ(f.kernel->ledger(f.a).internal, 1u);
  EXPECT_EQ(f.kernel->ledger(f.a).live, 1u);
}

TEST(Kernel, TheIndexFollowsAllChanges) {
  for (const bool early : {true, false}) {
    Fixture f(8);
    std::mt19937_64 random(3);
    const auto below = [&random](std::uint64_t n) { return static_cast<unsigned>(random() % n); };
    std::map<CertificateId, Query> live;
    const auto query = [&] {
      const ObjectId a = below(8), b = (a + 1 + below(3)) % 8, c = (a + 4 + below(4)) % 8;
      return below(2) == 0 ? Query(0, {a, b}) : Query(0, {c, a, b});
    };
    for (int step = 0; step < 4000; ++step) {
      const unsigned what = below(3);
      if (what == 0 || live.empty()) {
        const Query q = query();
        live[f.kernel->create(f.a, q, 0).id] = q;
      } else {
        const auto at = std::next(live.begin(), below(live.size()));
        if (what == 1) {
          f.kernel->retract(at->first);
          live.erase(at);
        } else {
          at->second = query();
          f.kernel->replace(at->first, at->second, 0);
        }
      }
      if (!early && step < 2000) continue;
      const ObjectId object = below(8);
      const auto span = f.kernel->certificates_of(object);
      std::vector<CertificateId> found(span.begin(), span.end()), wanted;
      std::sort(found.begin(), found.end());
      for (const auto& [id, q] : live) {
        if (std::find(q.ids.begin(), q.ids.begin() + q.arity, object) != q.ids.begin() + q.arity) {
          wanted.push_back(id);
        }
      }
      ASSERT_EQ(found, wanted);
      ASSERT_EQ(f.kernel->live_certificates(f.a, object), wanted.size());
    }
  }
}

TEST(Kernel, CorruptionIsForInexactArithmetics) {
  Fixture f;
  f.fails({0, 1}, 1);
  f.kernel->create(f.a, Query(0, {0, 1}), 0);
  f.kernel->create(f.b, Query(0, {0, 1}), 0);
  EXPECT_THROW(f.kernel->corrupt(f.a, "x"), std::logic_error);
  f.arithmetic->exact = false;
  f.kernel->corrupt(f.a, "lost");
  f.kernel->corrupt(f.a, "again");
  EXPECT_EQ(f.kernel->ledger(f.a).corruption, "lost (at t = 0)");
  EXPECT_EQ(f.kernel->ledger(f.a).live, 0u);
  EXPECT_EQ(f.kernel->ledger(f.b).live, 1u);
  EXPECT_EQ(f.kernel->queue().size(), 1u);
}

}  // namespace
}  // namespace kinex::test

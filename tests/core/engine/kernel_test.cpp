// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/scheduler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>

#include "core/engine/repeated_object.h"
#include "tests/core/arithmetic/certificate_fixture.h"
#include "tests/core/arithmetic/fake_arithmetic.h"

namespace kinex::test {
namespace kernel_test {

struct Fixture {
  explicit Fixture(std::size_t objects = 10) {
    auto made = std::make_unique<FakeArithmetic>();
    arithmetic = made.get();
    kernel = std::make_unique<Scheduler>(std::move(made), objects);
    a = kernel->add_structure();
    b = kernel->add_structure();
  }
  void fails(std::initializer_list<ObjectId> ids, int t) {
    arithmetic->times[Query(0, ids).ids] = t;
  }

  FakeArithmetic* arithmetic;
  std::unique_ptr<Scheduler> kernel;
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
  // The first no longer fails, the other does: ids and tags.
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

// `deferred`: within a call of a structure.
void replace_a_group(bool deferred, bool twice, bool of_four) {
  Fixture one, all;
  std::vector<CertificateId> ids;
  for (Fixture* f : {&one, &all}) {
    f->kernel->bind(make_predicate<Order>());  // it has a name
    f->fails({0, 1}, 5);
    f->fails({4, 5}, 3);
    f->fails({6, 7}, 8);
    ids.clear();
    for (ObjectId i = 0; i < 4; ++i) {
      const Query query = of_four ? Query(0, {i, i + 1, 8, 9}) : Query(0, {i, i + 1});
      ids.push_back(f->kernel->create(f->a, query, i).id);
    }
    f->fails({4, 5, 9, 1}, 3);
  }
  Kernel::Group group;
  const std::vector<Query> queries =
      of_four ? std::vector<Query>{Query(0, {4, 5, 9, 1}), Query(0, {8, 3, 1, 2}),
                                   Query(0, {2, 3, 8, 9})}
              : std::vector<Query>{Query(0, {4, 5}), Query(0, {1, 5}), Query(0, {6, 7, 8})};
  for (const Query& query : queries) {
    const std::uint32_t tag = 10 + static_cast<std::uint32_t>(group.size);
    group.ids[group.size] = ids[group.size];
    group.queries[group.size] = query;
    group.tags[group.size++] = tag;
  }
  if (twice) group.ids[2] = group.ids[1];
  if (deferred) one.kernel->begin_change(), all.kernel->begin_change();
  all.kernel->replace(group);
  for (std::size_t i = 0; i < group.size; ++i) {
    EXPECT_EQ(one.kernel->replace(group.ids[i], group.queries[i], group.tags[i]), group.outlooks[i]);
  }
  if (deferred) one.kernel->end_change(), all.kernel->end_change();
  EXPECT_EQ(group.outlooks[0], Outlook::kFails);
  for (const CertificateId id : ids) {
    EXPECT_EQ(one.kernel->query(id), all.kernel->query(id));
    EXPECT_EQ(one.kernel->tag(id), all.kernel->tag(id));
    EXPECT_EQ(one.kernel->outlook(id), all.kernel->outlook(id));
  }
  EXPECT_EQ(all.kernel->queue().top(), ids[0]);
  EXPECT_EQ(one.kernel->queue().size(), all.kernel->queue().size());
  EXPECT_EQ(one.arithmetic->numbers, all.arithmetic->numbers);
  for (ObjectId object = 0; object < 10; ++object) {
    EXPECT_EQ(one.kernel->live_certificates(one.a, object),
              all.kernel->live_certificates(all.a, object));
  }
  const StructureLedger &a = one.kernel->ledger(one.a), &b = all.kernel->ledger(all.a);
  EXPECT_EQ(a.certificates_created, b.certificates_created);
  EXPECT_EQ(a.certificates_retracted, b.certificates_retracted);
  EXPECT_EQ(a.max_per_object, b.max_per_object);
  EXPECT_EQ(a.failures_found, b.failures_found);
  EXPECT_EQ(a.failures_unused, b.failures_unused);
  EXPECT_EQ(a.live, b.live);
  EXPECT_EQ(a.max_live, b.max_live);
  if (twice || of_four) return;
  // A query that is refused leaves those before it replaced, and those after it as they were.
  group.queries = {Query(0, {0, 9}), Query(0, {1, 9, 9}), Query(0, {2, 9})};
  EXPECT_THROW(all.kernel->replace(group), RepeatedObject);
  EXPECT_TRUE(all.kernel->claims(ids[0], Query(0, {0, 9})));
  EXPECT_TRUE(all.kernel->claims(ids[1], Query(0, {1, 5})));
  EXPECT_TRUE(all.kernel->claims(ids[2], Query(0, {6, 7, 8})));
}

TEST(Kernel, AGroupIsReplacedAsOneByOne) {
  for (const bool deferred : {false, true}) {
    for (const bool twice : {false, true}) {
      for (const bool of_four : {false, true}) replace_a_group(deferred, twice, of_four);
    }
  }
}

TEST(Kernel, ClaimsIsTheComparisonOfQueries) {
  Fixture f;
  const std::vector<Query> queries{Query(0, {1}),          Query(0, {1, 0}),
                                   Query(0, {1, 2}),       Query(0, {1, 2, 3, 4, 5}),
                                   Query(1, {1, 2}),       Query(0, {1, 2, 3, 4, 5, 6}),
                                   Query(0, {0, 1, 2, 3, 4, 5, 6, 7}),
                                   Query(0, {0, 1, 2, 3, 4, 5, 6, 8})};
  std::vector<CertificateId> ids;
  for (const Query& query : queries) ids.push_back(f.kernel->create(f.a, query, 0).id);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    for (std::size_t j = 0; j < queries.size(); ++j) {
      EXPECT_EQ(f.kernel->claims(ids[i], queries[j]), i == j) << i << " " << j;
      EXPECT_EQ(f.kernel->claims(ids[i], queries[j]), f.kernel->query(ids[i]) == queries[j]);
    }
  }
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
  // A change reported after the failures of an instant is an event too; a repaired tie is not.
  f.kernel->report(f.a, 1, {2}, true);
  EXPECT_EQ(f.kernel->last_event().certificate.arity, 0);
  f.kernel->report(f.a, 2, {2}, false);
  EXPECT_EQ(a.failures, 1u);
  EXPECT_EQ(a.processed, 2u);
  EXPECT_EQ(a.external, 2u);
  EXPECT_EQ(a.internal, 0u);
}

// Records its input.
struct Reporter final : EventReporter {
  void reported(const Event& event) override { take("own", event); }
  void settled(Event event) override { take("settled", event); }
  void rebuilt(Event event) override { take("rebuilt", event); }
  void changed_within(StructureId id) override { lines.push_back("within " + std::to_string(id)); }
  void take(const char* what, const Event& event) {
    lines.push_back(std::string(what) + (event.external ? " !" : ""));
    gone.assign(event.gone.begin(), event.gone.end());
    came.assign(event.came.begin(), event.came.end());
    reason = event.reason;
  }
  std::vector<std::string> lines;
  std::vector<ObjectId> gone, came;
  std::string reason;
};

TEST(Kernel, EventsWithADifference) {
  Fixture f;
  Reporter reporter;
  f.kernel->set_reporter(&reporter);
  const std::vector<ObjectId> none, one{1}, two{2, 3};
  f.kernel->report(f.a, 0, {4}, true, one, two);
  EXPECT_EQ(reporter.gone, one);
  EXPECT_EQ(reporter.came, two);
  EXPECT_FALSE(f.kernel->last_event().has_difference());  // it was valid during the call
  f.kernel->report(f.a, 0, {4}, false);
  EXPECT_EQ(reporter.gone, none);
  f.kernel->report_settled(f.a, none, none);  // no difference: not reported
  f.kernel->report_settled(f.a, none, one);
  EXPECT_EQ(reporter.came, one);
  f.kernel->count_rebuild(f.a, "why");
  EXPECT_EQ(reporter.reason, "why");
  f.kernel->count_rebuild(f.a, "why", two, none);
  EXPECT_EQ(reporter.gone, two);
  f.kernel->report_changed_within(f.a);  // no event, and counted nowhere
  EXPECT_EQ(reporter.lines, (std::vector<std::string>{"own !", "own", "settled !", "rebuilt",
                                                      "rebuilt !", "within 0"}));
  EXPECT_EQ(f.kernel->ledger(f.a).external, 3u);
  EXPECT_EQ(f.kernel->ledger(f.a).processed, 3u);
  EXPECT_EQ(f.kernel->ledger(f.a).rebuilds, 2u);
  // A change caused by a failure: the failure is not an internal event.
  f.fails({0, 1}, 1);
  const auto failed = f.kernel->create(f.a, Query(0, {0, 1}), 0).id;
  f.kernel->queue().pop();
  f.kernel->begin_event(f.a, failed);
  f.kernel->count_rebuild(f.a, "why", one, two);
  f.kernel->end_event();
  EXPECT_EQ(f.kernel->ledger(f.a).external, 4u);
  EXPECT_EQ(f.kernel->ledger(f.a).processed, 4u);
  EXPECT_EQ(f.kernel->ledger(f.a).internal, 0u);
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
      switch (below(4)) {
        case 0: {  // kept outside of the certificate
          Query q(0, {});
          const unsigned first = below(8);
          q.arity = static_cast<std::uint8_t>(6 + below(3));
          for (ObjectId i = 0; i < q.arity; ++i) q.ids[i] = (first + 3 * i) % 8;
          return q;
        }
        case 1:
          return Query(0, {a, b});
        default:
          return Query(0, {c, a, b});
      }
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
      for (const auto& [id, q] : live) ASSERT_EQ(f.kernel->query(id), q);
      ASSERT_EQ(f.kernel->live_certificates(f.a, object), wanted.size());
    }
  }
}

// Every arity, every pair of places: refused, and nothing has changed.
TEST(Kernel, ACertificateNamesNoObjectTwice) {
  Fixture f;
  f.kernel->bind(make_predicate<Order>());
  const auto refused = [&](const auto& call) {
    try {
      call();
    } catch (const RepeatedObject& error) {
      EXPECT_EQ(error.structure(), f.b);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const CertificateId kept = f.kernel->create(f.b, Query(0, {8, 9}), 3).id;
  for (const bool indexed : {false, true}) {
    if (indexed) f.kernel->certificates_of(0);
    for (std::uint8_t arity = 2; arity <= kMaxArity; ++arity) {
      for (std::uint8_t i = 0; i < arity; ++i) {
        for (std::uint8_t j = i + 1; j < arity; ++j) {
          Query query(0, {});
          query.arity = arity;
          for (ObjectId k = 0; k < arity; ++k) query.ids[k] = k;
          const Query good = query;
          query.ids[j] = query.ids[i];
          std::string list;
          for (ObjectId k = 0; k < arity; ++k) {
            list += (k == 0 ? "" : ", ") + std::to_string(query.ids[k]);
          }
          const std::string text =
              "structure 1 asks for a certificate order(" + list + "), which names an object twice";
          EXPECT_EQ(refused([&] { f.kernel->create(f.b, query, 0); }), text);
          EXPECT_EQ(refused([&] { f.kernel->replace(kept, query, 0); }), text);
          EXPECT_EQ(f.kernel->query(kept), Query(0, {8, 9}));
          EXPECT_EQ(f.kernel->tag(kept), 3u);
          EXPECT_EQ(f.kernel->ledger(f.b).certificates_created,
                    f.kernel->ledger(f.b).certificates_retracted + 1);
          // Object 0 is in unused places as well: no repetition.
          f.kernel->retract(f.kernel->create(f.b, good, 0).id);
        }
      }
    }
  }
  f.kernel->retract(f.kernel->create(f.b, Query(0, {0}), 0).id);
  EXPECT_EQ(f.kernel->queue().live(), 1u);
  EXPECT_EQ(f.kernel->certificates_of(8).size(), 1u);
  EXPECT_EQ(f.kernel->certificates_of(0).size(), 0u);
}

// A constant may occur twice in a certificate (a vertex that two bodies have in their frames): it
// is in no index, which stays right for the other objects.
TEST(Kernel, AConstantMayStandTwice) {
  Fixture f;
  f.kernel->certificates_of(0);
  const ObjectId c = f.kernel->constant("c", {Rational(1)});
  std::vector<CertificateId> made;
  for (int i = 0; i < 3; ++i) made.push_back(f.kernel->create(f.a, Query(0, {0, c, c}), 0).id);
  f.kernel->retract(made[1]);
  f.kernel->replace(made[0], Query(0, {c, 0, c}), 0);
  EXPECT_EQ(f.kernel->certificates_of(0).size(), 2u);
  EXPECT_EQ(f.kernel->certificates_of(c).size(), 0u);
  EXPECT_EQ(f.kernel->live_certificates(f.a, 0), 2u);
  f.kernel->bind(make_predicate<Order>());
  EXPECT_THROW(f.kernel->create(f.a, Query(0, {0, c, 0}), 0), RepeatedObject);
  f.kernel->retract(made[0]);
  f.kernel->retract(made[2]);
  EXPECT_EQ(f.kernel->certificates_of(0).size(), 0u);
}

// A sign with a repeated object is allowed: the formula's value.
TEST(Kernel, ASignMayNameAnObjectTwice) {
  const Scene scene = make_scene({{{Rational(0)}, {Rational(0)}},
                                  {{Rational(3), Rational(1)}, {Rational(1)}},
                                  {{Rational(1)}, {Rational(2), Rational(-1)}}},
                                 Rational(0));
  for (const char* name : {"exact", "sturm", "double", "gsl", "mpfr:53"}) {
    Scheduler kernel(make_arithmetic(name, scene), scene.objects.size());
    set_motions(scene, kernel.arithmetic());
    const PredicateId order = kernel.bind(make_predicate<Order>());
    const PredicateId nearer = kernel.bind(make_predicate<DistanceOrder>());
    const PredicateId turn = kernel.bind(make_predicate<Orientation>());
    EXPECT_EQ(kernel.sign_after(order, {1, 1}), Sign::kZero) << name;
    EXPECT_EQ(kernel.sign_after(turn, {0, 1, 0}), Sign::kZero) << name;
    EXPECT_EQ(kernel.sign_after(turn, {0, 1, 2}), Sign::kPositive) << name;
    // Is 1 farther from 2 than 2 itself?
    EXPECT_EQ(kernel.sign_after(nearer, {2, 1, 2}), Sign::kPositive) << name;
    EXPECT_EQ(kernel.sign_after(nearer, {1, 2, 2}), Sign::kNegative) << name;
    EXPECT_EQ(kernel.sign_after(nearer, {1, 1, 2}), Sign::kZero) << name;
  }
}

TEST(Kernel, CorruptionIsForInexactArithmetics) {
  Fixture f;
  f.kernel->bind(make_predicate<Order>());
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

}  // namespace kernel_test
}  // namespace kinex::test

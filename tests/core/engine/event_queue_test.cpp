// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/event_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "tests/core/arithmetic/certificate_fixture.h"
#include "tests/core/arithmetic/fake_arithmetic.h"

namespace kinex::test {
namespace event_queue_test {

// The key of the queue's order.
using Rank = std::tuple<int, StructureId, PredicateId, std::vector<ObjectId>, CertificateId>;

struct Fixture {
  Fixture() {
    for (int predicate = 0; predicate < 2; ++predicate) arithmetic.bind(make_predicate<Order>());
  }
  FakeArithmetic arithmetic;
  EventQueue queue{arithmetic};
  std::set<Rank> expected;
  std::vector<Rank> rank;  // by certificate

  CertificateId add(int t, StructureId structure, PredicateId predicate, ObjectId a, ObjectId b) {
    const CertificateId id = queue.allocate(structure, Query(predicate, {a, b}), 0);
    if (rank.size() <= id) rank.resize(id + 1);
    push(id, t);
    return id;
  }
  void push(CertificateId id, int t) {
    const Certificate& c = queue.certificate(id);
    const Query query = queue.query(c);
    std::vector<ObjectId> ids(query.ids.begin(), query.ids.begin() + query.arity);
    std::sort(ids.begin(), ids.end());
    rank[id] = {t, c.structure, query.predicate, ids, id};
    expected.insert(rank[id]);
    queue.push(id, arithmetic.make(t));
  }
  void pop() {
    const CertificateId id = queue.top();
    ASSERT_EQ(rank[id], *expected.begin());
    FailureTime time = queue.pop();
    EXPECT_EQ(time.root, static_cast<std::uint32_t>(std::get<0>(rank[id])) + 1);
    arithmetic.release(time);
    expected.erase(expected.begin());
    queue.free(id);
  }
};

TEST(EventQueue, RandomOperations) {
  for (const double slack : {0.0, 0.4, 3.0, 40.0}) {
    Fixture f;
    f.arithmetic.slack = slack;
    std::mt19937_64 random(11);
    const auto below = [&random](std::uint64_t n) { return static_cast<unsigned>(random() % n); };
    for (int step = 0; step < 6000; ++step) {
      const unsigned what = below(10);
      if (what < 5 || f.queue.empty()) {
        // No two certificates claim the same, so each has a failure time of its own.
        f.add(static_cast<int>(below(60)), static_cast<StructureId>(below(3)),
              static_cast<PredicateId>(below(2)), below(5), 5 + static_cast<ObjectId>(step));
      } else if (what < 7) {
        f.pop();
        if (testing::Test::HasFatalFailure()) return;
      } else {
        const auto at = std::next(f.expected.begin(), below(f.expected.size()));
        const CertificateId id = std::get<4>(*at);
        const int t = static_cast<int>(below(60));
        f.expected.erase(at);
        if (what == 7) {
          f.queue.free(id);
        } else if (what == 8) {
          f.queue.remove(id);
          EXPECT_FALSE(f.queue.queued(id));
          f.push(id, t);
        } else {
          FailureTime old = f.queue.time(id);
          f.arithmetic.release(old);
          f.queue.reset(id, f.arithmetic.make(t));
          std::get<0>(f.rank[id]) = t;
          f.expected.insert(f.rank[id]);
        }
      }
      ASSERT_EQ(f.queue.size(), f.expected.size());
      ASSERT_EQ(f.arithmetic.numbers, static_cast<int>(f.queue.size()));
      if (f.queue.empty()) continue;
      // The certificates that share the first instant.
      std::vector<CertificateId> shared, wanted;
      f.queue.collect_first_instant(shared);
      for (const Rank& r : f.expected) {
        if (std::get<0>(r) == std::get<0>(*f.expected.begin())) wanted.push_back(std::get<4>(r));
      }
      std::sort(shared.begin(), shared.end());
      std::sort(wanted.begin(), wanted.end());
      ASSERT_EQ(shared, wanted);
      ASSERT_EQ(f.queue.first_instant_is_shared(), wanted.size() > 1);
    }
    while (!f.queue.empty() && !testing::Test::HasFatalFailure()) f.pop();
    EXPECT_EQ(f.arithmetic.numbers, 0);
    EXPECT_EQ(f.queue.live(), 0u);
    EXPECT_GT(f.queue.max_size(), 100u);
  }
}

// Failures are cut into buckets while few of the certificates are queued, and while all of them are: a list
// is then read by its links, or by ids.
TEST(EventQueue, FewOfManyCertificatesAreQueued) {
  for (const int queued_every : {1, 3, 20}) {
    Fixture f;
    f.arithmetic.slack = 0.4;
    for (int i = 0; i < 8000; ++i) {
      const auto object = static_cast<ObjectId>(i);
      if (i % queued_every == 0) {
        f.add((i * 3011) % 8000, 0, 0, object, 10000);
      } else {
        f.queue.allocate(0, Query(0, {object, 10000}), 0);
      }
    }
    ASSERT_EQ(f.queue.size(), f.expected.size());
    while (!f.queue.empty() && !testing::Test::HasFatalFailure()) f.pop();
    EXPECT_TRUE(f.expected.empty());
    EXPECT_EQ(f.arithmetic.numbers, 0);
  }
}

TEST(EventQueue, DisjointEnclosuresAreNotAskedAbout) {
  Fixture f;
  f.arithmetic.slack = 0.4;
  for (int i = 0; i < 500; ++i) f.add((i * 37) % 500, 0, 0, static_cast<ObjectId>(i), 1000);
  EXPECT_FALSE(f.queue.first_instant_is_shared());
  while (!f.queue.empty() && !testing::Test::HasFatalFailure()) f.pop();
  EXPECT_EQ(f.arithmetic.comparisons_asked, 0u);
}

TEST(EventQueue, OverlappingEnclosuresShrink) {
  Fixture f;
  f.arithmetic.slack = 2;
  const CertificateId a = f.add(1, 0, 0, 0, 1);
  const CertificateId b = f.add(2, 0, 0, 0, 2);
  const std::uint64_t asked = f.arithmetic.comparisons_asked;
  EXPECT_GT(asked, 0u);
  for (const CertificateId id : {a, b}) EXPECT_EQ(f.queue.time(id).lo, f.queue.time(id).hi);
  EXPECT_EQ(f.queue.top_hi(), 1);
  f.pop();
  f.pop();
  EXPECT_EQ(f.arithmetic.comparisons_asked, asked);
}

// Two certificates with one polynomial fail at one instant: no roots are compared.
TEST(EventQueue, EqualClaimsFailTogether) {
  Fixture f;
  f.arithmetic.slack = 2;
  f.add(1, 1, 0, 3, 4);
  f.add(1, 0, 0, 3, 4);
  EXPECT_TRUE(f.queue.first_instant_is_shared());
  EXPECT_EQ(f.arithmetic.comparisons_asked, 0u);
  // The opposite claim and that of another predicate have other failure times.
  f.add(2, 0, 0, 4, 3);
  f.add(2, 0, 1, 3, 4);
  EXPECT_GT(f.arithmetic.comparisons_asked, 0u);
  while (!f.queue.empty() && !testing::Test::HasFatalFailure()) f.pop();
}

TEST(EventQueue, IdsAreUsedAgain) {
  Fixture f;
  const CertificateId a = f.add(1, 0, 0, 0, 1);
  const CertificateId b = f.add(2, 0, 0, 0, 2);
  f.expected.erase(f.rank[a]);
  f.queue.free(a);
  EXPECT_FALSE(f.queue.certificate(a).live);
  EXPECT_EQ(f.add(3, 1, 1, 3, 4), a);
  EXPECT_EQ(f.queue.certificate(a).structure, 1);
  EXPECT_EQ(f.queue.top(), b);
  EXPECT_EQ(f.queue.capacity(), 2u);
}

}  // namespace event_queue_test
}  // namespace kinex::test

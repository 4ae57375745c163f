// SPDX-License-Identifier: GPL-3.0-or-later
// An arithmetic that looks failure times up in a table, for tests of the queue and the kernel.
#ifndef KINEX_TESTS_CORE_ARITHMETIC_FAKE_ARITHMETIC_H
#define KINEX_TESTS_CORE_ARITHMETIC_FAKE_ARITHMETIC_H

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/arithmetic.h"

namespace kinex::test {

class FakeArithmetic final : public Arithmetic {
 public:
  // The failure time of every query over these ids, in steps of 1; missing: it never fails. The
  // returned enclosures are `slack` wider on both sides.
  std::map<std::array<ObjectId, kMaxArity>, int> times;
  double slack = 0;
  int now = 0;
  bool exact = true;
  std::uint64_t comparisons_asked = 0;
  // Numbers handed out and not yet released.
  int numbers = 0;

  FailureTime make(int t) {
    ++numbers;
    return {t - slack, t + slack, static_cast<std::uint32_t>(t) + 1};
  }

  std::string name() const override { return "fake"; }
  bool is_exact() const override { return exact; }
  void set_motion(ObjectId, const Trajectory&, const std::optional<Rational>&) override {}
  void set_now(const Rational&) override {}
  void advance(const Query& query, FailureTime& time) override {
    now = times.at(query.ids);
    release(time);
  }
  double now_approximate() const override { return now; }
  const InstantName& name_now(InstantDetail) override { return name_of_now_; }
  Sign sign_after(const Query&) override { return Sign::kPositive; }
  Outlook failure(const Query& query, FailureTime& time) override {
    const auto at = times.find(query.ids);
    if (at == times.end()) return Outlook::kNever;
    time = make(at->second);
    return at->second <= now ? Outlook::kFailsNow : Outlook::kFails;
  }
  int compare(const Query&, FailureTime& a, const Query&, FailureTime& b) override {
    ++comparisons_asked;
    shrink(a);
    shrink(b);
    return a.lo < b.lo ? -1 : a.lo > b.lo ? 1 : 0;
  }
  int compare_with_now(const Query&, FailureTime& a) override {
    shrink(a);
    return a.lo < now ? -1 : a.lo > now ? 1 : 0;
  }
  int compare(const Query&, FailureTime&, const Rational&) override { return 0; }
  void release(FailureTime& time) override {
    if (time.root != 0) --numbers;
    time.root = 0;
  }
  std::optional<Rational> rational_between(const Query*, FailureTime*) override { return {}; }
  std::size_t bytes() const override { return 0; }

 private:
  static void shrink(FailureTime& time) { time.lo = time.hi = static_cast<double>(time.root) - 1; }
};

}  // namespace kinex::test

#endif

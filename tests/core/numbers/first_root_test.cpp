// SPDX-License-Identifier: GPL-3.0-or-later
// The filter never contradicts the exact roots, and rarely abstains on generic input.
#include "core/numbers/first_root.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "core/numbers/real_root.h"

namespace kinex {
namespace first_root_test {

using filter::Enclosure;
using filter::Search;

std::int64_t draw(std::mt19937_64& random, std::int64_t bound) {
  return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * bound + 1)) - bound;
}

struct Tally {
  int none = 0, found = 0, unknown = 0;
};

// Runs the filter on p over (a, b] and checks its answer against exact isolation.
void check_one(const std::vector<std::int64_t>& coefficients, double a, double b, Tally& tally) {
  std::vector<Integer> exact;
  std::vector<double> c, m;
  for (std::int64_t v : coefficients) {
    exact.emplace_back(v);
    c.push_back(static_cast<double>(v));
    m.push_back(std::fabs(c.back()));
  }
  Polynomial p(exact);
  if (p.degree() < 2) return;
  c.resize(static_cast<std::size_t>(p.degree()) + 1);
  m.resize(c.size());
  const Rational start = *Rational::from_double(a);
  if (p.sign_at(start) == Sign::kNegative) {
    for (double& v : c) v = -v;
    p = -p;
  }
  if (p.sign_at(start) == Sign::kZero) return;
  Enclosure out{};
  const Search answer = filter::first_sign_change<true>(c.data(), m.data(), p.degree(), 0, a, b, out);
  RootCounters counters;
  RealRoot from(start);
  std::optional<Rational> until;
  if (std::isfinite(b)) until = *Rational::from_double(b);
  auto root = first_sign_change_after(p, from, std::nullopt, counters);
  switch (answer) {
    case Search::kUnknown: ++tally.unknown; break;
    case Search::kNone:
      ++tally.none;
      if (root) {
        ASSERT_TRUE(until) << p.to_string() << " a=" << a;
        ASSERT_GT(compare(*root, *until, counters), 0) << p.to_string() << " a=" << a << " b=" << b;
      }
      break;
    case Search::kFound: {
      ++tally.found;
      ASSERT_TRUE(root) << p.to_string() << " a=" << a;
      ASSERT_GT(compare(*root, *Rational::from_double(out.lo), counters), 0) << p.to_string();
      ASSERT_LT(compare(*root, *Rational::from_double(out.hi), counters), 0) << p.to_string();
      // Exactly one root in the enclosure.
      int inside = 0;
      for (auto& r : isolate_real_roots(p, counters)) {
        if (compare(r.root, *Rational::from_double(out.lo), counters) > 0 &&
            compare(r.root, *Rational::from_double(out.hi), counters) < 0) {
          ++inside;
        }
      }
      ASSERT_EQ(inside, 1) << p.to_string();
      break;
    }
  }
}

struct Case {
  int degree;
  std::int64_t bound;
  double a, b;
  double max_unknown;  // share
};

class FirstRootAgainstExact : public ::testing::TestWithParam<Case> {};

TEST_P(FirstRootAgainstExact, NeverContradicts) {
  const Case& k = GetParam();
  std::mt19937_64 random(20261121u + static_cast<unsigned>(k.degree));
  Tally tally;
  const int rounds = 1500;
  for (int i = 0; i < rounds; ++i) {
    std::vector<std::int64_t> c;
    for (int j = 0; j <= k.degree; ++j) c.push_back(draw(random, k.bound));
    check_one(c, k.a, k.b, tally);
    if (HasFatalFailure()) return;
  }
  const int asked = tally.none + tally.found + tally.unknown;
  EXPECT_LE(tally.unknown, k.max_unknown * asked)
      << tally.none << " none, " << tally.found << " found, " << tally.unknown << " unknown";
  EXPECT_GT(tally.found, rounds / 20);
}

const double kForEver = std::numeric_limits<double>::infinity();
INSTANTIATE_TEST_SUITE_P(
    Generic, FirstRootAgainstExact,
    ::testing::Values(Case{2, 1 << 20, 0, 1, 0.001}, Case{2, 1 << 20, 0, kForEver, 0.001},
                      Case{3, 1 << 20, 0.25, kForEver, 0.001}, Case{4, 1 << 20, 0, 1, 0.001},
                      Case{4, 1 << 20, 0, kForEver, 0.001}, Case{4, 1 << 20, 0.5, 1, 0.001},
                      Case{4, 1 << 20, -3, kForEver, 0.001}, Case{5, 1 << 30, 0, kForEver, 0.001},
                      Case{6, 1 << 30, 0, 7, 0.001}, Case{8, 1 << 20, 0, kForEver, 0.001},
                      Case{12, 1 << 20, 0, kForEver, 0.002}, Case{7, 1 << 20, 0, kForEver, 0.002},
                      Case{20, 1 << 20, 0, kForEver, 0.01}));
INSTANTIATE_TEST_SUITE_P(SmallCoefficients, FirstRootAgainstExact,
                         ::testing::Values(Case{2, 3, 0, kForEver, 0.2}, Case{4, 3, 0, kForEver, 0.2},
                                           Case{4, 7, 1, kForEver, 0.25}, Case{8, 3, 0, 10, 0.2}));

std::vector<std::int64_t> multiply(const std::vector<std::int64_t>& a,
                                   const std::vector<std::int64_t>& b) {
  std::vector<std::int64_t> r(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) r[i + j] += a[i] * b[j];
  }
  return r;
}

TEST(FirstRoot, DoubleRootsAreNeverCalledSimple) {
  std::mt19937_64 random(7);
  Tally tally;
  for (int i = 0; i < 800; ++i) {
    const std::vector<std::int64_t> line{-(1 + static_cast<std::int64_t>(random() % 1000)),
                                         1 + static_cast<std::int64_t>(random() % 1000)};
    std::vector<std::int64_t> rest{draw(random, 100), draw(random, 100), draw(random, 100)};
    check_one(multiply(multiply(line, line), rest), 0, kForEver, tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.unknown, 0);  // a double root cannot be certified in floating point
}

TEST(FirstRoot, ShiftedWilkinsonAndMignotte) {
  Tally tally;
  for (std::int64_t shift : {0, 3, 100}) {
    std::vector<std::int64_t> p{1};
    for (std::int64_t k = 1; k <= 6; ++k) p = multiply(p, {-(k + shift), 1});
    check_one(p, 0, kForEver, tally);
  }
  for (std::int64_t a : {10, 1000, 30000}) {
    check_one({-2, 4 * a, -2 * a * a, 0, 1}, 0, kForEver, tally);
    check_one({-2, 4 * a, -2 * a * a, 0, 0, 0, 0, 0, 1}, 0, kForEver, tally);
  }
}

TEST(FirstRoot, RootExactlyAtTheEndIsFound) {
  // (2 - t)(t + 5), until 2.
  const double c[] = {10, -3, -1}, m[] = {10, 3, 1};
  Enclosure out{};
  ASSERT_EQ(filter::first_sign_change<true>(c, m, 2, 0, 0, 2, out), Search::kFound);
  EXPECT_LT(out.lo, 2);
  EXPECT_GT(out.hi, 2);
}

TEST(FirstRoot, OverflowAndUnderflowAbstain) {
  const double big[] = {1e307, -1e308, 1e308}, tiny[] = {1e-310, -1e-309, 1e-310};
  const double bm[] = {1e307, 1e308, 1e308}, tm[] = {1e-310, 1e-309, 1e-310};
  Enclosure out{};
  EXPECT_EQ(filter::first_sign_change<true>(big, bm, 2, 0, 0, 1e10, out), Search::kUnknown);
  EXPECT_EQ(filter::first_sign_change<true>(tiny, tm, 2, 0, 0, 1, out), Search::kUnknown);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double c[] = {1, nan, -1}, m[] = {1, nan, 1};
  EXPECT_EQ(filter::first_sign_change<true>(c, m, 2, 0, 0, 1, out), Search::kUnknown);
  EXPECT_EQ(filter::first_sign_change<false>(c, m, 2, 0, 0, 1, out), Search::kNone);
}

TEST(FirstRoot, NeighboursAreThoseOfTheLibrary) {
  using Limits = std::numeric_limits<double>;
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  std::mt19937_64 random(5);
  std::vector<double> numbers{
      0, 1, Limits::min(), Limits::denorm_min(), Limits::max(), Limits::infinity()};
  while (numbers.size() < 1000) {
    const double x = std::bit_cast<double>(random());
    if (!std::isnan(x)) numbers.push_back(x);
  }
  for (const double x : numbers) {
    for (const double y : {x, -x}) {
      EXPECT_EQ(bits(filter::next_up(y)), bits(std::nextafter(y, Limits::infinity()))) << y;
      EXPECT_EQ(bits(filter::next_down(y)), bits(std::nextafter(y, -Limits::infinity()))) << y;
    }
  }
  EXPECT_TRUE(std::isnan(filter::next_up(Limits::quiet_NaN())));
}

}  // namespace first_root_test
}  // namespace kinex

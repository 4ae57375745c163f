// SPDX-License-Identifier: GPL-3.0-or-later
// Binary scale, bits needed: answers known by hand, and brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "experiments/lab/binary_scale.h"
#include "experiments/trade/bits_needed.h"

namespace kinex {
namespace numbers_test {

Rational q(const char* text) { return *Rational::parse(text); }

TEST(BinaryScale, PowersAndLogarithms) {
  EXPECT_EQ(lab::power_of_two(0), Rational(1));
  EXPECT_EQ(lab::power_of_two(10), Rational(1024));
  EXPECT_EQ(lab::power_of_two(-3), q("1/8"));
  EXPECT_EQ(lab::absolute(q("-1/3")), q("1/3"));
  EXPECT_EQ(lab::floor_log2(Rational(1)), 0);
  EXPECT_EQ(lab::ceil_log2(Rational(1)), 0);
  EXPECT_EQ(lab::floor_log2(q("7/2")), 1);
  EXPECT_EQ(lab::ceil_log2(q("7/2")), 2);
  EXPECT_EQ(lab::floor_log2(q("1/3")), -2);
  EXPECT_EQ(lab::ceil_log2(q("1/3")), -1);
  EXPECT_EQ(lab::floor_log2(lab::power_of_two(-5000)), -5000);
  EXPECT_EQ(lab::ceil_log2(lab::power_of_two(-5000)), -5000);
}

// 1: the power with its exponent is at most x, and twice that is more. 2: likewise from above.
TEST(BinaryScale, LogarithmsBracketRandomFractions) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    const Rational x(Integer(static_cast<std::int64_t>(random() % 100000 + 1)),
                     Integer(static_cast<std::int64_t>(random() % 100000 + 1)));
    EXPECT_LE(lab::power_of_two(lab::floor_log2(x)), x);
    EXPECT_LT(x, lab::power_of_two(lab::floor_log2(x) + 1));
    EXPECT_GE(lab::power_of_two(lab::ceil_log2(x)), x);
    EXPECT_GT(x, lab::power_of_two(lab::ceil_log2(x) - 1));
  }
}

TEST(BinaryScale, RoundsToBits) {
  EXPECT_EQ(lab::round_to_bits(Rational(0), 5), Rational(0));
  EXPECT_EQ(lab::round_to_bits(Rational(13), 3), Rational(12));  // 1101: a tie, to the even 110
  EXPECT_EQ(lab::round_to_bits(Rational(11), 3), Rational(12));  // 1011: a tie, to the even 110
  EXPECT_EQ(lab::round_to_bits(Rational(15), 3), Rational(16));
  EXPECT_EQ(lab::round_to_bits(q("-1/3"), 2), q("-3/8"));
  EXPECT_EQ(lab::round_to_bits(q("1/3"), 1), q("1/4"));
}

// Rounding to 53 bits is what the compiler does with a fraction.
TEST(BinaryScale, RoundsAsDoublesDo) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 2000; ++i) {
    const auto a = static_cast<std::int64_t>(random() >> 12);
    const auto b = static_cast<std::int64_t>(random() >> 12) + 1;
    const double expected = static_cast<double>(a) / static_cast<double>(b);  // both are exact
    EXPECT_EQ(lab::round_to_bits(Rational(Integer(a), Integer(b)), 53),
              *Rational::from_double(expected));
  }
}

TEST(BinaryScale, UlpsAreThoseOfDoubles) {
  for (const double x : {1.0, 1.5, 0.1, 3e300, 1e-300, 2.2250738585072014e-308}) {
    const double next = std::nextafter(x, std::numeric_limits<double>::infinity());
    EXPECT_EQ(lab::ulp_of(*Rational::from_double(x)),
              *Rational::from_double(next) - *Rational::from_double(x))
        << x;
    EXPECT_EQ(lab::ulp_of(-*Rational::from_double(x)), lab::ulp_of(*Rational::from_double(x)));
  }
  EXPECT_EQ(lab::ulp_of(Rational(0)), lab::power_of_two(-1074));
  EXPECT_EQ(lab::ulp_of(q("1e-320")), lab::power_of_two(-1074));
}

long between(const char* a, const char* b) {
  RealRoot low(q(a)), high(q(b));
  RootCounters counters;
  return trade::bits_between(low, high, counters);
}

TEST(BitsBetween, KnownByHand) {
  EXPECT_EQ(between("1", "2"), 2);      // ceil(log2(2 / 1)) + 1
  EXPECT_EQ(between("0", "1"), 1);      // 1 / 1
  EXPECT_EQ(between("-1", "1"), 1);     // less than 1 is said as 1
  EXPECT_EQ(between("1/3", "2/3"), 2);  // 2 / 1
  EXPECT_EQ(between("7", "8"), 4);
  EXPECT_EQ(between("8", "9"), 5);  // 9 / 1: between 8 and 16
  EXPECT_EQ(between("-9", "-8"), 5);
  EXPECT_EQ(between("1", "1.0000000000000002220446049250313080847263336181640625"), 54);  // 1+2^-52
}

// sqrt(2) and 141421356/100000000: apart by 2.373e-9, 1.414.. / that = 5.96e8, between 2^29, 2^30.
TEST(BitsBetween, AlgebraicInstants) {
  RealRoot low(q("1.41421356"));
  RealRoot high(Polynomial({Integer(-2), Integer(0), Integer(1)}), Rational(1), Rational(2));
  RootCounters counters;
  EXPECT_EQ(trade::bits_between(low, high, counters), 31);
}

// So many bits are enough: the two numbers rounded to one bit more differ, in the right order.
TEST(BitsBetween, AreEnoughAndNotManyTooMany) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 500; ++i) {
    const Rational a(Integer(static_cast<std::int64_t>(random() % 1000000 + 1)), Integer(999983));
    const Rational b =
        a + Rational(Integer(1), Integer::power_of_two(static_cast<unsigned long>(random() % 90)));
    RealRoot low(a), high(b);
    RootCounters counters;
    const long bits = trade::bits_between(low, high, counters);
    EXPECT_LT(lab::round_to_bits(a, bits + 1), lab::round_to_bits(b, bits + 1));
    if (bits > 3) {
      EXPECT_LE(lab::absolute(lab::round_to_bits(b, bits - 3) - lab::round_to_bits(a, bits - 3)),
                lab::power_of_two(lab::floor_log2(b) - (bits - 3) + 1));  // the same, or neighbours
    }
  }
}

trade::ExactTrace trace_at(const std::vector<const char*>& times) {
  trade::ExactTrace trace;
  for (const char* t : times) {
    trace.names.push_back(0);
    trace.instants.push_back(static_cast<std::uint32_t>(trace.times.size()));
    trace.times.emplace_back(q(t));
  }
  return trace;
}

TEST(BitsNeeded, LargestAndPercentile) {
  trade::ExactTrace none = trace_at({});
  EXPECT_EQ(trade::bits_needed(none, Rational(9)).pairs, 0u);
  trade::ExactTrace one = trace_at({"1"});
  EXPECT_EQ(trade::bits_needed(one, Rational(1)).most, 0);
  EXPECT_EQ(trade::bits_needed(one, Rational(2)).most, 2);  // to know that it is before the end
  EXPECT_EQ(trade::bits_needed(one, Rational(2)).instants, 1u);
  trade::ExactTrace few = trace_at({"1", "2", "8", "9"});  // 2, 2 (8/6), 5
  const trade::BitsNeeded bits = trade::bits_needed(few, Rational(9));
  EXPECT_EQ(bits.pairs, 3u);
  EXPECT_EQ(bits.most, 5);
  EXPECT_EQ(bits.percentile_99, 5);
  EXPECT_EQ(bits.time, Rational(8));
  // 200 pairs, of which 2 need more: the 198th is one that does not.
  trade::ExactTrace many;
  Rational t(1);
  for (int i = 0; i <= 200; ++i) {
    if (i > 0) t = i == 50 || i == 120 ? t * q("1.0001") : t * Rational(2);
    many.times.emplace_back(t);
  }
  EXPECT_EQ(trade::bits_needed(many, t).most, 15);
  EXPECT_EQ(trade::bits_needed(many, t).percentile_99, 2);
}

}  // namespace numbers_test
}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials in machine integers against rationals: every valid result is right.
#include "core/numbers/dyadic_polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace kinex {
namespace dyadic_polynomial_test {

using List = std::vector<Rational>;

// The same with a denominator that no operation reduces.
struct Reference {
  List c;
  unsigned denominator_bits = 0;
};

Reference sum(const Reference& a, const Reference& b, int sign) {
  Reference r{List(std::max(a.c.size(), b.c.size())), a.denominator_bits};
  for (std::size_t i = 0; i < a.c.size(); ++i) r.c[i] += a.c[i];
  for (std::size_t i = 0; i < b.c.size(); ++i) r.c[i] += Rational(sign) * b.c[i];
  if (a.denominator_bits != b.denominator_bits) r.denominator_bits += b.denominator_bits;
  return r;
}

Reference product(const Reference& a, const Reference& b) {
  Reference r{List(a.c.size() + b.c.size() - 1), a.denominator_bits + b.denominator_bits};
  for (std::size_t i = 0; i < a.c.size(); ++i) {
    for (std::size_t j = 0; j < b.c.size(); ++j) r.c[i + j] += a.c[i] * b.c[j];
  }
  return r;
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  unsigned below(unsigned bound) { return static_cast<unsigned>(engine_() % bound); }
  // At most `bits` bits, often near a power of two, often zero.
  Rational dyadic(unsigned bits) {
    if (below(6) == 0) return Rational();
    Integer n = Integer::power_of_two(below(bits + 1));
    if (below(2) == 0) n += Integer(static_cast<int>(below(1000)));
    if (below(4) == 0) n -= Integer(1);
    if (below(2) == 0) n.negate();
    return Rational(n, Integer::power_of_two(below(bits + 1)));
  }
  List list(unsigned bits) {
    List result(1 + below(4));
    for (Rational& c : result) c = dyadic(bits);
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

Reference reference(const List& list) {
  Reference r{list, 0};
  for (const Rational& c : list) {
    const auto bits = static_cast<unsigned>(c.denominator().bit_length()) - 1;
    r.denominator_bits = std::max(r.denominator_bits, bits);
  }
  return r;
}

// The contract of write().
List written(const Reference& r, unsigned common) {
  List result = r.c;
  for (Rational& c : result) c *= Rational(Integer::power_of_two(common));
  while (result.size() > 1 && result.back().is_zero()) result.pop_back();
  return result;
}

void expect_same(const DyadicPolynomial& p, const Reference& r) {
  ASSERT_TRUE(p.is_valid());
  ASSERT_EQ(p.denominator_bits(), r.denominator_bits);
  for (const unsigned more : {0u, 1u, 70u}) {
    const unsigned common = p.denominator_bits() + more;
    const List wanted = written(r, common);
    List got(2, Rational(Integer(5), Integer(7)));  // the former contents are overwritten
    p.write(common, got);
    EXPECT_EQ(got, wanted);
    std::size_t bits = 0;
    for (const Rational& c : wanted) bits = std::max(bits, c.numerator().bit_length());
    EXPECT_GE(p.bits(common), bits);
    if (bits > 0) {
      EXPECT_EQ(p.bits(common), bits);
    }
  }
}

TEST(DyadicPolynomial, WhatIsValidIsRight) {
  int valid = 0, not_valid = 0;
  for (const unsigned bits : {3u, 12u, 20u, 30u, 45u, 61u}) {
    Draw draw(bits);
    for (int round = 0; round < 150; ++round) {
      const List a = draw.list(bits), b = draw.list(bits);
      const Reference ra = reference(a), rb = reference(b);
      const auto da = DyadicPolynomial::of(a), db = DyadicPolynomial::of(b);
      if (bits < 61) {
        expect_same(da, ra);
        expect_same(db, rb);
      }
      const auto square = product(sum(ra, rb, 1), sum(ra, rb, -1));
      const std::vector<std::pair<DyadicPolynomial, Reference>> all{
          {da + db, sum(ra, rb, 1)},
          {da - db, sum(ra, rb, -1)},
          {da * db, product(ra, rb)},
          {(da + db) * (da - db), square},
          {(da + db) * (da - db) + da, sum(square, ra, 1)},
          {da * db * db - da, sum(product(product(ra, rb), rb), ra, -1)}};
      for (const auto& [got, wanted] : all) {
        ++(got.is_valid() ? valid : not_valid);
        if (got.is_valid()) expect_same(got, wanted);
      }
    }
  }
  EXPECT_GT(valid, 2000);
  EXPECT_GT(not_valid, 500);
}

TEST(DyadicPolynomial, TheLargestNumbersAreWithinBounds) {
  const auto ones = [](unsigned bits, std::size_t size) {
    return List(size, Rational(Integer::power_of_two(bits) - Integer(1)));
  };
  // Four terms of 62 + 62 bits are 126 bits; with one bit more they are too many.
  const auto a = DyadicPolynomial::of(ones(62, 4)), b = DyadicPolynomial::of(ones(63, 4));
  expect_same(a * a, product(reference(ones(62, 4)), reference(ones(62, 4))));
  EXPECT_FALSE((a * b).is_valid());
  EXPECT_FALSE((a * a + a * a).is_valid());
}

TEST(DyadicPolynomial, OtherNumbersAreNotValid) {
  EXPECT_FALSE(DyadicPolynomial::of({}).is_valid());
  EXPECT_FALSE(DyadicPolynomial::of({Rational(Integer(1), Integer(3))}).is_valid());
  EXPECT_FALSE(DyadicPolynomial::of({Rational(Integer::power_of_two(63))}).is_valid());
  EXPECT_FALSE(DyadicPolynomial::of({Rational(Integer(1), Integer::power_of_two(63))}).is_valid());
  EXPECT_FALSE(DyadicPolynomial::of(List(DyadicPolynomial::kRoom + 1)).is_valid());
  const auto five = DyadicPolynomial::of(List(5, Rational(1)));
  const auto four = DyadicPolynomial::of(List(4, Rational(1)));
  EXPECT_TRUE((five * four).is_valid());
  EXPECT_FALSE((five * five).is_valid());
  EXPECT_FALSE((five * five + four).is_valid());
  EXPECT_FALSE((four * (five * five)).is_valid());
}

}  // namespace dyadic_polynomial_test
}  // namespace kinex

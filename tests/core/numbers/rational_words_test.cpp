// SPDX-License-Identifier: GPL-3.0-or-later
// Rational around the edges of a machine word: within the object, beyond it, and from the one to the other. The witness
// is GMP's mpq on its own.
#include <gmp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/rational.h"

namespace kinex {
namespace rational_words_test {

class Witness {
 public:
  explicit Witness(const std::string& text) : Witness() {
    mpq_set_str(q_, text.c_str(), 10);
    mpq_canonicalize(q_);
  }
  Witness(const Witness& other) : Witness() { mpq_set(q_, other.q_); }
  Witness& operator=(const Witness&) = delete;
  ~Witness() { mpq_clear(q_); }
  static Witness by(void (*f)(mpq_ptr, mpq_srcptr, mpq_srcptr), const Witness& a,
                    const Witness& b) {
    Witness result;
    f(result.q_, a.q_, b.q_);
    return result;
  }
  mpq_srcptr raw() const { return q_; }

 private:
  Witness() { mpq_init(q_); }
  mpq_t q_;
};

// Equal, canonical, and as GMP's own functions read it.
void expect_is(const Rational& value, const Witness& expected) {
  EXPECT_NE(mpq_equal(value.raw(), expected.raw()), 0) << value.to_string();
  EXPECT_EQ(value.sign(), mpq_sgn(expected.raw()));
  EXPECT_EQ(mpz_cmp(value.numerator().raw(), mpq_numref(expected.raw())), 0);
  EXPECT_EQ(mpz_cmp(value.denominator().raw(), mpq_denref(expected.raw())), 0);
}

// Around 0, 2^31, 2^32, 2^53, 2^62, 2^63, 2^64 and 2^128.
std::vector<std::string> integers() {
  std::vector<std::string> result{"0", "1", "2", "3", "6", "12", "1000000007"};
  mpz_t power;
  mpz_init(power);
  for (const unsigned long bits : {31UL, 32UL, 53UL, 62UL, 63UL, 64UL, 128UL}) {
    for (const long beside : {-1L, 0L, 1L}) {
      mpz_ui_pow_ui(power, 2, bits);
      beside < 0 ? mpz_sub_ui(power, power, 1)
                 : mpz_add_ui(power, power, static_cast<unsigned long>(beside));
      std::vector<char> digits(mpz_sizeinbase(power, 10) + 2);
      result.emplace_back(mpz_get_str(digits.data(), 10, power));
    }
  }
  mpz_clear(power);
  return result;
}

std::vector<std::string> fractions() {
  std::vector<std::string> result;
  const std::vector<std::string> all = integers();
  std::mt19937 random(1);
  for (const std::string& above : all) {
    result.push_back(above);
    result.push_back("-" + above);
    for (int i = 0; i < 3; ++i) {
      const std::string& below = all[1 + random() % (all.size() - 1)];
      result.push_back((i == 1 ? "-" : "") + above + "/" + below);
    }
  }
  return result;
}

Rational parsed(const std::string& text) {
  std::optional<Rational> value = Rational::parse(text);
  return *std::move(value);
}

TEST(RationalWords, EveryOperationIsThatOfGmp) {
  const std::vector<std::string> texts = fractions();
  for (const std::string& x : texts) {
    for (const std::string& y : texts) {
      SCOPED_TRACE(x + " and " + y);
      const Rational a = parsed(x), b = parsed(y);
      const Witness u(x), v(y);
      expect_is(a + b, Witness::by(mpq_add, u, v));
      expect_is(a - b, Witness::by(mpq_sub, u, v));
      expect_is(a * b, Witness::by(mpq_mul, u, v));
      if (!b.is_zero()) expect_is(a / b, Witness::by(mpq_div, u, v));
      EXPECT_EQ(a == b, mpq_equal(u.raw(), v.raw()) != 0);
      EXPECT_EQ(a <=> b, mpq_cmp(u.raw(), v.raw()) <=> 0);
      expect_is(-a, Witness::by(mpq_sub, Witness("0"), u));
      if (HasFailure()) return;
    }
  }
}

TEST(RationalWords, AnOperandMayBeTheResult) {
  for (const std::string& x : fractions()) {
    SCOPED_TRACE(x);
    const Witness u(x);
    Rational sum = parsed(x), difference = sum, product = sum, quotient = sum;
    const auto same = [](const Rational& value) -> const Rational& { return value; };
    sum += same(sum);
    difference -= same(difference);
    product *= same(product);
    expect_is(sum, Witness::by(mpq_add, u, u));
    expect_is(difference, Witness("0"));
    expect_is(product, Witness::by(mpq_mul, u, u));
    if (!quotient.is_zero()) {
      quotient /= same(quotient);
      expect_is(quotient, Witness("1"));
    }
  }
}

TEST(RationalWords, CopiesAndMovesBetweenBothForms) {
  const std::string within = "-7/3", beyond = "340282366920938463463374607431768211457/3";
  for (const std::string& x : {within, beyond}) {
    for (const std::string& y : {within, beyond, std::string("5")}) {
      SCOPED_TRACE(x + " and " + y);
      const Witness u(x), v(y);
      Rational a = parsed(x), b = parsed(y);
      Rational copy(a);
      expect_is(copy, u);
      copy = b;
      expect_is(copy, v);
      expect_is(b, v);
      Rational moved(std::move(copy));
      expect_is(moved, v);
      a = std::move(moved);
      expect_is(a, v);
      std::swap(a, b);
      expect_is(a, v);
      expect_is(b, v);
      Rational& self = a;
      a = self;
      expect_is(a, v);
      moved = parsed(x);  // what was moved from takes a new value
      expect_is(moved, u);
    }
  }
  std::vector<Rational> many;  // moves when the vector grows
  for (int i = 0; i < 100; ++i)
    many.push_back(parsed(i % 3 == 0 ? beyond : std::to_string(i) + "/7"));
  std::reverse(many.begin(), many.end());
  for (int i = 0; i < 100; ++i) {
    expect_is(many[static_cast<std::size_t>(99 - i)],
              Witness(i % 3 == 0 ? beyond : std::to_string(i) + "/7"));
  }
}

TEST(RationalWords, GmpMayWriteWhereItIsAskedTo) {
  Rational value(7);
  mpq_mul_2exp(value.edit(), value.raw(), 200);
  expect_is(value, Witness("11248566309812931928793734646388138217655420956479549847109632"));
  mpq_div_2exp(value.edit(), value.raw(), 201);
  expect_is(value, Witness("7/2"));
  value += Rational(1);
  expect_is(value, Witness("9/2"));
  value.set_words(-3, 4);
  expect_is(value, Witness("-3/4"));
}

// Long sums leave words and come back to them.
TEST(RationalWords, SumsThatGrowAndShrink) {
  std::mt19937_64 random(7);
  std::vector<Rational> terms;
  Rational sum;
  for (int i = 0; i < 60; ++i) {
    const auto n = static_cast<std::int64_t>(random() >> 2),
               d = static_cast<std::int64_t>(1 + (random() >> 40));
    terms.emplace_back(Integer(i % 2 == 0 ? n : -n), Integer(d));
    const Witness whole(sum.to_string()), term(terms.back().to_string());
    sum += terms.back();
    expect_is(sum, Witness::by(mpq_add, whole, term));
  }
  for (const Rational& term : terms) sum -= term;
  expect_is(sum, Witness("0"));
  EXPECT_EQ(sum, Rational());
}

}  // namespace rational_words_test
}  // namespace kinex

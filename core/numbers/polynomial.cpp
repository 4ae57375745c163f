// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/polynomial.h"

#include <algorithm>
#include <utility>

#include "core/numbers/check.h"

namespace kinex {

Polynomial::Polynomial(std::vector<Integer> coefficients) : c_(std::move(coefficients)) { strip(); }

void Polynomial::strip() {
  while (!c_.empty() && c_.back().is_zero()) c_.pop_back();
}

Polynomial Polynomial::from_rationals(const std::vector<Rational>& coefficients) {
  Integer denominator(1);
  for (const Rational& c : coefficients) {
    mpz_lcm(denominator.raw(), denominator.raw(), mpq_denref(c.raw()));
  }
  std::vector<Integer> integers(coefficients.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    mpz_divexact(integers[i].raw(), denominator.raw(), mpq_denref(coefficients[i].raw()));
    mpz_mul(integers[i].raw(), integers[i].raw(), mpq_numref(coefficients[i].raw()));
  }
  return Polynomial(std::move(integers)).primitive_part();
}

std::size_t Polynomial::max_bits() const {
  std::size_t bits = 0;
  for (const Integer& c : c_) bits = std::max(bits, c.bit_length());
  return bits;
}

Polynomial Polynomial::derivative() const {
  Polynomial result;
  if (c_.size() < 2) return result;
  result.c_.resize(c_.size() - 1);
  for (std::size_t i = 1; i < c_.size(); ++i) {
    mpz_mul_ui(result.c_[i - 1].raw(), c_[i].raw(), i);
  }
  return result;
}

Sign Polynomial::sign_at(const Rational& t) const {
  if (c_.empty()) return Sign::kZero;
  if (t.is_zero()) return to_sign(c_.front().sign());
  const mpz_srcptr numerator = mpq_numref(t.raw());
  const mpz_srcptr denominator = mpq_denref(t.raw());
  const std::size_t twos = mpz_scan1(denominator, 0);
  if (twos + 1 == mpz_sizeinbase(denominator, 2)) {
    return to_sign(scaled_value_at_dyadic(t.numerator(), twos).sign());
  }
  // Homogeneous Horner: c_d n^d + c_{d-1} n^{d-1} m + ... with m > 0.
  Integer value = c_.back();
  Integer weight(1);
  for (std::size_t i = c_.size() - 1; i-- > 0;) {
    mpz_mul(value.raw(), value.raw(), numerator);
    mpz_mul(weight.raw(), weight.raw(), denominator);
    value.add_product(c_[i], weight);
  }
  return to_sign(value.sign());
}

Integer Polynomial::scaled_value_at_dyadic(const Integer& numerator, unsigned long exponent) const {
  Integer value;
  if (c_.empty()) return value;
  // Room for the results from the start: growing numbers step by step costs more than the products.
  const std::size_t bits =
      max_bits() + (c_.size() - 1) * std::max<std::size_t>(numerator.bit_length(), exponent) + 128;
  Integer product;
  Integer term;
  mpz_realloc2(value.raw(), bits);
  mpz_realloc2(product.raw(), bits);
  mpz_realloc2(term.raw(), bits);
  mpz_set(value.raw(), c_.back().raw());
  unsigned long shift = 0;
  for (std::size_t i = c_.size() - 1; i-- > 0;) {
    mpz_mul(product.raw(), value.raw(), numerator.raw());
    shift += exponent;
    if (c_[i].is_zero()) {
      mpz_swap(value.raw(), product.raw());
    } else {
      mpz_mul_2exp(term.raw(), c_[i].raw(), shift);
      mpz_add(value.raw(), product.raw(), term.raw());
    }
  }
  return value;
}

Sign Polynomial::sign_at_dyadic(const Integer& numerator, unsigned long exponent) const {
  if (c_.empty()) return Sign::kZero;
  if (numerator.is_zero()) return to_sign(c_.front().sign());
  const unsigned long common = std::min<unsigned long>(exponent, numerator.trailing_zeros());
  if (common == 0) return to_sign(scaled_value_at_dyadic(numerator, exponent).sign());
  return to_sign(scaled_value_at_dyadic(numerator >> common, exponent - common).sign());
}

Rational Polynomial::value_at(const Rational& t) const {
  if (c_.empty()) return Rational(0);
  Integer value = c_.back();
  Integer weight(1);
  for (std::size_t i = c_.size() - 1; i-- > 0;) {
    mpz_mul(value.raw(), value.raw(), mpq_numref(t.raw()));
    mpz_mul(weight.raw(), weight.raw(), mpq_denref(t.raw()));
    value.add_product(c_[i], weight);
  }
  return Rational(value, weight);
}

Sign Polynomial::sign_at_plus_infinity() const {
  return c_.empty() ? Sign::kZero : to_sign(c_.back().sign());
}

Sign Polynomial::sign_at_minus_infinity() const {
  const Sign s = sign_at_plus_infinity();
  return degree() % 2 == 0 ? s : -s;
}

Integer Polynomial::content() const {
  Integer result;
  for (const Integer& c : c_) {
    mpz_gcd(result.raw(), result.raw(), c.raw());
    if (mpz_cmp_ui(result.raw(), 1) == 0) break;
  }
  return result;
}

Polynomial Polynomial::primitive_part() const {
  Polynomial result = *this;
  const Integer divisor = content();
  if (c_.empty() || mpz_cmp_ui(divisor.raw(), 1) == 0) return result;
  for (Integer& c : result.c_) c.divide_exactly(divisor);
  return result;
}

Polynomial Polynomial::canonical() const {
  Polynomial result = primitive_part();
  if (!c_.empty() && c_.back().sign() < 0) {
    for (Integer& c : result.c_) c.negate();
  }
  return result;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial result = a.degree() >= b.degree() ? a : b;
  const Polynomial& other = a.degree() >= b.degree() ? b : a;
  for (std::size_t i = 0; i < other.c_.size(); ++i) result.c_[i] += other.c_[i];
  result.strip();
  return result;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  Polynomial result = a;
  if (result.c_.size() < b.c_.size()) result.c_.resize(b.c_.size());
  for (std::size_t i = 0; i < b.c_.size(); ++i) result.c_[i] -= b.c_[i];
  result.strip();
  return result;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  if (a.is_zero() || b.is_zero()) return result;
  result.c_.resize(a.c_.size() + b.c_.size() - 1);
  for (std::size_t i = 0; i < a.c_.size(); ++i) {
    if (a.c_[i].is_zero()) continue;
    for (std::size_t j = 0; j < b.c_.size(); ++j) result.c_[i + j].add_product(a.c_[i], b.c_[j]);
  }
  return result;
}

Polynomial operator-(const Polynomial& a) {
  Polynomial result = a;
  for (Integer& c : result.c_) c.negate();
  return result;
}

std::string Polynomial::to_string() const {
  if (c_.empty()) return "0";
  std::string text;
  for (const Integer& c : c_) {
    if (!text.empty()) text += ' ';
    text += c.to_string();
  }
  return text;
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/dyadic_polynomial.h"

#include <algorithm>
#include <bit>

namespace kinex {
namespace {

using Unsigned128 = unsigned __int128;

Unsigned128 magnitude(Int128 value) {
  return value < 0 ? -static_cast<Unsigned128>(value) : static_cast<Unsigned128>(value);
}

unsigned bit_length(Unsigned128 value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  if (high != 0) return 64 + static_cast<unsigned>(std::bit_width(high));
  return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(value)));
}

}  // namespace

DyadicPolynomial DyadicPolynomial::of(const std::vector<Rational>& coefficients) {
  DyadicPolynomial p;
  if (coefficients.empty() || coefficients.size() > kRoom) return p;
  std::array<unsigned, kRoom> exponents{};
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const mpq_srcptr q = coefficients[i].raw();
    if (mpz_fits_slong_p(mpq_numref(q)) == 0 || mpz_fits_slong_p(mpq_denref(q)) == 0) return p;
    const auto denominator = static_cast<std::uint64_t>(mpz_get_si(mpq_denref(q)));
    if (!std::has_single_bit(denominator)) return p;
    exponents[i] = static_cast<unsigned>(std::countr_zero(denominator));
    p.exponent_ = std::max(p.exponent_, exponents[i]);
  }
  // At most 63 + 62 bits.
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    p.c_[i] = Int128{mpz_get_si(mpq_numref(coefficients[i].raw()))} *
              (Int128{1} << (p.exponent_ - exponents[i]));
  }
  p.size_ = coefficients.size();
  p.denominator_bits_ = p.exponent_;
  p.valid_ = true;
  p.measure();
  return p;
}

void DyadicPolynomial::measure() {
  Unsigned128 all = 0;
  for (std::size_t i = 0; i < size_; ++i) all |= magnitude(c_[i]);
  bits_ = bit_length(all);
}

DyadicPolynomial DyadicPolynomial::sum(const DyadicPolynomial& a, const DyadicPolynomial& b,
                                       bool minus) {
  DyadicPolynomial r;
  if (!a.valid_ || !b.valid_) return r;
  r.exponent_ = std::max(a.exponent_, b.exponent_);
  const unsigned to_a = r.exponent_ - a.exponent_, to_b = r.exponent_ - b.exponent_;
  if (std::max(a.bits_ + to_a, b.bits_ + to_b) + 1 > kMostBits) return r;
  r.denominator_bits_ = a.denominator_bits_ == b.denominator_bits_
                            ? a.denominator_bits_
                            : a.denominator_bits_ + b.denominator_bits_;
  r.size_ = std::max(a.size_, b.size_);
  const Int128 factor_a = Int128{1} << to_a;
  const Int128 factor_b = minus ? -(Int128{1} << to_b) : Int128{1} << to_b;
  for (std::size_t i = 0; i < r.size_; ++i) r.c_[i] = a.c_[i] * factor_a + b.c_[i] * factor_b;
  r.valid_ = true;
  r.measure();
  return r;
}

DyadicPolynomial operator*(const DyadicPolynomial& a, const DyadicPolynomial& b) {
  DyadicPolynomial r;
  if (!a.valid_ || !b.valid_ || a.size_ + b.size_ > DyadicPolynomial::kRoom + 1) return r;
  const auto terms = static_cast<unsigned>(std::min(a.size_, b.size_));
  const auto carries = static_cast<unsigned>(std::bit_width(terms - 1));
  if (a.bits_ + b.bits_ + carries > DyadicPolynomial::kMostBits) return r;
  r.exponent_ = a.exponent_ + b.exponent_;
  r.denominator_bits_ = a.denominator_bits_ + b.denominator_bits_;
  r.size_ = a.size_ + b.size_ - 1;
  const bool narrow = a.bits_ <= 63 && b.bits_ <= 63;
  for (std::size_t i = 0; i < a.size_; ++i) {
    if (a.c_[i] == 0) continue;
    if (narrow) {
      const auto factor = static_cast<std::int64_t>(a.c_[i]);
      for (std::size_t j = 0; j < b.size_; ++j) {
        r.c_[i + j] += Int128{factor} * static_cast<std::int64_t>(b.c_[j]);
      }
    } else {
      for (std::size_t j = 0; j < b.size_; ++j) r.c_[i + j] += a.c_[i] * b.c_[j];
    }
  }
  r.valid_ = true;
  r.measure();
  return r;
}

void DyadicPolynomial::write(unsigned common, std::vector<Rational>& out) const {
  static_assert(GMP_NUMB_BITS == 64);
  std::size_t size = size_;
  while (size > 1 && c_[size - 1] == 0) --size;
  out.resize(size);
  const unsigned shift = common - exponent_;
  for (std::size_t i = 0; i < size; ++i) {
    const mpq_ptr q = out[i].edit();
    const Unsigned128 value = magnitude(c_[i]);
    mp_limb_t* limbs = mpz_limbs_write(mpq_numref(q), 2);
    limbs[0] = static_cast<mp_limb_t>(value);
    limbs[1] = static_cast<mp_limb_t>(value >> 64);
    mpz_limbs_finish(mpq_numref(q), c_[i] < 0 ? -2 : 2);
    if (shift > 0) mpz_mul_2exp(mpq_numref(q), mpq_numref(q), shift);
    mpz_set_ui(mpq_denref(q), 1);
  }
}

}  // namespace kinex

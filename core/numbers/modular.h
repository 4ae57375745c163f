// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials modulo word-size primes, for polynomial_gcd.cpp; residues are in Montgomery form.
#ifndef KINEX_CORE_NUMBERS_MODULAR_H
#define KINEX_CORE_NUMBERS_MODULAR_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/numbers/polynomial.h"

namespace kinex {

// Arithmetic modulo an odd prime below 2^62. A residue r is represented by r * 2^64 mod p.
class PrimeField {
 public:
  explicit PrimeField(std::uint64_t prime);

  std::uint64_t prime() const { return p_; }
  std::uint64_t add(std::uint64_t a, std::uint64_t b) const {
    const std::uint64_t s = a + b;
    return s >= p_ ? s - p_ : s;
  }
  std::uint64_t subtract(std::uint64_t a, std::uint64_t b) const {
    return a >= b ? a - b : a + p_ - b;
  }
  std::uint64_t multiply(std::uint64_t a, std::uint64_t b) const {
    return reduce(static_cast<unsigned __int128>(a) * b);
  }
  // a*b - c*d.
  std::uint64_t cross(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) const {
    // a*b + c*(p - d) < 2 p^2 < 2^125: one reduction for both products.
    return reduce(static_cast<unsigned __int128>(a) * b +
                  static_cast<unsigned __int128>(c) * (p_ - d));
  }
  std::uint64_t inverse(std::uint64_t a) const;  // requires a != 0
  std::uint64_t from_word(std::uint64_t value) const { return multiply(value % p_, r2_); }
  std::uint64_t from_integer(const Integer& value) const {
    return multiply(mpz_fdiv_ui(value.raw(), p_), r2_);
  }
  std::uint64_t to_word(std::uint64_t a) const { return reduce(a); }

 private:
  std::uint64_t reduce(unsigned __int128 t) const {
    const std::uint64_t m = static_cast<std::uint64_t>(t) * negative_inverse_;
    // t + m p < 2^126 + 2^126.
    const auto r = static_cast<std::uint64_t>((t + static_cast<unsigned __int128>(m) * p_) >> 64);
    return r >= p_ ? r - p_ : r;
  }
  std::uint64_t p_;
  std::uint64_t negative_inverse_;  // -1/p mod 2^64
  std::uint64_t r2_;                // 2^128 mod p
};

// A fixed descending sequence of primes that starts with 2^61 - 1; each next() returns one more.
class PrimeSequence {
 public:
  std::uint64_t next();

 private:
  std::uint64_t last_ = 0;
  std::size_t taken_ = 0;  // entries of a table; beyond it, primes are searched for
};

using Residues = std::vector<std::uint64_t>;  // low degree first, no leading zeros

Residues residues(const PrimeField& field, const Polynomial& p);  // p modulo the prime
// A greatest common divisor, up to a unit; destroys its arguments.
Residues gcd(const PrimeField& field, Residues a, Residues b);

}  // namespace kinex

#endif

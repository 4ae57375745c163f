// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/modular.h"

#include <array>
#include <utility>

namespace kinex {

namespace {

constexpr std::uint64_t kFirstPrime = (std::uint64_t{1} << 61) - 1;

// The first primes of the sequence are kFirstPrime minus these; a primality proof takes longer than
// most of the gcds that need the prime.
constexpr std::array<std::uint16_t, 64> kBelowFirst = {
    0,    30,   44,   228,  258,  282,  338,  390,  402,  464,  530,  578,  674,  758,  798,  818,
    828,  842,  858,  938,  984,  1014, 1152, 1194, 1214, 1280, 1298, 1350, 1370, 1424, 1488, 1524,
    1532, 1542, 1608, 1620, 1668, 1740, 1752, 1812, 1844, 1848, 1854, 1862, 1868, 1908, 1920, 1922,
    1944, 1958, 2022, 2082, 2114, 2132, 2184, 2370, 2372, 2382, 2384, 2400, 2538, 2550, 2594, 2604,
};

std::uint64_t power(const PrimeField& field, std::uint64_t base, std::uint64_t exponent) {
  std::uint64_t result = field.from_word(1);
  for (; exponent != 0; exponent >>= 1) {
    if (exponent & 1) result = field.multiply(result, base);
    base = field.multiply(base, base);
  }
  return result;
}

// Miller-Rabin with the first twelve primes as bases: deterministic below 3.3e24 (Sorenson, Webster
// 2015). n odd, n > 37.
bool is_prime(std::uint64_t n) {
  constexpr std::array<std::uint64_t, 12> kBases = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  for (const std::uint64_t base : kBases) {
    if (n % base == 0) return false;
  }
  const PrimeField field(n);
  const std::uint64_t one = field.from_word(1);
  const std::uint64_t minus_one = field.subtract(0, one);
  const int twos = __builtin_ctzll(n - 1);
  for (const std::uint64_t base : kBases) {
    std::uint64_t x = power(field, field.from_word(base), (n - 1) >> twos);
    bool witness = x != one && x != minus_one;
    for (int i = 1; i < twos && witness; ++i) {
      x = field.multiply(x, x);
      witness = x != minus_one;
    }
    if (witness) return false;
  }
  return true;
}

void strip(Residues& a) {
  while (!a.empty() && a.back() == 0) a.pop_back();
}

}  // namespace

PrimeField::PrimeField(std::uint64_t prime) : p_(prime) {
  std::uint64_t inverse = prime;  // correct to 3 bits; each step doubles that
  for (int i = 0; i < 5; ++i) inverse *= 2 - prime * inverse;
  negative_inverse_ = 0 - inverse;
  const std::uint64_t r = (0 - prime) % prime;  // 2^64 mod p
  r2_ = static_cast<std::uint64_t>(static_cast<unsigned __int128>(r) * r % prime);
}

std::uint64_t PrimeField::inverse(std::uint64_t a) const {
  // Euclid on the representative a = r 2^64 finds r^-1 2^-64; the result is r^-1 2^64. The factors
  // stay below p in absolute value.
  std::uint64_t older = p_;
  std::uint64_t newer = a;
  std::int64_t older_factor = 0;
  std::int64_t newer_factor = 1;
  while (newer != 0) {
    const std::uint64_t quotient = older / newer;
    older -= quotient * newer;
    older_factor -= static_cast<std::int64_t>(quotient) * newer_factor;
    std::swap(older, newer);
    std::swap(older_factor, newer_factor);
  }
  const std::uint64_t plain = older_factor < 0 ? p_ - static_cast<std::uint64_t>(-older_factor)
                                               : static_cast<std::uint64_t>(older_factor);
  return multiply(multiply(plain, r2_), r2_);
}

std::uint64_t PrimeSequence::next() {
  if (taken_ < kBelowFirst.size()) return last_ = kFirstPrime - kBelowFirst[taken_++];
  do {
    last_ -= 2;
  } while (!is_prime(last_));
  return last_;
}

Residues residues(const PrimeField& field, const Polynomial& p) {
  Residues result(p.coefficients().size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = field.from_integer(p[i]);
  strip(result);
  return result;
}

Residues gcd(const PrimeField& field, Residues a, Residues b) {
  if (a.size() < b.size()) std::swap(a, b);
  while (!b.empty()) {
    if (b.size() == 1) return b;
    while (a.size() >= b.size()) {
      // Division-free: lead(b) a - lead(a) x^k b.
      const std::uint64_t lead_a = a.back();
      const std::uint64_t lead_b = b.back();
      const std::size_t k = a.size() - b.size();
      for (std::size_t i = 0; i < k; ++i) a[i] = field.multiply(a[i], lead_b);
      for (std::size_t i = 0; i + 1 < b.size(); ++i) {
        a[k + i] = field.cross(a[k + i], lead_b, lead_a, b[i]);
      }
      a.pop_back();
      strip(a);
    }
    std::swap(a, b);
  }
  return a;
}

}  // namespace kinex

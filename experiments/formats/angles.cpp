// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/angles.h"

#include <cstdint>
#include <utility>

namespace kinex::formats {

namespace {

constexpr unsigned long kFixedBits = 70;  // of the terms of series

}  // namespace

Rational rounded(const Rational& value, unsigned long bits) {
  const Integer doubled = floor_divide(value.numerator() << (bits + 1), value.denominator());
  return Rational((doubled + Integer(1)) >> 1, Integer::power_of_two(bits));
}

Rational approximate_pi() {
  return Rational(Integer(std::int64_t{0x3243F6A8885A308D}), Integer::power_of_two(60));
}

// Newton's iteration decreases monotonically until it is stationary.
Rational approximate_root(const Rational& square) {
  Rational root = square + Rational(1);
  for (;;) {
    if (root.is_zero()) return root;
    Rational next = rounded((root + square / root) / Rational(2), kFixedBits);
    if (!(next < root)) return root;
    root = std::move(next);
  }
}

CosSin approximate_cos_sin(const Rational& angle) {
  CosSin result{1, 0};
  Rational term = 1;
  for (int k = 1; !term.is_zero(); ++k) {
    term = rounded(term * angle / Rational(k), kFixedBits);
    Rational& part = k % 2 == 0 ? result.cos : result.sin;
    if (k / 2 % 2 == 0) {
      part += term;
    } else {
      part -= term;
    }
  }
  return result;
}

}  // namespace kinex::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/rational_value.h"

namespace kinex {

std::optional<Rational> rational_value(RealRoot& root, RootCounters& counters) {
  if (root.is_rational()) return root.value();
  const Polynomial p = root.polynomial().primitive_part();
  const Integer c = abs(p.leading());
  root.refine_to(static_cast<long>(c.bit_length()), counters);  // narrower than 1 / c
  if (root.is_rational()) return root.value();
  // Multiples of 1 / c strictly inside: at most one.
  const Rational end = root.upper() * Rational(c);
  Integer candidate = floor_divide(end.numerator(), end.denominator());
  const Rational value(candidate, c);
  if (value <= root.lower() || value >= root.upper() || p.sign_at(value) != Sign::kZero) {
    return std::nullopt;
  }
  return value;
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/points/unit_directions.h"

#include "core/numbers/integer.h"

namespace kinex {

std::vector<DirectionVector> unit_directions_2(int k) {
  std::vector<DirectionVector> result;
  for (int i = 0; i < k; ++i) {
    const Rational q = Rational(i) / Rational(k);
    const Rational all = Rational(1) + q * q;
    result.push_back({(Rational(1) - q * q) / all, Rational(2) * q / all});
  }
  for (int i = 0; i < k; ++i) {  // turned by a right angle
    const DirectionVector& u = result[static_cast<std::size_t>(i)];
    result.push_back({-u[1], u[0]});
  }
  return result;
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/points/unit_directions_3.h"

#include <algorithm>
#include <cstddef>

#include "core/numbers/integer.h"

namespace kinex {

std::vector<DirectionVector> unit_directions_3(int k) {
  // The largest r with r - 1/2 <= (sqrt(2) - 1) k: (2r + 2k - 1)^2 <= 8 k^2.
  int r = 0;
  while ((2 * r + 2 * k + 1) * (2 * r + 2 * k + 1) <= 8 * k * k) ++r;
  std::vector<DirectionVector> result;
  for (std::size_t last = 3; last-- > 0;) {
    for (int i = -r; i <= r; ++i) {
      for (int j = -r; j <= r; ++j) {
        const Rational a = Rational(i) / Rational(k), b = Rational(j) / Rational(k);
        const Rational squares = a * a + b * b, all = Rational(1) + squares;
        DirectionVector u(3);
        u[(last + 1) % 3] = Rational(2) * a / all;
        u[(last + 2) % 3] = Rational(2) * b / all;
        u[last] = (Rational(1) - squares) / all;
        // A vector may be that of two axes.
        const DirectionVector opposite{-u[0], -u[1], -u[2]};
        const auto is_there = [&](const DirectionVector& v) {
          return std::find(result.begin(), result.end(), v) != result.end();
        };
        if (!is_there(u) && !is_there(opposite)) result.push_back(u);
      }
    }
  }
  return result;
}

std::vector<DirectionVector> unit_directions(int k, int dimension) {
  return dimension == 2 ? unit_directions_2(k) : unit_directions_3(k);
}

}  // namespace kinex

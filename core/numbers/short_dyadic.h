// SPDX-License-Identifier: GPL-3.0-or-later
// ShortDyadic: k / 2^s with few digits, in machine words. Instants of scenes on lattices, and of other
// scenes of small integers, often are such numbers.
#ifndef KINEX_CORE_NUMBERS_SHORT_DYADIC_H
#define KINEX_CORE_NUMBERS_SHORT_DYADIC_H

#include <cstdint>
#include <optional>

#include "core/numbers/rational.h"

namespace kinex {

// numerator / 2^places, with an odd numerator or no places; |numerator| <= 2^40, 0 <= places <= 10.
struct ShortDyadic {
  std::int64_t numerator = 0;
  int places = 0;

  // All exact.
  double to_double() const;
  Rational to_rational() const;
  void assign_to(Rational& target) const;  // allocates only if `target` lacks the room
};

// Of the dyadic numbers in [lo, hi] that one with the fewest places, and of several the least; nullopt
// if it is not short, or the ends are not finite. O(1), no allocation.
std::optional<ShortDyadic> shortest_dyadic(double lo, double hi);

}  // namespace kinex

#endif

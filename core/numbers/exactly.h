// SPDX-License-Identifier: GPL-3.0-or-later
// The exact value of a double that is known to be finite.
#ifndef KINEX_CORE_NUMBERS_EXACTLY_H
#define KINEX_CORE_NUMBERS_EXACTLY_H

#include <optional>

#include "core/numbers/check.h"
#include "core/numbers/rational.h"

namespace kinex {

// Throws std::logic_error for an infinity or NaN; if those may occur, use Rational::from_double.
inline Rational exactly(double value) {
  const std::optional<Rational> result = Rational::from_double(value);
  require(result.has_value(), "a double that is not finite has no exact value");
  return *result;
}

}  // namespace kinex

#endif

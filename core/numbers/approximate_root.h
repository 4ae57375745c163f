// SPDX-License-Identifier: GPL-3.0-or-later
// An approximate root, computed in doubles. It is a guess, not a bound: the caller verifies it by
// exact signs.
#ifndef KINEX_CORE_NUMBERS_APPROXIMATE_ROOT_H
#define KINEX_CORE_NUMBERS_APPROXIMATE_ROOT_H

#include <optional>

#include "core/numbers/polynomial.h"

namespace kinex {

struct ApproximateRoot {  // a guess
  Integer center;  // the guess is center / 2^center_exponent
  long center_exponent;
  long log_error;  // its estimated error is 2^log_error
};

// A guess for the root of p between lower / 2^exponent and upper / 2^exponent, where the sign of p
// changes from `sign_at_lower` to its opposite. nullopt if double precision does not suffice.
// Deterministic: only + - * / and scaling by powers of two.
std::optional<ApproximateRoot> approximate_root(const Polynomial& p, const Integer& lower,
                                                const Integer& upper, long exponent,
                                                int sign_at_lower);

}  // namespace kinex

#endif

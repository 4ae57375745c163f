// SPDX-License-Identifier: GPL-3.0-or-later
// A guess for a root in double precision, to be verified by exact signs; not a bound of any kind.
#ifndef KINEX_CORE_NUMBERS_APPROXIMATE_ROOT_H
#define KINEX_CORE_NUMBERS_APPROXIMATE_ROOT_H

#include <optional>

#include "core/numbers/polynomial.h"

namespace kinex {

struct ApproximateRoot {
  Integer center;  // the guess is center / 2^center_exponent
  long center_exponent;
  long log_error;  // its estimated error is 2^log_error
};

// A root of p between lower / 2^exponent and upper / 2^exponent, where p changes sign from
// `sign_at_lower`; nullopt if double precision does not suffice. Deterministic: only + - * / and
// scaling by powers of two.
std::optional<ApproximateRoot> approximate_root(const Polynomial& p, const Integer& lower,
                                                const Integer& upper, long exponent,
                                                int sign_at_lower);

}  // namespace kinex

#endif

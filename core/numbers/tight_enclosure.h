// SPDX-License-Identifier: GPL-3.0-or-later
// Narrows an enclosure to the doubles next to the root, by one exact value of the polynomial.
#ifndef KINEX_CORE_NUMBERS_TIGHT_ENCLOSURE_H
#define KINEX_CORE_NUMBERS_TIGHT_ENCLOSURE_H

#include <vector>

#include "core/numbers/integer.h"

namespace kinex {

// Requires: p has a root in [lo, hi], lo < hi. False: nothing was proved, and the ends are
// unchanged.
// Source: the mean value theorem. With m in the middle, root = m - p(m) / p'(x) for an x between
// the ends. p(m) is computed exactly, p' and its variation in doubles with error bounds.
bool tighten(const std::vector<Integer>& p, double& lo, double& hi);

}  // namespace kinex

#endif

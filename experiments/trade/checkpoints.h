// SPDX-License-Identifier: GPL-3.0-or-later
// Times at which the states of runs are compared.
#ifndef KINEX_EXPERIMENTS_TRADE_CHECKPOINTS_H
#define KINEX_EXPERIMENTS_TRADE_CHECKPOINTS_H

#include <vector>

#include "experiments/trade/trace.h"

namespace kinex::trade {

// Up to ten rational times inside (start, end), ascending. None is an instant of the trace, and
// each lies well inside the gap between two instants, so that a run whose times are nearly right is
// in the right state there:
//   - one in each gap that holds a time (12k + 1)/97 of the way, k = 1 .. 7 (no round fractions:
//     scenes tend to be degenerate at those)
//   - one where a quarter, a half and three quarters of the instants are over
// Requires start < end, and no instant beyond them. May refine the instants.
std::vector<Rational> checkpoints_of(ExactTrace& exact, const Rational& start, const Rational& end);

}  // namespace kinex::trade

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// What a log says of an instant: whether it is true of itself, and how two compare.
#ifndef KINEX_EXPERIMENTS_LOG_INSTANT_H
#define KINEX_EXPERIMENTS_LOG_INSTANT_H

#include <string>

#include "core/real_root.h"
#include "experiments/log_reader.h"

namespace kinex {

// The same text: polynomial, root, interval and decimal.
bool same_text(const LogInstant& a, const LogInstant& b);

// What is wrong with the claim of an instant about itself; empty if it holds. By name: canonical
// polynomial, the minimal one where the instant is rational, an interval with that root and no
// other, the decimal. By interval: its ends, the decimal. By decimal: that it is a number.
std::string instant_problem(const LogInstant& instant, const LogHeader& header);

// The number that a name is of. Requires a log with names whose instant has no problem.
RealRoot root_of(const LogInstant& instant);

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The instants of a log: their self-consistency, and the comparison of two.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_INSTANT_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_INSTANT_H

#include <string>

#include "core/numbers/real_root.h"
#include "experiments/formats/log_reader.h"

namespace kinex::formats {

// The same text: polynomial, root, interval and decimal.
bool same_text(const LogInstant& a, const LogInstant& b);

// The defect of an instant; empty if it is consistent. Checked are
//   by name      canonical polynomial, the minimal one for a rational instant; interval with that
//                root and no other; the decimal
//   by interval  its ends, the decimal
//   by decimal   that it is a number
std::string instant_problem(const LogInstant& instant, const LogHeader& header);

// The number with this name. Requires a log with names, and an instant without a problem.
RealRoot root_of(const LogInstant& instant);

}  // namespace kinex::formats

#endif

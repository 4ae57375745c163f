// SPDX-License-Identifier: GPL-3.0-or-later
// Times in messages: exact if the exact text is short.
#ifndef KINEX_CORE_NUMBERS_TIME_TEXT_H
#define KINEX_CORE_NUMBERS_TIME_TEXT_H

#include <string>

#include "core/numbers/instant_name.h"
#include "core/numbers/rational.h"
#include "core/numbers/real_root.h"

namespace kinex {

//   "7"                                integers       (at most 20 characters)
//   "3/2 (1.5)", "1/3 (0.3333333333)"  fractions      (at most 20 characters)
//   "about 0.3333333333"               other numbers  (ten significant digits, maybe an exponent)
std::string time_text(const Rational& t);
// The same of an instant that is named in full (InstantDetail::kName); about its decimal where it is
// irrational, or the arithmetic inexact.
std::string time_text(const InstantName& instant);
// The same of a root of p, which is not zero: "1/3 (0.3333333333)", "about 1.414213".
std::string time_text(const Polynomial& p, RealRoot& root, RootCounters& counters);

}  // namespace kinex

#endif

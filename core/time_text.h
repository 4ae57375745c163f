// SPDX-License-Identifier: GPL-3.0-or-later
// A time in a message: short, and exact where that is short.
#ifndef KINEX_CORE_TIME_TEXT_H
#define KINEX_CORE_TIME_TEXT_H

#include <string>

#include "core/rational.h"

namespace kinex {

// "7"; "3/2 (1.5)" or "1/3 (0.3333333333)" where the fraction has at most 20 characters; else
// "about 0.3333333333" (ten significant digits, with an exponent where the number calls for one).
std::string time_text(const Rational& t);

}  // namespace kinex

#endif

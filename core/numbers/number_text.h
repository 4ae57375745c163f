// SPDX-License-Identifier: GPL-3.0-or-later
// Appends exact numbers to a string, in the form of to_string(), without a temporary string.
#ifndef KINEX_CORE_NUMBERS_NUMBER_TEXT_H
#define KINEX_CORE_NUMBERS_NUMBER_TEXT_H

#include <string>

#include "core/numbers/rational.h"

namespace kinex {

// Decimal digits, after '-' if the value is negative. Values of up to 128 bits are converted in
// machine words, others by GMP.
void append(std::string& out, const Integer& value);
// "p" or "p/q", in lowest terms, q > 1.
void append(std::string& out, const Rational& value);

}  // namespace kinex

#endif

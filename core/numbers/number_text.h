// SPDX-License-Identifier: GPL-3.0-or-later
// Appends exact numbers to a text, as to_string() writes them, without a temporary string.
#ifndef KINEX_CORE_NUMBERS_NUMBER_TEXT_H
#define KINEX_CORE_NUMBERS_NUMBER_TEXT_H

#include <string>

#include "core/numbers/rational.h"

namespace kinex {

// Decimal digits. Up to 128 bits in machine words.
void append(std::string& out, const Integer& value);
// "p" or "p/q".
void append(std::string& out, const Rational& value);

}  // namespace kinex

#endif

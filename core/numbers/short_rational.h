// SPDX-License-Identifier: GPL-3.0-or-later
// ShortRational: a fraction of two machine words, for hot paths in which GMP is too slow.
//
// Nearly all numbers of input files are short. A function may abstain but is never wrong; its caller
// then continues with Rational.
#ifndef KINEX_CORE_NUMBERS_SHORT_RATIONAL_H
#define KINEX_CORE_NUMBERS_SHORT_RATIONAL_H

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/numbers/rational.h"

namespace kinex {

// In lowest terms; denominator > 0.
struct ShortRational {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
};

// The value of "-7", "1/3" or "0.25" (see Rational::parse) with at most 18 digits above and 18 below.
// nullopt for all other text, be it a number or not. No allocation.
std::optional<ShortRational> parse_short(std::string_view text);

// `value` if both of its parts fit a word. No allocation.
std::optional<ShortRational> shortened(const Rational& value);

// target = value. No allocation.
void assign(Rational& target, const ShortRational& value);

// Whether a0 + a1 t = b0 + b1 t; nullopt where 128 bits do not hold the products.
std::optional<bool> equal_lines(const ShortRational& a0, const ShortRational& a1, const ShortRational& b0,
                                const ShortRational& b1, const ShortRational& t);

}  // namespace kinex

#endif

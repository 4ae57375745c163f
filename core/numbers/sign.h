// SPDX-License-Identifier: GPL-3.0-or-later
// Sign: the answer of a predicate. "Unknown" is never a Sign: filters return std::optional<Sign>.
#ifndef KINEX_CORE_NUMBERS_SIGN_H
#define KINEX_CORE_NUMBERS_SIGN_H

namespace kinex {

enum class Sign : signed char { kNegative = -1, kZero = 0, kPositive = 1 };  // of a number

constexpr Sign to_sign(int value) {  // the sign of an integer
  return value > 0 ? Sign::kPositive : value < 0 ? Sign::kNegative : Sign::kZero;
}
constexpr int to_int(Sign s) { return static_cast<int>(s); }  // -1, 0 or 1
constexpr Sign operator-(Sign s) { return to_sign(-to_int(s)); }  // of the negated number
constexpr Sign operator*(Sign a, Sign b) { return to_sign(to_int(a) * to_int(b)); }  // of a product

}  // namespace kinex

#endif

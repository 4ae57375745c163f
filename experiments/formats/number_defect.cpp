// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/number_defect.h"

#include <algorithm>
#include <cctype>

#include "core/numbers/rational.h"
#include "experiments/formats/json_document.h"

namespace kinex::formats {

namespace {

bool is_signed_digits(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

// A number but for its exponent, which is an integer.
bool is_number_of_another_exponent(std::string_view text) {
  const bool hexadecimal = text.find_first_of("xX") != text.npos;
  const std::size_t marker = text.find_last_of(hexadecimal ? "pP" : "eE");
  if (marker == text.npos || !is_signed_digits(text.substr(marker + 1))) return false;
  return Rational::parse(std::string(text.substr(0, marker + 1)) + "0").has_value();
}

bool has_zero_denominator(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == text.npos || !is_signed_digits(text.substr(0, slash))) return false;
  const std::string_view denominator = text.substr(slash + 1);
  return !denominator.empty() && denominator.find_first_not_of('0') == denominator.npos;
}

}  // namespace

NumberDefect number_defect(std::string_view text, const std::string& usual) {
  if (text.size() > kMaxNumberLength) {
    const std::string most = std::to_string(kMaxNumberLength);
    return {"has more than " + most + " characters", "write a number of at most " + most};
  }
  if (is_number_of_another_exponent(text)) {
    const std::string most = std::to_string(Rational::kMaxExponent);
    return {"has an exponent beyond " + most,
            "write a number with an exponent from -" + most + " to " + most};
  }
  if (has_zero_denominator(text)) return {"has the denominator 0", "write another denominator"};
  return {"is not a number", usual};
}

}  // namespace kinex::formats

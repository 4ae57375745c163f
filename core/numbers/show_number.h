// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the input as messages show them, however long they are.
#ifndef KINEX_CORE_NUMBERS_SHOW_NUMBER_H
#define KINEX_CORE_NUMBERS_SHOW_NUMBER_H

#include <cstddef>
#include <string>
#include <string_view>

#include "core/numbers/time_text.h"

namespace kinex {

// Numbers of so many characters are shown whole.
inline constexpr std::size_t kLongestShownNumber = 40;

// A number as it was written: "1e99999", and cut after 40 characters "7777... (50000 characters)".
inline std::string show_number(std::string_view text) {
  if (text.size() <= kLongestShownNumber) return std::string(text);
  return std::string(text.substr(0, kLongestShownNumber)) + "... (" + std::to_string(text.size()) +
         " characters)";
}

// A number whose text is not known: "-1/2", "about 1e+99999".
inline std::string show_number(const Rational& value) {
  std::string text = value.to_string();
  return text.size() <= kLongestShownNumber ? text : time_text(value);
}

}  // namespace kinex

#endif

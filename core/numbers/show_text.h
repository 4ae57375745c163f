// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of input as messages show them.
#ifndef KINEX_CORE_NUMBERS_SHOW_TEXT_H
#define KINEX_CORE_NUMBERS_SHOW_TEXT_H

#include <cstddef>
#include <string>
#include <string_view>

namespace kinex {

// A piece of input as it is shown in a message: printable ASCII in double quotes, cut after 40
// bytes.
inline std::string show_text(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  static constexpr char kHex[] = "0123456789abcdef";
  std::string result = "\"";
  for (std::size_t i = 0; i < text.size() && i < kLongest; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte >= 0x20 && byte < 0x7f) {
      result += text[i];
    } else {
      result += "\\x";
      result += kHex[byte >> 4];
      result += kHex[byte & 15];
    }
  }
  result += '"';
  if (text.size() > kLongest) result += " (" + std::to_string(text.size()) + " bytes)";
  return result;
}

}  // namespace kinex

#endif

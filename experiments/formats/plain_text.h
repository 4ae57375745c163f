// SPDX-License-Identifier: GPL-3.0-or-later
// Names of a scene or a log as reports and messages show them: on one line, and without what a terminal obeys.
#ifndef KINEX_EXPERIMENTS_FORMATS_PLAIN_TEXT_H
#define KINEX_EXPERIMENTS_FORMATS_PLAIN_TEXT_H

#include <cstddef>
#include <string>
#include <string_view>

namespace kinex::formats {

// True for the control characters of Unicode (C0, DEL, and C1, of two bytes in UTF-8) at text[i].
inline bool is_control(std::string_view text, std::size_t i) {
  const auto byte = static_cast<unsigned char>(text[i]);
  if (byte < 0x20 || byte == 0x7f) return true;
  return byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) >= 0x80 &&
         static_cast<unsigned char>(text[i + 1]) < 0xa0;
}

// The text with control characters as in JSON: "\n", "\u001b". `kept`: one that is left as it is.
inline std::string plain(std::string_view text, char kept = '\0') {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_control(text, i) || (kept != '\0' && text[i] == kept)) {
      result += text[i];
    } else if (text[i] == '\n') {
      result += "\\n";
    } else if (text[i] == '\t') {
      result += "\\t";
    } else if (text[i] == '\r') {
      result += "\\r";
    } else {
      if (static_cast<unsigned char>(text[i]) == 0xc2) ++i;
      const auto code = static_cast<unsigned char>(text[i]);
      result += "\\u00";
      result += kHex[code >> 4];
      result += kHex[code & 15];
    }
  }
  return result;
}

}  // namespace kinex::formats

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/html.h"

#include <cctype>

namespace kinex::lab {

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  // The table for terminals is ASCII; a page need not be.
  for (std::size_t at = 0; (at = result.find("+-", at)) != std::string::npos;) {
    result.replace(at, 2, "&plusmn;");
  }
  return result;
}

Html verdict_mark(Verdict verdict) {
  return html("<span class=\"v {0}\">{0}</span>", check_word(verdict));
}

Html verdict_mark(Verdict colour, std::string_view text, std::string_view title) {
  const Html shown = title.empty() ? Html() : html(" title=\"{}\"", title);
  return html("<span class=\"v text {}\"{}>{}</span>", check_word(colour), shown, text);
}

std::string anchor_of(std::string_view text) {
  std::string anchor;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      anchor += c;
    } else if (!anchor.empty() && anchor.back() != '-') {
      anchor += '-';
    }
  }
  while (!anchor.empty() && anchor.back() == '-') anchor.pop_back();
  return anchor;
}

}  // namespace kinex::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Html: text of a page of results. Plain text that becomes part of it is escaped.
#ifndef KINEX_EXPERIMENTS_LAB_HTML_H
#define KINEX_EXPERIMENTS_LAB_HTML_H

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/lab/verdict.h"

namespace kinex::lab {

// Escapes text for HTML; "+-" becomes one character.
std::string escape(std::string_view text);

class Html {
 public:
  Html() = default;
  Html(std::string_view plain) : text_(escape(plain)) {}             // NOLINT: escaped
  Html(const std::string& plain) : Html(std::string_view(plain)) {}  // NOLINT
  Html(const char* plain) : Html(std::string_view(plain)) {}         // NOLINT
  static Html markup(std::string text) {
    Html html;
    html.text_ = std::move(text);
    return html;
  }

  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }
  Html& operator+=(const Html& more) {
    text_ += more.text_;
    return *this;
  }
  friend Html operator+(Html a, const Html& b) { return std::move(a += b); }

 private:
  std::string text_;
};

// ---- html("<p>{} of {}</p>", name, count): `format` is HTML, arguments are Html, plain texts or numbers.

inline std::string_view html_argument(const Html& html) { return html.text(); }
inline std::string html_argument(std::string_view plain) { return escape(plain); }
inline std::string html_argument(const std::string& plain) { return escape(plain); }
inline std::string html_argument(const char* plain) { return escape(plain); }
inline int html_argument(int number) { return number; }
inline std::int64_t html_argument(std::int64_t number) { return number; }
inline std::uint64_t html_argument(std::uint64_t number) { return number; }
inline double html_argument(double number) { return number; }

template <class Argument>
using HtmlArgument = decltype(html_argument(std::declval<const Argument&>()));

template <class... Arguments>
Html html(fmt::format_string<HtmlArgument<Arguments>...> format, const Arguments&... arguments) {
  return Html::markup(fmt::format(format, html_argument(arguments)...));
}

// ---- parts

// A verdict's word in its colour.
Html verdict_mark(Verdict verdict);
// Any text in the colour of a verdict; `title`: shown while the pointer is on it; empty: none.
Html verdict_mark(Verdict colour, std::string_view text, std::string_view title = "");
// An anchor of letters, digits and "-" made of a text.
std::string anchor_of(std::string_view text);

}  // namespace kinex::lab

#endif

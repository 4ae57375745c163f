// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/json_defect.h"

#include <algorithm>

#include "core/numbers/rational.h"
#include "core/numbers/show_text.h"

namespace kinex::formats {

namespace {

constexpr const char* kCorrectIt =
    "correct the JSON there (no NaN, no comments, no trailing commas; text in UTF-8)";

// A part of a literal or of a number, or of what was meant to be one.
bool is_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' || c == '-' ||
         c == '.' || c == '_';
}

// The longest word that `offset` is in, or behind which it is (`behind`); otherwise the byte there.
std::string_view word_at(std::string_view text, std::size_t offset, bool behind = false) {
  std::size_t begin = offset, end = offset;
  while (end < text.size() && is_word(text[end])) ++end;
  while ((behind || end > offset) && begin > 0 && is_word(text[begin - 1])) --begin;
  return text.substr(begin, std::max<std::size_t>(1, end - begin));
}

JsonDefect not_allowed(std::string_view text, std::size_t offset, std::size_t length, const char* reason) {
  return {offset, show_text(text.substr(offset, length)) + " is not allowed here: " + reason, kCorrectIt};
}

JsonDefect ends_early(std::string_view text) {
  if (text.empty()) return {0, "the file is empty", "complete it to one JSON value"};
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return {text.size(), kEndsEarly + std::string(": it holds only white space"),
            "complete it to one JSON value"};
  }
  const std::string_view tail = text.substr(text.size() - std::min<std::size_t>(16, text.size()));
  return {text.size(), kEndsEarly + (", after " + show_text(tail)),
          "complete it to one JSON value"};
}

// The word at `offset`, where rapidjson stopped, in a text that has no string there.
JsonDefect word_defect(std::string_view text, rapidjson::ParseErrorCode code, std::size_t offset) {
  const bool in_value = code == rapidjson::kParseErrorValueInvalid ||
                        code == rapidjson::kParseErrorNumberMissFraction ||
                        code == rapidjson::kParseErrorNumberMissExponent;
  const std::string_view word = word_at(text, offset, in_value);
  const auto begin = static_cast<std::size_t>(word.data() - text.data());
  const auto refused = [&](const char* reason) { return not_allowed(text, begin, word.size(), reason); };
  if (begin < offset) return refused("it is neither a number nor true, false or null");
  switch (code) {
    case rapidjson::kParseErrorDocumentRootNotSingular:
      return refused("expected the end, after one value");
    case rapidjson::kParseErrorObjectMissName:
      return refused("expected a name in double quotes");
    case rapidjson::kParseErrorObjectMissColon:
      return refused("expected ':'");
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
      return refused("expected ',' or '}'");
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
      return refused("expected ',' or ']'");
    default:
      return refused("expected a value: [, {, a string, a number, true, false or null");
  }
}

JsonDefect escape_defect(std::string_view text, std::size_t offset, rapidjson::ParseErrorCode code) {
  // "\ud83d\ude" and what is shorter may be cut off.
  const std::string_view rest = text.substr(offset);
  if (rest.size() < 12 && rest.find_first_not_of("\\u0123456789abcdefABCDEF") == std::string_view::npos) {
    return ends_early(text);
  }
  if (code == rapidjson::kParseErrorStringEscapeInvalid) {
    return not_allowed(text, offset, 2, "no such escape in a string");
  }
  return not_allowed(text, offset, 6,
                     code == rapidjson::kParseErrorStringUnicodeEscapeInvalidHex
                         ? "expected four hexadecimal digits after \\u"
                         : "a high surrogate needs a low one, \\udc00 to \\udfff, after it");
}

}  // namespace

JsonDefect json_defect(std::string_view text, rapidjson::ParseErrorCode code, std::size_t offset) {
  if (offset >= text.size()) return ends_early(text);
  const auto byte = static_cast<unsigned char>(text[offset]);
  switch (code) {
    case rapidjson::kParseErrorStringMissQuotationMark:  // rapidjson takes NUL for the end
      return not_allowed(text, offset, 1, "a control character in a string, write \\u0000");
    case rapidjson::kParseErrorStringEscapeInvalid:
      if (byte < 0x20) {
        return not_allowed(text, offset, 1, "a control character in a string, write an escape");
      }
      return escape_defect(text, offset, code);
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
      return escape_defect(text, offset, code);
    case rapidjson::kParseErrorNumberTooBig:
      return range_defect(text, offset);
    default:
      return word_defect(text, code, offset);
  }
}

JsonDefect utf8_defect(std::string_view text, std::size_t offset) {
  return not_allowed(text, offset, 1, "a byte that is not UTF-8");
}

JsonDefect surrogate_defect(std::string_view text, std::size_t offset) {
  std::size_t at = text.find('\\', offset);
  while (at < text.size() && text.size() - at >= 6) {
    if (text[at + 1] == 'u' && (text[at + 2] == 'd' || text[at + 2] == 'D')) {
      if (text[at + 3] > '9' && text[at + 3] != 'a' && text[at + 3] != 'A' && text[at + 3] != 'b' &&
          text[at + 3] != 'B') {
        break;
      }
      at += text[at + 3] > '7' ? 10 : 4;  // a pair, of which both halves are escapes
    }
    at = text.find('\\', at + 2);
  }
  return not_allowed(text, std::min(at, text.size()), 6,
                     "a low surrogate, \\udc00 to \\udfff, needs a high one before it");
}

JsonDefect range_defect(std::string_view text, std::size_t offset) {
  const std::string most = std::to_string(Rational::kMaxExponent);
  return {offset, show_text(word_at(text, offset)) + " is beyond the range of a bare JSON number",
          "put it in double quotes; then it is read exactly, with an exponent from -" + most +
              " to " + most};
}

TextPosition position_in(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  TextPosition position;
  position.line += static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t newline = before.rfind('\n');
  position.column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1) + 1;
  return position;
}

}  // namespace kinex::formats

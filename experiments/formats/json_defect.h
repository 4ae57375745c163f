// SPDX-License-Identifier: GPL-3.0-or-later
// JsonDefect: what is wrong with a text that is no JSON, in words.
#ifndef KINEX_EXPERIMENTS_FORMATS_JSON_DEFECT_H
#define KINEX_EXPERIMENTS_FORMATS_JSON_DEFECT_H

#include <rapidjson/error/error.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace kinex::formats {

// What the problem of a text that stops in the midst of a value begins with.
inline constexpr const char* kEndsEarly = "the text ends too early";

struct JsonDefect {
  std::size_t offset = 0;  // in the text
  std::string problem, remedy;
};

// `code`: rapidjson's, found at `offset`. The defect lies where the word begins that is not allowed.
JsonDefect json_defect(std::string_view text, rapidjson::ParseErrorCode code, std::size_t offset);
// A byte that is no part of a UTF-8 character.
JsonDefect utf8_defect(std::string_view text, std::size_t offset);
// The string that begins at `offset` has half of a surrogate pair, as an escape.
JsonDefect surrogate_defect(std::string_view text, std::size_t offset);
// A bare number that no double comes near.
JsonDefect range_defect(std::string_view text, std::size_t offset);

// Line and column (from 1) of a byte of `text`.
struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;
};
TextPosition position_in(std::string_view text, std::size_t offset);

}  // namespace kinex::formats

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// JsonValue: a JSON tree that keeps numbers as written, so that nothing is rounded.
#ifndef KINEX_EXPERIMENTS_FORMATS_JSON_VALUE_H
#define KINEX_EXPERIMENTS_FORMATS_JSON_VALUE_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/numbers/stop.h"

namespace kinex {

struct JsonValue {
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  bool boolean = false;
  std::string text;               // kString: the string; kNumber: the token as written
  std::vector<JsonValue> items;   // kArray, kObject
  std::vector<std::string> keys;  // kObject: the name of each item, in the order of the file
  std::size_t offset = 0;         // where it ends (values) or begins (brackets) in the text

  // The member of that name, or nullptr.
  const JsonValue* find(std::string_view key) const;
};

// Limits; text beyond them is refused. The depth also bounds the recursion of every reader.
inline constexpr int kMaxJsonDepth = 64;
inline constexpr std::size_t kMaxNumberLength = 1000000;

// Parses the whole of `text`. Refuses (InputError with `file`, line and column):
//   - text that RFC 8259 forbids (NaN, comments, trailing commas, bytes that are not UTF-8)
//   - a name twice in one object
//   - nesting deeper than kMaxJsonDepth
//   - bare numbers beyond the range of a double (they can be quoted)
// `first_line`: the number of the text's first line in the file. `deadline`: polled between values;
// nullptr: none.
JsonValue parse_json(std::string_view text, const std::string& file, std::size_t first_line = 1,
                     Deadline* deadline = nullptr);

// Line and column (from 1) of a byte of `text`.
struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;
};
TextPosition position_in(std::string_view text, std::size_t offset);

// "a number", "an object" ... for messages.
std::string_view kind_name(JsonValue::Kind kind);
// A value as it is shown in a message: scalars in full (cut if long), others by their kind.
std::string shown(const JsonValue& value);

}  // namespace kinex

#endif

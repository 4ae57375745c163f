// SPDX-License-Identifier: GPL-3.0-or-later
// JsonDocument: a parsed JSON text, a tree of JsonValue. rapidjson reads it; numbers stay text.
#ifndef KINEX_EXPERIMENTS_FORMATS_JSON_DOCUMENT_H
#define KINEX_EXPERIMENTS_FORMATS_JSON_DOCUMENT_H

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/numbers/stop.h"
#include "experiments/formats/json_value.h"

namespace kinex::formats {

// Limits; text beyond them is refused. The depth also bounds the recursion of every reader.
inline constexpr int kMaxJsonDepth = 64;
inline constexpr std::size_t kMaxNumberLength = 1000000;

// Owns the bytes of strings and numbers, and the children of all values, in a few large blocks.
class JsonDocument {
 public:
  const JsonValue& root() const { return root_; }
  const JsonValue* operator->() const { return &root_; }
  const JsonValue& operator*() const { return root_; }

 private:
  friend class JsonTreeBuilder;

  std::vector<char> text_;  // empty: the text is another's
  std::vector<std::unique_ptr<JsonValue[]>> blocks_;
  JsonValue root_{};
};

// Parses the whole of `text`, of which it keeps a copy. Refuses (InputError with `file`, line and column):
//   - text that RFC 8259 forbids (NaN, comments, trailing commas, bytes that are not UTF-8)
//   - a name twice in one object
//   - nesting deeper than kMaxJsonDepth
//   - bare numbers beyond the range of a double (they can be quoted)
// A byte order mark at the beginning is skipped. `first_line`: the number of the text's first line in the
// file. `deadline`: polled between values; nullptr: none. Cost: linear, some 100 MB/s at least, and 24 bytes
// a value.
JsonDocument parse_json(std::string_view text, const std::string& file, std::size_t first_line = 1,
                        Deadline* deadline = nullptr);

// The same without the copy: changes `text` (closing quotation marks become NUL, nothing else), which must
// stay as it is as long as the document. A text with escapes is copied all the same, and one that is refused
// is as before.
JsonDocument parse_json_in_place(std::string& text, const std::string& file, Deadline* deadline = nullptr);

}  // namespace kinex::formats

#endif

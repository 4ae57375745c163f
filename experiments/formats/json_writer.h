// SPDX-License-Identifier: GPL-3.0-or-later
// JsonWriter: JSON text in exactly the order of the calls, so that equal data gives equal bytes.
#ifndef KINEX_EXPERIMENTS_FORMATS_JSON_WRITER_H
#define KINEX_EXPERIMENTS_FORMATS_JSON_WRITER_H

#include <cstdint>
#include <string>
#include <string_view>

#include "core/numbers/number_text.h"

namespace kinex::formats {

// Appends `text` (UTF-8) as a JSON string.
void append_json_string(std::string& out, std::string_view text);

// Appends to a string; begin_*/end_* must be balanced. No spaces but one after each ':' and ','.
class JsonWriter {
 public:
  explicit JsonWriter(std::string& out) : out_(out) {}

  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }
  JsonWriter& key(std::string_view name);
  JsonWriter& string(std::string_view text);
  // An exact number as a JSON string: "-7", "1/3".
  JsonWriter& quoted(const Integer& value) { return quote(value); }
  JsonWriter& quoted(const Rational& value) { return quote(value); }
  JsonWriter& number(std::uint64_t value);
  JsonWriter& number(int value);
  JsonWriter& real(double value);  // 6 significant digits; null if it is not finite
  JsonWriter& boolean(bool value) { return raw(value ? "true" : "false"); }
  JsonWriter& null() { return raw("null"); }
  // Text that is already JSON.
  JsonWriter& raw(std::string_view json);
  // The next value or key starts on a new line, indented by `spaces`.
  JsonWriter& line(int spaces);

 private:
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  void separate();
  template <class Number>
  JsonWriter& quote(const Number& value) {
    separate();
    out_ += '"';
    append(out_, value);
    out_ += '"';
    return *this;
  }

  std::string& out_;
  bool first_ = true;  // nothing yet in the innermost bracket
  bool after_key_ = false;
  int line_ = -1;  // pending line break
};

}  // namespace kinex::formats

#endif

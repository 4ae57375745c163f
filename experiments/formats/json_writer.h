// SPDX-License-Identifier: GPL-3.0-or-later
// JsonWriter: JSON text in exactly the order of the calls, so that equal data gives equal bytes.
#ifndef KINEX_EXPERIMENTS_FORMATS_JSON_WRITER_H
#define KINEX_EXPERIMENTS_FORMATS_JSON_WRITER_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

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
  // A text, a truth value, a whole number, a double as real(), an array of such values, an optional one
  // (null if it is absent), or anything with a function write_json(JsonWriter&, const Value&).
  template <class Value>
  JsonWriter& value(const Value& value);
  // Members of the open object, names and values in turn: members("n", 8, "law", "n log n").
  template <class Value, class... Rest>
  JsonWriter& members(std::string_view name, const Value& first, const Rest&... rest) {
    key(name).value(first);
    if constexpr (sizeof...(rest) > 0) members(rest...);
    return *this;
  }
  // An object of such members.
  template <class... Members>
  JsonWriter& object(const Members&... all) {
    return begin_object().members(all...).end_object();
  }
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

// ---- implementation

template <class Value>
inline constexpr bool kIsOptional = false;
template <class Value>
inline constexpr bool kIsOptional<std::optional<Value>> = true;
template <class Value>
inline constexpr bool kIsVector = false;
template <class Value>
inline constexpr bool kIsVector<std::vector<Value>> = true;

template <class Value>
JsonWriter& JsonWriter::value(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return boolean(value);
  } else if constexpr (std::is_integral_v<Value>) {
    return raw(std::to_string(value));
  } else if constexpr (std::is_floating_point_v<Value>) {
    return real(value);
  } else if constexpr (std::is_convertible_v<const Value&, std::string_view>) {
    return string(value);
  } else if constexpr (kIsOptional<Value>) {
    return value ? this->value(*value) : null();
  } else if constexpr (kIsVector<Value>) {
    begin_array();
    for (const auto& one : value) this->value(one);
    return end_array();
  } else {
    write_json(*this, value);
    return *this;
  }
}

}  // namespace kinex::formats

#endif

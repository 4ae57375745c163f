// SPDX-License-Identifier: GPL-3.0-or-later
// FieldWriter and FieldReader: exact conversion of values to text and back, by one function:
//
//   template <class Archive> void fields(Archive& archive, Point& p) { archive(p.x, p.y); }
//
// Values that differ between two runs go to a text of their own: archive.times(p.seconds).
// The texts have no names and no types: only the program that wrote them can read them. Numbers are
// followed by a space; strings are preceded by their length, containers by their size.
#ifndef KINEX_EXPERIMENTS_LAB_FIELD_ARCHIVE_H
#define KINEX_EXPERIMENTS_LAB_FIELD_ARCHIVE_H

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/numbers/rational.h"

namespace kinex::lab {

class FieldWriter {
 public:
  template <class... Values>
  void operator()(Values&... values) {
    (put(values), ...);
  }
  template <class... Values>
  void times(Values&... values) {
    std::swap(text, times_text);
    (put(values), ...);
    std::swap(text, times_text);
  }
  std::string text, times_text;

 private:
  template <class Value>
  void put(Value& value) {
    if constexpr (std::is_same_v<Value, bool> || std::is_enum_v<Value>) {
      text += std::to_string(static_cast<long>(value)) + " ";
    } else if constexpr (std::is_integral_v<Value>) {
      text += std::to_string(value) + " ";
    } else if constexpr (std::is_floating_point_v<Value>) {
      char number[40];
      std::snprintf(number, sizeof number, "%a ", value);
      text += number;
    } else {
      fields(*this, value);
    }
  }
  void put(std::string& value) { text += std::to_string(value.size()) + ":" + value + " "; }
  void put(Integer& value) {
    std::string digits = value.to_string();
    put(digits);
  }
  void put(Rational& value) {
    std::string fraction = value.to_string();
    put(fraction);
  }
  template <class Value>
  void put(std::optional<Value>& value) {
    bool is_there = value.has_value();
    put(is_there);
    if (is_there) put(*value);
  }
  template <class Value>
  void put(std::vector<Value>& values) {
    std::size_t size = values.size();
    put(size);
    for (Value& value : values) put(value);
  }
  template <class Value>
  void put(std::deque<Value>& values) {
    std::size_t size = values.size();
    put(size);
    for (Value& value : values) put(value);
  }
  template <class Value, std::size_t kSize>
  void put(std::array<Value, kSize>& values) {
    for (Value& value : values) put(value);
  }
  template <class Key, class Value>
  void put(std::map<Key, Value>& values) {
    std::size_t size = values.size();
    put(size);
    for (auto& [key, value] : values) {
      Key copy = key;
      put(copy);
      put(value);
    }
  }
};

// Throws std::runtime_error for a text that is not what was written.
class FieldReader {
 public:
  explicit FieldReader(std::string_view text, std::string_view times = "")
      : rest_(text), times_(times) {}
  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  template <class... Values>
  void times(Values&... values) {
    std::swap(rest_, times_);
    (get(values), ...);
    std::swap(rest_, times_);
  }
  bool at_end() const { return rest_.empty() && times_.empty(); }

 private:
  [[noreturn]] static void fail() { throw std::runtime_error("not what was written"); }

  std::string_view until(char end) {
    const std::size_t at = rest_.find(end);
    if (at == rest_.npos) fail();
    const std::string_view token = rest_.substr(0, at);
    rest_.remove_prefix(at + 1);
    return token;
  }
  template <class Value>
  static Value whole(std::string_view token) {
    Value value{};
    const auto [rest, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error != std::errc() || rest != token.data() + token.size()) fail();
    return value;
  }
  template <class Value>
  void get(Value& value) {
    if constexpr (std::is_same_v<Value, bool> || std::is_enum_v<Value>) {
      value = static_cast<Value>(whole<long>(until(' ')));
    } else if constexpr (std::is_integral_v<Value>) {
      value = whole<Value>(until(' '));
    } else if constexpr (std::is_floating_point_v<Value>) {
      const std::string number(until(' '));
      char* end = nullptr;
      value = static_cast<Value>(std::strtod(number.c_str(), &end));
      if (number.empty() || *end != '\0') fail();
    } else {
      fields(*this, value);
    }
  }
  void get(std::string& value) {
    const std::size_t size = whole<std::size_t>(until(':'));
    if (rest_.size() < size + 1 || rest_[size] != ' ') fail();
    value = rest_.substr(0, size);
    rest_.remove_prefix(size + 1);
  }
  void get(Integer& value) {
    std::string digits;
    get(digits);
    const std::optional<Integer> number = Integer::parse(digits);
    if (!number) fail();
    value = *number;
  }
  void get(Rational& value) {
    std::string fraction;
    get(fraction);
    const std::optional<Rational> number = Rational::parse(fraction);
    if (!number) fail();
    value = *number;
  }
  template <class Value>
  void get(std::optional<Value>& value) {
    bool is_there = false;
    get(is_there);
    value.reset();
    if (is_there) get(value.emplace());
  }
  template <class Value>
  void get(std::vector<Value>& values) {
    const std::size_t size = whole<std::size_t>(until(' '));
    if (size > rest_.size()) fail();
    values.assign(size, Value{});
    for (Value& value : values) get(value);
  }
  template <class Value>
  void get(std::deque<Value>& values) {
    const std::size_t size = whole<std::size_t>(until(' '));
    if (size > rest_.size()) fail();
    values.assign(size, Value{});
    for (Value& value : values) get(value);
  }
  template <class Value, std::size_t kSize>
  void get(std::array<Value, kSize>& values) {
    for (Value& value : values) get(value);
  }
  template <class Key, class Value>
  void get(std::map<Key, Value>& values) {
    const std::size_t size = whole<std::size_t>(until(' '));
    values.clear();
    for (std::size_t i = 0; i < size; ++i) {
      Key key{};
      get(key);
      get(values[key]);
    }
  }
  std::string_view rest_, times_;
};

// The two texts of a value.
struct Fields {
  std::string exact, times;
};

template <class Value>
Fields to_fields(Value value) {
  FieldWriter writer;
  writer(value);
  return {std::move(writer.text), std::move(writer.times_text)};
}

// nullopt if the texts are not what was written.
template <class Value>
std::optional<Value> from_fields(const Fields& fields) {
  Value value;
  try {
    FieldReader reader(fields.exact, fields.times);
    reader(value);
    if (!reader.at_end()) return std::nullopt;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  return value;
}

}  // namespace kinex::lab

#endif

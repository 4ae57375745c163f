// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/json_value.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "experiments/formats/input_error.h"

namespace kinex {

namespace {

// Reads bytes for nlohmann's lexer and shows the handler below its position.
struct TrackedBytes {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  const char** reached;

  reference operator*() const { return *at; }
  TrackedBytes& operator++() {
    *reached = ++at;
    return *this;
  }
  friend bool operator==(const TrackedBytes& a, const TrackedBytes& b) { return a.at == b.at; }
};

class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const char* const* reached, Deadline* deadline)
      : text_(text), reached_(reached), deadline_(deadline) {}

  JsonValue take() { return std::move(root_); }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }
  std::size_t where() const { return where_; }

  bool null() override {
    add(JsonValue::Kind::kNull);
    return true;
  }
  bool boolean(bool value) override {
    add(JsonValue::Kind::kBoolean).boolean = value;
    return true;
  }
  bool number_integer(number_integer_t value) override { return number(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(std::to_string(value)); }
  bool number_float(number_float_t, const string_t& token) override { return number(token); }
  bool string(string_t& value) override {
    add(JsonValue::Kind::kString).text = std::move(value);
    return true;
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonValue::Kind::kObject); }
  bool start_array(std::size_t) override { return open(JsonValue::Kind::kArray); }
  bool key(string_t& name) override {
    open_.back()->keys.push_back(std::move(name));
    return true;
  }
  bool end_object() override {
    if (!keys_are_distinct(*open_.back())) return false;
    open_.pop_back();
    return true;
  }
  bool end_array() override {
    open_.pop_back();
    return true;
  }
  bool parse_error(std::size_t, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    where_ = offset() == 0 ? 0 : offset() - 1;
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow) {
      problem_ = show_text(token) + " is beyond the range of a bare JSON number";
      remedy_ = "put it in double quotes; then it is read exactly";
    } else if (ends_early(error.what())) {
      where_ = text_.size();
      problem_ = text_.empty() ? "the file is empty" : "the text ends too early";
      if (!text_.empty()) problem_ += ", after " + show_text(tail());
      remedy_ = "complete it to one JSON value";
    } else {
      problem_ = show_text(token) + " is not allowed here" + reason(error.what());
      remedy_ = "correct the JSON there (no NaN, no comments, no trailing commas; text in UTF-8)";
    }
    return false;
  }

 private:
  std::size_t offset() const { return static_cast<std::size_t>(*reached_ - text_.data()); }
  std::string_view tail() const {
    return text_.substr(text_.size() - std::min<std::size_t>(16, text_.size()));
  }

  bool ends_early(std::string_view message) const {
    return offset() >= text_.size() &&
           (message.find("unexpected end of input") != std::string_view::npos ||
            message.find("invalid ") != std::string_view::npos);
  }

  // nlohmann's message after its last "; " or " - ".
  static std::string reason(std::string_view message) {
    const std::size_t expected = message.rfind("expected ");
    if (expected != std::string_view::npos) return ": " + std::string(message.substr(expected));
    const std::size_t invalid = message.find("invalid ");
    if (invalid == std::string_view::npos) return "";
    return ": " + std::string(message.substr(invalid, message.find(';', invalid) - invalid));
  }

  bool fail(std::string problem, std::string remedy, std::size_t where) {
    problem_ = std::move(problem);
    remedy_ = std::move(remedy);
    where_ = where;
    return false;
  }

  JsonValue& add(JsonValue::Kind kind) {
    if (deadline_ != nullptr) deadline_->poll();
    JsonValue* value = &root_;
    if (!open_.empty()) value = &open_.back()->items.emplace_back();
    value->kind = kind;
    value->offset = offset() == 0 ? 0 : offset() - 1;
    return *value;
  }

  bool number(std::string token) {
    if (token.size() > kMaxNumberLength) {
      return fail("a number of " + std::to_string(token.size()) + " characters",
                  "write at most 1000000", offset());
    }
    JsonValue& value = add(JsonValue::Kind::kNumber);
    // The lexer has read one byte more than the number.
    if (value.offset > 0) --value.offset;
    value.text = std::move(token);
    return true;
  }

  bool open(JsonValue::Kind kind) {
    if (static_cast<int>(open_.size()) >= kMaxJsonDepth) {
      return fail("brackets are nested deeper than " + std::to_string(kMaxJsonDepth) + " levels",
                  "no file of kinex needs that", offset() - 1);
    }
    // Growing `items` of the innermost open value moves only closed values, so pointers stay valid.
    open_.push_back(&add(kind));
    return true;
  }

  bool keys_are_distinct(const JsonValue& object) {
    std::vector<std::size_t> order(object.keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(std::string_view(object.keys[a]), a) <
             std::pair(std::string_view(object.keys[b]), b);
    });
    for (std::size_t i = 1; i < order.size(); ++i) {
      const std::string& name = object.keys[order[i]];
      if (name != object.keys[order[i - 1]]) continue;
      return fail("the name " + show_text(name) + " stands twice in one object",
                  "remove one of them", object.items[order[i]].offset);
    }
    return true;
  }

  std::string_view text_;
  const char* const* reached_;
  Deadline* deadline_;
  JsonValue root_;
  std::vector<JsonValue*> open_;
  std::string problem_, remedy_;
  std::size_t where_ = 0;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == key) return &items[i];
  }
  return nullptr;
}

JsonValue parse_json(std::string_view text, const std::string& file, std::size_t first_line,
                     Deadline* deadline) {
  const char* reached = text.data();
  TreeBuilder builder(text, &reached, deadline);
  const TrackedBytes begin{text.data(), &reached};
  const TrackedBytes end{text.data() + text.size(), &reached};
  if (!nlohmann::json::sax_parse(begin, end, &builder)) {
    const TextPosition at = position_in(text, builder.where());
    throw InputError(file,
                     "line " + std::to_string(at.line + first_line - 1) + ", column " +
                         std::to_string(at.column),
                     builder.problem(), builder.remedy());
  }
  return builder.take();
}

TextPosition position_in(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  TextPosition position;
  position.line += static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t newline = before.rfind('\n');
  position.column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1) + 1;
  return position;
}

std::string_view kind_name(JsonValue::Kind kind) {
  switch (kind) {
    case JsonValue::Kind::kNull:
      return "null";
    case JsonValue::Kind::kBoolean:
      return "true or false";
    case JsonValue::Kind::kNumber:
      return "a number";
    case JsonValue::Kind::kString:
      return "a string";
    case JsonValue::Kind::kArray:
      return "an array";
    case JsonValue::Kind::kObject:
      return "an object";
  }
  return "";
}

std::string shown(const JsonValue& value) {
  switch (value.kind) {
    case JsonValue::Kind::kNull:
      return "null";
    case JsonValue::Kind::kBoolean:
      return value.boolean ? "true" : "false";
    case JsonValue::Kind::kString:
      return show_text(value.text);
    case JsonValue::Kind::kNumber:
      if (value.text.size() <= 40) return value.text;
      return value.text.substr(0, 40) + "... (" + std::to_string(value.text.size()) +
             " characters)";
    default:
      return std::string(kind_name(value.kind));
  }
}

}  // namespace kinex

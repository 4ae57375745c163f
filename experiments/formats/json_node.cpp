// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/json_node.h"

#include <algorithm>
#include <utility>

#include "core/numbers/near_names.h"
#include "core/numbers/short_rational.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_defect.h"
#include "experiments/formats/number_defect.h"

namespace kinex::formats {

namespace {

std::string listed(std::span<const std::string_view> names) {
  std::string result;
  for (const std::string_view name : names) {
    if (!result.empty()) result += ", ";
    result += '"' + std::string(name) + '"';
  }
  return result;
}

// JSON pointer (RFC 6901).
std::string escaped(std::string_view key) {
  std::string result;
  for (const char c : key) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else if (static_cast<unsigned char>(c) < 0x20 || result.size() > 60) {
      result += '?';
      if (result.size() > 60) break;
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string JsonNode::path() const {
  if (parent_ == nullptr) return "";
  const JsonValue& above = *parent_->value_;
  const std::string own =
      above.kind() == JsonValue::Kind::kObject ? escaped(above.keys()[index_].text())
                                               : std::to_string(index_);
  return parent_->path() + "/" + own;
}

void JsonNode::fail(const std::string& problem, const std::string& remedy) const {
  const std::string where = path();
  std::string line;
  if (source_->first_line != 0) {
    const std::size_t below = position_in(source_->text, value_->offset()).line - 1;
    line = " (line " + std::to_string(source_->first_line + below) + ")";
  }
  throw InputError(source_->file, where.empty() ? "/" : where, problem, remedy + line);
}

void JsonNode::refuse(std::string_view what, const std::string& remedy) const {
  const bool is_open = is(JsonValue::Kind::kArray) || is(JsonValue::Kind::kObject);
  fail(shown(*value_) + (is_open ? " in place of " : " is not ") + std::string(what), remedy);
}

std::string_view JsonNode::string() const {
  if (!is(JsonValue::Kind::kString)) refuse("a string", "write text in double quotes");
  return value_->text();
}

bool JsonNode::boolean() const {
  if (!is(JsonValue::Kind::kBoolean)) refuse("true or false", "write true or false");
  return value_->boolean();
}

void JsonNode::read(Rational& number) const {
  poll();
  const std::string_view text = value_->text();
  if (const auto words = parse_short(text)) return assign(number, *words);
  static const char kRemedy[] = "write an integer, a fraction \"1/3\" or a decimal";
  if (!is(JsonValue::Kind::kNumber) && !is(JsonValue::Kind::kString)) refuse("a number", kRemedy);
  if (text.size() > kMaxNumberLength) fail("a number of more than 1000000 characters", kRemedy);
  std::optional<Rational> result = Rational::parse(text);
  if (!result) {
    const NumberDefect defect = number_defect(text, kRemedy);
    fail(shown(*value_) + " " + defect.problem, defect.remedy);
  }
  number = *std::move(result);
}

Rational JsonNode::rational() const {
  Rational number;
  read(number);
  return number;
}

int JsonNode::integer(int low, int high) const {
  const std::string range =
      "write an integer from " + std::to_string(low) + " to " + std::to_string(high);
  if (!is(JsonValue::Kind::kNumber)) refuse("an integer", range);
  const Rational number = rational();
  if (number.denominator() != Integer(1) || number < Rational(low) || Rational(high) < number) {
    refuse("an integer from " + std::to_string(low) + " to " + std::to_string(high), range);
  }
  return static_cast<int>(number.numerator().to_int64());
}

void JsonNode::require_array() const {
  if (!is(JsonValue::Kind::kArray)) refuse("an array", "write [ ... ]");
}

void JsonNode::require_object(std::span<const std::string_view> allowed) const {
  if (!is(JsonValue::Kind::kObject)) refuse("an object", "write { ... } with " + listed(allowed));
  const std::span<const JsonValue> keys = value_->keys();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (std::find(allowed.begin(), allowed.end(), keys[i].text()) != allowed.end()) continue;
    at(i).fail(show_text(keys[i].text()) + " is not a known field",
               did_you_mean(keys[i].text(), {allowed.begin(), allowed.end()},
                            "known are " + listed(allowed)));
  }
}

JsonNode JsonNode::at(std::size_t index) const {
  return JsonNode(value_->items()[index], *this, index);
}

std::optional<JsonNode> JsonNode::find(std::string_view name) const {
  const std::span<const JsonValue> keys = value_->keys();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].text() == name) return at(i);
  }
  return std::nullopt;
}

JsonNode JsonNode::member(std::string_view name) const {
  std::optional<JsonNode> result = find(name);
  if (!result) fail("\"" + std::string(name) + "\" is missing", "add it");
  return *result;
}

}  // namespace kinex::formats

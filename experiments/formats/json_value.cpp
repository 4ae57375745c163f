// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/json_value.h"

#include "core/numbers/show_number.h"
#include "core/numbers/show_text.h"

namespace kinex::formats {

const JsonValue* JsonValue::find(std::string_view key) const {
  const std::span<const JsonValue> names = keys();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].text() == key) return &items()[i];
  }
  return nullptr;
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
  const std::string_view text = value.text();
  switch (value.kind()) {
    case JsonValue::Kind::kNull:
      return "null";
    case JsonValue::Kind::kBoolean:
      return value.boolean() ? "true" : "false";
    case JsonValue::Kind::kString:
      return show_text(text);
    case JsonValue::Kind::kNumber:
      return show_number(text);
    default:
      return std::string(kind_name(value.kind()));
  }
}

}  // namespace kinex::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/canonical_json.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "experiments/formats/json_writer.h"

namespace kinex::formats {

namespace {

void append(std::string& out, const JsonValue& value);

void append_object(std::string& out, const JsonValue& value) {
  std::vector<std::size_t> order(value.keys().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return value.key(a) < value.key(b); });
  out += '{';
  for (const std::size_t i : order) {
    if (out.back() != '{') out += ',';
    append_json_string(out, value.key(i));
    out += ':';
    append(out, value.items()[i]);
  }
  out += '}';
}

void append(std::string& out, const JsonValue& value) {
  switch (value.kind()) {
    case JsonValue::Kind::kNull:
      out += "null";
      break;
    case JsonValue::Kind::kBoolean:
      out += value.boolean() ? "true" : "false";
      break;
    case JsonValue::Kind::kNumber:
      out += value.text();
      break;
    case JsonValue::Kind::kString:
      append_json_string(out, value.text());
      break;
    case JsonValue::Kind::kArray:
      out += '[';
      for (std::size_t i = 0; i < value.items().size(); ++i) {
        if (i > 0) out += ',';
        append(out, value.items()[i]);
      }
      out += ']';
      break;
    case JsonValue::Kind::kObject:
      append_object(out, value);
      break;
  }
}

}  // namespace

std::string canonical_json(const JsonValue& value) {
  std::string text;
  append(text, value);
  return text;
}

}  // namespace kinex::formats

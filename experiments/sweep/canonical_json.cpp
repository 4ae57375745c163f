// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/canonical_json.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "experiments/formats/json_writer.h"

namespace kinex::sweep {

namespace {

void append(std::string& out, const formats::JsonValue& value);

void append_object(std::string& out, const formats::JsonValue& value) {
  std::vector<std::size_t> order(value.keys().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return value.key(a) < value.key(b); });
  out += '{';
  for (const std::size_t i : order) {
    if (out.back() != '{') out += ',';
    formats::append_json_string(out, value.key(i));
    out += ':';
    append(out, value.items()[i]);
  }
  out += '}';
}

void append(std::string& out, const formats::JsonValue& value) {
  switch (value.kind()) {
    case formats::JsonValue::Kind::kNull:
      out += "null";
      break;
    case formats::JsonValue::Kind::kBoolean:
      out += value.boolean() ? "true" : "false";
      break;
    case formats::JsonValue::Kind::kNumber:
      out += value.text();
      break;
    case formats::JsonValue::Kind::kString:
      formats::append_json_string(out, value.text());
      break;
    case formats::JsonValue::Kind::kArray:
      out += '[';
      for (std::size_t i = 0; i < value.items().size(); ++i) {
        if (i > 0) out += ',';
        append(out, value.items()[i]);
      }
      out += ']';
      break;
    case formats::JsonValue::Kind::kObject:
      append_object(out, value);
      break;
  }
}

}  // namespace

std::string canonical_json(const formats::JsonValue& value) {
  std::string text;
  append(text, value);
  return text;
}

}  // namespace kinex::sweep

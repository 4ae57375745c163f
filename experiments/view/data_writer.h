// SPDX-License-Identifier: GPL-3.0-or-later
// Writes doubles, ids and texts of the page's data as JSON.
#ifndef KINEX_EXPERIMENTS_VIEW_DATA_WRITER_H
#define KINEX_EXPERIMENTS_VIEW_DATA_WRITER_H

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/formats/json_writer.h"

namespace kinex::view {

// The shortest text that reads back as the same double; null if it is not finite.
inline void write_double(formats::JsonWriter& json, double value) {
  if (!std::isfinite(value)) {
    json.null();
    return;
  }
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  json.raw(std::string_view(text, static_cast<std::size_t>(end - text)));
}

template <class Range>
void write_ids(formats::JsonWriter& json, const Range& ids) {
  json.begin_array();
  for (const auto id : ids) json.number(std::uint64_t{id});
  json.end_array();
}

inline void write_texts(formats::JsonWriter& json, const std::vector<std::string>& texts) {
  json.begin_array();
  for (const std::string& text : texts) json.string(text);
  json.end_array();
}

}  // namespace kinex::view

#endif

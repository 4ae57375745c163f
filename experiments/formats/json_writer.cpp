// SPDX-License-Identifier: GPL-3.0-or-later
// Kept by hand, because rapidjson::Writer gives other bytes, and scene hashes, keys of cells and event
// logs are made of these:
//   strings   it writes \n, \t, \u001F and DEL as it is; here they are \u000a, \u0009, \u001f and \u007f
//   spaces    one after each ',' and ':', all on one line: neither Writer nor PrettyWriter has that
//   reals     it writes the shortest text that reads back, here they have 6 digits
//   exact     numbers of any length are quoted from their own digits, without a copy
// A class derived from it as PrettyWriter is would replace all four, and use its stack of brackets
// alone, for which it allocates memory in each line of a log.
#include "experiments/formats/json_writer.h"

#include <cmath>
#include <cstdio>

namespace kinex::formats {

namespace {

bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 && byte != 0x7f && c != '"' && c != '\\';
}

}  // namespace

void append_json_string(std::string& out, std::string_view text) {
  static constexpr char kHex[] = "0123456789abcdef";
  out += '"';
  for (;;) {
    std::size_t plain = 0;
    while (plain < text.size() && is_plain(text[plain])) ++plain;
    out.append(text.data(), plain);
    if (plain == text.size()) break;
    const char c = text[plain];
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      out += "\\u00";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    }
    text.remove_prefix(plain + 1);
  }
  out += '"';
}

void JsonWriter::separate() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (!first_) out_ += line_ >= 0 ? "," : ", ";
  if (line_ >= 0) {
    out_ += '\n';
    out_.append(static_cast<std::size_t>(line_), ' ');
    line_ = -1;
  }
  first_ = false;
}

JsonWriter& JsonWriter::open(char bracket) {
  separate();
  out_ += bracket;
  first_ = true;
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  if (line_ >= 0) {
    out_ += '\n';
    out_.append(static_cast<std::size_t>(line_), ' ');
    line_ = -1;
  }
  out_ += bracket;
  first_ = false;
  after_key_ = false;
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  separate();
  append_json_string(out_, name);
  out_ += ": ";
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::string(std::string_view text) {
  separate();
  append_json_string(out_, text);
  return *this;
}

JsonWriter& JsonWriter::raw(std::string_view json) {
  separate();
  out_ += json;
  return *this;
}

JsonWriter& JsonWriter::number(std::uint64_t value) { return raw(std::to_string(value)); }

JsonWriter& JsonWriter::number(int value) { return raw(std::to_string(value)); }

JsonWriter& JsonWriter::real(double value) {
  if (!std::isfinite(value)) return null();
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return raw(buffer);
}

JsonWriter& JsonWriter::line(int spaces) {
  line_ = spaces;
  return *this;
}

}  // namespace kinex::formats

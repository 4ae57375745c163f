// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/page.h"

#include <zlib.h>

#include <new>

#include "experiments/lab/html.h"
#include "experiments/view/base91.h"

namespace kinex::view {

namespace {

// Data beyond this are packed: the page then starts when they are unpacked.
constexpr std::size_t kLargestPlain = 4'000'000;
constexpr int kPacking = 5;  // of 9: higher levels take twice the time for one part in a hundred

void fill(std::string& page, std::string_view mark, std::string_view text) {
  page.replace(page.find(mark), mark.size(), text);
}

// JSON that is safe inside HTML: "<" can occur only inside strings.
std::string harmless(std::string_view json) {
  std::string result;
  result.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

// zlib's form of a text, which browsers unpack ("deflate" of DecompressionStream).
std::string packed(std::string_view text) {
  std::string bytes(compressBound(text.size()), '\0');
  uLongf size = bytes.size();
  const int result = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                               reinterpret_cast<const Bytef*>(text.data()), text.size(), kPacking);
  if (result != Z_OK) throw std::bad_alloc();  // there is no other reason
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string view_page(const std::string& title, std::string_view data) {
  std::string page(kViewFrame);
  const bool pack = data.size() > kLargestPlain;
  // The first mark of its kind is the right one, whatever title and data contain: the title
  // precedes the data on the page, and is filled in after it.
  fill(page, "@STYLE@", kViewStyle);
  fill(page, "@START@", pack ? "<script>\n" + std::string(kViewUnpack) + "</script>" : "");
  fill(page, "@SCRIPT_TYPE@", pack ? "text/plain" : "text/javascript");
  fill(page, "@SCRIPT@", kViewScript);
  fill(page, "@DATA_TYPE@", pack ? "text/plain" : "application/json");
  fill(page, "@DATA@", pack ? base91(packed(data)) : harmless(data));
  fill(page, "@TITLE@", lab::escape(title));
  return page;
}

}  // namespace kinex::view

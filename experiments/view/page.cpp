// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/page.h"

#include "experiments/lab/html.h"

namespace kinex::view {

namespace {

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

}  // namespace

std::string view_page(const std::string& title, std::string_view data) {
  std::string page(kViewFrame);
  // The first mark of its kind is the right one, whatever title and data contain: the title
  // precedes the data on the page, and is filled in after it.
  fill(page, "@STYLE@", kViewStyle);
  fill(page, "@SCRIPT@", kViewScript);
  fill(page, "@DATA@", harmless(data));
  fill(page, "@TITLE@", lab::escape(title));
  return page;
}

}  // namespace kinex::view

// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of a page of results lead to all of its sections and stay short.
#include <gtest/gtest.h>

#include <string>

#include "experiments/lab/html_page.h"

namespace kinex {
namespace html_page_test {

// The contents of a page of so many sections.
std::string contents_of(int sections) {
  lab::HtmlPage page("kinex test", "1 of 1 holds", true, {});
  for (int i = 1; i <= sections; ++i) {
    const std::string id = "part-" + std::to_string(i);
    page.add({id, "Part " + std::to_string(i), lab::html("<p>text</p>")});
  }
  const std::string text = page.text();
  const std::size_t begin = text.find("<nav"), end = text.find("</nav>");
  EXPECT_LT(begin, end);
  for (int i = 1; i <= sections; ++i) {
    const std::size_t link = text.find("<a href=\"#part-" + std::to_string(i) + "\">");
    EXPECT_TRUE(begin < link && link < end) << i;
  }
  return text.substr(begin, end - begin);
}

TEST(HtmlPage, FewSectionsAreAllNamed) {
  EXPECT_EQ(contents_of(1).find("<details>"), std::string::npos);
  EXPECT_EQ(contents_of(9).find("<details>"), std::string::npos);
}

TEST(HtmlPage, OfManySectionsTheMiddleIsFolded) {
  const std::string text = contents_of(27);
  const std::size_t begin = text.find(
      "<details><summary>22 more parts of this page, from \"Part 4\" to \"Part 25\"</summary>");
  const std::size_t end = text.find("</details>");
  ASSERT_NE(begin, std::string::npos);
  const auto is_folded = [&](int i) {
    const std::size_t link = text.find("#part-" + std::to_string(i) + "\"");
    return begin < link && link < end;
  };
  for (int i = 1; i <= 27; ++i) EXPECT_EQ(is_folded(i), i > 3 && i < 26) << i;
}

}  // namespace html_page_test
}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// What is no JSON is refused where the word begins that is wrong, and told why.
#include "experiments/formats/json_defect.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "experiments/formats/json_document.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace json_defect_test {

using namespace std::string_view_literals;

struct Case {
  std::string_view text;
  const char* place;
  const char* words;
};

TEST(JsonDefect, NamesPlaceWordAndReason) {
  const Case cases[] = {
      {"", "column 1", "the file is empty"},
      {" \n ", "line 2, column 2", "the text ends too early: it holds only white space"},
      {"{]", "column 2", "\"]\" is not allowed here: expected a name in double quotes"},
      {"[1,]", "column 4", "\"]\" is not allowed here: expected a value"},
      {"[1 22]", "column 4", "\"22\" is not allowed here: expected ',' or ']'"},
      {"{\"a\" 1}", "column 6", "\"1\" is not allowed here: expected ':'"},
      {"{\"a\":1 \"b\"}", "column 8", "expected ',' or '}'"},
      {"[1] x", "column 5", "\"x\" is not allowed here: expected the end"},
      {"[NaN]", "column 2", "\"NaN\" is not allowed here"},
      {"[-Infinity]", "column 2", "\"-Infinity\" is not allowed here"},
      {"[truex]", "column 2", "\"truex\" is not allowed here: it is neither"},
      {"[01]", "column 2", "\"01\" is not allowed here: it is neither"},
      {"[1.]", "column 2", "\"1.\" is not allowed here: it is neither"},
      {"[tru", "column 5", "the text ends too early, after \"[tru\""},
      {"[\"a", "column 4", "the text ends too early"},
      {"[\"\\u12", "column 7", "the text ends too early"},
      {"[\"\\u12x\"]", "column 3", "expected four hexadecimal digits"},
      {"[\"\\q\"]", "column 3", "\"\\q\" is not allowed here: no such escape"},
      {"[\"\\ud800\"]", "column 3", "a high surrogate needs a low one"},
      {"[\"a\\u0041\\ud83d\\ude00\\udc00\"]", "column 22", "a low surrogate"},
      {"[\"\\udc00\"]", "column 3", "\"\\udc00\" is not allowed here: a low surrogate"},
      {"[\"a\nb\"]", "line 1, column 4", "\"\\x0a\" is not allowed here: a control character"},
      {"[\"a\", \"\xff\"]", "column 8", "\"\\xff\" is not allowed here: a byte that is not UTF-8"},
      {"[\"\\n\", \"\xc0\x80\"]", "column 9", "a byte that is not UTF-8"},
      {"\xef\xbb[1]", "column 1", "a byte that is not UTF-8"},
      {"[1e400]", "column 2", "\"1e400\" is beyond the range"},
      {"[12.5e308]", "column 2", "\"12.5e308\" is beyond the range"},
      {"[1\0]"sv, "column 3", "\"\\x00\" is not allowed here"},
      {"[\"a\0\"]"sv, "column 4", "a control character"},
      {"[1]\0"sv, "column 4", "expected the end"},
      {"\0"sv, "column 1", "expected a value"},
  };
  for (const Case& one : cases) {
    EXPECT_INPUT_ERROR(formats::parse_json(one.text, "f"), one.place);
    EXPECT_INPUT_ERROR(formats::parse_json(one.text, "f"), one.words);
  }
}

TEST(JsonDefect, TheFirstOfTwoCounts) {
  EXPECT_INPUT_ERROR(formats::parse_json("[1,, \"\xff\"]", "f"), "column 4");
  EXPECT_INPUT_ERROR(formats::parse_json("[\"\xff\",, 1]", "f"), "column 3");
}

TEST(JsonDefect, NumbersUpToTheLargestDoubleAreBare) {
  for (const char* token : {"1.7976931348623157e308", "-1e308", "0.00000001e310", "1e-400"}) {
    EXPECT_EQ(formats::parse_json(token, "f")->text(), token);
  }
  const std::string nines(308, '9');
  EXPECT_EQ(formats::parse_json(nines, "f")->text(), nines);
  EXPECT_INPUT_ERROR(formats::parse_json(nines + "99", "f"), "beyond the range");
  EXPECT_INPUT_ERROR(formats::parse_json("0." + std::string(formats::kMaxNumberLength, '1'), "f"),
                     "a number of 1000002 characters; write at most 1000000");
}

TEST(JsonDocument, AMarkOfByteOrderIsSkipped) {
  EXPECT_EQ(formats::parse_json("\xef\xbb\xbf 7", "f")->text(), "7");
}

TEST(JsonDocument, ManyNamesAreComparedToo) {
  std::string text = "{";
  for (int i = 0; i < 100; ++i) text += "\"n" + std::to_string(i) + "\": 0, ";
  EXPECT_EQ(formats::parse_json(text + "\"x\": 0}", "f")->items().size(), 101u);
  EXPECT_INPUT_ERROR(formats::parse_json(text + "\n\"n42\": 0}", "f"),
                     "line 2, column 1: the name \"n42\" stands twice");
}

TEST(JsonDocument, InPlaceIsTheSame) {
  for (const char* text : {"{\"a\": [1, \"two\", {\"b\": null}]}", "[\"with \\n escapes\", \"a\"]"}) {
    std::string bytes = text;
    const formats::JsonDocument copied = formats::parse_json(text, "f");
    const formats::JsonDocument there = formats::parse_json_in_place(bytes, "f");
    EXPECT_EQ(there->items().size(), copied->items().size());
    EXPECT_EQ(there->items()[0].text(), copied->items()[0].text());
  }
  std::string broken = "[\"a\", \"b\", tru]";
  EXPECT_INPUT_ERROR(formats::parse_json_in_place(broken, "f"), "column 12");
  EXPECT_EQ(broken, "[\"a\", \"b\", tru]");
  broken = "[\"a\"";
  EXPECT_INPUT_ERROR(formats::parse_json_in_place(broken, "f"), "after \"[\"a\"\"");
}

// Documents own what their values show.
TEST(JsonDocument, MayBeMoved) {
  formats::JsonDocument first = formats::parse_json("[\"s\"]", "f");
  const formats::JsonDocument second = std::move(first);
  EXPECT_EQ(second->items()[0].text(), "s");
}

}  // namespace json_defect_test
}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/json_document.h"

#include <gtest/gtest.h>

#include "experiments/formats/json_defect.h"
#include "experiments/formats/json_writer.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace json_value_test {

formats::JsonDocument parse(std::string_view text) { return formats::parse_json(text, "f.json"); }

TEST(JsonValue, NumbersKeepTheirText) {
  for (const char* token : {"0", "-0.10", "1e2", "1E+2", "123456789012345678901234567890", "0.1",
                            "1e-400", "9007199254740993", "18446744073709551616", "2.50"}) {
    const formats::JsonDocument document = parse(token);
    const formats::JsonValue& value = *document;
    EXPECT_EQ(value.kind(), formats::JsonValue::Kind::kNumber);
    EXPECT_EQ(value.text(), token);
  }
  EXPECT_EQ(parse("-7")->text(), "-7");
}

TEST(JsonValue, TreesKeepTheirOrder) {
  const formats::JsonDocument document = parse(R"({"b": [1, "two", null], "a": {"x": true}})");
  const formats::JsonValue& value = *document;
  ASSERT_EQ(value.keys().size(), 2u);
  EXPECT_EQ(value.key(0), "b");
  EXPECT_EQ(value.key(1), "a");
  EXPECT_EQ(value.items()[0].items()[1].text(), "two");
  EXPECT_EQ(value.items()[0].items()[2].kind(), formats::JsonValue::Kind::kNull);
  EXPECT_TRUE(value.find("a")->find("x")->boolean());
  EXPECT_EQ(value.find("c"), nullptr);
}

TEST(JsonValue, ValuesKnowTheirLine) {
  const std::string text = "{\"a\":\n [1,\n  22\n ,\"x\"]}";
  const formats::JsonDocument document = parse(text);
  const formats::JsonValue& value = *document;
  const formats::JsonValue& list = *value.find("a");
  EXPECT_EQ(formats::position_in(text, list.offset()).line, 2u);
  EXPECT_EQ(formats::position_in(text, list.items()[0].offset()).line, 2u);
  EXPECT_EQ(formats::position_in(text, list.items()[1].offset()).line, 3u);
  EXPECT_EQ(formats::position_in(text, list.items()[2].offset()).line, 4u);
}

TEST(JsonValue, DepthIsLimitedExactly) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_NO_THROW(parse(nested(formats::kMaxJsonDepth)));
  EXPECT_INPUT_ERROR(parse(nested(formats::kMaxJsonDepth + 1)), "line 1, column 65");
  EXPECT_INPUT_ERROR(parse(nested(1000000)), "nested deeper");
}

TEST(JsonValue, NamesStandOnce) {
  EXPECT_INPUT_ERROR(parse("{\"a\": 1,\n \"b\": 2, \"a\": 3}"), "f.json: line 2, column");
  EXPECT_INPUT_ERROR(parse(R"({"a": 1, "\u0061": 2})"), "the name \"a\" stands twice");
  EXPECT_NO_THROW(parse(R"({"a": {"a": 1}, "b": {"a": 1}})"));
}

TEST(JsonValue, FirstLineIsAdded) {
  EXPECT_INPUT_ERROR(formats::parse_json("{]", "log", 7), "log: line 7, column 2");
}

TEST(JsonWriter, WritesWhatTheParserReads) {
  std::string text;
  formats::JsonWriter json(text);
  const std::string odd = "a\"b\\c\n\t\x01 \xc3\xa4";
  json.begin_object().key("s").string(odd).key("n").number(-3).key("list").begin_array();
  json.boolean(true).null().real(0.5).begin_array().end_array().end_array();
  json.line(2).key(odd).begin_object().end_object().end_object();
  const formats::JsonDocument document = parse(text);
  const formats::JsonValue& value = *document;
  EXPECT_EQ(value.find("s")->text(), odd);
  EXPECT_EQ(value.find("n")->text(), "-3");
  EXPECT_EQ(value.find("list")->items().size(), 4u);
  EXPECT_EQ(value.find("list")->items()[2].text(), "0.5");
  EXPECT_NE(value.find(odd), nullptr);
}

TEST(JsonWriter, EscapesWhatHasToBe) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_array().string("").string("a\"b\\").string("\x1f\x7f").string("\"\"").string("plain");
  json.quoted(Integer(-7)).quoted(Rational(Integer(1), Integer(3))).end_array();
  EXPECT_EQ(text, R"(["", "a\"b\\", "\u001f\u007f", "\"\"", "plain", "-7", "1/3"])");
}

}  // namespace json_value_test
}  // namespace kinex

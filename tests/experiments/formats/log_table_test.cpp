// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/expect_input_error.h"

namespace kinex::formats {
namespace log_table_test {

using testing::HasSubstr;

const std::string kHeader =
    R"({"format": "kinex-log", "version": 2, "scene": "s", "scene_hash": ")" +
    std::string(64, '0') +
    R"(", "arithmetic": "exact", "exact": true, "instants": "names", "build": "kinex 0", "structures": [)"
    R"({"label": "list", "structure": "sorted_list", "key": "x", "kinds": ["swap", "tie", "motion", "insert", )"
    R"("erase", "settled", "rebuild"]}], "objects": ["a", "b c", "d,e", "\"f\""]})"
    "\n";

std::string record(int seq, const std::string& ids, const std::string& certificate,
                   const std::string& time, const std::string& change = "") {
  return "{\"seq\": " + std::to_string(seq) + R"(, "structure": "list", "kind": ")" +
         (change.empty() ? "swap" : "settled") + R"(", "ids": )" + ids + R"(, "certificate": )" +
         certificate + R"(, "external": true)" + change + R"(, "time": )" + time + "}\n";
}

const std::string kThird =
    R"({"polynomial": ["-1", "3"], "root": 1, "interval": ["1/3", "1/3"], "decimal": "0.333333333333"})";
const std::string kRoot =
    R"({"polynomial": ["-2", "0", "1"], "root": 2, "interval": ["1", "2"], "decimal": "1.41421356237"})";
const std::string kLog =
    kHeader +
    record(1, R"(["a", "b c"])", R"({"predicate": "order_x", "ids": ["a", "b c"]})", kThird) +
    record(2, R"(["d,e", "\"f\""])", R"({"predicate": "order_x", "ids": ["d,e", "\"f\""]})",
           kRoot) +
    record(3, "[]", "null", kRoot, R"(, "gone": ["a"], "came": ["b c"])");

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

LogTable table(LogTableForm form, const std::vector<std::string>& filters = {},
               const std::string& log = kLog) {
  LogReader reader(log, "t.log");
  LogFilter filter;
  for (const std::string& text : filters) filter.add(text);
  filter.fit(reader);
  return log_table(reader, filter, form);
}

TEST(LogTable, AlignedColumns) {
  const LogTable plain = table(LogTableForm::kPlain);
  EXPECT_EQ(
      plain.text,
      "seq  time            exactly             structure  kind     ids            effect    "
      "certificate\n"
      "  1  0.333333333333  1/3                 list       swap     a \"b c\"        external  "
      "order_x(a \"b c\")\n"
      "  2  1.41421356237   root 2 of -2 + t^2  list       swap     d,e \"\\\"f\\\"\"    external  "
      "order_x(d,e \"\\\"f\\\"\")\n"
      "  3  1.41421356237   root 2 of -2 + t^2  list       settled  -[a] +[\"b c\"]  external\n")
      << plain.text;
  EXPECT_EQ(plain.records, 3u);
  EXPECT_EQ(plain.shown, 3u);
  EXPECT_FALSE(plain.complete);
}

TEST(LogTable, ColumnsThatAreWanted) {
  LogReader reader(kLog, "t.log");
  EXPECT_EQ(log_table(reader, {}, LogTableForm::kPlain, {"kind", "seq", "time"}).text,
            "kind     seq  time\n"
            "swap       1  0.333333333333\n"
            "swap       2  1.41421356237\n"
            "settled    3  1.41421356237\n");
  LogReader again(kLog, "t.log");
  EXPECT_EQ(log_table(again, {}, LogTableForm::kCsv, {"root", "lower"}).text, "root,lower\n1,1/3\n2,1\n2,1\n");
  LogReader wrong(kLog, "t.log");
  EXPECT_INPUT_ERROR(log_table(wrong, {}, LogTableForm::kPlain, {"root"}),
                     "--columns: \"root\" is not a column of the table; write some of seq, time, exactly");
}

TEST(LogTable, CsvQuotesWhatNeedsIt) {
  EXPECT_EQ(table(LogTableForm::kCsv).text,
            "seq,time,polynomial,root,lower,upper,structure,kind,ids,external,predicate,"
            "certificate_ids,gone,came,"
            "reason\n"
            "1,0.333333333333,-1 3,1,1/3,1/3,list,swap,\"a \"\"b c\"\"\",true,order_x,\"a \"\"b "
            "c\"\"\",,,\n"
            "2,1.41421356237,-2 0 1,2,1,2,list,swap,\"d,e \"\"\\\"\"f\\\"\"\"\"\",true,order_x,"
            "\"d,e \"\"\\\"\"f\\\"\"\"\"\",,,\n"
            "3,1.41421356237,-2 0 1,2,1,2,list,settled,,true,,,a,\"\"\"b c\"\"\",\n");
}

TEST(LogTable, Filters) {
  const auto shown = [](const std::vector<std::string>& filters) {
    return table(LogTableForm::kCsv, filters).shown;
  };
  EXPECT_EQ(shown({"kind=swap"}), 2u);
  EXPECT_EQ(shown({"kind=swap,kind=settled"}), 3u);  // alternatives
  EXPECT_EQ(shown({"kind=swap,settled"}), 3u);
  EXPECT_EQ(shown({"kind=swap,settled,object=d,e,a"}), 3u);
  EXPECT_EQ(shown({"kind=tie,settled", "external=true,false"}), 1u);
  EXPECT_EQ(shown({"predicate=order_y,order_x"}), 2u);
  EXPECT_EQ(shown({"kind=swap", "object=a"}), 1u);   // both
  EXPECT_EQ(shown({"object=a"}), 2u);                // also what was gone
  EXPECT_EQ(shown({"object=d,e"}), 1u);              // a comma in an id
  EXPECT_EQ(shown({"object=d,e,kind=settled"}), 0u);
  EXPECT_EQ(shown({"external=false"}), 0u);
  EXPECT_EQ(shown({"predicate=order_x"}), 2u);
  EXPECT_EQ(shown({"structure=list"}), 3u);
}

TEST(LogTable, FiltersThatCannotBe) {
  LogFilter filter;
  EXPECT_INPUT_ERROR(filter.add("swap"), "--filter: \"swap\" is no condition; write KEY=VALUE");
  EXPECT_INPUT_ERROR(filter.add("knid=swap"),
                     "--filter: \"knid\" is not a key; did you mean kind?");
  EXPECT_INPUT_ERROR(filter.add("external=yes"), "neither true nor false");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"kind=sawp"}),
                     "--filter: there is no kind \"sawp\" in t.log; did you mean swap?");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"kind=swap,sawp"}),
                     "--filter: there is no kind \"sawp\" in t.log; did you mean swap?");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"object=a,z"}),
                     "there is no object \"z\" in t.log");
  EXPECT_INPUT_ERROR(filter.add("external=true,yes"), "\"yes\" is neither true nor false");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"structure=hull"}), "it has list");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"object=z"}), "there is no object \"z\" in t.log");
  EXPECT_INPUT_ERROR(
      table(LogTableForm::kCsv, {"predicate=in_cirle_2"}),
      "--filter: there is no predicate \"in_cirle_2\" in t.log; did you mean in_circle_2?");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"predicate=order_x,flip"}),
                     "--filter: there is no predicate \"flip\" in t.log; it has order_x");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"predicate="}),
                     "there is no predicate \"\" in t.log");
}

// A program with structures of its own has predicates of its own.
TEST(LogTable, PredicatesThatOnlyTheLogKnows) {
  const std::string own = replaced(kLog, "\"predicate\": \"order_x\", \"ids\": [\"a\"",
                                   "\"predicate\": \"mine\", \"ids\": [\"a\"");
  EXPECT_EQ(table(LogTableForm::kCsv, {"predicate=mine"}, own).shown, 1u);
  EXPECT_EQ(table(LogTableForm::kCsv, {"predicate=mine,order_y"}, own).shown, 1u);
  EXPECT_EQ(table(LogTableForm::kCsv, {"predicate=order_strip/012123"}, own).shown, 0u);
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"predicate=mien"}, own),
                     "--filter: there is no predicate \"mien\" in t.log; did you mean mine?");
  const std::string none =
      kHeader + record(1, "[]", "null", kRoot, R"(, "gone": ["a"], "came": ["b c"])");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"predicate=flip"}, none), "in t.log; it has none");
}

// A message is not cut off where a name has a character of no width.
TEST(LogTable, NamesWithControlCharacters) {
  const std::string odd = replaced(kLog, R"(["a", "b c", "d,e",)", R"(["a", "b\u0000c", "d\ne",)");
  EXPECT_INPUT_ERROR(table(LogTableForm::kCsv, {"object=some"}, odd),
                     R"(it has a, b\u0000c, d\ne, "f")");
}

TEST(LogTable, LongInstantsAreAbridged) {
  LogHeader header;
  LogInstant instant;
  instant.lower = instant.upper = *Rational::parse("1/" + std::string(60, '7'));
  EXPECT_EQ(instant_words(instant, header), "a fraction of 61 digits");
  header.instants = InstantDetail::kInterval;
  EXPECT_EQ(instant_words(instant, header), "");
}

}  // namespace log_table_test
}  // namespace kinex::formats

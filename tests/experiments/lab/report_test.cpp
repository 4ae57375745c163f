// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of every report: HTML that escapes, tables in three forms, JSON members, rows of a database.
#include "experiments/lab/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/lab/report_json.h"
#include "experiments/lab/result_database.h"

namespace kinex {
namespace report_test {

using lab::html;
using lab::Html;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(HtmlText, EscapesWhatIsNoHtml) {
  EXPECT_EQ(Html("a < b & \"c\" +- 1").text(), "a &lt; b &amp; &quot;c&quot; &plusmn; 1");
  const std::string name = "<x>";
  EXPECT_EQ(html("<p>{} {} {} {:.1f}</p>", name, "&", 3, 0.25).text(), "<p>&lt;x&gt; &amp; 3 0.2</p>");
  EXPECT_EQ(html("<b>{}</b>", html("<i>{}</i>", name)).text(), "<b><i>&lt;x&gt;</i></b>");
  EXPECT_EQ(lab::verdict_mark(lab::Verdict::kGaveUp).text(),
            "<span class=\"v GAVE UP\">GAVE UP</span>");
  EXPECT_EQ(lab::anchor_of("cell a_b, n = 3"), "cell-a_b-n-3");
}

lab::Table small_table() {
  lab::Table table;
  table.title = "A title";
  table.header = {"name", "count", "remark"};
  table.rows = {{"a", "12", "few"}, {"b", "-", "<none>"}};
  table.note = "A note.";
  return table;
}

TEST(Table, AlignsNumbersInAllForms) {
  EXPECT_EQ(lab::markdown(small_table()),
            "\n## A title\n\nA note.\n\n| name | count | remark |\n| --- | ---: | --- |\n"
            "| a | 12 | few |\n| b | - | <none> |\n");
  const std::string page = lab::html_table(small_table()).text();
  EXPECT_THAT(page, HasSubstr("<th scope=\"col\" class=\"r\">count</th>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"r\">12</td><td>few</td>"));
  EXPECT_THAT(page, HasSubstr("<td>&lt;none&gt;</td>"));
  EXPECT_THAT(page, HasSubstr("<tr class=\"first\"><td>a</td>"));
  const std::vector<lab::TextColumn> columns{{"name", -6, false}, {"count", 5}, {"remark", 0, false}};
  EXPECT_EQ(lab::text_header(columns), "name   count  remark\n");
  EXPECT_EQ(lab::text_row(columns, {"a", "12", "few"}), "a         12  few\n");
}

// A narrow window shows the first columns of a wide table.
TEST(Table, VerdictsStandFirstOnPages) {
  lab::Table table = small_table();
  table.header[2] = "verdict";
  const std::string page = lab::html_table(table).text();
  EXPECT_THAT(page, HasSubstr("<tr><th scope=\"col\">verdict</th><th scope=\"col\">name</th>"));
  EXPECT_THAT(page, HasSubstr("<td>few</td><td>a</td><td class=\"r\">12</td></tr>"));
  EXPECT_THAT(lab::markdown_rows(table), HasSubstr("| name | count | verdict |"));
  const std::vector<lab::TextColumn> columns{{"name", -6, false},
                                             {"outcome", 0, false, nullptr, true}};
  EXPECT_THAT(lab::html_table(lab::html_columns(columns), {{{"a", "good"}}}).text(),
              HasSubstr("<td>good</td><td>a</td>"));
}

TEST(ReportPage, HasItsSectionsThatAreNotEmpty) {
  lab::Report report;
  report.title = "kinex test";
  report.verdict = "1 < 2";
  report.good = true;
  report.question = "Is it?";
  report.before = {{"first", "First", "here"}, {"empty", "Empty", {}}};
  report.after = {{"last", "Last", html("<p>{}</p>", "there")}};
  lab::PageFacts facts;
  facts.command = "kinex test 'a b'";
  std::string page = lab::report_page(report, {}, facts);
  EXPECT_THAT(page, HasSubstr("<p class=\"verdict PASS\">1 &lt; 2</p>"));
  EXPECT_THAT(page, HasSubstr("<h2 id=\"first\">"));
  EXPECT_THAT(page, HasSubstr("<p>there</p>"));
  EXPECT_THAT(page, Not(HasSubstr("Empty")));
  EXPECT_THAT(page, Not(HasSubstr("Plots")));
  EXPECT_THAT(page, Not(HasSubstr("Interrupted")));
  EXPECT_THAT(page, Not(HasSubstr("earlier commands")));
  report.interrupted = true;
  facts.taken = {2, 40};
  page = lab::report_page(report, {}, facts);
  EXPECT_THAT(page, HasSubstr("<p class=\"verdict FAIL\">"));
  EXPECT_THAT(page, HasSubstr("in 2 s, after 40 s of parts that earlier commands had finished"));
  EXPECT_THAT(page, HasSubstr("Interrupted"));
}

// Of many figures the first are unfolded; few have no folds.
TEST(ReportPage, FoldsManyFigures) {
  const auto count = [](const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
    return found;
  };
  for (const int figures : {3, 12}) {
    lab::Report report;
    lab::Drawings drawings;
    for (int i = 0; i < figures; ++i) {
      report.figures.push_back({"figure " + std::to_string(i), "what it shows", ""});
      drawings.svg.emplace_back("<svg></svg>");
    }
    const std::string page = lab::report_page(report, drawings, {});
    EXPECT_EQ(count(page, "<img "), figures);
    EXPECT_EQ(count(page, "<details "), figures == 3 ? 0 : 12);
    EXPECT_EQ(count(page, " open><summary>"), figures == 3 ? 0 : 4);
    EXPECT_THAT(page, HasSubstr("id=\"plot-figure-2\""));
  }
}

TEST(JsonMembers, AreOfEveryKind) {
  std::string text;
  lab::RunningMean mean;
  mean.add(2);
  formats::JsonWriter(text).object("text", "a\n", "whole", std::uint64_t{7}, "real", 0.5, "is", true,
                                   "none", std::optional<double>(), "some", std::optional<int>(3), "all",
                                   std::vector<std::string>{"x", "y"}, "mean", mean);
  EXPECT_EQ(text,
            "{\"text\": \"a\\u000a\", \"whole\": 7, \"real\": 0.5, \"is\": true, \"none\": null, "
            "\"some\": 3, \"all\": [\"x\", \"y\"], \"mean\": {\"mean\": 2, \"standard_error\": 0, "
            "\"smallest\": 2, \"largest\": 2}}");
}

TEST(ResultDatabase, TakesRowsByTheirTypes) {
  lab::ResultDatabase database(
      "CREATE TABLE t(id INTEGER PRIMARY KEY, a TEXT, b INTEGER, c REAL) STRICT");
  EXPECT_EQ(database.insert("t", nullptr, "one", 1, 0.5), 1);
  EXPECT_EQ(database.insert("t", nullptr, std::optional<std::string>(), true, std::optional<double>(2)),
            2);
  EXPECT_ANY_THROW(database.insert("t", nullptr, "one", "no number", 0.5));
  EXPECT_ANY_THROW(lab::ResultDatabase("CREATE TABLE t(a TEXT) STRICT").insert("t", 1, 2));
  EXPECT_THAT(database.bytes(), HasSubstr("one"));
}

}  // namespace report_test
}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// Two event logs: which record of one is which of the other, what differs, and where one ends.
#include "experiments/formats/log_diff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/formats/input_error.h"

namespace kinex {
namespace log_diff_test {

// A log of sorted_list with these records: kind, object, effect and time of each; without a last
// line.
struct Said {
  std::string kind, id;
  bool external = true;
  std::string time = R"({"decimal": "0"})";
};
std::string made_log(const std::vector<Said>& records, bool exact = false,
                     const std::vector<std::string>& labels = {"l"},
                     const char* instants = "names") {
  std::string text = R"({"format": "kinex-log", "version": 2, "scene": "s", "scene_hash": ")" +
                     std::string(64, '0') + R"(", "arithmetic": "a", "exact": )" +
                     (exact ? "true" : "false") + R"(, "instants": ")" + instants +
                     R"(", "build": "", "structures": [)";
  for (const std::string& label : labels) {
    text += std::string(&label == &labels.front() ? "" : ", ") + R"({"label": ")" + label +
            R"(", "structure": "sorted_list", "key": "x", "kinds": []})";
  }
  text += "], \"objects\": []}\n";
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Said& said = records[i];
    const std::size_t colon = said.id.find(':');
    const std::string label = colon == std::string::npos ? "l" : said.id.substr(0, colon);
    text += "{\"seq\": " + std::to_string(i + 1) + R"(, "structure": ")" + label +
            R"(", "kind": ")" + said.kind + R"(", "ids": [")" + said.id +
            R"("], "certificate": null, "external": )" + (said.external ? "true" : "false") +
            (std::string_view(instants) == "none" ? "" : ", \"time\": " + said.time) + "}\n";
  }
  return text;
}
std::string last_line(const std::string& status, const std::string& reached) {
  const std::string digest(64, '0');
  return "{\"end\": \"" + status +
         "\", \"reached\": " + (reached.empty() ? "null" : "\"" + reached + "\"") +
         ", \"records\": 0, \"external\": 0, \"digest\": \"" + digest + "\", \"seal\": \"" +
         digest + "\"}\n";
}

std::vector<Said> swaps(const std::vector<std::string>& ids) {
  std::vector<Said> result;
  for (const std::string& id : ids) result.push_back({"swap", id});
  return result;
}

TEST(LogDiff, CountsByHand) {
  const formats::LogDifference difference = formats::diff_logs(
      made_log(swaps({"a", "b", "c", "d", "a"})) + last_line("done", "9"), "a",
      made_log(swaps({"a", "c", "b", "x", "a", "a"})) + last_line("done", "9"), "b");
  EXPECT_EQ(difference.first, 2u);
  EXPECT_EQ(difference.line_a, 3u);
  EXPECT_EQ(difference.missing, 1u);       // d
  EXPECT_EQ(difference.invented, 2u);      // x, the third a
  EXPECT_EQ(difference.out_of_order, 1u);  // b or c
  EXPECT_EQ(difference.row_a, "2  0  l  swap  b  external");
  EXPECT_EQ(difference.row_b, "2  0  l  swap  c  external");
  ASSERT_EQ(difference.kinds.size(), 1u);
  EXPECT_EQ(difference.kinds[0].structure + " " + difference.kinds[0].kind, "l swap");
  EXPECT_EQ(difference.kinds[0].events_a, 5u);
  EXPECT_EQ(difference.kinds[0].events_b, 6u);
  EXPECT_EQ(difference.kinds[0].missing, 1u);
  EXPECT_EQ(difference.kinds[0].invented, 2u);
}

TEST(LogDiff, EffectsAndRecordsOfChanges) {
  std::vector<Said> a = swaps({"a", "b"});
  std::vector<Said> b = a;
  b[1].external = false;
  formats::LogDifference difference = formats::diff_logs(made_log(a), "a", made_log(b), "b");
  EXPECT_EQ(difference.first, 2u);
  EXPECT_EQ(difference.other_effects, 1u);
  EXPECT_EQ(difference.missing + difference.invented + difference.out_of_order, 0u);
  b = a;
  b.insert(b.begin() + 1, {"motion", "a", false});
  difference = formats::diff_logs(made_log(a), "a", made_log(b), "b");
  EXPECT_EQ(difference.first, 0u);
  EXPECT_EQ(difference.events_b, 2u);
  EXPECT_EQ(difference.other_records, 1u);
  EXPECT_FALSE(difference.equal());
}

// Structures that only one of the runs maintained are left out, and named.
TEST(LogDiff, OtherStructures) {
  const std::string both = made_log(swaps({"l:a", "m:a", "l:b"}), false, {"l", "m"});
  const std::string one = made_log(swaps({"l:a", "l:b"}));
  const formats::LogDifference difference = formats::diff_logs(both, "both", one, "one");
  EXPECT_TRUE(difference.equal());
  EXPECT_EQ(difference.events_a, 2u);
  EXPECT_EQ(difference.only_a, std::vector<std::string>{"m"});
  EXPECT_TRUE(difference.only_b.empty());
  // The same structure by the same key, under another label.
  const formats::LogDifference renamed =
      formats::diff_logs(made_log(swaps({"m:a", "m:b"}), false, {"m"}), "a", one, "b");
  ASSERT_EQ(renamed.other_labels.size(), 1u);
  EXPECT_EQ(renamed.other_labels[0].label_a + " " + renamed.other_labels[0].label_b, "m l");
  EXPECT_EQ(renamed.events_a, 2u);
  std::string by_y = made_log({}, false, {"m"});
  by_y.replace(by_y.find("\"key\": \"x\""), 10, "\"key\": \"y\"");
  EXPECT_THROW(formats::diff_logs(by_y, "a", one, "b"), formats::InputError);
}

// The same events at other times: a difference between exact logs, where instants are numbers,
// whatever their names.
TEST(LogDiff, InstantsCountInExactLogs) {
  const auto log = [](const std::string& time, bool exact = true, const char* instants = "names") {
    return made_log({{"swap", "a", true, time}}, exact, {"l"}, instants) + last_line("done", "9");
  };
  const std::string one =
      R"({"polynomial": ["-2", "0", "1"], "root": 2, "interval": ["1", "2"], "decimal": "1.41421356237"})";
  const std::string narrow =
      R"({"polynomial": ["-2", "0", "1"], "root": 2, "interval": ["1", "3/2"], "decimal": "1.41421356237"})";
  const std::string renamed =
      R"({"polynomial": ["6", "0", "-5", "0", "1"], "root": 3, "interval": ["1", "3/2"], "decimal": "1.41421356237"})";
  const std::string near =
      R"({"polynomial": ["-3", "0", "1"], "root": 2, "interval": ["1", "2"], "decimal": "1.73205080756"})";
  const std::string other =
      R"({"polynomial": ["-2", "0", "1"], "root": 1, "interval": ["-2", "-1"], "decimal": "-1.41421356237"})";
  EXPECT_TRUE(formats::diff_logs(log(one), "a", log(narrow), "b").equal());
  EXPECT_TRUE(formats::diff_logs(log(one), "a", log(renamed), "b").equal());
  for (const std::string& time : {other, near}) {
    const formats::LogDifference difference = formats::diff_logs(log(one), "a", log(time), "b");
    EXPECT_EQ(difference.first, 1u);
    EXPECT_EQ(difference.other_instants, 1u);
    EXPECT_EQ(difference.missing + difference.invented + difference.out_of_order, 0u);
  }
  const std::string inexact = R"({"decimal": "1"})";
  EXPECT_TRUE(formats::diff_logs(log(one), "a", log(inexact, false), "b").equal());
  // A log without names: as far as its intervals tell.
  const std::string holds = R"({"interval": ["5/4", "3/2"], "decimal": "1.41421356237"})";
  const std::string misses = R"({"interval": ["3/2", "2"], "decimal": "1.50000000000"})";
  EXPECT_TRUE(formats::diff_logs(log(one), "a", log(holds, true, "intervals"), "b").equal());
  EXPECT_FALSE(formats::diff_logs(log(one), "a", log(misses, true, "intervals"), "b").equal());
  const std::string apart = R"({"interval": ["2", "3"], "decimal": "2.00000000000"})";
  EXPECT_FALSE(
      formats::diff_logs(log(holds, true, "intervals"), "a", log(apart, true, "intervals"), "b")
          .equal());
  EXPECT_EQ(formats::diff_logs(log(one), "a", log("", true, "none"), "b").instants,
            formats::InstantsCompared::kNot);
}

// The record of an exact log at this whole number, or of an inexact one near it.
std::string at(int t, const char* instants = "names") {
  const std::string decimal = std::to_string(t) + ".00000000000", whole = std::to_string(t);
  if (std::string_view(instants) == "decimal") {
    return "{\"decimal\": \"" + whole + ".00000000" + std::to_string(t) + "\"}";
  }
  return "{\"polynomial\": [\"-" + whole + "\", \"1\"], \"root\": 1, \"interval\": [\"" + whole +
         "\", \"" + whole + "\"], \"decimal\": \"" + decimal + "\"}";
}

std::string differences_of(const formats::LogDifference& difference) {
  std::string text;
  for (const formats::RecordDifference& one : difference.differences) {
    text +=
        (text.empty() ? "" : " ") + std::to_string(one.line_a) + "|" + std::to_string(one.line_b);
    text += std::string(one.out_of_order ? "o" : "") + (one.other_effect ? "e" : "") +
            (one.other_instant ? "i" : "") + (one.is_change ? "c" : "");
  }
  return text;
}

// Events that come again are told apart by their instants, and without these by where they stand: a
// record that is missing takes no others with it.
TEST(LogDiff, ARecordThatIsMissingAmongMany) {
  for (const char* form : {"names", "decimal", "none"}) {
    const bool none = std::string_view(form) == "none", exact = std::string_view(form) != "decimal";
    const auto log = [&](int without, bool inexact) {
      std::vector<Said> records;
      for (int t = 1; t <= 8; ++t) {
        if (t == without) continue;
        records.push_back(
            {"swap", t % 2 == 0 ? "a" : "b", true, at(t, inexact ? "decimal" : "names")});
      }
      return made_log(records, !inexact, {"l"}, none ? "none" : "names") + last_line("done", "9");
    };
    for (int t = 1; t <= 8; ++t) {
      const formats::LogDifference difference =
          formats::diff_logs(log(0, false), "a", log(t, !exact), "b", 5);
      SCOPED_TRACE(form + std::string(" ") + std::to_string(t));
      EXPECT_EQ(difference.missing, 1u);
      EXPECT_EQ(difference.invented + difference.out_of_order + difference.other_instants, 0u);
      EXPECT_EQ(differences_of(difference), std::to_string(t + 1) + "|0");
      EXPECT_EQ(difference.different, 1u);
      EXPECT_EQ(difference.first, static_cast<std::uint64_t>(t));
      const formats::LogDifference back =
          formats::diff_logs(log(t, !exact), "a", log(0, false), "b", 5);
      EXPECT_EQ(differences_of(back), "0|" + std::to_string(t + 1));
    }
  }
}

// What is left over between equal instants is one event at two instants, or two of different kinds.
TEST(LogDiff, RecordsOneByOne) {
  const auto log = [](const std::vector<std::pair<std::string, int>>& said) {
    std::vector<Said> records;
    for (const auto& [id, t] : said) records.push_back({"swap", id, true, at(t)});
    return made_log(records, true) + last_line("done", "99");
  };
  const auto compared = [&](const auto& a, const auto& b) {
    return differences_of(formats::diff_logs(log(a), "a", log(b), "b", 9));
  };
  using Events = std::vector<std::pair<std::string, int>>;
  EXPECT_EQ(compared(Events{{"a", 1}, {"a", 3}, {"a", 5}}, Events{{"a", 1}, {"a", 4}, {"a", 5}}),
            "3|3i");
  EXPECT_EQ(compared(Events{{"a", 1}, {"a", 3}}, Events{{"a", 3}, {"a", 5}}), "2|0 0|3");
  EXPECT_EQ(compared(Events{{"a", 1}, {"a", 9}}, Events{{"a", 8}}), "2|0 3|2i");
  EXPECT_EQ(compared(Events{{"a", 1}, {"b", 1}, {"c", 2}}, Events{{"b", 1}, {"a", 1}, {"d", 2}}),
            "2|3o 4|0 0|4");
  // An event that comes twice at one instant.
  EXPECT_EQ(compared(Events{{"a", 1}, {"b", 1}, {"a", 1}, {"c", 1}},
                     Events{{"b", 1}, {"a", 1}, {"c", 1}}),
            "2|0");
  const formats::LogDifference many =
      formats::diff_logs(log({{"a", 1}, {"b", 2}, {"c", 3}}), "a", log({}), "b", 2);
  EXPECT_EQ(differences_of(many), "2|0 3|0");
  EXPECT_EQ(many.different, 3u);
  EXPECT_EQ(many.differences[1].row_a, "2  2.00000000000  2  l  swap  b  external");
}

// Where one log ends before the other, the rest of that is neither missing nor invented.
TEST(LogDiff, OneEndsBeforeTheOther) {
  const auto log = [](int from, int to, const std::string& last, const char* form = "names") {
    std::vector<Said> records;
    for (int t = from; t <= to; ++t) {
      if (t == 4) records.push_back({"motion", "c", false, at(t, form)});
      records.push_back({"swap", "a", true, at(t, form)});
    }
    return made_log(records, std::string_view(form) == "names") + last;
  };
  const std::string whole = log(1, 6, last_line("done", "9"));
  for (const char* form : {"names", "decimal"}) {
    for (const std::string& last : {last_line("done", "3"), last_line("limit", "3"), std::string(),
                                    last_line("limit", "2"), std::string("{\"seq\": 4, \"str")}) {
      SCOPED_TRACE(form + last);
      const std::string part = log(1, 3, last, form);
      const formats::LogDifference difference = formats::diff_logs(whole, "a", part, "b", 5);
      EXPECT_EQ(difference.missing + difference.invented + difference.other_records, 0u);
      EXPECT_EQ(difference.other_instants + difference.out_of_order, 0u);
      EXPECT_EQ(difference.after_b, 4u);
      EXPECT_EQ(difference.after_a, 0u);
      EXPECT_EQ(difference.first, 4u);
      EXPECT_EQ(difference.different, 0u);
      EXPECT_FALSE(difference.equal());
      EXPECT_EQ(formats::diff_logs(part, "b", whole, "a").after_a, 4u);
    }
  }
  // What is missing before the end is missing.
  const formats::LogDifference gap = formats::diff_logs(whole, "a", log(2, 3, ""), "b", 5);
  EXPECT_EQ(differences_of(gap), "2|0");
  EXPECT_EQ(gap.after_b, 4u);
  EXPECT_EQ(formats::diff_logs(whole, "a", log(1, 3, last_line("done", "9")), "b").missing, 3u);
  EXPECT_EQ(formats::diff_logs(whole, "a", log(1, 3, last_line("done", "")), "b").missing, 3u);
  // One that was cut off in the midst of an instant.
  std::vector<Said> records = {
      {"swap", "a", true, at(1)}, {"swap", "b", true, at(1)}, {"swap", "c", true, at(1)}};
  const std::string all = made_log(records, true) + last_line("done", "2");
  records.pop_back();
  const formats::LogDifference torn = formats::diff_logs(all, "a", made_log(records, true), "b");
  EXPECT_EQ(torn.missing, 0u);
  EXPECT_EQ(torn.after_b, 1u);
}

// Attributes: external events by what they change, whatever their kind; within an instant in no order.
TEST(LogDiff, ChangesOfAttributes) {
  const auto compare = [](const std::vector<Said>& a, const std::vector<Said>& b) {
    return formats::diff_logs(made_log(a, true) + last_line("done", "9"), "a",
                              made_log(b, true) + last_line("done", "9"), "b", 9, formats::Compared::kAttributes);
  };
  const std::vector<Said> one = {
      {"swap", "a", true, at(1)}, {"swap", "b", true, at(1)}, {"order", "x", false, at(1)}, {"swap", "c", true, at(2)}};
  std::vector<Said> other = {
      {"swap", "b", true, at(1)}, {"tie", "a", true, at(1)}, {"swap", "c", true, at(2)}, {"order", "y", false, at(3)}};
  const formats::LogDifference same = compare(one, other);
  EXPECT_TRUE(same.equal());
  EXPECT_EQ(same.events_a, 3u);
  EXPECT_EQ(same.events_b, 3u);
  // At another instant.
  other[2].time = at(3);
  const formats::LogDifference late = compare(one, other);
  EXPECT_EQ(late.first, 3u);
  EXPECT_EQ(late.other_instants, 1u);
  // A change that is missing, and named by its line.
  other.erase(other.begin() + 1);
  other[1].time = at(2);
  const formats::LogDifference less = compare(one, other);
  EXPECT_EQ(less.missing, 1u);
  EXPECT_EQ(less.invented + less.out_of_order + less.other_instants, 0u);
  ASSERT_EQ(less.differences.size(), 1u);
  EXPECT_EQ(less.differences[0].line_a, 2u);
  EXPECT_FALSE(less.equal());
}

// A log that was cut off anywhere behind its first line is read as far as its lines are whole.
TEST(LogDiff, LogsThatAreCutAnywhere) {
  std::vector<Said> records;
  for (int t = 1; t <= 2; ++t) records.push_back({"swap", "\u00e4\\u00e4\\\"", t == 1, at(t)});
  const std::string whole = made_log(records, true) + last_line("done", "2");
  const std::size_t header = whole.find('\n');
  for (std::size_t size = header + 1; size < whole.size() - 1; ++size) {
    const std::string cut = whole.substr(0, size);
    const formats::LogDifference difference = formats::diff_logs(whole, "a", cut, "b");
    const std::size_t lines = static_cast<std::size_t>(std::count(cut.begin(), cut.end(), '\n'));
    // A line is whole without its line break, too.
    const bool in_a_line = whole[size] != '\n' && cut.back() != '\n';
    EXPECT_EQ(difference.ending_b.status, "cut off") << size;
    EXPECT_EQ(difference.ending_b.cut_line, in_a_line ? lines + 1 : 0) << size;
    EXPECT_EQ(difference.missing + difference.invented, 0u) << size;
  }
  EXPECT_THROW(formats::diff_logs(whole, "a", whole.substr(0, header / 2), "b"),
               formats::InputError);
}

}  // namespace log_diff_test
}  // namespace kinex

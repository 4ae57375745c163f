// SPDX-License-Identifier: GPL-3.0-or-later
// Files of collision queries: what is read, what is refused and how, how names determine kinds.
#include "experiments/formats/query_file.h"

#include <gtest/gtest.h>

#include "experiments/formats/query_answers.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace query_file_test {

std::string lines(const std::string& row, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += row + "\n";
  return text;
}

formats::QueryFile parse(const std::string& text) {
  return formats::parse_queries(text, "q.csv", ContactKind::kVertexFace);
}

TEST(QueryFile, CoordinatesAreExact) {
  const char* const kSeventhRow =
      "-9007199254740993,3,5,-9223372036854775808,1,-18446744073709551616\n";
  const std::string text =
      lines("1,2,-3,4,0,1", 6) + kSeventhRow + lines("9007199254740993,1,1,-3,7,7", 1);
  const formats::QueryFile file = parse(text + lines("1,2,-3,4,0,1", 8));
  ASSERT_EQ(file.queries.size(), 2u);
  EXPECT_FALSE(file.has_truth);
  EXPECT_EQ(file.queries[0].line, 1u);
  EXPECT_EQ(file.queries[1].line, 9u);
  const auto at = [&](int time, std::size_t point, std::size_t axis) {
    return file.queries[0].query.coordinate(ContactQuery::index(time, point, axis)).to_string();
  };
  EXPECT_EQ(at(0, 0, 0), "1/2");
  EXPECT_EQ(at(0, 3, 1), "-3/4");
  EXPECT_EQ(at(1, 1, 2), "0");
  EXPECT_EQ(at(1, 2, 0), "-3002399751580331");
  EXPECT_EQ(at(1, 2, 1), "-5/9223372036854775808");
  EXPECT_EQ(at(1, 2, 2), "-1/18446744073709551616");
  EXPECT_EQ(at(1, 3, 0), "9007199254740993");  // not a double
  EXPECT_EQ(at(1, 3, 1), "-1/3");
  EXPECT_EQ(at(1, 3, 2), "1");
  EXPECT_FALSE(file.queries[0].query.all_doubles());
  EXPECT_TRUE(file.queries[1].query.all_doubles());
}

TEST(QueryFile, DoublesInAnyFormStayDoubles) {
  // 2^-200 and 2^200 * 3, by fractions that no machine word holds.
  const std::string huge = Integer::power_of_two(200).to_string();
  const formats::QueryFile file = parse(lines("1," + huge + ",-3,-1," + huge + ",-1", 8));
  EXPECT_TRUE(file.queries[0].query.all_doubles());
  EXPECT_EQ(file.queries[0].query.rounded(0).value, 0x1p-200);
  EXPECT_EQ(file.queries[0].query.rounded(1).value, 3);
  EXPECT_EQ(file.queries[0].query.rounded(2).value, -0x1p200);
}

TEST(QueryFile, TruthBelongsToAQuery) {
  const formats::QueryFile file = parse(lines("1,2,-3,4,0,1,1", 8) + lines("1,2,-3,4,0,1,0", 8));
  EXPECT_TRUE(file.has_truth);
  EXPECT_TRUE(file.queries[0].truth);
  EXPECT_FALSE(file.queries[1].truth);
}

TEST(QueryFile, ErrorsNameLineTextAndRemedy) {
  EXPECT_INPUT_ERROR(parse(lines("1,2,-3,4,0,1", 9)),
                     "q.csv: line 9: the last query has only 1 line; a query is 8 lines");
  EXPECT_INPUT_ERROR(parse(lines("1,2,-3,4,0,1", 7) + "1,2,-3,0,0,1"),
                     "q.csv: line 8: the denominator \"0\" is zero; write a non-zero integer");
  EXPECT_INPUT_ERROR(parse("\n\n1,2,3\n"), "q.csv: line 3: 3 columns in \"1,2,3\"; write x_num");
  EXPECT_INPUT_ERROR(parse(lines("1,2,-3,4,0,1,1", 7) + "1,2,-3,4,0,1,0"),
                     "q.csv: line 8: the truth \"0\" differs from that in line 1");
}

TEST(QueryFile, KindsByName) {
  using Kind = std::optional<ContactKind>;
  EXPECT_EQ(formats::contact_kind_of_path("spikes/edge-edge/data_0_0.csv"), Kind(ContactKind::kEdgeEdge));
  EXPECT_EQ(formats::contact_kind_of_path("/a/vertex-face/data"), Kind(ContactKind::kVertexFace));
  EXPECT_EQ(formats::contact_kind_of_path("edge-edge/vertex-face-1.csv"), Kind(ContactKind::kVertexFace));
  EXPECT_EQ(formats::contact_kind_of_path("my-edge-edge.csv"), Kind(ContactKind::kEdgeEdge));
  EXPECT_EQ(formats::contact_kind_of_path("edge-edge//x.csv"), Kind(ContactKind::kEdgeEdge));
  EXPECT_EQ(formats::contact_kind_of_path("vertex-face/edge-edge-vertex-face"), Kind());
  EXPECT_EQ(formats::contact_kind_of_path("data.csv"), Kind());
  EXPECT_EQ(formats::contact_kind_of_path("-"), Kind());
  EXPECT_EQ(formats::contact_kind_of_path(""), Kind());
  EXPECT_EQ(formats::contact_kind_of_path("/"), Kind());
}

TEST(ContactTally, CountsAgainstTheTruth) {
  formats::ContactTally tally;
  tally.count(true, true);
  tally.count(false, false);
  tally.count(false, false);
  EXPECT_FALSE(tally.differs());
  tally.count(true, false);
  EXPECT_TRUE(tally.differs());
  tally.count(false, true);
  tally.count(true, std::nullopt);
  EXPECT_EQ(formats::tally_json(tally, "q.csv", ContactKind::kEdgeEdge, true),
            "{\"file\": \"q.csv\", \"kind\": \"edge-edge\", \"queries\": 6, \"contacts\": 3, "
            "\"true_positives\": 1, \"true_negatives\": 2, \"false_positives\": 1, "
            "\"false_negatives\": 1}\n");
  EXPECT_THAT(formats::tally_json(tally, "q\xff.csv", ContactKind::kEdgeEdge, false),
              testing::StartsWith("{\"file\": \"\\\"q\\\\xff.csv\\\"\", "));
}

}  // namespace query_file_test
}  // namespace kinex

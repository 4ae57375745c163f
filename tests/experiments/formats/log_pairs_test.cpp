// SPDX-License-Identifier: GPL-3.0-or-later
// Which structures of one log are compared with which of another.
#include "experiments/formats/log_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/formats/input_error.h"

namespace kinex {
namespace log_pairs_test {

using formats::Compared;
using testing::HasSubstr;

formats::LogStructure structure(const std::string& label, const std::string& name,
                                const std::string& options = "", const std::string& key = "") {
  return {label, name, key, {}, options};
}

formats::LogHeader header(std::vector<formats::LogStructure> structures) {
  formats::LogHeader made;
  made.structures = std::move(structures);
  return made;
}

// "a=b c=d", and behind ! what is alone in each.
std::string pairs(const std::vector<formats::LogStructure>& a,
                  const std::vector<formats::LogStructure>& b,
                  Compared compared = Compared::kAttributes) {
  const formats::LogPairs made = formats::pair_structures(header(a), "a", header(b), "b", compared);
  std::string text;
  for (const auto& [other, label] : made.labels_b)
    text += (text.empty() ? "" : " ") + label + "=" + other;
  for (const auto* only : {&made.only_a, &made.only_b}) {
    for (const std::string& label : *only) text += " !" + label;
  }
  return text;
}

std::string refusal(const std::vector<formats::LogStructure>& a,
                    const std::vector<formats::LogStructure>& b,
                    Compared compared = Compared::kAttributes) {
  try {
    return pairs(a, b, compared);
  } catch (const formats::InputError& error) {
    return error.what();
  }
}

TEST(LogPairs, StructuresOfOneAttribute) {
  EXPECT_EQ(pairs({structure("l", "emst_list")}, {structure("c", "emst_cycles")}), "l=c");
  EXPECT_THAT(
      refusal({structure("l", "emst_list")}, {structure("c", "emst_cycles")}, Compared::kEvents),
      testing::AllOf(
          HasSubstr("b: line 1: it has no structure in common with a: it maintains emst_cycles, "
                    "the other emst_list"),
          HasSubstr("--attributes")));
  // Those for other attributes are none, and no group is no attribute in common.
  EXPECT_THAT(refusal({structure("l", "emst_list")}, {structure("c", "closest_pair_all")}),
              HasSubstr("b: line 1: it has no attribute in common with a"));
  EXPECT_THAT(refusal({structure("l", "sorted_list", "", "\"x\"")}, {structure("d", "delaunay_2")}),
              HasSubstr("no attribute in common"));
  // A structure that this program does not know is like itself.
  EXPECT_EQ(pairs({structure("l", "mine")}, {structure("k", "mine")}), "l=k");
  EXPECT_THAT(refusal({structure("l", "mine")}, {structure("k", "ours")}),
              HasSubstr("no attribute in common"));
}

// The same label first, then the same structure, then the same attribute; each once.
TEST(LogPairs, WhichOfSeveral) {
  EXPECT_EQ(pairs({structure("x", "emst_list"), structure("y", "emst_cycles")},
                  {structure("u", "emst_cycles"), structure("x", "emst_clusters")}),
            "y=u x=x");
  EXPECT_EQ(pairs({structure("x", "emst_list")},
                  {structure("u", "emst_cycles"), structure("v", "emst_list")}),
            "x=v !u");
  EXPECT_EQ(pairs({structure("x", "emst_list"), structure("y", "delaunay_2")},
                  {structure("u", "emst_cycles")}),
            "x=u !y");
}

// What makes another attribute, and what is a matter of the method.
TEST(LogPairs, KeysObjectsAndParameters) {
  const auto together = [](const std::string& name, const std::string& options,
                           const std::string& other, const std::string& others) {
    return refusal({structure("a", name, options)}, {structure("b", other, others)}) == "a=b";
  };
  EXPECT_TRUE(together("emst_clusters", R"({"cluster":3})", "emst_list", ""));
  EXPECT_TRUE(together("directions_2", "", "directions_2_tournament", ""));
  EXPECT_TRUE(together("directions_2", R"({"k":5})", "directions_2_tournament", R"({"k":5})"));
  EXPECT_FALSE(together("directions_2", R"({"k":5})", "directions_2_tournament", R"({"k":6})"));
  EXPECT_FALSE(together("directions_2", R"({"k":5})", "directions_2_tournament", ""));
  EXPECT_FALSE(together("emst_list", R"({"of":["p","q"]})", "emst_cycles", ""));
  EXPECT_TRUE(together("emst_list", R"({"of":["p","q"]})", "emst_cycles", R"({"of":["p","q"]})"));
  // Of what is read the parameters count, not the name.
  EXPECT_TRUE(
      together("diameter_2", R"({"over":"convex_hull_2_naive"})", "diameter_all_pairs", ""));
  EXPECT_TRUE(together("diameter_2", R"({"over":"convex_hull_2_naive"})", "diameter_2", ""));
  EXPECT_TRUE(together("mst_polygon_list", R"({"over":{"corners":20,"structure":"cones_local"}})",
                       "mst_polygon_cycles",
                       R"({"over":{"corners":20,"structure":"cones_local"}})"));
  EXPECT_FALSE(together("mst_polygon_list", R"({"over":{"corners":20,"structure":"cones_local"}})",
                        "mst_polygon_cycles", ""));
  EXPECT_EQ(pairs({structure("a", "maximum_heap", "", "\"x\"")},
                  {structure("b", "maximum_hanger", "", "\"x\"")}),
            "a=b");
  EXPECT_THAT(refusal({structure("a", "maximum_heap", "", "\"x\"")},
                      {structure("b", "maximum_hanger", "", "\"y\"")}),
              HasSubstr("no attribute in common"));
}

}  // namespace log_pairs_test
}  // namespace kinex

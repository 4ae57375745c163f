// SPDX-License-Identifier: GPL-3.0-or-later
// kinex gen as it is typed: sizes and their defaults, what is maintained, and what is said where it cannot be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/formats/json_document.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace gen_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

Finished gen(Words words) {
  words.insert(words.begin(), "gen");
  return run_kinex(words);
}

void expect_refused(const Words& words, const std::string& message) {
  const Finished finished = gen(words);
  EXPECT_EQ(finished.exit_code, 2) << finished.out;
  EXPECT_THAT(finished.err, HasSubstr("kinex: " + message + "\n"));
}

// What --help says of one workload is said of that one; of all, what holds for them.
TEST(Gen, HelpNamesTheSizesOfAWorkload) {
  EXPECT_THAT(gen({"walks", "--help"}).out,
              AllOf(HasSubstr("  --n  objects: 100 by default, 1 at least\n"),
                    HasSubstr("  --m  flight plans of each object: 20 by default, 1 at least\n"),
                    Not(HasSubstr("Workloads:"))));
  EXPECT_THAT(gen({"hull-worst", "--help"}).out,
              AllOf(HasSubstr("  --n  moving points: 100 by default, 1 at least\n"),
                    HasSubstr("  --m  slow points: as --n by default, 1 at least\n")));
  const std::string all = gen({"--help"}).out;
  EXPECT_THAT(all, HasSubstr("Workloads:"));
  std::string text;  // without line breaks
  for (const char c : all) {
    if (c != '\n' && (c != ' ' || (!text.empty() && text.back() != ' '))) text += c;
    if (c == '\n' && !text.empty() && text.back() != ' ') text += ' ';
  }
  EXPECT_THAT(text, HasSubstr("(100; tournament-worst: 64)"));
  EXPECT_THAT(text, HasSubstr("(same as --n; walks: 20, skew-rows: 1, polygons-in-box: 8, "
                              "parallel-edges: 1, random-graph: 10)"));
}

TEST(Gen, PowersOfTwo) {
  const Finished usual = gen({"tournament-worst", "-v"});
  EXPECT_EQ(usual.exit_code, 0) << usual.err;
  EXPECT_THAT(usual.err, HasSubstr(", 64 objects, "));
  expect_refused({"tournament-worst", "--n", "100"},
                 "tournament-worst: --n: \"100\" is not a power of two; write 64 or 128");
  expect_refused({"tournament-worst", "--n", "3"},
                 "tournament-worst: --n: \"3\" is not a power of two; write 2 or 4");
  expect_refused({"tournament-worst", "--n", "9000000"},
                 "tournament-worst: --n: \"9000000\" is not a power of two; write 8388608");
}

// Its name and its summary are those of a hull.
TEST(Gen, TheWorstHullMaintainsAHull) {
  const Finished made = gen({"hull-worst", "--n", "3"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const formats::JsonDocument scene = formats::parse_json(made.out, "scene");
  ASSERT_EQ(scene->find("maintain")->items().size(), 1u);
  EXPECT_EQ(scene->find("maintain")->items()[0].text(), "convex_hull_2");
}

TEST(Gen, WhatAStructureNeeds) {
  expect_refused(
      {"uniform-square", "--n", "8", "--maintain", "graph_mst_list"},
      "--maintain: \"graph_mst_list\" is for 1 axis, the scene has 2; give --dimension 1");
  EXPECT_EQ(gen({"uniform-square", "--n", "8", "--dimension", "1", "--maintain", "graph_mst_list"})
                .exit_code,
            0);
  expect_refused({"uniform-square", "--n", "8", "--maintain", "delaunay_3"},
                 "--maintain: \"delaunay_3\" needs 3 axes, the scene has 2; give --dimension 3");
  expect_refused({"sort-worst", "--n", "8", "--maintain", "delaunay_2"},
                 "--maintain: \"delaunay_2\" needs 2 axes, the scene has 1; choose another "
                 "workload: kinex gen "
                 "uniform-square --maintain delaunay_2");
  expect_refused({"uniform-square", "--n", "8", "--maintain", "line_arrangement_2,delaunay_2"},
                 "--maintain: \"delaunay_2\" is for points, the scene has lines; maintain it in a "
                 "scene of its own: "
                 "the objects would have to be of another kind");
}

// What is written is read.
TEST(Gen, WhatNobodyReadsIsNotWritten) {
  EXPECT_EQ(gen({"breathing", "--n", "100"}).exit_code, 0);
  expect_refused({"breathing", "--n", "101"},
                 "gen: breathing cannot be made of these options: /objects/3/weight: a weight of degree 101; "
                 "choose smaller sizes (kinex gen breathing --help names them)");
  expect_refused({"random-graph", "--maintain", "disc_pairs_all"},
                 "gen: random-graph cannot be made of these options: /objects/0/ends: vertices of a disc; "
                 "choose another workload: kinex gen uniform-square --maintain disc_pairs_all");
}

// Decimal digits, whatever they begin with.
TEST(Gen, SizesAreDecimal) {
  const Finished ten = gen({"grid", "--n", "10"});
  EXPECT_EQ(gen({"grid", "--n", "010"}).out, ten.out);
  EXPECT_EQ(gen({"grid", "--n", "0000000000000000000000010"}).out, ten.out);
  expect_refused({"grid", "--n", "0x10"},
                 "--n: \"0x10\" is not a whole number that fits; write one from 1 to 10000000");
  expect_refused({"grid", "--degree", "0x1"},
                 "--degree: \"0x1\" is not a whole number that fits; write one, as 100");
}

// Discs are boxes, and have weights: one scene is for all three.
TEST(Gen, ObjectsForSeveralStructures) {
  for (const char* maintain :
       {"box_pairs,disc_pairs_all", "disc_pairs_all,box_pairs", "box_pairs,regular_2"}) {
    const Finished made = gen({"uniform-square", "--n", "6", "--maintain", maintain});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Finished run = run_kinex({"run", "-", "--audit", "events"}, made.out);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("(discs)"));
  }
  EXPECT_THAT(gen({"uniform-square", "--n", "6", "--maintain", "box_pairs"}).out,
              HasSubstr("half_extents"));
}

// Names of groups and families are taken for structures.
TEST(Gen, GroupsAndFamiliesAreNoStructures) {
  const std::string closest =
      "\"closest_pair\" is what several structures maintain, not one of them; write one of "
      "closest_pair_delaunay, "
      "closest_pair_all, ";
  const Finished refused = gen({"uniform-square", "--n", "8", "--maintain", "closest_pair"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err,
              AllOf(HasSubstr("kinex: --maintain: " + closest), HasSubstr("closest_pair_bins")));
  // In space only those that can be there are named.
  expect_refused({"uniform-square", "--n", "8", "--dimension", "3", "--maintain", "closest_pair"},
                 "--maintain: \"closest_pair\" is what several structures maintain, not one of "
                 "them; write one of "
                 "closest_pair_delaunay, closest_pair_all");
  expect_refused({"uniform-square", "--n", "8", "--maintain", "proximity"},
                 "--maintain: \"proximity\" is a family of structures, not one of them; kinex list "
                 "structures --family "
                 "proximity names them");
  std::string scene = gen({"uniform-square", "--n", "8"}).out;
  const std::size_t at = scene.find("\"delaunay_2\"");
  ASSERT_NE(at, std::string::npos);
  scene.replace(at, 12, "\"closest_pair\"");
  EXPECT_THAT(run_kinex({"run", "-"}, scene).err, HasSubstr("/maintain/0: " + closest));
  EXPECT_THAT(run_kinex({"run", "-", "--maintain", "maximum:x"}, gen({"grid", "--n", "4"}).out).err,
              HasSubstr("--maintain: \"maximum\" is what several structures maintain, not one of "
                        "them; write one of "
                        "maximum_tournament, maximum_heap, "));
}

// Two structures of one kind: the lines of their bounds are told apart.
TEST(Gen, BoundsHaveLabels) {
  const Finished made =
      gen({"uniform-square", "--n", "5", "--maintain",
           "sorted_list,sorted_list:y,{\"structure\": \"sorted_list\", \"as\": \"across\", "
           "\"key\": {\"direction\": [1, 1]}}"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Finished run = run_kinex({"run", "-"}, made.out);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* name : {"sorted_list.swaps: ", "sorted_list:y: sorted_list.swaps: ",
                           "across: sorted_list.swaps: "}) {
    EXPECT_THAT(run.out, HasSubstr("\nbound     " + std::string(name)));
  }
}

}  // namespace gen_test
}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// kinex diff --attributes: structures for one attribute, on scenes where much happens at one instant.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/formats/file_io.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace diff_attributes_test {

using testing::HasSubstr;
using testing::StartsWith;

class DiffAttributes : public testing::Test {
 protected:
  // The log of a run of the scene.
  std::string log(const std::string& structure, const std::vector<std::string>& more = {}) {
    std::string file = scratch_.file(structure + (more.empty() ? "" : more.back()) + ".jsonl");
    std::vector<std::string> command = {"run", scene_, "--maintain", structure, "--events", file};
    command.insert(command.end(), more.begin(), more.end());
    EXPECT_EQ(run_kinex(command).exit_code, 0) << structure;
    return file;
  }
  void scene(const std::vector<std::string>& words) {
    std::vector<std::string> command = {"gen"};
    command.insert(command.end(), words.begin(), words.end());
    command.insert(command.end(), {"-o", scene_, "--force"});
    ASSERT_EQ(run_kinex(command).exit_code, 0);
  }

  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json");
};

// A grid: many events at an instant, in another order and of other kinds by method.
TEST_F(DiffAttributes, MethodsAgree) {
  scene({"grid", "--n", "16"});
  for (const std::vector<std::string>& group :
       {std::vector<std::string>{"emst_list", "emst_cycles", "emst_clusters"},
        {"maximum_tournament", "maximum_heap", "maximum_hanger", "maximum_envelope",
         "maximum_sorted_list"},
        {"convex_hull_2", "convex_hull_2_naive", "convex_hull_2_brute_force",
         "convex_hull_2_delaunay"},
        {"closest_pair_all", "closest_pair_delaunay", "closest_pair_cones", "closest_pair_bins"}}) {
    const std::string first = log(group[0]);
    for (std::size_t i = 1; i < group.size(); ++i) {
      const std::string other = log(group[i]);
      EXPECT_EQ(run_kinex({"diff", "--attributes", first, other, "-q"}).exit_code, 0) << group[i];
    }
  }
  const Finished told = run_kinex({"diff", "--attributes", scratch_.file("emst_list.jsonl"),
                                   scratch_.file("emst_cycles.jsonl")});
  EXPECT_THAT(told.out, HasSubstr("emst_list of " + scratch_.file("emst_list.jsonl") +
                                  " is compared with emst_cycles of "));
  EXPECT_THAT(told.out, HasSubstr("\nequal: "));
  // Their other events are not the same, and without the option there is nothing to compare but what they read.
  EXPECT_THAT(
      run_kinex({"diff", scratch_.file("emst_list.jsonl"), scratch_.file("emst_cycles.jsonl")}).out,
      HasSubstr("not compared: emst_list\n"));
}

// A change that is missing, and one at another instant, are found and named.
TEST_F(DiffAttributes, WhatIsMissingIsNamed) {
  scene({"uniform-square", "--n", "12", "--seed", "1"});
  const std::string one = log("closest_pair_all"), two = log("closest_pair_local");
  std::string text = formats::read_text_file(two);
  const std::size_t change =
      text.find("\"structure\": \"closest_pair_local\", \"kind\": \"replace\"");
  ASSERT_NE(change, std::string::npos);
  std::size_t external = text.find("\"external\": true", change);
  while (external != std::string::npos && text.find("\"structure\": \"closest_pair_local\"",
                                                    text.rfind('\n', external)) > external) {
    external = text.find("\"external\": true", external + 1);
  }
  ASSERT_NE(external, std::string::npos);
  const std::size_t begin = text.rfind('\n', external) + 1, end = text.find('\n', external) + 1;
  text.erase(begin, end - begin);
  write_file(two, text);
  const Finished told = run_kinex({"diff", "--attributes", one, two});
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_THAT(told.out, HasSubstr(": 1 missing, 0 invented, 0 out of order"));
  const Finished json = run_kinex({"diff", "--attributes", "--json", one, two});
  EXPECT_THAT(json.out, StartsWith("{\"equal\": false, \"compared\": \"attributes\", "));
}

// Exact against floating, by other methods.
TEST_F(DiffAttributes, ExactAgainstDouble) {
  scene({"uniform-square", "--n", "12", "--seed", "1"});
  const std::string one = log("emst_list"), two = log("emst_cycles", {"--arithmetic", "double"});
  const Finished told = run_kinex({"diff", "--attributes", one, two});
  EXPECT_EQ(told.exit_code, 0) << told.out;
  EXPECT_THAT(told.out, HasSubstr("; instants not compared\n"));
}

TEST_F(DiffAttributes, OtherAttributesAreRefused) {
  scene({"uniform-square", "--n", "6"});
  const std::string one = log("closest_pair_all"), two = log("convex_hull_2");
  const Finished told = run_kinex({"diff", "--attributes", one, two});
  EXPECT_EQ(told.exit_code, 2);
  EXPECT_THAT(told.err, HasSubstr(two + ": line 1: it has no attribute in common with " + one));
}

}  // namespace diff_attributes_test
}  // namespace kinex

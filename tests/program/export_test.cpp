// SPDX-License-Identifier: GPL-3.0-or-later
// kinex export and import: a scene goes out and comes back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program/spawn.h"

namespace kinex {
namespace export_test {

using testing::HasSubstr;
using testing::StartsWith;

// Text as a scene has it, for people, goes out and comes back.
TEST(Export, WholeScenes) {
  const ScratchFolder scratch;
  const std::string scene = scratch.file("red.json"), features = scratch.file("red.mfjson");
  write_file(
      scene,
      R"({"kinex": 1, "name": "red", "description": "one red point", "dimension": 1, )"
      R"("time": {"start": 0, "end": 4}, "objects": [)"
      R"({"id": "a", "colour": "red", "motion": [{"from": 0, "to": 3, "coordinates": [[0, 1]]}]}, )"
      R"({"id": "b", "motion": [{"from": 3, "coordinates": [[1]]}]}], )"
      R"("maintain": [{"structure": "sorted_list", "of": "red"}]})");
  const Finished out = run_kinex({"export", scene, "--mf-json", "-o", features});
  EXPECT_EQ(out.err, "kinex: 2 objects, exactly\n");
  const Finished back = run_kinex({"import", features});
  EXPECT_THAT(back.out, HasSubstr("\"description\": \"one red point\""));
  write_file(scene, back.out);
  EXPECT_EQ(run_kinex({"export", scene, "--mf-json"}).out, read_file(features));
  // Up to a time at which b is not there yet; a time at which the red one is not there.
  EXPECT_THAT(run_kinex({"export", scene, "--mf-json", "--until", "2"}).err,
              StartsWith("kinex: 1 object, exactly; kinex import gives the same motions"));
  std::string late = read_file(scene);
  late.replace(late.find("\"colour\": \"red\", "), 17, "");
  late.replace(late.find("\"id\": \"b\", "), 11, "\"id\": \"b\", \"colour\": \"red\", ");
  write_file(scene, late);
  const Finished refused = run_kinex({"export", scene, "--mf-json", "--until", "2"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err,
              HasSubstr("such a file cannot hold the scene, kinex import refuses it: no object has "
                        "the colour \"red\"; give a later --until, or leave it out"));
  // Other structures are asked for: those of the file are not looked at.
  EXPECT_EQ(run_kinex({"import", features, "--maintain", "maximum_heap"}).exit_code, 0);
}

}  // namespace export_test
}  // namespace kinex

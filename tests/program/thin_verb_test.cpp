// SPDX-License-Identifier: GPL-3.0-or-later
// kinex thin from outside: the scene that it writes keeps the diameter, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/numbers/rational.h"
#include "experiments/formats/scene_reader.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace thin_verb_test {

using testing::HasSubstr;

Rational squared_diameter(const Scene& scene, const Rational& t) {
  Rational best;
  for (const SceneObject& a : scene.objects) {
    for (const SceneObject& b : scene.objects) {
      Rational sum;
      for (const int axis : {0, 1}) {
        const Rational d = a.motion.pieces[0].trajectory.position(axis, t) -
                           b.motion.pieces[0].trajectory.position(axis, t);
        sum += d * d;
      }
      best = std::max(best, sum);
    }
  }
  return best;
}

TEST(ThinVerb, WritesASceneThatKeepsTheDiameter) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json"), thin = scratch.file("thin.json");
  ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "60", "--seed", "8", "-o", scene}).exit_code, 0);
  const Scene all = formats::read_scene(scene);
  std::set<std::string> names;
  for (const SceneObject& object : all.objects) names.insert(object.id);
  std::size_t before = 0;
  for (const char* error : {"1/2", "1/10", "1/50"}) {
    SCOPED_TRACE(error);
    const Finished run = run_kinex({"thin", scene, "--error", error, "--force", "-o", thin});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr(" of 60 objects"));
    const Scene some = formats::read_scene(thin);
    EXPECT_LT(some.objects.size(), 60u);
    EXPECT_GE(some.objects.size(), before);
    before = some.objects.size();
    for (const SceneObject& object : some.objects) EXPECT_TRUE(names.contains(object.id));
    const Rational kept = Rational(1) - *Rational::parse(error);
    for (int i = -7; i <= 13; ++i) {  // after the end, too
      const Rational t = Rational(i) / Rational(6);
      EXPECT_GE(squared_diameter(some, t), kept * kept * squared_diameter(all, t));
    }
    EXPECT_EQ(run_kinex({"check", thin}).exit_code, 0);
    EXPECT_EQ(run_kinex({"run", thin, "--maintain", "diameter_2", "--audit", "events"}).exit_code, 0);
  }
  EXPECT_GT(before, 4u);
  // Without --output on standard output, and the usual error is 1/50.
  const Finished out = run_kinex({"thin", scene});
  EXPECT_EQ(out.exit_code, 0);
  EXPECT_EQ(out.out, read_file(thin));
}

// Nobody may name a colour that no object has.
TEST(ThinVerb, KeepsOneOfEachColourThatIsNamed) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json"), thin = scratch.file("thin.json");
  write_file(scene, R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 1}, "objects": [
    {"id": "a", "motion": [[-9], [-9]]}, {"id": "b", "motion": [[9], [-9]]}, {"id": "c", "motion": [[0], [9]]},
    {"id": "r", "motion": [[0], [0]], "colour": "red"}, {"id": "s", "motion": [[1], [0]], "colour": "red"},
    {"id": "t", "motion": [[0], [1]], "colour": "blue"}, {"id": "u", "motion": [[0], [2]], "colour": "green"},
    {"id": "v", "motion": [[1], [1]], "colour": "grey"}],
    "maintain": ["diameter_2", {"structure": "bichromatic_pair_all", "colours": ["red", "blue"]},
      {"structure": "sorted_list", "of": "green"}]})");
  const Finished run = run_kinex({"thin", scene, "--error", "1/2", "-o", thin});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::string left;
  for (const SceneObject& object : formats::read_scene(thin).objects) left += object.id;
  EXPECT_EQ(left, "abcrtu");
  EXPECT_EQ(run_kinex({"run", thin}).exit_code, 0);
}

TEST(ThinVerb, RefusesByName) {
  ScratchFolder scratch;
  const auto made = [&scratch](const char* name, std::vector<std::string> how) {
    const std::string file = scratch.file(name);
    how.insert(how.begin(), "gen");
    how.insert(how.end(), {"-o", file});
    EXPECT_EQ(run_kinex(how).exit_code, 0) << name;
    return file;
  };
  const std::string plane = made("plane.json", {"uniform-square", "--n", "5"});
  const std::string line = made("line.json", {"uniform-square", "--n", "5", "--dimension", "1"});
  const std::string curved = made("curved.json", {"uniform-square", "--n", "5", "--degree", "2"});
  const std::string bodies = made("bodies.json", {"polygon-orbit", "--n", "4"});
  const std::string lines = made("lines.json", {"random-lines-and-points", "--n", "5"});
  const std::string discs = made("discs.json", {"random-discs", "--n", "5"});
  const std::string boxes = made("boxes.json", {"random-boxes", "--n", "5"});
  struct Bad {
    std::vector<std::string> arguments;
    std::string says;
  };
  const std::vector<Bad> all{
      {{plane, "--error", "0"},
       "--error: 0 is no part of the diameter that may be lost; write a number from 1/100000 on, "
       "less than 1, as 1/50: the"},
      {{plane, "--error", "1"}, "--error: 1 is no part of the diameter that may be lost; write"},
      {{plane, "--error", "-1/2"}, "--error: -1/2 is no part of the diameter"},
      {{plane, "--error", "1" + std::string(999, '9')},
       "--error: 1" + std::string(39, '9') + "... (1000 characters) is no part of the diameter"},
      {{plane, "--error", "some"}, "--error: \"some\""},
      {{plane, "-o", plane}, "--output"},
      {{line},
       "line.json: the scene has 1 axis; a kernel is a few points whose diameter is nearly that of "
       "all, in the plane: give a scene with 2 axes"},
      {{curved}, "has a motion of degree 2; give a scene of linear motion"},
      {{bodies}, "bodies.json: the objects are bodies; give a scene of points"},
      {{lines},
       "lines.json: some objects are lines, which have no diameter; give a scene of points"},
      {{discs},
       "discs.json: the objects are discs, and the diameter is that of points; give a scene of "
       "points"},
      {{boxes}, "boxes.json: the objects are boxes, and"},
      {{scratch.file("none.json")}, "none.json"},
  };
  for (const Bad& bad : all) {
    std::vector<std::string> arguments{"thin"};
    arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
    const Finished run = run_kinex(arguments);
    EXPECT_EQ(run.exit_code, 2) << bad.says;
    EXPECT_THAT(run.err, HasSubstr(bad.says));
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace thin_verb_test
}  // namespace kinex

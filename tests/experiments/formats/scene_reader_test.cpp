// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/scene_reader.h"

#include <gtest/gtest.h>

#include "experiments/formats/scene_writer.h"
#include "tests/experiments/expect_input_error.h"
#include "tests/sanitized.h"

namespace kinex {
namespace scene_reader_test {

Scene parse(const std::string& text) { return formats::parse_scene(text, "s.json"); }

Scene with_coefficient(const std::string& token) {
  return parse(R"({"kinex": 1, "dimension": 1, "time": {"start": 0},
                   "objects": [{"id": "a", "motion": [[)" +
               token + "]]}]}");
}

Rational coefficient(const std::string& token) {
  return with_coefficient(token).objects[0].motion.pieces[0].trajectory.coordinates[0][0];
}

Rational ratio(int p, int q) { return Rational(Integer(p), Integer(q)); }

TEST(SceneReader, NumbersAreReadExactly) {
  EXPECT_EQ(coefficient("0.1"), ratio(1, 10));
  EXPECT_EQ(coefficient("1e2"), Rational(100));
  EXPECT_EQ(coefficient("1E2"), Rational(100));
  EXPECT_EQ(coefficient("-2.50"), ratio(-5, 2));
  EXPECT_EQ(coefficient("\"2/6\""), ratio(1, 3));
  EXPECT_EQ(coefficient("\"0x1.8p+3\""), Rational(12));
  EXPECT_EQ(coefficient("\"1e-300\""), Rational(Integer(1), power(Integer(10), 300)));
  EXPECT_EQ(coefficient("1e-400"), Rational(Integer(1), power(Integer(10), 400)));
  EXPECT_EQ(coefficient("9007199254740993").to_string(), "9007199254740993");
  EXPECT_EQ(coefficient("123456789012345678901234567890").to_string(),
            "123456789012345678901234567890");
}

constexpr const char* kExample = R"(
  {"kinex": 1, "name": "two-crossing", "dimension": 2, "time": {"start": 0, "end": 1},
   "objects": [
     {"id": "a", "motion": [[0, 1], ["1/3", 0, -1]]},
     {"id": "b", "motion": [{"from": 0, "to": "1/2", "coordinates": [[1, -1], [0]]},
                            {"from": "1/2", "to": 1, "coordinates": [["1/2"], [0, "0.0"]]}]}],
   "maintain": ["sorted_list", {"structure": "sorted_list", "key": {"direction": ["3", "4"]},
                "as": "along"}, {"structure": "sorted_list", "key": "y", "as": "by y"},
                {"structure": "sorted_list", "key": {"squared_distance_to": "a"}, "as": "far"}]})";

TEST(SceneReader, ReadsTheExample) {
  const Scene scene = parse(kExample);
  EXPECT_EQ(scene.name, "two-crossing");
  EXPECT_EQ(scene.dimension, 2);
  EXPECT_EQ(scene.start, Rational(0));
  EXPECT_EQ(*scene.end, Rational(1));
  EXPECT_EQ(scene.degree(), 2);
  ASSERT_EQ(scene.objects.size(), 2u);
  const Motion& b = scene.objects[1].motion;
  ASSERT_EQ(b.pieces.size(), 2u);
  EXPECT_EQ(*b.pieces[0].to, ratio(1, 2));
  EXPECT_EQ(b.pieces[1].trajectory.degree(), 0);
  ASSERT_EQ(scene.maintain.size(), 4u);
  EXPECT_EQ(scene.maintain[0].label, "sorted_list");
  EXPECT_EQ(scene.maintain[1].key.kind, Key::Kind::kDirection);
  EXPECT_EQ(scene.maintain[1].key.direction[1], Rational(4));
  EXPECT_EQ(scene.maintain[2].key.axis, 1);
  EXPECT_EQ(scene.maintain[3].key.object, 0u);
}

TEST(SceneReader, GapsSeparateLivesAndSeamsMustMeet) {
  const auto pieces = [](const char* second_from, const char* x, const char* extra) {
    return parse(std::string(R"({"kinex": 1, "dimension": 1, "time": {"start": 0})") + extra +
                 R"(, "objects": [{"id": "a", "motion": [
                   {"from": 0, "to": 1, "coordinates": [[0, 1]]},
                   {"from": )" +
                 second_from + R"(, "coordinates": [[)" + x + "]]}]}]}");
  };
  EXPECT_NO_THROW(pieces("1", "1", ""));
  EXPECT_NO_THROW(pieces("2", "7", ""));
  EXPECT_NO_THROW(pieces("1", "7", ", \"jumps\": true"));
  EXPECT_INPUT_ERROR(pieces("1", "7", ""), "/objects/0/motion/1: the object jumps at 1 from");
  EXPECT_INPUT_ERROR(pieces("0.5", "7", ", \"jumps\": true"), "/objects/0/motion/1/from");
}

TEST(SceneReader, ErrorsNameFilePathTextAndRemedy) {
  EXPECT_INPUT_ERROR(
      with_coefficient("\"0.1.2\""),
      "s.json: /objects/0/motion/0/0: \"0.1.2\" is not a number; write an integer, a "
      "fraction \"1/3\" or a decimal (line 2)");
  EXPECT_INPUT_ERROR(with_coefficient("\"-1/00\""),
                     "/objects/0/motion/0/0: \"-1/00\" has the denominator 0; write another denominator");
}

TEST(SceneWriter, RoundTrip) {
  const Scene scene = parse(kExample);
  const std::string text = formats::write_scene(scene);
  const Scene again = parse(text);
  EXPECT_EQ(formats::write_scene(again), text);
  ASSERT_EQ(again.objects.size(), scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    EXPECT_EQ(again.objects[i].id, scene.objects[i].id);
    ASSERT_EQ(again.objects[i].motion.pieces.size(), scene.objects[i].motion.pieces.size());
    for (std::size_t k = 0; k < scene.objects[i].motion.pieces.size(); ++k) {
      const MotionPiece& before = scene.objects[i].motion.pieces[k];
      const MotionPiece& after = again.objects[i].motion.pieces[k];
      EXPECT_EQ(before.from, after.from);
      EXPECT_EQ(before.to, after.to);
      EXPECT_EQ(before.trajectory, after.trajectory);
    }
  }
  EXPECT_EQ(again.maintain[3].key.object, 0u);
  EXPECT_EQ(again.maintain[1].key.direction, scene.maintain[1].key.direction);
}

constexpr const char* kBodies = R"(
  {"kinex": 1, "name": "bodies", "dimension": 2, "time": {"start": 0, "end": 1},
   "objects": [
     {"id": "a", "polygon": [[0, 0], [1, "1/3"], [0, 1]], "motion": [[0, 1], ["1/3", 0, -1]]},
     {"id": "b", "polygon": [[9, 9], [10, 9], [9, 11]], "motion": [[0], [0]], "rotor": [[1], [0, 1]]},
     {"id": "c", "polygon": [[0, 5], [1, 5], [0, 6]], "motion": [
       {"to": "1/2", "coordinates": [[0], [0, 1]], "rotor": [[1, -1], [0, 1, 0]]},
       {"from": "1/2", "coordinates": [[0], ["1/2"]], "rotor": [["-1/2"], ["-1/2"]]}]}]})";

TEST(SceneReader, ReadsBodies) {
  const Scene scene = parse(kBodies);
  EXPECT_TRUE(scene.has_bodies());
  EXPECT_EQ(scene.axes(), kBodyAxes);
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[0].polygon[1], (Vertex2{Rational(1), ratio(1, 3)}));
  const auto coordinates = [&](std::size_t object, std::size_t piece) {
    return scene.objects[object].motion.pieces[piece].trajectory.coordinates;
  };
  using Lists = std::vector<std::vector<Rational>>;
  EXPECT_EQ(coordinates(0, 0), (Lists{{0, 1}, {ratio(1, 3), 0, -1}, {1}, {0}}));
  EXPECT_EQ(coordinates(1, 0), (Lists{{0}, {0}, {1}, {0, 1}}));
  EXPECT_EQ(coordinates(2, 0), (Lists{{0}, {0, 1}, {1, -1}, {0, 1}}));
  EXPECT_EQ(coordinates(2, 1), (Lists{{0}, {ratio(1, 2)}, {ratio(-1, 2)}, {ratio(-1, 2)}}));
}

TEST(SceneWriter, BodiesRoundTrip) {
  const Scene scene = parse(kBodies);
  const std::string text = formats::write_scene(scene);
  const Scene again = parse(text);
  EXPECT_EQ(formats::write_scene(again), text);
  ASSERT_EQ(again.objects.size(), scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    EXPECT_EQ(again.objects[i].polygon, scene.objects[i].polygon);
    for (std::size_t k = 0; k < scene.objects[i].motion.pieces.size(); ++k) {
      EXPECT_EQ(again.objects[i].motion.pieces[k].trajectory,
                scene.objects[i].motion.pieces[k].trajectory);
    }
  }
}

// A grid of squares in each other's way for boxes, and not for polygons.
TEST(SceneReader, ManyBodiesAreFoundApart) {
  std::string objects;
  const int side = test::kSanitized ? 30 : 100;
  for (int i = 0; i < side * side; ++i) {
    const std::string x = std::to_string(i % side) + ".0", y = std::to_string(i / side) + "e0";
    objects +=
        (i == 0 ? "" : ", ") +
        (R"({"id": "b)" + std::to_string(i) +
         R"(", "polygon": [["-0.6", 0], [0, "-0.1"], ["0.6", 0], [0, "0.1"]], "motion": [[)" + x +
         "], [" + y + R"(]], "rotor": [[2], [1]]})");
  }
  const std::string head = R"({"kinex": 1, "dimension": 2, "time": {"start": 0}, "objects": [)";
  EXPECT_EQ(parse(head + objects + "]}").objects.size(), static_cast<std::size_t>(side * side));
  objects += R"(, {"id": "z", "polygon": [[0, 0], [1, 0], [0, 1]], "motion": [["5.5"], ["5.5"]]})";
  EXPECT_INPUT_ERROR(parse(head + objects + "]}"), "\"z\" overlap at the scene's start");
}

// b is there from 1 to 3, then from 3 on elsewhere; a moves right through the origin at 2.
TEST(SceneReader, BodiesDoNotAppearInOthers) {
  const auto scene = [](const char* x, const char* from, const char* there) {
    const std::string square = R"([[-1, -1], [1, -1], [1, 1], [-1, 1]])";
    return R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 6}, "jumps": true,
      "objects": [{"id": "a", "polygon": )" +
           square + R"(, "motion": [[-20, 10], [0]]},
        {"id": "b", "polygon": )" +
           square + R"(, "motion": [{"from": )" + from + R"(, "to": 3, "coordinates": [[)" + x +
           R"(], [0]]}, {"from": 3, "coordinates": [[)" + there + R"(], [0]]}]}]})";
  };
  EXPECT_NO_THROW(parse(scene("0", "1", "0")));  // a comes later, and has gone when b goes on
  EXPECT_INPUT_ERROR(parse(scene("-11", "1", "0")), "the body \"b\" appears at 1 into \"a\"");
  EXPECT_INPUT_ERROR(parse(scene("0", "\"21/10\"", "0")), "/objects/1: the body \"b\" appears");
  EXPECT_INPUT_ERROR(parse(scene("0", "1", "\"17/2\"")), "the body \"b\" jumps at 3 into \"a\"");
  EXPECT_NO_THROW(parse(scene("-8", "1", "0")));  // touches
  EXPECT_INPUT_ERROR(parse(scene("\"-8.000001\"", "1", "0")), "appears at 1 into");
  EXPECT_NO_THROW(parse(scene("\"-7.999999\"", "1", "0")));
  // At the start it is refused as there.
  EXPECT_INPUT_ERROR(parse(scene("-19", "0", "0")), "overlap at the scene's start");
}

// For separation_minkowski.
TEST(SceneReader, BodiesThatTurnAgainstEachOther) {
  const auto maintained = [](const std::string& a, const std::string& b,
                             const std::string& life = "") {
    const std::string body = R"("polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": )";
    const auto motion = [](const std::string& when, int x, const std::string& rotor) {
      return R"([{)" + when + R"("coordinates": [[)" + std::to_string(x) +
             R"(], [0]], "rotor": [)" + rotor + "]}]}";
    };
    Scene scene = parse(R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 6},
        "objects": [{"id": "a", )" +
                        body + motion("", 0, a) + R"(, {"id": "c", )" + body +
                        motion(R"("to": 2, )", 90, "[1], [0]") + R"(, {"id": "b", )" + body +
                        motion(life, 50, b) + "]}");
    formats::set_maintain(scene, {"separation_minkowski"});
  };
  EXPECT_NO_THROW(maintained("[1], [0]", "[2], [1]"));
  EXPECT_INPUT_ERROR(maintained("[1], [0]", "[1], [0, 1]"), "\"a\" and \"b\" do; maintain");
  EXPECT_INPUT_ERROR(maintained("[1, 1], [3]", "[1], [0]"), "\"a\" and \"c\" do; maintain");
  // By (1 + i) (1 + t^2), and by a multiple of it: at one angle.
  EXPECT_NO_THROW(maintained("[1, 0, 1], [1, 0, 1]", "[-2], [1]"));
  // One after the other.
  EXPECT_NO_THROW(maintained("[1], [0]", "[1], [1]", R"("from": 3, )"));
  EXPECT_INPUT_ERROR(maintained("[1], [0]", "[1], [0, 1]", R"("from": 3, )"), "\"a\" and \"b\"");
  // Against c, which has gone then, and alike.
  const auto pair = [&](const std::string& rotor, const std::string& other) {
    maintained(rotor, other, R"("from": 3, )");
  };
  EXPECT_INPUT_ERROR(pair("[1], [0, 1]", "[1], [0, 1]"), "\"a\" and \"c\"");
}

// As one, at different angles, or by turns.
TEST(SceneReader, BodiesThatTurnAsOne) {
  const auto maintained = [](const std::string& rotor, const std::string& other) {
    const std::string body = R"("polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": )";
    Scene scene = parse(R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 6},
        "objects": [{"id": "a", )" +
                        body + R"([[0], [0]], "rotor": [)" + rotor + R"(]}, {"id": "b", )" + body +
                        R"([[50], [0]], "rotor": [)" + other + "]}]}");
    formats::set_maintain(scene, {"separation_minkowski"});
  };
  EXPECT_NO_THROW(maintained("[1], [0, 1]", "[1], [0, 1]"));
  EXPECT_NO_THROW(maintained("[1], [0, 1]", "[1, -1], [1, 1]"));  // a quarter turn ahead
  EXPECT_NO_THROW(maintained("[1], [0, 1]", "[2, 4], [0, 2, 4]"));
  EXPECT_INPUT_ERROR(maintained("[1], [0, 1]", "[1], [0, -1]"), "\"a\" and \"b\"");
  EXPECT_INPUT_ERROR(maintained("[1], [0, 1]", "[1], [0, 2]"), "\"a\" and \"b\"");
}

TEST(SceneHash, DependsOnContentNotOnForm) {
  const std::string hash = formats::scene_hash(with_coefficient("\"1/2\""));
  EXPECT_EQ(hash.size(), 64u);
  for (const char* same : {"0.5", "\"2/4\"", " 5e-1 ", "\"0x1p-1\"", "0.5, 0, 0"}) {
    EXPECT_EQ(formats::scene_hash(with_coefficient(same)), hash) << same;
  }
  EXPECT_NE(formats::scene_hash(with_coefficient("0.50000000000000000001")), hash);
  EXPECT_NE(formats::scene_hash(with_coefficient("0.5, 1")), hash);
}

// What is neither a scene nor a log is named as such; a script may have commas in its first line.
TEST(SceneReader, OtherFiles) {
  const std::string script =
      "kinex gen uniform-square --n 20 --maintain delaunay_2,sorted_list\nkinex run square.json\n";
  EXPECT_INPUT_ERROR(formats::parse_scene(script, "run.sh"),
                     "run.sh: line 1: \"kinex gen uniform-square --n 20 --mainta\" (65 bytes) "
                     "begins neither a scene nor "
                     "an event log; give a scene (JSON, as kinex gen and kinex import make it)");
  EXPECT_INPUT_ERROR(formats::parse_scene("\n#!/bin/sh\n", "run.sh"),
                     "run.sh: line 2: \"#!/bin/sh\" begins neither");
  EXPECT_INPUT_ERROR(formats::parse_scene("id,t,x\na,0,1\n", "t.csv"),
                     "this is a table, not a scene");
  EXPECT_INPUT_ERROR(formats::parse_scene("id;t;x", "t.csv"), "this is a table, not a scene");
}

TEST(SceneReader, MaintainOption) {
  Scene scene = parse(kExample);
  formats::set_maintain(scene, {"sorted_list", "sorted_list:y", "delaunay_2"});
  ASSERT_EQ(scene.maintain.size(), 3u);
  EXPECT_EQ(scene.maintain[1].label, "sorted_list:y");
  EXPECT_EQ(scene.maintain[1].key.axis, 1);
  EXPECT_INPUT_ERROR(formats::set_maintain(scene, {"tap"}), "--maintain: \"tap\" is not a known structure");
  EXPECT_INPUT_ERROR(formats::set_maintain(scene, {"sorted_list:z"}), "\"z\" is not a key");
  EXPECT_INPUT_ERROR(formats::set_maintain(scene, {"delaunay_2:x"}),
                     "\"delaunay_2\" takes no key, as \"x\"; write delaunay_2 alone");
  EXPECT_INPUT_ERROR(formats::set_maintain(scene, {"delaunay_2", "delaunay_2"}), "stands twice");
  EXPECT_INPUT_ERROR(formats::set_maintain(scene, {"sorted_list,"}), "\"\" is not a known structure");
  // All that is wrong, and not the first alone.
  EXPECT_INPUT_ERROR(
      formats::set_maintain(scene, {"tap,delaunay_2", "sorted_lisd,delaunay_2:x"}),
      "--maintain: \"tap\" is not a known structure; kinex list structures names them; and "
      "\"sorted_lisd\" is not a known structure; did you mean sorted_list?; and \"delaunay_2\" "
      "takes "
      "no key, as \"x\"; write delaunay_2 alone");
  EXPECT_INPUT_ERROR(formats::set_maintain(scene, {"a,b,c,d,e,f,g,h,i,j"}), "; and 2 more");
}

// A structure's id is a byte, and one of its values is that of none.
TEST(SceneReader, AtMost255StructuresFitOneRun) {
  const auto scene_with = [](int count, const char* structure) {
    std::string text = R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 1},
      "objects": [{"id": "a", "motion": [[0], [0]]}, {"id": "b", "motion": [[1], [0]]}], "maintain": [)";
    for (int i = 0; i < count; ++i) {
      text += std::string(i == 0 ? "" : ", ") + R"({"structure": ")" + structure + R"(", "as": "s)" +
              std::to_string(i) + "\"}";
    }
    return text + "]}";
  };
  EXPECT_EQ(parse(scene_with(255, "sorted_list")).maintain.size(), 255u);
  EXPECT_INPUT_ERROR(parse(scene_with(256, "sorted_list")),
                     "/maintain/255: more than 255 structures in one run");
  EXPECT_INPUT_ERROR(parse(scene_with(100000, "sorted_list")), "/maintain/255: more than 255");
  // They read a triangulation that was not requested.
  EXPECT_INPUT_ERROR(parse(scene_with(255, "convex_hull_2_delaunay")),
                     "/maintain/254: more than 255 structures in one run");
  EXPECT_EQ(parse(scene_with(254, "convex_hull_2_delaunay")).maintain.size(), 254u);
  Scene scene = parse(scene_with(1, "sorted_list"));
  std::string entries;
  for (int i = 0; i < 256; ++i) {
    entries += std::string(i == 0 ? "" : ",") + R"({"structure": "sorted_list", "as": "s)" +
               std::to_string(i) + "\"}";
  }
  EXPECT_INPUT_ERROR(formats::set_maintain(scene, {entries}),
                     "--maintain: more than 255 structures in one run");
}

// Commas inside of JSON belong to it, be they in brackets, braces or strings.
TEST(SceneReader, MaintainOptionInJson) {
  Scene scene = parse(kExample);
  formats::set_maintain(scene, {R"( sorted_list , {"structure": "sorted_list", "key": {"direction":
      ["3", 4]}, "as": "a,}\",{b"},{"structure":"minimum_tournament","key":)"
                       R"({"squared_distance_to":"a"}},delaunay_2)",
                       "sorted_list:y"});
  ASSERT_EQ(scene.maintain.size(), 5u);
  EXPECT_EQ(scene.maintain[0].label, "sorted_list");
  EXPECT_EQ(scene.maintain[1].label, "a,}\",{b");
  EXPECT_EQ(scene.maintain[1].key.direction, (std::vector<Rational>{Rational(3), Rational(4)}));
  EXPECT_EQ(scene.maintain[2].label, "minimum_tournament");
  EXPECT_EQ(scene.maintain[2].key.kind, Key::Kind::kSquaredDistance);
  EXPECT_EQ(scene.maintain[2].key.object, 0u);
  EXPECT_EQ(scene.maintain[3].structure, "delaunay_2");
  EXPECT_EQ(scene.maintain[4].key.axis, 1);
  const auto refused = [&](const std::string& entry) { formats::set_maintain(scene, {entry}); };
  EXPECT_INPUT_ERROR(refused("{"), "--maintain: line 1, column 2: the text ends too early");
  EXPECT_INPUT_ERROR(refused("{}"), "--maintain: /: \"structure\" is missing; add it");
  EXPECT_INPUT_ERROR(refused(R"({"structure": "sorted_list"} x)"), "--maintain: line 1");
  EXPECT_INPUT_ERROR(refused(R"({"structure": "tap"})"), "--maintain: /structure: \"tap\"");
  EXPECT_INPUT_ERROR(refused(R"({"structure": "sorted_list", "key": "z"})"), "/key: \"z\"");
  EXPECT_INPUT_ERROR(
      refused(R"({"structure": "sorted_list", "key": {"squared_distance_to": "Sun"}})"),
      "/key/squared_distance_to: there is no object \"Sun\"");
  EXPECT_INPUT_ERROR(refused(R"({"structure": "sorted_list"},sorted_list)"), "stands twice");
  EXPECT_INPUT_ERROR(refused(R"(sorted_list,{"structure": "sorted_list"})"), "is used twice");
  EXPECT_INPUT_ERROR(refused("sorted_list:{"), "other keys are written as in a scene");
}

}  // namespace scene_reader_test
}  // namespace kinex

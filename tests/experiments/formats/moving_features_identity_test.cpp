// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes as Moving Features and back: every member of a scene comes back, or the scene is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/moving_features.h"
#include "experiments/formats/moving_features_writer.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/workload.h"
#include "tests/experiments/expect_input_error.h"
#include "tests/places.h"

namespace kinex::formats {
namespace moving_features_identity_test {

using testing::HasSubstr;

struct Text {
  Scene scene;
  SceneWords words;
};

Text parsed(const std::string& text) {
  const JsonDocument document = parse_json(text, "s");
  const JsonSource source{"s", text};
  return {parse_scene(text, "s"), read_words(JsonNode(*document, source))};
}

WrittenFeatures features_of(const Text& text) {
  MovingFeaturesForm form;
  form.tolerance = *Rational::parse("1e-3");
  form.words = text.words;
  return write_moving_features(text.scene, "s", form);
}

std::string again(const std::string& features, const MovingFeaturesOptions& options = {}) {
  const ImportReport report = import_moving_features(features, "f", options);
  return write_scene(report.scene, report.words);
}

std::string scene(const std::string& members, const std::string& objects,
                  const std::string& maintain = "") {
  return R"({"kinex": 1, "name": "s", "time": {"start": 0, "end": 4}, )" + members +
         R"(, "objects": [)" + objects + R"(], "maintain": [)" + maintain + "]}";
}

// Every member of the schema stands in one of these.
const std::vector<std::string>& kept() {
  static const std::vector<std::string> scenes{
      scene(
          R"("dimension": 1, "$schema": "scene.schema.json", "description": "three edges", "source": "by hand", )"
          R"("expect": {"z": [1.0, null], "a": "b"})",
          R"({"id": "a", "ends": ["u", "v"], "motion": [["1/4", 1]]}, )"
          R"({"id": "b", "ends": ["v", "w"], "motion": [[2]]}, {"id": "c", "ends": ["w", "u"], "motion": [[3, -1]]})",
          R"("graph_mst_list")"),
      scene(R"("dimension": 1)",
            R"({"id": "a", "weight": "1/3", "motion": [[0, 1]]}, {"id": "b", "motion": [[5]]})",
            R"("sorted_list")"),
      scene(
          R"("dimension": 2, "queries": [{"at": 1, "box": [[0, "1/3"], [0, 1]]}])",
          R"({"id": "a", "colour": "red", "motion": [[0, 1], [1]]}, {"id": "b", "colour": "blue", "motion": [[2], [0, 1]]}, )"
          R"({"id": "c", "colour": "red", "motion": [[5], [3]]})",
          R"({"structure": "sorted_list", "of": "red", "as": "reds"}, {"structure": "sorted_list", "key": {"squared_distance_to": "b"}}, "range_tree_2")"),
      // Ends at the scene's, beyond them, only one of them; a piece that is two; a gap; a jump; nothing to maintain.
      scene(
          R"("dimension": 2, "jumps": true)",
          R"({"id": "a", "motion": [{"from": 0, "to": 4, "coordinates": [[0, 1], [1]]}]}, )"
          R"({"id": "b", "motion": [{"from": -1, "to": 7, "coordinates": [[1, 1], [1]]}]}, )"
          R"({"id": "c", "motion": [{"to": 3, "coordinates": [[2, 1], [1]]}]}, )"
          R"({"id": "d", "motion": [{"from": 1, "coordinates": [[3, 1], [1]]}]}, )"
          R"({"id": "e", "motion": [{"from": 0, "to": 1, "coordinates": [[4, 1], [1]]}, )"
          R"({"from": 1, "to": 2, "coordinates": [[4, 1], [1]]}, {"from": 3, "to": 4, "coordinates": [[4, 1], [1]]}]}, )"
          R"({"id": "f", "motion": [{"to": 2, "coordinates": [[5], [1]]}, {"from": 2, "coordinates": [[6], [1]]}]})"),
      scene(R"("dimension": 2, "jumps": true)", R"({"id": "a", "motion": [[0, 1], [1]]})",
            R"("sorted_list")"),
      // A frame beside its polygon, turned frames, one rotor of two lengths, bodies that overlap.
      scene(
          R"("dimension": 2, "overlapping_starts": "contact")",
          R"({"id": "a", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[0, 1], [1]]}, )"
          R"({"id": "b", "polygon": [[0, 0], [1, 0], [0, 1]], "motion": [[0], [0, 1]], "rotor": [[1], [1]]}, )"
          R"({"id": "c", "polygon": [[0, 1], [2, 1], [2, 2]], "motion": [)"
          R"({"to": 2, "coordinates": [[9], [0, 1]], "rotor": [[1], [1]]}, )"
          R"({"from": 2, "coordinates": [[9], [0, 1]], "rotor": [[2], [2]]}]}, )"
          R"({"id": "d", "polygon": [[0, 0], [1, 0], [0, 1]], "motion": [[7], [0, 1]]})",
          R"("separation_minkowski")"),
      scene(R"("dimension": 3)", R"({"id": "a", "motion": [[0, 1], [1], [2]]})",
            R"("sorted_list")")};
  return scenes;
}

// These cannot be held; the message says what of them.
const std::vector<std::pair<std::string, std::string>>& refused() {
  static const std::vector<std::pair<std::string, std::string>> scenes{
      {scene(R"("dimension": 2)", R"({"id": "a", "radius": [1], "motion": [[0], [1]]})"),
       "discs or boxes"},
      {scene(R"("dimension": 1)", R"({"id": "a", "half_extents": [[1]], "motion": [[0]]})"),
       "discs or boxes"},
      {scene(R"("dimension": 2)", R"({"id": "a", "line": true, "motion": [[0], [1]]})"), "lines"},
      {scene(R"("dimension": 2)", R"({"id": "a", "weight": [0, 1], "motion": [[0], [1]]})"),
       "the weight of \"a\" changes"},
      {scene(R"("dimension": 1)",
             R"({"id": "a", "motion": [{"from": 5, "to": 6, "coordinates": [[0]]}]}, )"
             R"({"id": "b", "motion": [[0]]})"),
       "\"a\" is there at other times than the scene's only"},
      {scene(R"("dimension": 1)", ""), "/objects: no objects"}};
  return scenes;
}

TEST(MovingFeaturesIdentity, EveryMemberComesBackOrIsRefused) {
  for (const std::string& text : kept()) {
    SCOPED_TRACE(text);
    const Text one = parsed(text);
    const WrittenFeatures features = features_of(one);
    EXPECT_EQ(features.inexact, 0u);
    EXPECT_EQ(again(features.text), write_scene(one.scene, one.words));
  }
  for (const auto& [text, message] : refused()) {
    SCOPED_TRACE(text);
    EXPECT_INPUT_ERROR(features_of(parsed(text)), message);
  }
}

// A new member of scenes has to be thought of here.
TEST(MovingFeaturesIdentity, TheSchemaHasNoOtherMembers) {
  std::string all;
  for (const std::string& text : kept()) all += text;
  for (const auto& [text, message] : refused()) all += text;
  const JsonDocument schema = parse_json(
      read_text_file(KINEX_SOURCE_DIR "/experiments/schemas/scene.schema.json"), "schema");
  const JsonValue& definitions = *schema->find("definitions");
  std::size_t members = 0;
  for (const JsonValue* owner : {&*schema, definitions.find("point"), definitions.find("piece"),
                                 definitions.find("body_piece"), definitions.find("query")}) {
    for (const JsonValue& key : owner->find("properties")->keys()) {
      EXPECT_THAT(all, HasSubstr("\"" + std::string(key.text()) + "\": "));
      ++members;
    }
  }
  EXPECT_GT(members, 25u);
}

// What does not depend on places that were rounded.
std::string without_motions(Scene scene) {
  for (SceneObject& object : scene.objects) {
    for (Vertex2& vertex : object.polygon) vertex = {0, 0};
    const std::size_t axes = object.motion.pieces[0].trajectory.coordinates.size();
    std::vector<Rational> last = object.motion.pieces[0].trajectory.coordinates.back();
    object.motion.pieces = {{std::nullopt, std::nullopt, {{axes, {Rational()}}}}};
    if (scene.extents == Extents::kWeight)
      object.motion.pieces[0].trajectory.coordinates.back() = last;
  }
  return write_scene(scene);
}

TEST(MovingFeaturesIdentity, AllWorkloads) {
  std::size_t same = 0, near = 0;
  std::set<std::string> reasons;
  for (const lab::Workload& workload : lab::workloads()) {
    SCOPED_TRACE(workload.name);
    Text one;
    try {
      lab::WorkloadParameters parameters;
      parameters.n = 6;
      one.scene = lab::generate_scene(workload, parameters);
    } catch (const InputError&) {
      lab::WorkloadParameters power;
      power.n = 8;
      one.scene = lab::generate_scene(workload, power);
    }
    if (!one.scene.end) one.scene.end = one.scene.start + Rational(1);
    WrittenFeatures features;
    try {
      features = features_of(one);
    } catch (const InputError& error) {
      const std::string& problem = error.problem();
      reasons.insert(problem.substr(std::min(problem.find_last_of('"') + 1, problem.size() - 1)));
      continue;
    }
    if (features.inexact == 0) {
      EXPECT_EQ(again(features.text), write_scene(one.scene));
      ++same;
    } else {
      const Scene back = import_moving_features(features.text, "f", {}).scene;
      EXPECT_EQ(without_motions(back), without_motions(one.scene));
      ++near;
    }
  }
  EXPECT_GT(same, 20u);
  EXPECT_GT(near, 0u);
  EXPECT_LE(reasons.size(), 5u) << testing::PrintToString(reasons);
}

// Times in the file's own members are in its own scale; --time-zero moves them too.
TEST(MovingFeaturesIdentity, AnotherTimeZero) {
  const std::string features = features_of(parsed(kept()[3])).text;
  MovingFeaturesOptions options;
  options.common.time_zero = OptionTime{"--time-zero", "1969-12-31T23:59:58Z"};
  const Scene later = import_moving_features(features, "f", options).scene;
  EXPECT_EQ(later.start, Rational(2));
  EXPECT_EQ(later.end, Rational(6));
  const auto pieces = [&](std::size_t i) { return later.objects[i].motion.pieces; };
  EXPECT_EQ(pieces(1).front().from, Rational(1));
  EXPECT_EQ(pieces(2).front().from, std::nullopt);
  EXPECT_EQ(pieces(4).front().to, Rational(3));
  const Scene asked =
      import_moving_features(features_of(parsed(kept()[2])).text, "f", options).scene;
  ASSERT_EQ(asked.queries.size(), 1u);
  EXPECT_EQ(asked.queries[0].at, Rational(3));
}

// Members of ours that places contradict, once another program has changed them.
TEST(MovingFeaturesIdentity, PlacesThatWereChanged) {
  const auto with = [](const std::string& members, const std::string& type,
                       const std::string& places) {
    return R"({"type": "FeatureCollection", "crs": {"type": "Name", "properties": {"name": "kinex:plane"}}, )"
           R"("kinex": {"start": "0", "end": "2", "time_zero": "1970-01-01T00:00:00Z"}, "features": [{"type": "Feature", )"
           R"("id": "a", "temporalGeometry": {"type": ")" +
           type +
           R"(", "datetimes": ["1970-01-01T00:00:00Z", "1970-01-01T00:00:01Z"], "coordinates": [)" +
           places + R"(], "interpolation": "Linear"}, "properties": {"kinex": {)" + members +
           "}}}]}";
  };
  const auto point = [&](const std::string& members) {
    return again(with(members, "MovingPoint", "[0, 0], [1, 1]"));
  };
  EXPECT_THAT(point(R"("from": null)"), HasSubstr(R"([{"to": 1, )"));
  EXPECT_INPUT_ERROR(
      point(R"("from": "1/2")"),
      "f: /features/0/properties/kinex/from: it is after the first place; remove it: the places");
  EXPECT_INPUT_ERROR(point(R"("to": "2")"),
                     "/kinex/to: the object disappears before the scene ends");
  EXPECT_INPUT_ERROR(point(R"("cuts": ["3"])"), "/kinex/cuts: no piece goes on at 3");
  EXPECT_INPUT_ERROR(point(R"("cuts": ["1e99999"])"), "no piece goes on at about 1e+99999; remove");
  EXPECT_INPUT_ERROR(point(R"("ends": ["u", "u"])"), "/kinex/ends: not the ends of an edge");
  EXPECT_INPUT_ERROR(point(R"("ends": ["u", "v"])"),
                     "edges of a graph with places of more than one axis");
  EXPECT_INPUT_ERROR(point(R"("colour": "")"), "/kinex/colour: an empty name");
  const auto body = [&](const std::string& members) {
    return again(with(members, "MovingPolygon",
                      "[[[0, 0], [1, 0], [0, 1], [0, 0]]], [[[0, 0], [1, 0], [0, 1], [0, 0]]]"));
  };
  EXPECT_THAT(body(R"("polygon": [[1, 1], [2, 1], [1, 2]])"), HasSubstr("[[-1], [-1]]"));
  EXPECT_INPUT_ERROR(body(R"("polygon": [[1, 1], [3, 1], [1, 2]])"),
                     "/kinex/polygon: it is not that of the places");
  EXPECT_INPUT_ERROR(body(R"("polygon": [[1, 1], [2, 1], [1, 2]], "rotors": [[1, 0], [2, 0]])"),
                     "/kinex/rotors: 2 rotors for 1 piece");
  EXPECT_INPUT_ERROR(body(R"("rotors": [[0, 0]])"), "a rotor [0, 0]");
}

}  // namespace moving_features_identity_test
}  // namespace kinex::formats

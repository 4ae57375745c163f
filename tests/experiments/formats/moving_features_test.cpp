// SPDX-License-Identifier: GPL-3.0-or-later
// Moving Features in and out. (Files that are refused: tests/corpus/features/bad.)
#include "experiments/formats/moving_features.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/formats/json_document.h"
#include "experiments/formats/moving_features_writer.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/workload.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex::formats {
namespace moving_features_test {

using testing::ElementsAre;
using testing::HasSubstr;

Rational number(const char* text) { return *Rational::parse(text); }

MovingFeaturesOptions planar() {
  MovingFeaturesOptions options;
  options.plane = Plane::as_they_are();
  return options;
}

ImportReport import(const std::string& features, const MovingFeaturesOptions& options = planar()) {
  return import_moving_features(R"({"type": "FeatureCollection", "features": [)" + features + "]}",
                                "f.json", options);
}

std::string moving_point(const std::string& id, const std::string& places,
                         const std::string& interpolation = "Linear") {
  return R"({"type": "Feature", "id": ")" + id +
         R"(", "temporalGeometry": {"type": "MovingPoint", "datetimes": ["2024-01-01T00:00:00Z", )"
         R"("2024-01-01T00:00:00.5Z", "2024-01-01T00:00:02Z"], "coordinates": )" +
         places + R"(, "interpolation": ")" + interpolation + "\"}}";
}

MovingFeaturesForm form(const char* tolerance = "1e-6") {
  MovingFeaturesForm form;
  form.tolerance = number(tolerance);
  return form;
}

Scene again(const std::string& text) { return import_moving_features(text, "f.json", {}).scene; }

TEST(MovingFeatures, TimesAreSecondsFromTheFirstDate) {
  const ImportReport report = import(moving_point("a", "[[0, 0], [0.1, 1], [0.1, 4]]"));
  EXPECT_EQ(report.time_zero, "2024-01-01T00:00:00Z");
  const Scene& scene = report.scene;
  EXPECT_EQ(scene.start, Rational(0));
  EXPECT_EQ(scene.end, Rational(2));
  const std::vector<MotionPiece>& pieces = scene.objects[0].motion.pieces;
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].trajectory.coordinates[0],
            (std::vector<Rational>{0, number("1/5")}));  // 0.1 is 1/10
  EXPECT_EQ(pieces[1].trajectory.position(1, number("3/2")), Rational(3));
  MovingFeaturesOptions later = planar();
  later.common.time_zero = OptionTime{"--time-zero", "2023-12-31T23:59:00Z"};
  later.common.end_time = OptionTime{"--end", "2024-01-01T00:00:01Z"};
  const Scene moved = import(moving_point("a", "[[0, 0], [0.1, 1], [0.1, 4]]"), later).scene;
  EXPECT_EQ(moved.start, Rational(60));
  EXPECT_EQ(moved.end, Rational(61));
}

TEST(MovingFeatures, StepsJump) {
  const Scene scene = import(moving_point("a", "[[0, 0], [7, 1], [9, 9]]", "Step")).scene;
  EXPECT_TRUE(scene.jumps);
  const std::vector<MotionPiece>& pieces = scene.objects[0].motion.pieces;
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[1].trajectory.position(0, Rational(2)), Rational(7));
  EXPECT_FALSE(import(moving_point("a", "[[0, 0], [0, 0], [9, 9]]", "Step")).scene.jumps);
  EXPECT_NO_THROW(parse_scene(write_scene(scene), "s"));
}

TEST(MovingFeatures, DiscreteIsReadAsLinearIfAsked) {
  MovingFeaturesOptions options = planar();
  EXPECT_INPUT_ERROR(import(moving_point("a", "[[0, 0], [7, 1], [9, 9]]", "Discrete"), options),
                     "--linear");
  options.linear = true;
  EXPECT_EQ(import(moving_point("a", "[[0, 0], [7, 1], [9, 9]]", "Discrete"), options)
                .scene.objects.size(),
            1u);
}

TEST(MovingFeatures, DegreesBecomeMetresByStatedFactors) {
  MovingFeaturesOptions options;
  options.plane = Plane::around("13.4,60");
  const ImportReport report =
      import(moving_point("a", "[[13.4, 60], [13.5, 60], [13.5, 60.1]]"), options);
  const Trajectory& last = report.scene.objects[0].motion.pieces.back().trajectory;
  // A degree of the sphere's meridian is 111195.08 m; on its parallel of 60 degrees half of that.
  EXPECT_NEAR(last.position(0, Rational(2)).to_double(), 5559.754, 0.001);
  EXPECT_NEAR(last.position(1, Rational(2)).to_double(), 11119.508, 0.001);
  EXPECT_THAT(report.notes, ElementsAre(HasSubstr("x = 55597.54")));
  EXPECT_INPUT_ERROR(Plane::around("13.4"), "--local: \"13.4\" is no place; write LON,LAT");
  EXPECT_INPUT_ERROR(Plane::around("13.4,90"), "is no place");
}

TEST(MovingFeatures, PropertiesByName) {
  MovingFeaturesOptions options = planar();
  options.common.columns = {{"id", "trackId"}, {"t", "when"}};
  const auto fix = [](int id, const std::string& x, const std::string& t) {
    return R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [)" + x +
           R"(, 0]}, "properties": {"trackId": )" + std::to_string(id) + R"(, "when": )" + t +
           R"(, "speed": 3}})";
  };
  const ImportReport report =
      import(fix(7, "0", "0") + "," + fix(7, "3", "1.5") + "," + fix(8, "1", "0"), options);
  ASSERT_EQ(report.scene.objects.size(), 1u);
  EXPECT_EQ(report.scene.objects[0].id, "7");
  EXPECT_EQ(report.scene.end, number("3/2"));
  EXPECT_EQ(report.single_fixes.size(), 1u);
  EXPECT_THAT(report.single_fixes[0], testing::StartsWith("\"8\" (line "));
  MovingFeaturesOptions late = options;
  late.common.start_time = {"--start", "2"};
  late.common.end_time = {"--end", "3"};
  EXPECT_INPUT_ERROR(
      import(fix(7, "0", "0") + "," + fix(7, "3", "1.5"), late),
      "no trace is in the time of the scene, 2 to 3: the traces are from 0 to 3/2 (1.5)");
  options.common.columns = {{"x", "east"}};
  EXPECT_INPUT_ERROR(import(fix(7, "0", "0"), options),
                     "--column: x=east: places are not in properties here");
}

TEST(MovingFeatures, PolygonsAreBodies) {
  const std::string polygon =
      R"({"type": "Feature", "id": "a", "temporalGeometry": {"type": "MovingPolygon", "datetimes": [0, 1000], )"
      R"("coordinates": [[[[0, 0], [0, 1], [1, 0], [0, 0]]], [[[5, 0], [5, 1], [6, 0], [5, 0]]]], )"
      R"("interpolation": "Linear"}})";
  const Scene scene = import(polygon).scene;
  ASSERT_TRUE(scene.has_bodies());  // counter-clockwise, though the file was not
  EXPECT_EQ(scene.objects[0].polygon, (std::vector<Vertex2>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(scene.end, Rational(1));
  EXPECT_EQ(scene.objects[0].motion.pieces[0].trajectory.position(0, Rational(1)), Rational(5));
}

// Linear scenes of decimals: written and read, they are the same, byte by byte.
TEST(MovingFeatures, RoundTripIsTheIdentity) {
  for (const char* workload :
       {"uniform-square", "grid", "lattice", "meet", "walks", "new-plans", "come-and-go"}) {
    SCOPED_TRACE(workload);
    lab::WorkloadParameters parameters;
    parameters.n = 9;
    if (std::string(workload) == "meet") parameters.dimension = 1;
    const Scene scene = lab::generate_scene(*lab::find_workload(workload), parameters);
    const WrittenFeatures features = write_moving_features(scene, "s.json", form());
    if (features.inexact > 0) continue;  // plans at thirds, ..
    EXPECT_EQ(features.error, Rational(0));
    EXPECT_EQ(write_moving_features(again(features.text), "s.json", form()).text, features.text);
    EXPECT_EQ(write_scene(again(features.text)), write_scene(scene));
  }
  const Scene scene = parse_scene(
      R"({"kinex": 1, "name": "late", "dimension": 2, "time": {"start": "5/2", "end": 4}, "objects": [)"
      R"({"id": "a", "weight": "1/3", "motion": [[1, 2], ["0.25"]]}, {"id": "b", "motion": [)"
      R"({"to": 3, "coordinates": [[0, 1], [3]]}, {"from": "7/2", "coordinates": [[1], [1, 1]]}]}], )"
      R"("maintain": ["sorted_list", {"structure": "sorted_list", "key": "y", "as": "up"}]})",
      "s");
  EXPECT_EQ(write_scene(again(write_moving_features(scene, "s", form()).text)), write_scene(scene));
}

// Places of `features` at `t`, against those of the scene: within the error that is stated.
void expect_near(const Scene& scene, const WrittenFeatures& features) {
  const Scene back = again(features.text);
  ASSERT_EQ(back.objects.size(), scene.objects.size());
  Rational worst;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    for (int k = 0; k < 1000; ++k) {
      const Rational t =
          scene.start + (*scene.end - scene.start) * Rational(Integer(2 * k + 1), Integer(2000));
      const MotionPiece* const exact = scene.objects[i].motion.piece_after(t);
      const MotionPiece* const read = back.objects[i].motion.piece_after(t);
      ASSERT_NE(read, nullptr);
      for (int axis = 0; axis < scene.dimension; ++axis) {
        const Rational off =
            exact->trajectory.position(axis, t) - read->trajectory.position(axis, t);
        worst = std::max(worst, off.sign() < 0 ? -off : off);
      }
    }
  }
  EXPECT_LE(worst, features.error);
  EXPECT_GT(worst, features.error / Rational(100000)) << "the bound says nothing";
}

TEST(MovingFeatures, CurvesAreSampledWithinTheirBound) {
  lab::WorkloadParameters parameters;
  parameters.n = 4;
  parameters.degree = 3;
  const Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
  const WrittenFeatures features = write_moving_features(scene, "s.json", form("1/1000"));
  EXPECT_EQ(features.inexact, 4u);
  EXPECT_LE(features.error, number("1/1000") + number("1e-11"));
  EXPECT_THAT(features.text, HasSubstr("\"error_at_most\": "));
  expect_near(scene, features);
  EXPECT_INPUT_ERROR(write_moving_features(scene, "s.json", form("1e-15")),
                     "--tolerance: a piece would take more than");
}

// MobilityDB's asMFJSON: the geometry alone is one object.
TEST(MovingFeatures, GeometryAlone) {
  const auto read = [](const std::string& members) {
    return import_moving_features(
               R"({"type": "MovingGeomPoint", "crs": {"type": "Name", "properties": {"name": "EPSG:3857"}}, )"
               R"("bbox": [[0, 0], [3, 0]], )" +
                   members +
                   R"("coordinates": [[0, 0], [3, 0]], "datetimes": ["2020-03-01T12:30:45+00", "2020-03-01T12:30:46.5+00"], )"
                   R"("lower_inc": true, "upper_inc": true, "interpolation": "Linear"})",
               "f", {})
        .scene;
  };
  const Scene scene = read("");
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].id, "1");
  EXPECT_EQ(scene.end, number("3/2"));
  EXPECT_EQ(scene.objects[0].motion.pieces[0].trajectory.position(0, Rational(1)), Rational(2));
  EXPECT_EQ(read(R"("id": "tram", )").objects[0].id, "tram");
}

// Two features of one line: the place is named, not the line.
TEST(MovingFeatures, TwoOfOneId) {
  const std::string one = moving_point("a", "[[0, 0], [7, 1], [9, 9]]");
  EXPECT_INPUT_ERROR(import(one + ", " + one),
                     "f.json: /features/1: the id \"a\" is that of /features/0 too; give one");
}

// Plans that change at thirds: times and places are rounded.
TEST(MovingFeatures, FractionsAreRoundedWithinTheirBound) {
  const Scene scene = parse_scene(
      R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 1}, "objects": [{"id": "a", "motion": [)"
      R"({"from": 0, "to": "1/3", "coordinates": [[0, 1000], [0]]}, )"
      R"({"from": "1/3", "to": 1, "coordinates": [["2000/3", -1000], [0]]}]}], "maintain": ["sorted_list"]})",
      "s");
  const WrittenFeatures features = write_moving_features(scene, "s.json", form());
  EXPECT_EQ(features.inexact, 1u);
  EXPECT_LE(features.error, number("2e-9"));
  expect_near(scene, features);
}

TEST(MovingFeatures, BodiesThatDoNotTurn) {
  const std::string body =
      R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 1}, "objects": [{"id": "a", )"
      R"("polygon": [[0, 0], [1, 0], [0, 1]], "motion": [[0, 1], [0]], "rotor": ROTOR}], "maintain": []})";
  const auto scene = [&](const std::string& rotor) {
    std::string text = body;
    return parse_scene(text.replace(text.find("ROTOR"), 5, rotor), "s");
  };
  const Scene turned = scene("[[1], [1]]");  // by 90 degrees
  const std::string text = write_moving_features(turned, "s", form()).text;
  EXPECT_THAT(text, HasSubstr("[[[0, 0], [0, 1], [-1, 0], [0, 0]]]"));
  EXPECT_EQ(write_scene(again(text)), write_scene(turned));
  EXPECT_INPUT_ERROR(write_moving_features(scene("[[1], [0, 1]]"), "s", form()),
                     "the body \"a\" turns");
}

TEST(MovingFeatures, WhatCannotBeWritten) {
  Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), {});
  MovingFeaturesForm late = form();
  late.time_zero = number("253402300799.5");
  EXPECT_INPUT_ERROR(write_moving_features(scene, "s.json", late), "the years 1 to 9999");
  scene.end.reset();
  EXPECT_INPUT_ERROR(write_moving_features(scene, "s.json", form()),
                     "s.json: /time: the scene has no end");
  MovingFeaturesForm until = form();
  until.until = Rational(1);
  EXPECT_NO_THROW(parse_json(write_moving_features(scene, "s.json", until).text, "f"));
}

}  // namespace moving_features_test
}  // namespace kinex::formats

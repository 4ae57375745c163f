// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of rigid bodies: polygons, headings, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "experiments/formats/csv_import.h"
#include "experiments/formats/csv_polygons.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/placed_body.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "tests/experiments/body_fixture.h"
#include "tests/experiments/expect_input_error.h"
#include "tests/shared_data.h"

namespace kinex {
namespace csv_bodies_test {

constexpr const char* kSquare = "id,x,y\n*,-1,-1\n*,1,-1\n*,1,1\n*,-1,1\n";

formats::ImportOptions bodies(std::string_view polygons, const std::string& heading = "",
                     bool compass = false) {
  formats::ImportOptions options;
  options.polygons = formats::parse_polygons(polygons, "p.csv");
  if (!heading.empty()) options.heading = {heading, compass};
  return options;
}

Scene import(std::string_view table, const formats::ImportOptions& options) {
  return formats::import_csv(table, "t.csv", options).scene;
}

void parse(const std::string& rows) { formats::parse_polygons("id,x,y\n" + rows, "p.csv"); }

TEST(CsvPolygons, AreExactAndInOrder) {
  const formats::PolygonTable table =
      formats::parse_polygons("y,id,x\n0,b,0\n0,a,0\n0,a,0.1\n0,b,1/3\n1e-3,a,0\n1,b,0\n1,b,-.5\n", "p");
  ASSERT_EQ(table.entries.size(), 2u);
  EXPECT_EQ(table.entries[0].id, "b");
  EXPECT_EQ(table.entries[1].line, 3u);
  const formats::Polygon2 a{{0, 0}, {ratio(1, 10), 0}, {0, ratio(1, 1000)}};
  const formats::Polygon2 b{{0, 0}, {ratio(1, 3), 0}, {0, 1}, {ratio(-1, 2), 1}};
  EXPECT_EQ(*table.find("a"), a);
  EXPECT_EQ(*table.find("b"), b);
  EXPECT_EQ(table.find("c"), nullptr);
  EXPECT_EQ(*formats::parse_polygons(kSquare, "p").find("anything"), square_of(1));
}

TEST(CsvPolygons, RefusesWithFileAndLine) {
  EXPECT_INPUT_ERROR(parse("a,0,0\na,1,0\n"),
                     "p.csv: line 2: \"a\": a polygon of 2 vertices; write at least 3");
  EXPECT_INPUT_ERROR(parse("b,0,0\nb,1,0\nb,0,1\na,0,0\na,0,1\na,1,0\n"),
                     "p.csv: line 5: \"a\": a polygon whose vertices go clockwise; write them "
                     "counter-clockwise");
  EXPECT_INPUT_ERROR(parse("a,0,0\na,1,0\na,0,1\na,0,0.0\n"),
                     "p.csv: line 5: \"a\": vertex 3 is where vertex 0 is already");
  EXPECT_INPUT_ERROR(parse("a,0,0\nb,0,0\na,1,0\nb,1,0\na,2,0\nb,0,1\na,0,1\n"),
                     "p.csv: line 4: \"a\": vertex 1 lies on the line of its neighbours");
  EXPECT_INPUT_ERROR(parse("a,0,0\na,4,0\na,4,4\na,3,1\n"),
                     "p.csv: line 5: \"a\": the polygon is not convex: it turns to the right");
  EXPECT_INPUT_ERROR(parse("a,0,0\na,2,0\na,0,2\na,2,2\n"),
                     "p.csv: line 2: \"a\": the polygon is not simple: its edges 1-2 and 3-0 meet");
  // A pentagram.
  EXPECT_INPUT_ERROR(parse("a,0,10\na,-6,-8\na,10,3\na,-10,3\na,6,-8\n"),
                     "p.csv: line 2: \"a\": a polygon that winds round 2 times");
  EXPECT_INPUT_ERROR(parse("a,0,0\na,1,zero\na,0,1\n"),
                     "p.csv: line 3: \"zero\" in column \"y\" is not a number");
  EXPECT_INPUT_ERROR(parse("a,0,0\n,1,0\n"), "p.csv: line 3: an empty id");
  EXPECT_INPUT_ERROR(parse(""), "p.csv: there are no rows");
  EXPECT_INPUT_ERROR(formats::parse_polygons("id,x\na,0\n", "p.csv"), "p.csv: line 1: the columns are not");
  EXPECT_INPUT_ERROR(formats::parse_polygons("id,x,y,z\na,0,0,0\n", "p.csv"), "the columns are not id, x");
  EXPECT_INPUT_ERROR(formats::parse_polygons("", "p.csv"), "p.csv: the file is empty");
  // What JSON would have to escape is no number.
  EXPECT_INPUT_ERROR(parse("a,0,0\na,\"1\"\"\",0\n"), "line 3: \"1\"\" in column \"x\" is not");
}

TEST(CsvBodies, VelocitiesOfBodies) {
  const Scene scene = import("id,x,y,vx,vy,h\na,0,0,1,2,90\nb,9,0,0,0,-90\nc,0,9,0,0,36.87\n",
                             bodies(std::string(kSquare) + "b,0,0\nb,1,0\nb,0,1\n", "h"));
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_TRUE(scene.has_bodies());
  EXPECT_EQ(scene.objects[0].polygon, square_of(1));
  EXPECT_EQ(scene.objects[1].polygon, (formats::Polygon2{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(scene.objects[0].motion.pieces[0].trajectory, trajectory({{0, 1}, {0, 2}, {1}, {1}}));
  EXPECT_EQ(scene.objects[1].motion.pieces[0].trajectory, trajectory({{9}, {0}, {-1}, {1}}));
  const std::string text = formats::write_scene(scene);
  EXPECT_EQ(formats::write_scene(formats::parse_scene(text, "again")), text);
  // Vertex (1, 0) of c is where the heading points.
  const Trajectory& c = scene.objects[2].motion.pieces[0].trajectory;
  const Vertex2 tip = formats::placed_polygon({{1, 0}, {0, 1}, {-1, 0}}, c, 0)[0];
  EXPECT_NEAR(tip[0].to_double(), 0.799998928148509, 4e-12);
  EXPECT_NEAR(tip[1].to_double(), 9.60000142913266, 4e-12);
}

TEST(CsvBodies, WithoutHeadingTheyDoNotTurn) {
  const Scene scene = import("id,t,x,y\na,0,0,0\na,1,5,0\na,2,5,5\n", bodies(kSquare));
  ASSERT_EQ(scene.objects[0].motion.pieces.size(), 2u);
  EXPECT_EQ(scene.objects[0].motion.pieces[1].trajectory, trajectory({{5}, {-5, 5}, {1}, {0}}));
  EXPECT_EQ(formats::write_scene(scene).find("rotor"), std::string::npos);
}

TEST(CsvBodies, TracesTurnContinuously) {
  const Scene scene = import(
      "id,t,x,y,h\na,0,0,0,0\na,1,1,0,90\na,2,2,0,90\na,3,3,0,90\na,4,4,0,10.5\na,9/2,9,0,-20\n"
      "a,5,9,0,160\na,6,9,0,-20\n",
      bodies(kSquare, "h"));
  EXPECT_FALSE(scene.jumps);
  const auto& pieces = scene.objects[0].motion.pieces;
  ASSERT_EQ(pieces.size(), 6u);  // the second and the third are one
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    EXPECT_TRUE(pieces[i - 1].trajectory.meets(pieces[i].trajectory, *pieces[i].from, true)) << i;
  }
  EXPECT_EQ(pieces[1].trajectory, trajectory({{0, 1}, {0}, {1}, {1}}));
  EXPECT_EQ(*pieces[1].to, Rational(3));
  EXPECT_NO_THROW(formats::parse_scene(formats::write_scene(scene), "again"));
}

TEST(CsvBodies, ABearingIsAHeadingFromNorth) {
  const std::string rows[] = {"a,0,0,0,", "a,1,1,0,", "b,0,9,0,", "b,1,9,9,"};
  const int bearings[] = {0, 271, -44, 180};
  std::string by_bearing = "id,t,x,y,c\n", by_heading = by_bearing;
  for (std::size_t i = 0; i < 4; ++i) {
    by_bearing += rows[i] + std::to_string(bearings[i]) + "\n";
    by_heading += rows[i] + std::to_string(90 - bearings[i]) + "\n";
  }
  const Scene scene = import(by_bearing, bodies(kSquare, "c", true));
  EXPECT_EQ(formats::write_scene(scene), formats::write_scene(import(by_heading, bodies(kSquare, "c"))));
  // It sets out to the north.
  const Trajectory& a = scene.objects[0].motion.pieces[0].trajectory;
  EXPECT_EQ(formats::placed_polygon({{1, 0}, {0, 1}, {-1, 0}}, a, 0)[0], (Vertex2{0, 1}));
}

TEST(CsvBodies, TheSameFixTwice) {
  const formats::ImportOptions options = bodies(kSquare, "h");
  const formats::ImportReport report =
      formats::import_csv("id,t,x,y,h\na,0,0,0,0\na,0,0,0,360\na,1,0,0,0\n", "t.csv", options);
  EXPECT_EQ(report.repeated_fixes, 1u);
  EXPECT_INPUT_ERROR(import("id,t,x,y,h\na,0,0,0,0\na,0,0,0,1\na,1,0,0,0\n", options),
                     "t.csv: line 3: \"a\" has another heading at the same time in line 2");
}

TEST(CsvBodies, FixedObjectsAreBodiesToo) {
  formats::ImportOptions options = bodies(std::string(kSquare) + "quay,0,0\nquay,9,0\nquay,0,1\n");
  options.fixed = {"quay,0,5", "buoy,-5,0"};
  const Scene scene = import("id,x,y,vx,vy\na,0,0,1,0\n", options);
  EXPECT_EQ(scene.objects[1].polygon.size(), 3u);
  EXPECT_EQ(scene.objects[2].polygon, square_of(1));
  EXPECT_EQ(scene.objects[2].motion.pieces[0].trajectory, trajectory({{-5}, {0}, {1}, {0}}));
  options.polygons = formats::parse_polygons("id,x,y\na,0,0\na,1,0\na,0,1\n", "p.csv");
  EXPECT_INPUT_ERROR(import("id,x,y,vx,vy\na,0,0,1,0\n", options),
                     "--fixed: \"quay\" has no polygon in p.csv; add its vertices there");
}

TEST(CsvBodies, PolygonsAndObjectsBelongTogether) {
  const std::string table = "id,t,x,y\na,0,0,0\nb,0,5,0\na,1,0,0\nb,1,5,0\nlone,0,0,0\n";
  const std::string a = "a,0,0\na,1,0\na,0,1\n", b = "b,0,0\nb,1,0\nb,0,1\n";
  EXPECT_INPUT_ERROR(import(table, bodies("id,x,y\n" + a)),
                     "t.csv: line 3: \"b\" has no polygon in p.csv; add its vertices there, or");
  EXPECT_INPUT_ERROR(import(table, bodies("id,x,y\n" + a + b + "c,0,0\nc,1,0\nc,0,1\n")),
                     "p.csv: line 8: there is no object \"c\"; write an id of t.csv, or \"*\"");
  // A single fix makes no object, with a polygon or without.
  EXPECT_EQ(import(table, bodies("id,x,y\n" + a + b)).objects.size(), 2u);
  EXPECT_EQ(
      import(table, bodies("id,x,y\n" + a + b + "lone,0,0\nlone,1,0\nlone,0,1\n")).objects.size(),
      2u);
}

TEST(CsvBodies, BodiesInContactAreRefusedByName) {
  const auto apart = [](const char* x) {
    return "id,x,y,vx,vy\nfar,90,0,0,0\na,0,0,1,0\nb," + std::string(x) + ",0,0,0\n";
  };
  EXPECT_INPUT_ERROR(import(apart("2"), bodies(kSquare)),
                     "t.csv: line 4: the bodies \"a\" and \"b\" touch at the scene's start; place");
  EXPECT_INPUT_ERROR(import(apart("1"), bodies(kSquare)), "\"a\" and \"b\" overlap at the");
  EXPECT_NO_THROW(import(apart("2.0000001"), bodies(kSquare)));
  try {
    import(apart("2"), bodies(kSquare));
  } catch (const formats::InputError& error) {  // no line of a file that is not there
    EXPECT_EQ(error.remedy(),
              "place them apart, or give --overlapping-starts contact (not refused)");
  }
  formats::ImportOptions contact = bodies(kSquare);
  contact.overlapping_starts = OverlappingStarts::kContact;
  EXPECT_EQ(import(apart("1"), contact).overlapping_starts, OverlappingStarts::kContact);
  // At another start they are apart.
  formats::ImportOptions options = bodies(kSquare);
  options.start = -1;
  EXPECT_NO_THROW(import(apart("2"), options));
}

TEST(CsvBodies, HeadingsAreRefusedWithARemedy) {
  const std::string table = "id,x,y,vx,vy,h\na,0,0,0,0,";
  EXPECT_INPUT_ERROR(import(table + "north\n", bodies(kSquare, "h")),
                     "t.csv: line 2: \"north\" in column \"h\" is not a number");
  EXPECT_INPUT_ERROR(import(table + "\n", bodies(kSquare, "h")), "line 2: \"\" in column \"h\"");
  EXPECT_INPUT_ERROR(import(table + "511\n", bodies(kSquare, "h", true)),
                     "t.csv: line 2: \"511\" in column \"h\" is not an angle; write degrees from");
  EXPECT_INPUT_ERROR(import(table + "0\n", bodies(kSquare, "g", true)),
                     "t.csv: line 1: there is no column \"g\", the one of --bearing");
  EXPECT_INPUT_ERROR(import(table + "0\n", bodies(kSquare, "vx")),
                     "--heading: the column \"vx\" has another meaning");
  EXPECT_INPUT_ERROR(import(table + "0\n", bodies(kSquare)),
                     "t.csv: line 1: the column \"h\" means nothing here; remove it, or name it");
  // Traces are the remedy where there are velocities.
  const auto said_of = [](const std::string& rows) {
    try {
      import(rows, bodies(kSquare));
    } catch (const formats::InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_THAT(said_of(table + "0\n"),
              testing::HasSubstr("; a body that turns is written as traces, for no rotor"));
  EXPECT_THAT(said_of("id,t,x,y,h\na,0,0,0,0\na,1,0,0,0\n"),
              testing::AllOf(testing::EndsWith("or give --ignore-columns"),
                             testing::Not(testing::HasSubstr("traces"))));
  formats::ImportOptions points;
  points.heading = {"h", false};
  EXPECT_INPUT_ERROR(import(table + "0\n", points), "--heading: points have no heading; give");
}

TEST(CsvBodies, MoveInThePlane) {
  EXPECT_INPUT_ERROR(
      import("id,x,vx\na,0,0\n", bodies(kSquare)),
      "t.csv: line 1: bodies have 2 axes, the table has 1; name the columns x and y");
  EXPECT_INPUT_ERROR(import("id,t,x,y,z\na,0,0,0,0\n", bodies(kSquare)), "the table has 3");
}

// Storms as triangles that point where a hash of their number says.
TEST(CsvBodies, Hurricanes) {
  const std::string file = shared_data("hurricanes.csv");
  KINEX_REQUIRE_DATA(file);
  const std::string text = formats::read_text_file(file);
  std::string table = "id,t,x,y,h\n";
  std::size_t rows = 0;
  for (std::size_t begin = text.find('\n') + 1; begin < text.size() && rows < 5000; ++rows) {
    const std::size_t end = text.find('\n', begin);
    table += text.substr(begin, end - begin) + "," + std::to_string(rows * 7919 % 3600) + "/10\n";
    begin = end + 1;
  }
  const std::string small = "id,x,y\n*,-1e-3,-1e-3\n*,1e-3,0\n*,-1e-3,1e-3\n";
  const formats::ImportReport report = formats::import_csv(table, file, bodies(small, "h"));
  EXPECT_GT(report.scene.objects.size(), 150u);
  EXPECT_EQ(report.rows, rows);
}

}  // namespace csv_bodies_test
}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of discs, boxes, points with weights or colours, edges of graphs and lines.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/formats/csv_import.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace csv_properties_test {

formats::ImportReport import(std::string_view text, const formats::ImportOptions& options = {}) {
  return formats::import_csv(text, "t.csv", options);
}
formats::ImportOptions named(const std::vector<formats::NamedColumn>& columns,
                             bool ignore = false) {
  formats::ImportOptions options;
  options.columns = columns;
  options.ignore_columns = ignore;
  return options;
}
// The scene of these objects as it is written.
std::string by_hand(int dimension, const std::string& time, const std::string& objects) {
  const std::string text = R"({"kinex": 1, "dimension": )" + std::to_string(dimension) +
                           R"(, "time": )" + time + R"(, "objects": [)" + objects +
                           R"(], "maintain": []})";
  return formats::write_scene(formats::parse_scene(text, "hand.json"));
}
std::string written(std::string_view text, const formats::ImportOptions& options = {}) {
  const std::string scene = formats::write_scene(import(text, options).scene);
  EXPECT_EQ(formats::write_scene(formats::parse_scene(scene, "again")), scene);
  return scene;
}

// A radius changes as a place does: linearly between two fixes.
TEST(CsvProperties, Discs) {
  // Right after its end it would be negative.
  EXPECT_INPUT_ERROR(import("id,t,x,y,radius\na,0,0,0,1\na,2,4,0,2\na,4,4,0,0\n"),
                     "t.csv: line 4: \"0\" in column \"radius\": the radius of \"a\" is negative "
                     "right after its last fix");
  const std::string table =
      "id,t,x,y,radius\na,0,0,0,1\na,2,4,0,2\na,4,4,0,1\nb,0,9,0,.5\nb,4,9,0,1/2\n";
  EXPECT_EQ(
      written(table),
      by_hand(
          2, R"({"start": 0, "end": 4})",
          R"({"id": "a", "motion": [{"from": 0, "to": 2, "coordinates": [[0, 2], [0]], "radius": [1, "1/2"]},
                                {"from": 2, "to": 4, "coordinates": [[4], [0]], "radius": [3, "-1/2"]}]},
         {"id": "b", "motion": [{"from": 0, "to": 4, "coordinates": [[9], [0]], "radius": ["1/2"]}]})"));
  const formats::ImportReport report = import(table);
  EXPECT_EQ(report.notes, std::vector<std::string>{"the objects are discs"});
  EXPECT_EQ(report.details[0], "columns: id, t, x, y, radius");
}

TEST(CsvProperties, ColumnsByNameSeparatorsAndDates) {
  const std::string hand = by_hand(
      2, R"({"start": 0, "end": 60})",
      R"({"id": "7", "colour": "tram", "motion": [{"from": 0, "to": 60, "coordinates": [[0, "1/10"], [0]], "radius": [1, "1/60"]}]})");
  const std::string rows =
      "7;2024-05-01T08:00:00Z;0;0;1;99;tram\n7;2024-05-01T08:01:00Z;6;0;2;99;tram\n";
  const formats::ImportOptions options =
      named({{"id", "vehicle"}, {"t", "time"}, {"radius", "r"}, {"colour", "kind"}}, true);
  EXPECT_EQ(written("vehicle;time;x;y;r;radius;kind\n" + rows, options), hand);
  std::string tabs = "vehicle;time;x;y;r;radius;kind\n" + rows;
  for (char& c : tabs) c = c == ';' ? '\t' : c;
  EXPECT_EQ(written(tabs, options), hand);
  EXPECT_EQ(import(tabs, options).details[0],
            "columns: id from vehicle, t from time, x, y, radius from r, colour from kind");
  EXPECT_EQ(import(tabs, options).details[1], "ignored: radius");
}

TEST(CsvProperties, BoxesAndRates) {
  EXPECT_EQ(
      written("id,x,y,z,vx,vy,vz,hx,hy,hz,vhy\na,0,1,0,1,0,0,1,2,0.5,1\n"),
      by_hand(
          3, R"({"start": 0})",
          R"({"id": "a", "half_extents": [[1], [2, 1], ["1/2"]], "motion": [[0, 1], [1], [0]]})"));
  EXPECT_EQ(
      written("id,t,x,hx\na,0,0,1\na,2,0,3\n"),
      by_hand(
          1, R"({"start": 0, "end": 2})",
          R"({"id": "a", "motion": [{"from": 0, "to": 2, "coordinates": [[0]], "half_extents": [[1, 1]]}]})"));
}

TEST(CsvProperties, WeightsOfEitherSign) {
  EXPECT_EQ(
      written("id,t,x,y,weight\na,0,0,0,-1\na,2,0,0,3\nb,0,1,1,7\nb,2,1,1,7\n"),
      by_hand(
          2, R"({"start": 0, "end": 2})",
          R"({"id": "a", "weight": [-1, 2], "motion": [{"from": 0, "to": 2, "coordinates": [[0], [0]]}]},
                       {"id": "b", "weight": 7, "motion": [{"from": 0, "to": 2, "coordinates": [[1], [1]]}]})"));
  EXPECT_EQ(written("id,x,y,vx,vy,weight,vweight\na,0,0,1,0,5,-1/2\n"),
            by_hand(2, R"({"start": 0})",
                    R"({"id": "a", "weight": [5, "-1/2"], "motion": [[0, 1], [0]]})"));
}

// An empty field says nothing, in any row.
TEST(CsvProperties, WordsAreThoseOfTheObject) {
  const std::string hand = by_hand(
      2, R"({"start": 0, "end": 2})",
      R"({"id": "a", "colour": "light, \"red\"", "motion": [{"from": 0, "to": 2, "coordinates": [[0, 1], [0]]}]},
         {"id": "b", "motion": [{"from": 0, "to": 2, "coordinates": [[5], [0]]}]})");
  EXPECT_EQ(written("id,t,x,y,colour\na,0,0,0,\nb,0,5,0,\na,2,2,0,\"light, "
                    "\"\"red\"\"\"\nb,2,5,0,\na,1,1,0,\n"),
            hand);
  // An object of a single fix is left out, its colour too.
  EXPECT_EQ(written("id,t,x,y,colour\nlone,1,0,0,green\na,0,0,0,\"light, "
                    "\"\"red\"\"\"\nb,0,5,0,\na,2,2,0,\nb,2,5,0,\n"),
            hand);
  EXPECT_INPUT_ERROR(import("id,x,vx,colour\na,0,0,re\xff\n"),
                     "t.csv: line 2: \"re\\xff\" in column \"colour\" is not UTF-8");
  EXPECT_INPUT_ERROR(import("id,t,x,colour\na,0,0,red\na,1,0,\na,2,0,blue\n"),
                     "t.csv: line 4: \"blue\" in column \"colour\": the colour of \"a\" is "
                     "\"red\" in line 2; write the same in all rows");
  EXPECT_EQ(import("id,x,vx,colour\na,0,0,red\nb,0,0,red\nc,0,0,blue\n").notes,
            std::vector<std::string>{"the objects are points of 2 colours"});
}

TEST(CsvProperties, EdgesOfAGraph) {
  const std::string hand = by_hand(
      1, R"({"start": 0, "end": 9})",
      R"({"id": "a", "ends": ["u", "v"], "motion": [{"from": 0, "to": 9, "coordinates": [[1]]}]},
         {"id": "b", "ends": ["v", "w"], "motion": [{"from": 0, "to": 9, "coordinates": [[2, 1]]}]})");
  const std::string rows = "a,0,u,v,1\nb,0,v,w,2\na,9,,,1\nb,9,v,w,11\n";
  EXPECT_EQ(written("id,t,from,to,weight\n" + rows), hand);
  EXPECT_EQ(written("id,t,from,to,x\n" + rows), hand);
  EXPECT_EQ(written("id,t,tail,head,cost\n" + rows,
                    named({{"from", "tail"}, {"to", "head"}, {"weight", "cost"}})),
            hand);
  EXPECT_EQ(
      written("id,from,to,weight,vweight\na,u,v,1,0\nb,v,w,2,1\n"),
      by_hand(
          1, R"({"start": 0})",
          R"({"id": "a", "ends": ["u", "v"], "motion": [[1]]}, {"id": "b", "ends": ["v", "w"], "motion": [[2, 1]]})"));
  EXPECT_INPUT_ERROR(import("id,t,from,to,weight\na,0,u,v,1\na,0,u,v,2\n"),
                     "line 3: \"a\" has another weight at the same time in line 2");
}

TEST(CsvProperties, Lines) {
  const std::string hand = by_hand(
      2, R"({"start": 0})",
      R"({"id": "l", "line": true, "motion": [["1/2", 1], [0]]}, {"id": "p", "colour": "red", "motion": [[0, 1], [1]]})");
  EXPECT_EQ(written("id,x,y,vx,vy,line,colour\nl,1/2,0,1,0,True,\np,0,1,1,0,,red\n"), hand);
  EXPECT_EQ(written("id,slope,height,vslope,vheight,is,colour\nl,1/2,0,1,0,1,\np,0,1,1,0,0,red\n",
                    named({{"x", "slope"},
                           {"y", "height"},
                           {"vx", "vslope"},
                           {"vy", "vheight"},
                           {"line", "is"}})),
            hand);
}

// Tables of others may have columns of these names.
TEST(CsvProperties, AMeaningWithoutAColumn) {
  const std::string table =
      "id,t,x,y,line,from,to,weight,radius\na,0,0,0,M10,A,B,9,1\na,1,0,0,M10,A,B,9,1\n";
  EXPECT_INPUT_ERROR(import(table), "t.csv: line 1: the columns \"radius\" and \"weight\"");
  const formats::ImportReport report =
      import(table, named({{"line", ""}, {"radius", ""}, {"weight", ""}}, true));
  EXPECT_EQ(report.ignored_columns, 5u);
  EXPECT_EQ(report.scene.extents, Extents::kNone);
  EXPECT_EQ(import("id,t,x,y,vx,vy\na,0,0,0,1,1\n", named({{"t", ""}}, true)).scene.objects.size(),
            1u);
  EXPECT_INPUT_ERROR(import(table, named({{"x", ""}})), "t.csv: line 1: there is no column \"x\"");
}

TEST(CsvProperties, WhatHasNoUseIsRefusedByName) {
  const std::string table = "id,t,x,y,r\na,0,0,0,1\na,1,0,0,1\n";
  EXPECT_INPUT_ERROR(import(table, named({{"hz", "r"}}, true)),
                     "--column: hz=r has no use here: the table has 2 axes; leave it out");
  EXPECT_INPUT_ERROR(import(table, named({{"vradius", "r"}}, true)),
                     "--column: vradius=r has no use here: traces have values at fixes, no rates");
  EXPECT_INPUT_ERROR(import(table, named({{"from", "r"}}, true)),
                     "--column: from=r has no use here: the table has 2 axes, edges of a graph are "
                     "in tables of 1");
  EXPECT_INPUT_ERROR(import(table, named({{"vx", "r"}}, true)),
                     "--column: vx=r has no use here; leave it out");
  EXPECT_INPUT_ERROR(import("id,x,VX\na,0,0\n"), "there is no column \"vx\" in small letters");
  EXPECT_INPUT_ERROR(import("id,when,x,Radius\na,0,0,0\n"),
                     "there is no column \"t\", and none \"vx\"");
}

// As before these columns had a meaning.
TEST(CsvProperties, BodiesHaveNone) {
  formats::ImportOptions options;
  options.polygons = formats::parse_polygons("id,x,y\n*,-1,-1\n*,1,-1\n*,0,1\n", "p.csv");
  const std::string table = "id,t,x,y,radius,colour\na,0,0,0,1,red\na,1,0,0,1,blue\n";
  EXPECT_INPUT_ERROR(import(table, options),
                     "t.csv: line 1: the column \"radius\" means nothing here: objects with "
                     "polygons have none; remove it, or give --ignore-columns");
  options.ignore_columns = true;
  EXPECT_EQ(import(table, options).ignored_columns, 2u);
  options.columns = {{"weight", "radius"}};
  EXPECT_INPUT_ERROR(import(table, options),
                     "--column: weight=radius has no use here: objects with polygons have none");
}

TEST(CsvProperties, FixedObjects) {
  formats::ImportOptions options;
  options.fixed = {"Sun,0,1/3,2"};
  const std::string discs = "id,t,x,y,radius\na,0,0,0,1\na,2,0,0,3\n";
  EXPECT_EQ(
      written(discs, options),
      by_hand(
          2, R"({"start": 0, "end": 2})",
          R"({"id": "a", "motion": [{"from": 0, "to": 2, "coordinates": [[0], [0]], "radius": [1, 1]}]},
                       {"id": "Sun", "radius": [2], "motion": [[0], ["1/3"]]})"));
  options.fixed = {"Sun,0,1"};
  EXPECT_INPUT_ERROR(import(discs, options),
                     "--fixed: \"Sun,0,1\" has 3 fields, not 4; write ID,X,Y,RADIUS");
  options.fixed = {"Sun,0,1,-2"};
  EXPECT_INPUT_ERROR(import(discs, options),
                     "--fixed: \"-2\" in \"Sun,0,1,-2\" is negative; write a radius of 0 or more");
  EXPECT_INPUT_ERROR(import("id,x,vx,weight\na,0,0,0\n", options),
                     "has 4 fields, not 3; write ID,X,WEIGHT");
  EXPECT_INPUT_ERROR(import("id,x,vx,hx\na,0,0,0\n", options),
                     "has 4 fields, not 3; write ID,X,HX");
  EXPECT_INPUT_ERROR(import("id,x,y,vx,vy,hx,hy\na,0,0,0,0,0,0\n", options),
                     "has 4 fields, not 5; write ID,X,Y,HX,HY");
  options.fixed = {"Sun,0,1,-2"};
  EXPECT_EQ(written("id,x,y,vx,vy,weight\na,0,0,0,0,3\n", options),
            by_hand(2, R"({"start": 0})", R"({"id": "a", "weight": 3, "motion": [[0], [0]]},
                                             {"id": "Sun", "weight": -2, "motion": [[0], [1]]})"));
}

// ---- a radius is refused in a table where the same scene by hand is refused

bool takes(const std::string& table, const formats::ImportOptions& options) {
  std::string scene;
  try {
    scene = formats::write_scene(import(table, options).scene);
  } catch (const formats::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("negative"), std::string::npos) << error.what();
    return false;
  }
  EXPECT_NO_THROW(formats::parse_scene(scene, "again")) << scene;
  return true;
}
bool takes_by_hand(const std::string& time, const std::string& objects) {
  try {
    by_hand(1, time, objects);
    return true;
  } catch (const formats::InputError&) {
    return false;
  }
}
std::string time_of(const formats::ImportOptions& options) {
  return R"({"start": )" + options.start->to_string() +
         (options.end ? R"(, "end": )" + options.end->to_string() : "") + "}";
}

TEST(CsvProperties, RatesAreRefusedAsInScenes) {
  std::size_t taken = 0, cases = 0;
  for (const int start : {-2, 0, 1}) {
    for (const int length : {0, 1, 2, 5}) {
      for (int radius = -2; radius <= 2; ++radius) {
        for (int rate = -2; rate <= 2; ++rate) {
          formats::ImportOptions options;
          options.start = Rational(start);
          if (length > 0) options.end = Rational(start + length);
          const std::string r = std::to_string(radius), v = std::to_string(rate);
          const bool by_table =
              takes("id,x,vx,radius,vradius\na,0,0," + r + "," + v + "\n", options);
          EXPECT_EQ(by_table,
                    takes_by_hand(time_of(options), R"({"id": "a", "motion": [[0]], "radius": [)" +
                                                        r + ", " + v + "]}"))
              << start << " " << length << " " << r << " " << v;
          taken += by_table ? 1 : 0;
          ++cases;
        }
      }
    }
  }
  EXPECT_GT(taken, cases / 4);
  EXPECT_LT(taken, cases * 3 / 4);
}

TEST(CsvProperties, TracesAreRefusedAsInScenes) {
  std::size_t taken = 0, cases = 0;
  for (const auto& [start, end] : {std::pair(0, 2), {0, 1}, {0, 4}, {1, 2}, {2, 3}, {-1, 1}}) {
    for (int radii = 0; radii < 8; ++radii) {
      const int a = radii & 1, b = radii >> 1 & 1, c = radii >> 2 & 1;
      formats::ImportOptions options;
      options.start = Rational(start);
      options.end = Rational(end);
      const auto row = [](int t, int r) {
        return "a," + std::to_string(t) + ",0," + std::to_string(r) + "\n";
      };
      const auto piece = [](int t, int from, int to) {
        return R"({"from": )" + std::to_string(t) + R"(, "to": )" + std::to_string(t + 1) +
               R"(, "coordinates": [[0]], "radius": [)" + std::to_string(from - (to - from) * t) +
               ", " + std::to_string(to - from) + "]}";
      };
      const bool by_table = takes("id,t,x,radius\n" + row(0, a) + row(1, b) + row(2, c), options);
      EXPECT_EQ(by_table,
                takes_by_hand(time_of(options), R"({"id": "a", "motion": [)" + piece(0, a, b) +
                                                    ", " + piece(1, b, c) + "]}"))
          << start << " " << end << " " << a << b << c;
      taken += by_table ? 1 : 0;
      ++cases;
    }
  }
  EXPECT_GT(taken, cases / 2);
  EXPECT_LT(taken, cases);
}

}  // namespace csv_properties_test
}  // namespace kinex

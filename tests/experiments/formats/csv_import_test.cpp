// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_import.h"

#include <gtest/gtest.h>

#include <set>

#include "experiments/formats/csv_table.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/utf8.h"
#include "tests/experiments/expect_input_error.h"
#include "tests/shared_data.h"

namespace kinex {
namespace csv_import_test {

formats::ImportReport import(std::string_view text) { return formats::import_csv(text, "t.csv", {}); }
Rational ratio(int p, int q) { return Rational(Integer(p), Integer(q)); }

TEST(CsvTable, FollowsRfc4180) {
  const formats::CsvTable table =
      formats::parse_csv("\xef\xbb\xbf id , x\r\n\"a, \"\"b\"\"\",1\r\n\n\"two\nlines\",2", "t");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"id", "x"}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].fields[0], "a, \"b\"");
  EXPECT_EQ(table.rows[1].fields[0], "two\nlines");
  EXPECT_EQ(table.rows[1].line, 4u);
  EXPECT_INPUT_ERROR(formats::parse_csv("", "t.csv"), "t.csv: the file is empty");
  EXPECT_INPUT_ERROR(formats::parse_csv("a,a\n", "t.csv"), "column \"a\" stands twice");
  EXPECT_INPUT_ERROR(formats::parse_csv("a,b\n1,2\n3\n", "t.csv"),
                     "t.csv: line 3: 1 field in a table");
  EXPECT_INPUT_ERROR(formats::parse_csv("a,b\n\"1,2\n3\n", "t.csv"), "t.csv: line 2: a quote is not closed");
  EXPECT_INPUT_ERROR(formats::parse_csv("a,b\n\"1\"2,2\n", "t.csv"), "text after a closing quote");
}

// Names and values alike.
TEST(CsvTable, BlanksAroundFieldsAreRemoved) {
  const formats::CsvTable table =
      formats::parse_csv("id, t,\tx \r\n a b , 0 ,1\n\"c\" ,  \" 1\" ,  \n   \n \"d,e\",,2", "t");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"id", "t", "x"}));
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].fields, (std::vector<std::string>{"a b", "0", "1"}));
  EXPECT_EQ(table.rows[1].fields, (std::vector<std::string>{"c", " 1", ""}));  // in quotes they stay
  EXPECT_EQ(table.rows[2].fields, (std::vector<std::string>{"d,e", "", "2"}));
  EXPECT_EQ(table.rows[2].line, 5u);
  EXPECT_EQ(formats::parse_csv("id\t x\n a\t\n", "t").rows[0].fields, (std::vector<std::string>{"a", ""}));
  EXPECT_INPUT_ERROR(formats::parse_csv("a,b\n\"1\" 2,2\n", "t.csv"), "text after a closing quote");
}

TEST(CsvTable, LinesThatEndWithCarriageReturnsAlone) {
  EXPECT_INPUT_ERROR(formats::parse_csv("id,t,x\ra,0,1\r", "t.csv"),
                     "t.csv: its lines end with carriage returns (CR) alone; end them with line feeds: tr '\\r' '\\n' < FILE");
}

TEST(CsvImport, CapitalsMatter) {
  EXPECT_INPUT_ERROR(import("ID,T,X,Y\na,0,0,0\n"),
                     "t.csv: line 1: there is no column \"id\" in small letters; capitals matter; write the names in small "
                     "letters, or give --column id=ID --column t=T --column x=X --column y=Y");
  EXPECT_INPUT_ERROR(import("id,T,x\na,0,0\n"), "there is no column \"t\" in small letters; capitals matter; write the "
                                                "names in small letters, or give --column t=T");
  EXPECT_INPUT_ERROR(import("id,t,x,Y\na,0,0,0\n"), "the column \"Y\" means nothing here; capitals matter; write the names in "
                                                   "small letters, or give --column y=Y, or --ignore-columns");
}

TEST(CsvImport, TracesAreExactAndLinearBetweenFixes) {
  const formats::ImportReport report =
      import("id,t,x,y\na,3,0.3,0\nb,0,1,1\na,0,0,0\na,1,0.1,0\na,2,0.2,0\nb,2,0,2\nc,9,0,0\n");
  const Scene& scene = report.scene;
  EXPECT_EQ(report.rows, 7u);
  EXPECT_EQ(report.single_fixes.size(), 1u);
  EXPECT_EQ(scene.start, Rational(0));
  EXPECT_EQ(*scene.end, Rational(9));
  ASSERT_EQ(scene.objects.size(), 2u);
  // 0.1 is 1/10, so a flies straight at one speed: one piece.
  ASSERT_EQ(scene.objects[0].motion.pieces.size(), 1u);
  const MotionPiece& a = scene.objects[0].motion.pieces[0];
  EXPECT_EQ(*a.from, Rational(0));
  EXPECT_EQ(*a.to, Rational(3));
  EXPECT_EQ(a.trajectory.coordinates[0], (std::vector<Rational>{Rational(0), ratio(1, 10)}));
  const MotionPiece& b = scene.objects[1].motion.pieces[0];
  EXPECT_EQ(b.trajectory.position(0, Rational(1)), ratio(1, 2));
  EXPECT_EQ(b.trajectory.position(1, Rational(2)), Rational(2));
}

TEST(CsvImport, PiecesMeet) {
  const Scene scene = import("id,t,x\na,0,0\na,1/3,0.7\na,2,-5\na,7,1/9\n").scene;
  const auto& pieces = scene.objects[0].motion.pieces;
  ASSERT_EQ(pieces.size(), 3u);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i - 1].to, pieces[i].from);
    EXPECT_EQ(pieces[i - 1].trajectory.position(0, *pieces[i].from),
              pieces[i].trajectory.position(0, *pieces[i].from));
  }
  EXPECT_NO_THROW(formats::parse_scene(formats::write_scene(scene), "again"));
}

TEST(CsvImport, Velocities) {
  const Scene scene = import("vy,id,x,y,vx\n4,a,1,2,3\n0,b,0,0,0\n").scene;
  EXPECT_FALSE(scene.end);
  const Trajectory& a = scene.objects[0].motion.pieces[0].trajectory;
  EXPECT_EQ(a.position(0, Rational(2)), Rational(7));
  EXPECT_EQ(a.position(1, Rational(2)), Rational(10));
  EXPECT_EQ(scene.objects[1].motion.degree(), 0);
  formats::ImportOptions options;
  options.start = Rational(-5);
  options.end = Rational(5);
  const Scene other = formats::import_csv("id,x,vx\na,1,3\n", "t", options).scene;
  EXPECT_EQ(other.start, Rational(-5));
  EXPECT_EQ(*other.end, Rational(5));
}

TEST(CsvImport, RefusesWithFileAndLine) {
  EXPECT_INPUT_ERROR(import("id,t,x\na,0,0\na,0,1\n"), "t.csv: line 3: \"a\" is at another place");
  EXPECT_EQ(import("id,t,x\na,0,0\na,0.0,0\na,1,1\n").repeated_fixes, 1u);
  EXPECT_INPUT_ERROR(import("id,t,x\na,0,zero\n"), "t.csv: line 2: \"zero\" in column \"x\"");
  EXPECT_INPUT_ERROR(import("id,t,x\n,0,0\n"), "t.csv: line 2: an empty id");
  EXPECT_INPUT_ERROR(import("id,t,x\n"), "there are no rows");
  EXPECT_INPUT_ERROR(import("id,t,x\na,0,0\n"), "no object has two fixes");
  EXPECT_INPUT_ERROR(import("name,t,x\n"), "there is no column \"id\"");
  EXPECT_INPUT_ERROR(import("id,t,y\na,0,0\n"), "there is no column \"x\"");
  EXPECT_INPUT_ERROR(import("id,x,y,vx\na,0,0,0\n"), "there is no column \"vy\"");
  EXPECT_INPUT_ERROR(import("id,time,x\na,0,0\n"), "there is no column \"t\", and none \"vx\"");
  EXPECT_INPUT_ERROR(import("id,t,x,speed\na,0,0,0\n"),
                     "t.csv: line 1: the column \"speed\" means nothing here");
  EXPECT_INPUT_ERROR(import("id,x,vx\na,0,0\na,0,0\n"), "the id \"a\" is that of line 2 too");
}

TEST(CsvImport, FixedObjects) {
  formats::ImportOptions options;
  options.fixed = {"Sun,0,1/3", "\"a, b\",-0.5,1e-2"};
  const Scene scene = formats::import_csv("id,t,x,y\na,1,0,0\na,2,1,1\n", "t", options).scene;
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[1].id, "Sun");
  EXPECT_EQ(scene.objects[2].id, "a, b");
  const Motion& sun = scene.objects[1].motion;
  EXPECT_EQ(sun.degree(), 0);
  ASSERT_EQ(sun.pieces.size(), 1u);
  EXPECT_FALSE(sun.pieces[0].from || sun.pieces[0].to);  // there at all times
  EXPECT_EQ(sun.pieces[0].trajectory.position(0, Rational(7)), Rational(0));
  EXPECT_EQ(sun.pieces[0].trajectory.position(1, Rational(7)), ratio(1, 3));
  EXPECT_EQ(scene.objects[2].motion.pieces[0].trajectory.position(0, Rational(0)), ratio(-1, 2));
  EXPECT_EQ(scene.objects[2].motion.pieces[0].trajectory.position(1, Rational(0)), ratio(1, 100));
}

TEST(CsvImport, IdsAreThoseThatAScenesReaderTakes) {
  for (const char* id : {"\xff", "a\x80", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                         "\xe0\x80\xaf", "\xf0\x80\x80\xaf", "\xf8\x88\x80\x80\x80"}) {
    EXPECT_INPUT_ERROR(import("id,x,vx\na,0,0\n" + std::string(id) + ",0,1\n"),
                       "t.csv: line 3: the id");
    EXPECT_FALSE(formats::is_utf8(id));
  }
  const std::string longest(formats::kMaxIdLength, 'a');
  EXPECT_INPUT_ERROR(import("id,x,vx\na" + longest + ",0,1\n"),
                     "t.csv: line 2: an id of 1001 characters");
  for (const std::string& id :
       std::initializer_list<std::string>{"\xc3\xa9", "\xe2\x82\xac", "\xf0\x9d\x84\x9e",
                                          "\xf4\x8f\xbf\xbf", "tab\t\x01", longest}) {
    const std::string text = formats::write_scene(import("id,x,vx\n" + id + ",0,1\n").scene);
    EXPECT_EQ(formats::parse_scene(text, "again").objects[0].id, id);
  }
}

TEST(CsvImport, FixedObjectsAreRefusedWithARemedy) {
  const auto fixed = [](const std::string& row) {
    formats::ImportOptions options;
    options.fixed = {"first,0,0", row};
    formats::import_csv("id,x,y,vx,vy\na,0,0,1,1\n", "t.csv", options);
  };
  EXPECT_NO_THROW(fixed("Sun,0,0"));
  EXPECT_INPUT_ERROR(fixed("Sun,0"), "--fixed: \"Sun,0\" has 2 fields, not 3; write ID,X,Y");
  EXPECT_INPUT_ERROR(fixed("Sun,0,0,0"), "--fixed: \"Sun,0,0,0\" has 4 fields, not 3");
  EXPECT_INPUT_ERROR(fixed(""), "--fixed: \"\" has 1 field, not 3");
  EXPECT_INPUT_ERROR(fixed(",0,0"), "--fixed: an empty id; write a name");
  EXPECT_INPUT_ERROR(fixed("a,0,0"),
                     "--fixed: there is an object \"a\" already; give one of them another name");
  EXPECT_INPUT_ERROR(fixed("first,1,0"), "there is an object \"first\" already");
  EXPECT_INPUT_ERROR(fixed("Sun,0,zero"), "\"zero\" in \"Sun,0,zero\" is not a number; write an");
  EXPECT_INPUT_ERROR(fixed("Sun,1/0,0"), "\"1/0\" in");
  EXPECT_INPUT_ERROR(fixed("Sun,inf,0"), "\"inf\" in");
  EXPECT_INPUT_ERROR(fixed("\"Sun,0,0"), "--fixed: line 1: a quote is not closed; close it");
  EXPECT_INPUT_ERROR(fixed("Sun,0,0\nMoon,1,1"), "a second line: \"Moon\"; write one row");
}

TEST(CsvImport, Hurricanes) {
  const std::string file = shared_data("hurricanes.csv");
  KINEX_REQUIRE_DATA(file);
  const formats::ImportReport report = formats::import_csv(formats::read_text_file(file), file, {});
  EXPECT_EQ(report.rows, 49105u);
  EXPECT_EQ(report.scene.objects.size() + report.single_fixes.size(), 1814u);
  EXPECT_EQ(report.scene.dimension, 2);
  const std::string text = formats::write_scene(report.scene);
  EXPECT_EQ(formats::write_scene(formats::parse_scene(text, "again")), text);
}

TEST(CsvImport, Stars) {
  const std::string file = shared_data("nearest_stars.csv");
  KINEX_REQUIRE_DATA(file);
  const Scene scene = formats::import_csv(formats::read_text_file(file), file, {}).scene;
  EXPECT_EQ(scene.objects.size(), 294u);
  EXPECT_EQ(scene.dimension, 3);
  EXPECT_EQ(scene.objects[0].id, "Proxima Cen");
  EXPECT_EQ(scene.objects[0].motion.pieces[0].trajectory.coordinates[0][0],
            Rational(Integer(-474539), Integer(1000000)));
}

// ---- other separators, columns by name, dates

TEST(CsvTable, SeparatorsOfTheFirstLine) {
  const auto columns = [](std::string_view text) { return formats::parse_csv(text, "t").columns; };
  using Columns = std::vector<std::string>;
  EXPECT_EQ(columns("id;x\na;1\n"), (Columns{"id", "x"}));
  EXPECT_EQ(columns("id\tx\na\t1\n"), (Columns{"id", "x"}));
  EXPECT_EQ(columns("\"a,b\";x\n1;2\n"), (Columns{"a,b", "x"}));
  EXPECT_EQ(columns("id;x,y\n1,2\n"), (Columns{"id;x", "y"}));  // a comma before a semicolon
  EXPECT_EQ(columns("id;x;name, first\n1;2;3\n"),
            (Columns{"id", "x", "name, first"}));  // the more frequent
  EXPECT_EQ(columns("id\tx\tname, first; last\n"), (Columns{"id", "x", "name, first; last"}));
  EXPECT_EQ(columns("id,\t\tt,\t\tx\n1,2,3\n"), (Columns{"id", "t", "x"}));  // tabs as blanks
  EXPECT_EQ(formats::parse_csv("id;x,y\n1;2\n", "t", ';').columns, (Columns{"id", "x,y"}));
  EXPECT_EQ(formats::parse_csv("id;x\n\"a;b\";1\n", "t").rows[0].fields[0], "a;b");
}

TEST(CsvImport, NamesWithOtherSeparators) {
  EXPECT_INPUT_ERROR(
      import("id;t, in s;x, in m\na;0;1\n"),
      "t.csv: line 2: 1 field in a table of 3 columns: \"a;0;1\"; separate its fields by "
      "commas, as those of line 1, or give --separator semicolon");
  EXPECT_INPUT_ERROR(import("id;t, in s;x, in m\na;0,5;1,5\n"), "there is no column \"id\"; ");
  EXPECT_INPUT_ERROR(import("id;t, in s;x, in m\na;0,5;1,5\n"),
                     ", or give --separator semicolon if \"id;t\" is more than one name");
  EXPECT_INPUT_ERROR(
      import("id;t;x\na;0,5;1\n"),
      "line 2: \"0,5\" in column \"t\" is not a number; write decimals with a point, "
      "not with a comma, or dates as");
}

TEST(CsvImport, AFirstLineOfValuesIsNoHeader) {
  const std::string problem =
      "values, not names of columns; write a line above it that names the "
      "columns, as id,t,x,y";
  EXPECT_INPUT_ERROR(import("a,0,1,1\na,1,2,2\n"), "t.csv: line 1: \"a,0,1,1\": " + problem);
  EXPECT_INPUT_ERROR(import("a;0;0;0\na;1;2;2\n"), "t.csv: line 1: \"a;0;0;0\": " + problem);
  EXPECT_INPUT_ERROR(formats::parse_polygons("a,0,1\na,1,2\n", "p.csv"),
                     "line 1: \"a,0,1\": " + problem);
  formats::ImportOptions options;
  options.columns = {{"id", "name"}};
  EXPECT_INPUT_ERROR(formats::import_csv("a,0,1,1\n", "t.csv", options), problem);
  // Years can be names.
  options.columns = {{"id", "place"}};
  EXPECT_INPUT_ERROR(formats::import_csv("place,2015,2016\na,0,1\n", "t.csv", options),
                     "there is no column \"x\"");
  options.columns = {{"id", "0"}, {"t", "1"}, {"x", "2"}};
  EXPECT_EQ(formats::import_csv("0,1,2\na,0,0\na,1,1\n", "t.csv", options).scene.objects.size(),
            1u);
}

TEST(CsvImport, TracesOutsideOfTheTimeOfTheScene) {
  const auto between = [](const char* start, const char* end, std::vector<std::string> fixed = {}) {
    formats::ImportOptions options;
    options.start_time = {"--start", start};
    options.end_time = {"--end", end};
    options.fixed = std::move(fixed);
    return formats::import_csv("id,t,x\na,0,0\na,1,1\nb,1/2,3\nb,4,5\n", "t.csv", options).notes;
  };
  const std::string problem =
      "t.csv: no trace is in the time of the scene, 5 to 9: the traces are from 0 to 4; give "
      "--start "
      "and --end within these";
  EXPECT_INPUT_ERROR(between("5", "9"), problem);
  EXPECT_INPUT_ERROR(between("5", "9", {"Sun,0"}), problem);
  EXPECT_INPUT_ERROR(between("-3", "-1"),
                     "in the time of the scene, -3 to -1: the traces are from 0 to 4");
  EXPECT_INPUT_ERROR(
      between("9", "5"),
      "the scene would end at 5, not after its start at 9: the traces are from 0 to 4; "
      "give --start and --end, the earlier one first");
  EXPECT_EQ(between("3/2", "5"),
            std::vector<std::string>{
                "1 trace is outside of the time of the scene, 3/2 (1.5) to 5: \"a\""});
  // A fix at the start or the end is in the time of the scene.
  EXPECT_TRUE(between("0", "9").empty());
  EXPECT_TRUE(between("1", "4").empty());
  EXPECT_TRUE(between("-1", "1/2").empty());
}

TEST(CsvImport, TracesOfASingleFixAreNamed) {
  const formats::ImportReport report = import("id,t,x\na,0,0\nb,0,0\nb,1,1\n\n\"c, d\",5,5\n");
  EXPECT_EQ(report.single_fixes, (std::vector<std::string>{"\"a\" (line 2)", "\"c, d\" (line 6)"}));
  EXPECT_INPUT_ERROR(import("id,t,x\na,0,0\nb,0,0\n"),
                     "no object has two fixes: \"a\" (line 2), \"b\" (line 3); ");
}

formats::ImportReport import_with(std::string_view text,
                                  const std::vector<formats::NamedColumn>& columns,
                                  bool ignore = false) {
  formats::ImportOptions options;
  options.columns = columns;
  options.ignore_columns = ignore;
  return formats::import_csv(text, "t.csv", options);
}

TEST(CsvImport, ColumnsByName) {
  const std::string table = "trackId,when,x,east,speed\na,0,99,1,7\na,2,98,5,7\n";
  const formats::ImportReport report =
      import_with(table, {{"id", "trackId"}, {"t", "when"}, {"x", "east"}}, true);
  EXPECT_EQ(report.ignored_columns, 2u);
  const Trajectory& a = report.scene.objects[0].motion.pieces[0].trajectory;
  EXPECT_EQ(a.coordinates, (std::vector<std::vector<Rational>>{{1, 2}}));
  EXPECT_INPUT_ERROR(import_with(table, {{"id", "trackId"}, {"t", "when"}}),
                     "the column \"east\" means nothing here; ");
  EXPECT_INPUT_ERROR(import_with(table, {{"id", "trackId"}, {"t", "when"}}), "--ignore-columns");
  EXPECT_INPUT_ERROR(import_with(table, {}), "there is no column \"id\"; ");
  EXPECT_INPUT_ERROR(import_with(table, {}), "--column id=NAME");
  EXPECT_INPUT_ERROR(
      import_with(table, {{"id", "trakId"}}),
      "line 1: there is no column \"trakId\", that of --column id; did you mean trackId?");
  EXPECT_INPUT_ERROR(
      import_with(table, {{"id", "trackId"}, {"t", "trackId"}}),
      "--column: t=trackId after id=trackId; give every meaning one column of its own");
  EXPECT_INPUT_ERROR(import_with(table, {{"id", "trackId"}, {"id", "when"}}),
                     "--column: id=when after id=trackId");
}

TEST(CsvImport, DatesAreSecondsFromTheFirst) {
  const std::string table =
      "id,t,x\nb,2024-05-01T12:00:10.5Z,0\nb,2024-05-01T14:01:00+02:00,99\na,2024-05-01T12:00:00Z,"
      "0\n"
      "a,2024-05-01T12:01:00Z,6\n";
  const formats::ImportReport report = import(table);
  EXPECT_EQ(report.time_zero, "2024-05-01T12:00:00Z");
  EXPECT_EQ(report.scene.start, Rational(0));
  EXPECT_EQ(*report.scene.end, Rational(60));
  EXPECT_EQ(*report.scene.objects[0].motion.pieces[0].from, *Rational::parse("10.5"));
  EXPECT_EQ(report.scene.objects[1].motion.pieces[0].trajectory.coordinates[0],
            (std::vector<Rational>{0, *Rational::parse("1/10")}));
  formats::ImportOptions options;
  options.time_zero = formats::OptionTime{"--time-zero", "2024-05-01"};
  options.start_time = formats::OptionTime{"--start", "2024-05-01T12:00:20Z"};
  options.end_time = formats::OptionTime{"--end", "43260"};
  const Scene scene = formats::import_csv(table, "t.csv", options).scene;
  EXPECT_EQ(scene.start, Rational(43220));
  EXPECT_EQ(*scene.end, Rational(43260));
  options.time_zero = formats::OptionTime{"--time-zero", "yesterday"};
  EXPECT_INPUT_ERROR(formats::import_csv(table, "t.csv", options),
                     "--time-zero: \"yesterday\" is not a date");
  EXPECT_INPUT_ERROR(formats::import_csv("id,t,x\na,0,0\na,1,1\n", "t.csv", options),
                     "--time-zero: the file's times are numbers; leave it out");
  options.time_zero.reset();
  EXPECT_INPUT_ERROR(formats::import_csv("id,t,x\na,0,0\na,1,1\n", "t.csv", options),
                     "--start: \"2024-05-01T12:00:20Z\" is a date, the file's times are numbers");
}

}  // namespace csv_import_test
}  // namespace kinex

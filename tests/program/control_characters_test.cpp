// SPDX-License-Identifier: GPL-3.0-or-later
// Names and labels of a scene hold what they like; a terminal obeys none of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/formats/plain_text.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace control_characters_test {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

TEST(PlainText, ControlCharactersAreWrittenOut) {
  EXPECT_EQ(formats::plain("a\nb\tc\r\x1b[31m\x7f"), "a\\nb\\tc\\r\\u001b[31m\\u007f");
  EXPECT_EQ(formats::plain("\xc2\x9b" "1m"), "\\u009b1m");  // C1
  EXPECT_EQ(formats::plain("\xc3\xa9 \xc2\xa0 \xe2\x82\xac"), "\xc3\xa9 \xc2\xa0 \xe2\x82\xac");
  EXPECT_EQ(formats::plain("a\nb\x1b", '\n'), "a\nb\\u001b");
  EXPECT_EQ(formats::plain(std::string("\0", 1)), "\\u0000");
}

// b meets a at 1; c appears in contact with a.
const char* const kBodies = R"({"kinex": 1, "name": "n\u001b[31m\n", "dimension": 2, "time": {"start": 0, "end": 9},
 "objects": [
  {"id": "a\u001b\n", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[0], [0]]},
  {"id": "b\u009b", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[3, -1], [0]]},
  {"id": "c\u001b\n", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]],
   "motion": [{"from": 6, "coordinates": [[0], [8, -1]]}]}],
 "maintain": [{"structure": "separation_mixed", "as": "l\u001b\n"}]})";
const char* const kPoints = R"({"kinex": 1, "name": "n\u001b[31m\n", "dimension": 1, "time": {"start": 0, "end": 2},
 "objects": [{"id": "a\u001b\n", "motion": [[0, 1]]}, {"id": "b\u007f", "motion": [[1]]}, {"id": "c", "motion": [[5]]}],
 "maintain": [{"structure": "sorted_list", "as": "l\u001b\n"}]})";

// Neither on standard output nor on standard error.
void expect_plain(const Words& command, const std::vector<std::string>& says) {
  SCOPED_TRACE(command[0]);
  const Finished finished = run_kinex(command);
  const std::string all = finished.out + finished.err;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(all[i] == '\n' || !formats::is_control(all, i)) << i << " of: " << formats::plain(all);
  }
  for (const std::string& text : says) EXPECT_THAT(all, HasSubstr(text));
  EXPECT_THAT(all, Not(HasSubstr("internal error")));
}

TEST(ControlCharacters, DoNotReachTheTerminal) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json"), log = scratch.file("scene.jsonl"), page = scratch.file("p.html");
  write_file(scene, kPoints);
  expect_plain({"run", scene, "--events", log, "--at", "0", "-v"},
               {"scene     n\\u001b[31m\\n\n", "as \"l\\u001b\\n\"", "at 0  l\\u001b\\n "});
  expect_plain({"run", scene, "--explain"}, {"builds    l\\u001b\\n"});
  expect_plain({"check", scene, "-v"}, {"scene     n\\u001b[31m\\n\n"});
  expect_plain({"check", log, "-v"}, {"log       n\\u001b[31m\\n, exact"});
  expect_plain({"check", log, "--scene", scene}, {"log       n\\u001b[31m\\n, exact"});
  expect_plain({"log", log, "-v"}, {"  l\\u001b\\n  ", "\"a\\u001b\\u000a\" \"b\\u007f\""});
  expect_plain({"log", log, "--csv", "--columns", "ids"}, {"a\\u001b\\u000a"});
  expect_plain({"diff", log, log, "-v"}, {"equal"});
  expect_plain({"view", scene, "-o", page, "-v"}, {"scene     n\\u001b[31m\\n, 3 objects"});
}

TEST(ControlCharacters, NorInTables) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json");
  write_file(scene, kPoints);
  expect_plain({"trade", scene, "--arithmetic", "gsl", "-o", scratch.file("trade"), "-v"},
               {"l\\u001b\\n, n\\u001b[31m\\n, n = 3"});
}

TEST(ControlCharacters, NorInMessages) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json");
  write_file(scene, kBodies);
  expect_plain({"run", scene}, {"\"c\\x1b\\x0a\" appears at 6 in contact with \"a\\x1b\\x0a\"; "});
  expect_plain({"view", scene, "-o", scratch.file("p.html")},
               {"\"c\\x1b\\x0a\" appears at 6 in contact with \"a\\x1b\\x0a\"; "});
  expect_plain({"check", scratch.file("no\x1b\nfile")}, {"no\\u001b\\nfile"});
}

// Of an id with a byte that ends texts of C, all is shown, and what comes after it.
TEST(ControlCharacters, DoNotCutMessagesOff) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json"), log = scratch.file("scene.jsonl");
  const auto refused = [&](const Words& command, const std::string& text,
                           const std::string& message) {
    write_file(scene, text);
    const Finished finished = run_kinex(command);
    EXPECT_EQ(finished.exit_code, 2) << message;
    EXPECT_THAT(finished.err, HasSubstr(message));
  };
  const auto points = [](const std::string& maintain, const std::string& rest = "") {
    return R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 2}, "objects": [)"
           R"({"id": "a\u0000a", "colour": "red", "motion": [[0, 1], [0]]}, {"id": "b", "colour": "blue", "motion": [[1], [0]]}, )"
           R"({"id": "c\u0000c", "motion": [[5], [1)" +
           rest + R"(]]}], "maintain": [{"structure": )" + maintain + "}]}";
  };
  refused(
      {"run", scene}, R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 9}, "objects": [
  {"id": "a\u0000a", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[0], [0]]},
  {"id": "c\u0000c", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]],
   "motion": [{"from": 6, "coordinates": [[0], [8, -1]]}]}], "maintain": ["separation_mixed"]})",
      ": /objects/1/motion/0: \"c\\x00c\" appears at 6 in contact with \"a\\x00a\"; let it come");
  refused({"run", scene},
          points(R"("voronoi_cell_2", "query": "c\u0000c", "of": ["a\u0000a", "b"])"),
          "is about \"c\\x00c\", which is not among its sites; take it into");
  refused({"run", scene}, points(R"("nearest_site", "query": "c\u0000c", "of": ["c\u0000c", "b"])"),
          "has its query \"c\\x00c\" among its sites; leave it out");
  refused(
      {"run", scene},
      points(
          R"("sorted_list", "key": {"squared_distance_to": "c\u0000c"}, "of": ["a\u0000a", "b"])"),
      "measures the distance to \"c\\x00c\", which is not among its objects; take it into");
  refused({"thin", scene}, points(R"("delaunay_2")", ", 0, 1"),
          "object \"c\\x00c\" has a motion of degree 2; give a scene");
  write_file(scene, points(R"("sorted_list", "key": "x")"));
  ASSERT_EQ(run_kinex({"run", scene, "--events", log}).exit_code, 0);
  refused({"log", log, "--filter", "object=none"}, "",
          "there is no object \"none\" in " + log + "; it has a\\u0000a, b, c\\u0000c\n");
}

}  // namespace control_characters_test
}  // namespace kinex

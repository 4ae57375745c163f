// SPDX-License-Identifier: GPL-3.0-or-later
// kinex import of rigid bodies, from the tables to the contact.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/program/spawn.h"

namespace kinex {
namespace import_bodies_test {

using testing::HasSubstr;

class ImportBodies : public testing::Test {
 protected:
  // A rod that turns about its middle below a wall, from heading 0 to 180.
  void SetUp() override {
    write_file(polygons_,
               "id,x,y\nrod,2,0\nrod,0,0.1\nrod,-2,0\nrod,0,-0.1\n"
               "*,-9,0\n*,9,0\n*,9,1\n*,-9,1\n");
    write_file(table_, "id,t,x,y,angle\nrod,0,0,0,0\nrod,1,0,0,180\n");
  }
  Finished import(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"import", table_, "--polygons", polygons_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_kinex(arguments);
  }
  void expect_refused(const std::vector<std::string>& more, const std::string& message) const {
    const Finished refused = import(more);
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(refused.err, HasSubstr(message));
  }
  // The log of a run of an imported scene.
  std::string events_of(const Finished& made) const {
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(run_kinex({"check", "-"}, made.out).exit_code, 0);
    const std::string log = scratch_.file("log.jsonl");
    const Finished run = run_kinex({"run", "-", "--maintain", "separation_mixed,closest_features",
                                    "--audit", "events", "--events", log, "--force"},
                                   made.out);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read_file(log);
  }
  ScratchFolder scratch_;
  const std::string polygons_ = scratch_.file("polygons.csv");
  const std::string table_ = scratch_.file("table.csv");
};

// The rotor is (1 - t) + it, so the tip is at height 4t(1 - t) / ((1 - t)^2 + t^2), and at that of
// the wall, 1, where 6t^2 - 6t + 1 = 0.
TEST_F(ImportBodies, ARodMeetsTheWallWhenItMust) {
  const Finished made =
      import({"--heading", "angle", "--fixed", "wall,0,1", "--name", "rod and wall"});
  EXPECT_THAT(made.err, HasSubstr("2 rows, 2 objects"));
  EXPECT_THAT(made.out, HasSubstr(R"("rotor": [[1, -1], [0, 1]])"));
  EXPECT_THAT(made.out, HasSubstr(R"("maintain": ["separation_mixed"])"));
  const std::string events = events_of(made);
  const std::string contact =
      R"("kind": "contact", "ids": ["rod", "wall", "rod.v0", "wall.e0"], "certificate")";
  const std::size_t first = events.find(contact);
  ASSERT_NE(first, std::string::npos) << events;
  EXPECT_NE(events.find(contact, first + 1), std::string::npos);  // both structures
  EXPECT_THAT(events.substr(first), HasSubstr(R"("time": {"polynomial": ["1", "-6", "6"])"));
  EXPECT_THAT(events.substr(first), HasSubstr(R"("decimal": "0.211324865405)"));
}

// From south over west to north: the tip meets a wall in the north. Headings with the same
// numbers turn from west over south to east, and it does not.
TEST_F(ImportBodies, BearingsTurnClockwiseFromNorth) {
  write_file(table_, "id,t,x,y,angle\nrod,0,0,0,180\nrod,1,0,0,270\nrod,2,0,0,360\n");
  write_file(polygons_, "id,x,y\nrod,2,0\nrod,0,0.1\nrod,0,-0.1\n*,-9,0\n*,9,0\n*,9,1\n*,-9,1\n");
  const std::vector<std::string> wall{"--fixed", "wall,0,1", "--bearing", "angle"};
  // After 1 the rotor is (cs, 1 - s + cs) with c = cos 45, s = t - 1. The tip is at height 1 when
  // it points to 150 degrees: q/p = tan 75, and 1/s = 1 + (tan 75 - 1) c.
  const std::string events = events_of(import(wall));
  const std::size_t contact =
      events.find(R"("kind": "contact", "ids": ["rod", "wall", "rod.v0", "wall.e0"])");
  ASSERT_NE(contact, std::string::npos) << events;
  EXPECT_THAT(events.substr(contact), HasSubstr(R"("decimal": "1.3410813774)"));
  const std::string south = events_of(import({"--fixed", "wall,0,1", "--heading", "angle"}));
  EXPECT_THAT(south, testing::Not(HasSubstr(R"("kind": "contact", )")));
}

TEST_F(ImportBodies, MayStartOverlapping) {
  const Finished made =
      import({"--heading", "angle", "--fixed", "wall,0,0.05", "--overlapping-starts", "contact"});
  EXPECT_THAT(made.out, HasSubstr(R"("overlapping_starts": "contact")"));
  EXPECT_THAT(events_of(made), HasSubstr(R"("kind": "overlap", "ids": ["rod", "wall"])"));
}

TEST_F(ImportBodies, RefusesInAnOrderlyWay) {
  expect_refused({"--heading", "angle", "--fixed", "wall,0,0.05"},
                 "table.csv: the bodies \"rod\" and \"wall\" overlap at the scene's start");
  expect_refused({"--heading", "angle", "--fixed", "wall,0,0.05"},
                 "or give --overlapping-starts contact");
  expect_refused({"--heading", "angle", "--overlapping-starts", "merge"},
                 "--overlapping-starts: \"merge\" is no choice; write refused or contact");
  expect_refused({}, "table.csv: line 1: the column \"angle\" means nothing here");
  expect_refused({"--heading", "course"}, "there is no column \"course\", the one of --heading");
  expect_refused({"--heading", "angle", "--bearing", "angle"}, "--heading");
  expect_refused({"--heading", "angle", "-o", polygons_}, "is the input itself");
  expect_refused({"--heading", "angle", "--fixed", "wall,0,1", "--maintain", "delaunay_2"},
                 "is for points, the scene has bodies");
  const Finished points = run_kinex({"import", table_, "--heading", "angle"});
  EXPECT_EQ(points.exit_code, 2);
  EXPECT_THAT(points.err, HasSubstr("--heading: points have no heading; give --polygons too"));
  write_file(polygons_, "id,x,y\nrod,0,0\nrod,0,1\nrod,1,0\n");
  expect_refused({"--heading", "angle"}, "polygons.csv: line 2: \"rod\": a polygon whose vertices");
  const Finished absent = run_kinex({"import", table_, "--polygons", scratch_.file("absent.csv")});
  EXPECT_EQ(absent.exit_code, 2);
  EXPECT_THAT(absent.err, HasSubstr("absent.csv"));
}

}  // namespace import_bodies_test
}  // namespace kinex

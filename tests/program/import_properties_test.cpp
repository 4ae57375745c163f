// SPDX-License-Identifier: GPL-3.0-or-later
// kinex import of discs, boxes, points with weights or colours, edges of graphs and lines: the events are those of the
// same scene by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/program/spawn.h"

namespace kinex {
namespace import_properties_test {

using testing::HasSubstr;
using Words = std::vector<std::string>;

// The records of a run after the log's header, which has the scene's hash.
std::string events_of(const std::string& scene) {
  const Finished run = run_kinex({"run", "-", "--audit", "events", "--events", "-"}, scene);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run.out.substr(run.out.find('\n') + 1);
}

// `event`: a part of the events.
void expect_same_events(const std::string& table, const Words& options, const std::string& hand,
                        const std::string& event) {
  Words arguments{"import", "-", "--name", "hand"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Finished made = run_kinex(arguments, table);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string events = events_of(hand);
  EXPECT_THAT(events, HasSubstr(event));
  EXPECT_EQ(events_of(made.out), events);
}

// The discs meet where the distance of their centres is the sum of the radii: 9 - 2t = 1 + t/2 + 1/2, t = 3.
TEST(ImportProperties, Discs) {
  expect_same_events(
      "id,t,x,y,r\na,0,0,0,1\na,4,8,0,3\na,5,8,0,1\nb,0,9,0,1/2\nb,5,9,0,.5\n",
      {"--column", "radius=r"},
      R"({"kinex": 1, "name": "hand", "dimension": 2, "time": {"start": 0, "end": 5}, "maintain": ["disc_pairs_all"], "objects": [
      {"id": "a", "motion": [{"from": 0, "to": 4, "coordinates": [[0, 2], [0]], "radius": [1, "1/2"]},
                             {"from": 4, "to": 5, "coordinates": [[8], [0]], "radius": [11, -2]}]},
      {"id": "b", "motion": [{"from": 0, "to": 5, "coordinates": [[9], [0]], "radius": ["1/2"]}]}]})",
      R"("decimal": "3.00000000000")");
}

TEST(ImportProperties, Boxes) {
  expect_same_events(
      "id\tx\ty\tvx\tvy\thx\thy\tvhx\na\t0\t0\t1\t0\t1\t1\t1\nb\t9\t1\t0\t0\t2\t1/2\t0\n",
      {"--end", "20", "--maintain", "box_pairs,sorted_list"},
      R"({"kinex": 1, "name": "hand", "dimension": 2, "time": {"start": 0, "end": 20}, "maintain": ["box_pairs", "sorted_list"],
      "objects": [{"id": "a", "half_extents": [[1, 1], [1]], "motion": [[0, 1], [0]]},
                  {"id": "b", "half_extents": [[2], ["1/2"]], "motion": [[9], [1]]}]})",
      R"("decimal": "3.00000000000")");
}

// e is hidden until its weight is large enough.
TEST(ImportProperties, Weights) {
  expect_same_events(
      "id;t;x;y;weight\na;2024-05-01T08:00:00Z;0;0;0\na;2024-05-01T08:00:10Z;0;0;0\n"
      "b;2024-05-01T08:00:00Z;4;0;0\nb;2024-05-01T08:00:10Z;4;0;0\nc;2024-05-01T08:00:00Z;0;4;0\nc;"
      "2024-05-01T08:00:10Z;0;4;0\n"
      "e;2024-05-01T08:00:00Z;1;1;-9\ne;2024-05-01T08:00:10Z;1;1;1\n",
      {"--maintain", "regular_2"},
      R"({"kinex": 1, "name": "hand", "dimension": 2, "time": {"start": 0, "end": 10}, "maintain": ["regular_2"], "objects": [
      {"id": "a", "motion": [{"from": 0, "to": 10, "coordinates": [[0], [0]]}]},
      {"id": "b", "motion": [{"from": 0, "to": 10, "coordinates": [[4], [0]]}]},
      {"id": "c", "motion": [{"from": 0, "to": 10, "coordinates": [[0], [4]]}]},
      {"id": "e", "weight": [-9, 1], "motion": [{"from": 0, "to": 10, "coordinates": [[1], [1]]}]}]})",
      R"("ids": ["e")");
}

TEST(ImportProperties, Colours) {
  const std::string entry =
      R"({"structure": "closest_pair_all", "of": "red"},bichromatic_pair_all)";
  const std::string table = "id,x,vx,colour\na,0,1,red\nb,5,0,blue\nc,9,-1,red\nd,7,0,red\n";
  expect_same_events(table, {"--end", "9", "--maintain", entry},
                     R"({"kinex": 1, "name": "hand", "dimension": 1, "time": {"start": 0, "end": 9},
      "maintain": [{"structure": "closest_pair_all", "of": "red"},
                   {"structure": "bichromatic_pair_all", "colours": ["red", "blue"]}], "objects": [
      {"id": "a", "colour": "red", "motion": [[0, 1]]}, {"id": "b", "colour": "blue", "motion": [[5]]},
      {"id": "c", "colour": "red", "motion": [[9, -1]]}, {"id": "d", "colour": "red", "motion": [[7]]}]})",
                     R"("external": true)");
  const std::string note =
      "no structure is about the colours: --maintain with \"of\" or \"colours\" names them";
  EXPECT_THAT(run_kinex({"import", "-"}, table).err,
              HasSubstr("the objects are points of 2 colours\nkinex: " + note));
  EXPECT_THAT(run_kinex({"import", "-", "--maintain", entry}, table).err,
              testing::Not(HasSubstr(note)));
  const Finished refused = run_kinex(
      {"import", "-", "--maintain", R"({"structure": "closest_pair_all", "of": "green"})"}, table);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("no object has the colour \"green\""));
}

TEST(ImportProperties, EdgesOfAGraph) {
  expect_same_events(
      "edge,t,tail,head,cost\na,0,u,v,1\na,9,u,v,1\nb,0,v,w,2\nb,9,v,w,11\nc,0,w,u,8\nc,9,w,u,-1\n",
      {"--column", "id=edge", "--column", "from=tail", "--column", "to=head", "--column",
       "weight=cost"},
      R"({"kinex": 1, "name": "hand", "dimension": 1, "time": {"start": 0, "end": 9}, "maintain": ["graph_mst_list"], "objects": [
      {"id": "a", "ends": ["u", "v"], "motion": [{"from": 0, "to": 9, "coordinates": [[1]]}]},
      {"id": "b", "ends": ["v", "w"], "motion": [{"from": 0, "to": 9, "coordinates": [[2, 1]]}]},
      {"id": "c", "ends": ["w", "u"], "motion": [{"from": 0, "to": 9, "coordinates": [[8, -1]]}]}]})",
      R"("decimal": "3.00000000000")");
}

TEST(ImportProperties, Lines) {
  expect_same_events(
      "id,x,y,vx,vy,line\nl,0,1,1,0,true\nm,-1,2,0,0,true\np,2,6,0,0,\n", {"--end", "9"},
      R"({"kinex": 1, "name": "hand", "dimension": 2, "time": {"start": 0, "end": 9}, "maintain": ["incidences_all"], "objects": [
      {"id": "l", "line": true, "motion": [[0, 1], [1]]}, {"id": "m", "line": true, "motion": [[-1], [2]]},
      {"id": "p", "motion": [[2], [6]]}]})",
      R"("decimal": "2.50000000000")");
}

// What is maintained if nothing is said is about the objects.
TEST(ImportProperties, TheStructureFitsTheObjects) {
  const auto maintain = [](const std::string& table) {
    const std::string scene = run_kinex({"import", "-"}, table).out;
    const std::size_t at = scene.find("\"maintain\": ");
    return at == std::string::npos ? scene : scene.substr(at + 12, scene.find(']', at) - at - 11);
  };
  EXPECT_EQ(maintain("id,x,y,vx,vy\na,0,0,0,0\n"), "[\"delaunay_2\"]");
  EXPECT_EQ(maintain("id,x,y,vx,vy,radius\na,0,0,0,0,1\n"), "[\"disc_pairs_all\"]");
  EXPECT_EQ(maintain("id,x,y,vx,vy,hx,hy\na,0,0,0,0,1,1\n"), "[\"box_pairs\"]");
  EXPECT_EQ(maintain("id,x,y,z,vx,vy,vz,weight\na,0,0,0,0,0,0,1\n"), "[\"regular_3\"]");
  EXPECT_EQ(maintain("id,x,vx,weight\na,0,0,1\n"), "[\"sorted_list\"]");  // none is about these
  EXPECT_EQ(maintain("id,from,to,weight,vweight\na,u,v,0,0\n"), "[\"graph_mst_list\"]");
  EXPECT_EQ(maintain("id,x,y,vx,vy,line\na,0,0,0,0,true\n"), "[\"incidences_all\"]");
}

TEST(ImportProperties, MeaningsOnTheCommandLine) {
  const std::string table = "id,t,x,line\na,0,0,M1\na,1,1,M1\n";
  EXPECT_EQ(run_kinex({"import", "-", "--column", "line=", "--ignore-columns"}, table).exit_code,
            0);
  for (const auto& [option, message] :
       {std::pair("id=", "--column: \"id=\" names no column; write MEANING=COLUMN"),
        {"radius", "--column: \"radius\" names no column"},
        {"raduis=line", "--column: \"raduis\" is not a meaning; did you mean radius?"},
        {"speed=line",
         "--column: \"speed\" is not a meaning; write one of id, t, x, y, z, vx, vy, vz, radius, "
         "weight, hx"},
        {"radius=r", "there is no column \"r\", that of --column radius"}}) {
    const Finished refused = run_kinex({"import", "-", "--column", option}, table);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr(message));
  }
}

}  // namespace import_properties_test
}  // namespace kinex

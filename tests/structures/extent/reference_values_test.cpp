// SPDX-License-Identifier: GPL-3.0-or-later
// The attributes of two small scenes with the instants at which they change, over every hull, in
// `exact` and in `sturm`, audited after every event.
#include <string>
#include <vector>

#include "tests/structures/extent/calipers_support.h"
#include "tests/structures/extent/circle_support.h"

namespace kinex::test {
namespace reference_values_test {

using Values = std::vector<std::string>;

// One history of a structure, from the first value on.
struct Expected {
  std::vector<std::string> structures;
  Ids begins_with;
  Values values;
};

void expect_values(const Scene& scene, const std::vector<Expected>& all) {
  for (const Expected& expected : all) {
    for (const std::string& structure : expected.structures) {
      const bool over_hulls = !find_structure_info(structure)->reads.empty();
      for (const std::string& hull : over_hulls ? kHulls : std::vector<std::string>{""}) {
        for (const char* arithmetic : {"exact", "sturm"}) {
          SCOPED_TRACE(structure + " over " + hull + " in " + arithmetic);
          const CaliperRun run(scene, structure, hull, arithmetic);
          EXPECT_EQ(run.begins_with, expected.begins_with);
          EXPECT_EQ(run.values(), expected.values);
        }
      }
    }
  }
}

// T1: a vertex passes over the opposite side. Right angles at 2, 4 - sqrt 3, 4 + sqrt 3 and 6; two sides
// are equally long at 6 - sqrt 15 and 2 + sqrt 15. The scene is its own mirror image under t -> 8 - t,
// and so are the instants. Those of the perimeter agree with a search by doubles on a fine grid.
TEST(ReferenceValues, Triangle) {
  expect_values(
      scene_of({path({{0}, {0}}), path({{4}, {0}}), path({{-2, 1}, {1}})}, 0, Rational(8)),
      {{{"bounding_box", "bounding_box_2_hull"},
        {2, 1, 0, 2},
        {"2.00000000000: 0 1 0 2", "6.00000000000: 0 2 0 2"}},
       {{"diameter_2", "diameter_all_pairs"}, {1, 2}, {"2.12701665379: 0 1", "5.87298334620: 0 2"}},
       {{"width_2"}, {1, 2, 0}, {"2.12701665379: 0 1 2", "5.87298334620: 2 0 1"}},
       {{"min_area_rectangle_2"},
        {1, 2, 2, 0, 1},
        {"2.00000000000: 0 1 1 2 0", "6.00000000000: 2 0 0 1 2"}},
       {{"min_perimeter_rectangle_2"},
        {1, 2, 2, 0, 1},
        {"1.60604421602: 0 1 1 2 2", "2.00000000000: 2 0 0 1 2", "2.26794919243: 1 2 0 0 1",
         "2.75236038274: 0 1 1 2 0", "5.24763961725: 2 0 0 1 1", "5.73205080756: 1 2 2 0 1",
         "6.00000000000: 0 1 2 2 0", "6.39395578397: 2 0 0 1 2"}},
       {{"calipers_2"}, {0, 1, 0, 2, 1, 2}, {}},
       {{"min_circle_2", "min_circle_2_brute_force"},
        {1, 2},
        {"2.00000000000: 0 1 2", "2.26794919243: 0 1", "5.73205080756: 0 1 2",
         "6.00000000000: 0 2"}}});
}

// T2: a point passes through two opposite vertices of a square.
Scene through_vertices() {
  return scene_of({path({{1}, {0}}), path({{0}, {1}}), path({{-1}, {0}}), path({{0}, {-1}}),
                   path({{-3, 1}, {0}})},
                  0, Rational(6));
}

// The area changes at 2 - sqrt 2 and 4 + sqrt 2, too.
TEST(ReferenceValues, ThroughVertices) {
  expect_values(
      through_vertices(),
      {{{"bounding_box", "bounding_box_2_hull"},
        {4, 0, 3, 1},
        {"2.00000000000: 2 0 3 1", "4.00000000000: 2 4 3 1"}},
       {{"diameter_2", "diameter_all_pairs"}, {0, 4}, {"2.00000000000: 0 2", "4.00000000000: 2 4"}},
       {{"width_2"}, {1, 4, 3}, {"2.00000000000: 0 1 2", "4.00000000000: 3 4 1"}},
       {{"min_area_rectangle_2"},
        {1, 4, 4, 3, 0},
        {"0.585786437626: 0 1 4 4 0", "2.00000000000: 0 1 1 2 0", "4.00000000000: 1 2 2 4 4",
         "5.41421356237: 3 4 4 1 2"}},
       {{"min_perimeter_rectangle_2"},
        {0, 1, 4, 4, 0},
        {"2.00000000000: 0 1 1 2 0", "4.00000000000: 1 2 2 4 4"}},
       {{"min_circle_2", "min_circle_2_brute_force"},
        {0, 4},
        {"2.00000000000: 0 1 2 3", "4.00000000000: 2 4"}}});
}

// One vertex of the hull leaves and another enters, at one instant each: not one event, so not as
// a CaliperRun.
TEST(ReferenceValues, HullEventsThroughVertices) {
  struct Sink final : EventSink {
    Sink(const Simulator& of, StructureId hull) : simulator(&of), id(hull) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      if (event.structure != id || !event.external) return;
      lines.push_back(std::string(simulator->event_kinds(id)[event.kind]) + " " +
                      std::to_string(event.ids[0]) + " at " +
                      arithmetic.describe_now().approximate);
    }
    const Simulator* simulator;
    StructureId id;
    Values lines;
  };
  for (const std::string& hull : kHulls) {
    for (const char* arithmetic : {"exact", "sturm"}) {
      SCOPED_TRACE(hull + " in " + arithmetic);
      const Scene scene = asking(through_vertices(), hull, "");
      Simulator simulator(scene, planned_arithmetic(arithmetic, scene),
                          Trial::options(AuditLevel::kEvents));
      Sink sink(simulator, asked_structure(scene));
      add_structures(simulator, scene);
      simulator.set_sink(&sink);
      simulator.start();
      EXPECT_EQ(simulator.run_until(std::nullopt), RunStatus::kDone);
      EXPECT_EQ(simulator.violations(), Values{});
      EXPECT_EQ(sink.lines, (Values{"leave 4 at 2.00000000000", "enter 2 at 2.00000000000",
                                    "leave 0 at 4.00000000000", "enter 4 at 4.00000000000"}));
    }
  }
}

// T3: all points in one place at one instant, and from there on.
TEST(ReferenceValues, ThroughOnePoint) {
  for (const int start : {-1, 0}) {
    expect_values(
        through_origin(8, Rational(start)),
        {{{"diameter_2", "diameter_all_pairs", "min_circle_2", "min_circle_2_brute_force"},
          {0, 2},
          {}},
         {{"width_2"}, {2, 4, 5}, {}},
         {{"min_area_rectangle_2", "min_perimeter_rectangle_2"}, {2, 4, 0, 5, 2}, {}}});
  }
}

// T4: a square at common velocity.
TEST(ReferenceValues, SquareAtCommonVelocity) {
  expect_values(scene_of({path({{0, 1}, {0, 2}}), path({{1, 1}, {0, 2}}), path({{1, 1}, {1, 2}}),
                          path({{0, 1}, {1, 2}})},
                         0, Rational(9)),
                {{{"diameter_2", "diameter_all_pairs"}, {0, 2}, {}},
                 {{"width_2"}, {0, 1, 2}, {}},
                 {{"min_circle_2", "min_circle_2_brute_force"}, {0, 1, 2, 3}, {}}});
}

}  // namespace reference_values_test
}  // namespace kinex::test

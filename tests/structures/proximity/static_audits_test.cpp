// SPDX-License-Identifier: GPL-3.0-or-later
// What audits compare with: trees by boost::graph, boxes by CGAL; and an audit sees an attribute that is not that
// of the positions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "structures/proximity/spanning_tree.h"
#include "structures/proximity/static_closest_pair_audit.h"
#include "structures/proximity/static_forest_audit.h"
#include "structures/proximity/static_meetings_audit.h"
#include "structures/proximity/static_order_audit.h"
#include "tests/structures/proximity/meetings_support.h"

namespace kinex::test {
namespace static_audits_test {

using Ids = std::vector<ObjectId>;

TEST(StaticAudits, TiesOfATreeGoToSmallerIds) {
  Snapshot grid(Rational(0), 2, 2, 9);
  for (ObjectId i = 0; i < 9; ++i) {
    grid.set(i, 0, Rational(static_cast<int>(i) % 3));
    grid.set(i, 1, Rational(static_cast<int>(i) / 3));
  }
  EXPECT_EQ(static_spanning_tree(grid), (Ids{0, 1, 0, 3, 1, 2, 1, 4, 2, 5, 3, 6, 4, 7, 5, 8}));
}

// Level points as after a turn, equal ones by id, and one that is not alive.
TEST(StaticAudits, TheFourOrdersOfALattice) {
  Snapshot grid(Rational(0), 2, 2, 11);
  for (ObjectId i = 0; i < 9; ++i) {
    grid.set(i, 0, Rational(static_cast<int>(i) % 3));
    grid.set(i, 1, Rational(static_cast<int>(i) / 3));
  }
  for (const int axis : {0, 1}) grid.set(10, axis, Rational(1));  // as 4
  EXPECT_EQ(static_order(grid, kAlongX), (Ids{6, 3, 0, 7, 4, 10, 1, 8, 5, 2}));
  EXPECT_EQ(static_order(grid, kAlongY), (Ids{0, 1, 2, 3, 4, 10, 5, 6, 7, 8}));
  EXPECT_EQ(static_order(grid, kAlongSum), (Ids{0, 3, 1, 6, 4, 10, 2, 7, 5, 8}));
  EXPECT_EQ(static_order(grid, kAlongDifference), (Ids{6, 7, 3, 8, 4, 10, 0, 5, 1, 2}));
}

// Parallel edges, a loop, two parts.
TEST(StaticAudits, AForestOfAnyGraph) {
  const std::vector<std::array<std::uint32_t, 2>> edges{{0, 1}, {1, 0}, {2, 2},
                                                        {3, 4}, {1, 2}, {0, 2}};
  EXPECT_EQ(static_forest(edges, 5), (std::vector<std::size_t>{0, 3, 4}));
  EXPECT_EQ(static_forest({}, 0), std::vector<std::size_t>{});
}

// Against the definition; many of the boxes only touch, some are points, some are not there.
TEST(StaticAudits, ClosedBoxes) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    SCOPED_TRACE(dimension);
    Random random(static_cast<std::uint64_t>(dimension));
    Snapshot boxes(Rational(0), dimension, 2 * dimension, 40);
    for (ObjectId i = 0; i < 40; ++i) {
      if (i % 13 == 5) continue;
      for (int axis = 0; axis < dimension; ++axis) {
        boxes.set(i, axis, Rational(random.between(0, 9)));
        boxes.set(i, dimension + axis, Rational(random.between(0, 2)));
      }
    }
    std::size_t touches = 0;
    const Ids expected = static_meetings(boxes, [&](ObjectId a, ObjectId b) {
      bool meet = true, touch = false;
      for (int axis = 0; axis < dimension; ++axis) {
        const Rational gap = boxes.position(b, axis) - boxes.position(a, axis);
        const Rational apart = gap.sign() < 0 ? -gap : gap;
        const Rational reach =
            boxes.position(a, dimension + axis) + boxes.position(b, dimension + axis);
        meet = meet && apart <= reach;
        touch = touch || apart == reach;
      }
      touches += meet && touch;
      return meet;
    });
    EXPECT_GT(touches, 3u);
    EXPECT_EQ(static_box_pairs(boxes, false), expected);
  }
}

// Three points at one place, two at another; one alone, at the distance 1 from both and from another one.
TEST(StaticAudits, AllClosestPairs) {
  using Pairs = std::vector<std::array<ObjectId, 2>>;
  Snapshot points(Rational(0), 2, 2, 8);
  const int places[8][2] = {{1, 0}, {0, 0}, {1, 1}, {0, 0}, {5, 5}, {1, 0}, {0, 0}, {9, 9}};
  for (const ObjectId i : {0u, 2u, 3u}) {
    for (const int axis : {0, 1}) points.set(i, axis, Rational(places[i][axis]));
  }
  EXPECT_EQ(static_closest_pairs(points), (Pairs{{0, 2}, {0, 3}}));
  AuditReport right, wrong;
  check_closest_pairs(
      points, {0, 2}, [](const auto&) { return true; }, right);
  check_closest_pairs(
      points, {0, 2}, [](const auto& pair) { return pair[1] != 3; }, wrong);
  EXPECT_EQ(right.violations, std::vector<std::string>{});
  EXPECT_EQ(wrong.violations, std::vector<std::string>{"closest pair 0, 3 is no candidate"});
  for (const ObjectId i : {1u, 4u, 5u, 6u}) {
    for (const int axis : {0, 1}) points.set(i, axis, Rational(places[i][axis]));
  }
  EXPECT_EQ(static_closest_pairs(points), (Pairs{{0, 5}, {1, 3}, {3, 6}}));
  EXPECT_EQ(static_closest_pair(points), (Ids{0, 5}));
}

// The audit of a structure at its own positions, and at those of the scene's start, where its attribute was
// another one.
TEST(StaticAudits, AnAuditSeesAWrongAttribute) {
  Scene lined = reference_scene(8, 2, 2), graph = reference_scene(8, 1, 3);
  with_lines(lined, LineUse::kWithPoints);
  graph = suited(graph, *find_structure_info("graph_mst_list"));
  const std::pair<const char*, Scene> runs[]{
      {"emst_list", reference_scene(8, 2, 1)},
      {"emst_cycles", reference_scene(7, 3, 2)},
      {"mst_maximum_norm_list", reference_scene(8, 2, 1)},
      {"mst_polygon_cycles", reference_scene(6, 2, 1)},
      {"graph_mst_clusters", graph},
      {"box_pairs", extended_reference(8, 2, 1, Extents::kHalfExtents)},
      {"points_in_arrangement", lined}};
  for (auto [name, scene] : runs) {
    SCOPED_TRACE(name);
    scene.end = *scene.end - Rational(Integer(1), Integer(97));
    const TwinRun run(scene, {ask(name)});
    ASSERT_NE(run.attribute(), run.begins_with);
    const Structure& structure = run.simulator.structure(run.ids[0]);
    AuditReport right, wrong;
    structure.audit(run.simulator.snapshot(*scene.end), right);
    structure.audit(run.simulator.snapshot(scene.start), wrong);
    EXPECT_EQ(right.violations, std::vector<std::string>{});
    EXPECT_FALSE(wrong.violations.empty());
  }
}

// At the positions of the start all four orders are others.
TEST(StaticAudits, AnAuditSeesAWrongOrder) {
  Scene scene = reference_scene(8, 2, 1);
  for (std::size_t i = 0; i < 8; ++i) scene.objects[i].colour = i % 2 == 0 ? "red" : "blue";
  scene.end = *scene.end - Rational(Integer(1), Integer(97));
  for (const char* const name :
       {"octants_listed", "closest_pair_range_tree", "bichromatic_pair_maximum_norm"}) {
    SCOPED_TRACE(name);
    Request request = ask(name);
    if (std::string(name).starts_with("bichromatic")) request.colours = {"red", "blue"};
    const TwinRun run(scene, {request});
    AuditReport wrong;
    run.simulator.structure(run.ids[0]).audit(run.simulator.snapshot(scene.start), wrong);
    for (const char* const axis : {"x", "y", "x + y", "x - y"}) {
      const std::string said = std::string("the order differs from a sorted list, by ") + axis;
      EXPECT_EQ(std::count(wrong.violations.begin(), wrong.violations.end(), said), 1) << axis;
    }
  }
}

// The last line and the last point leave before the end; an audit of positions that have them still, or have
// one that stays no more, tells that they are not in the structure.
TEST(StaticAudits, AnAuditSeesAMissingObject) {
  for (const char* name : {"line_arrangement_2", "trapezoids_2", "points_in_arrangement",
                           "incidences_all", "incidences_cutting"}) {
    SCOPED_TRACE(name);
    Scene scene = reference_scene(10, 2, 2);
    const LineUse lines = find_structure_info(name)->lines;
    with_lines(scene, lines);
    for (const std::size_t i : {8u, 9u}) scene.objects[i].motion.pieces[0].to = Rational(4);
    scene.end = Rational(Integer(969), Integer(97));
    const TwinRun run(scene, {ask(name)});
    const Structure& structure = run.simulator.structure(run.ids[0]);
    const Snapshot there = run.simulator.snapshot(*scene.end);
    AuditReport right;
    structure.audit(there, right);
    EXPECT_EQ(right.violations, std::vector<std::string>{});
    for (const ObjectId missing :
         {8u, 9u}) {  // a level line just above object 1, and a point there
      Snapshot more = there;
      more.set(missing, 0, missing == 8 ? Rational(0) : there.position(1, 0));
      more.set(missing, 1, there.position(1, 1) + Rational(Integer(1), Integer(1000000)));
      AuditReport wrong;
      structure.audit(more, wrong);
      EXPECT_FALSE(wrong.violations.empty()) << missing;
    }
    for (const ObjectId gone : {0u, 1u}) {
      std::vector<bool> members(10, true);
      members[gone] = false;
      AuditReport wrong;
      structure.audit(there.of(members), wrong);
      EXPECT_FALSE(wrong.violations.empty()) << gone;
    }
  }
}

}  // namespace static_audits_test
}  // namespace kinex::test

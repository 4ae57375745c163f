// SPDX-License-Identifier: GPL-3.0-or-later
// Exact counts of the worst-case families and of the reference scenes: over every hull, in `exact` and
// in `sturm`, which agree event by event, audited after every event.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/extent/calipers_support.h"
#include "tests/structures/extent/circle_support.h"
#include "tests/structures/extent/directions_support.h"

namespace kinex::test {
namespace reference_counts_test {

// Events of a kind, all changes of the attribute if it is empty; or "hull", the changes of the hull.
struct Count {
  std::string structure, kind;
  int events;
};

bool reads_hull(const std::string& structure) {
  return structure != "bounding_box" && structure != "diameter_all_pairs" &&
         structure != "min_circle_2_brute_force";
}

std::uint64_t counted_in(const CaliperRun& run, const Count& count, const std::string& hull) {
  if (count.kind.empty()) return run.ledger().external;
  if (count.kind != "hull") return run.count(count.kind);
  for (StructureId id = 0; id < run.simulator.structures(); ++id) {
    if (run.simulator.structure(id).name() == hull) return run.simulator.ledger(id).external;
  }
  ADD_FAILURE() << "no hull in the plan";
  return 0;
}

// The counts of one structure are beside each other.
void expect_counts(const std::string& what, const Scene& scene, const std::vector<Count>& counts) {
  for (std::size_t first = 0, end; first < counts.size(); first = end) {
    const std::string& structure = counts[first].structure;
    for (end = first; end < counts.size() && counts[end].structure == structure;) ++end;
    for (const std::string& hull : reads_hull(structure) ? kHulls : std::vector<std::string>{""}) {
      SCOPED_TRACE(what + ": " + structure + " over " + hull);
      const CaliperRun exact(scene, structure, hull), sturm(scene, structure, hull, "sturm");
      EXPECT_EQ(exact.sink.lines, sturm.sink.lines);
      EXPECT_EQ(exact.values(), sturm.values());
      for (std::size_t i = first; i < end; ++i) {
        const auto events = static_cast<std::uint64_t>(counts[i].events);
        EXPECT_EQ(counted_in(exact, counts[i], hull), events) << counts[i].kind;
        EXPECT_EQ(counted_in(sturm, counts[i], hull), events) << counts[i].kind << " in sturm";
      }
    }
  }
}

// How often the edge changes that the strip or the rectangle is flush with: the first two ids.
int flush_changes(const CaliperRun& run) {
  int changes = 0;
  Ids before(run.begins_with.begin(), run.begins_with.begin() + 2);
  for (const auto& [instant, ids] : run.sink.history) {
    const Ids edge(ids.begin(), ids.begin() + 2);
    changes += edge != before ? 1 : 0;
    before = edge;
  }
  return changes;
}

// The sides of the box that change, in all.
int sides_changed(const CaliperRun& run) {
  int sides = 0;
  Ids before = run.begins_with;
  for (const auto& [instant, ids] : run.sink.history) {
    for (std::size_t side = 0; side < ids.size(); ++side)
      sides += ids[side] != before[side] ? 1 : 0;
    before = ids;
  }
  return sides;
}

std::string size(int n, int m) { return std::to_string(n) + ", " + std::to_string(m); }

TEST(ReferenceCounts, Vernier) {
  for (const auto& [n, m] : {std::pair{2, 2}, {3, 2}, {2, 3}, {3, 3}}) {
    expect_counts("vernier " + size(n, m), vernier(n, m),
                  {{"diameter_2", "", n * m - 1},
                   {"diameter_2", "hull", n},
                   {"diameter_2", "antiparallel", (n - 1) * (m - 1)},
                   {"diameter_all_pairs", "", n * m - 1},
                   {"calipers_2", "", (n - 1) * (m - 1) + n},
                   {"width_2", "", 2}});
  }
}

TEST(ReferenceCounts, VernierTurned) {
  for (const auto& [n, m] : {std::pair{2, 2}, {3, 2}, {2, 3}, {3, 3}}) {
    expect_counts("vernier turned " + size(n, m), vernier_turned(n, m),
                  {{"calipers_2_4", "", m * (n + 2)},
                   {"calipers_2_4", "perpendicular", (n - 1) * (m - 1) + 2 * m},
                   {"min_area_rectangle_2", "perpendicular", (n - 1) * (m - 1) + 2 * m}});
  }
}

TEST(ReferenceCounts, Comb) {
  for (const auto& [n, m] : {std::pair{1, 3}, {2, 2}, {2, 3}, {3, 2}}) {
    if (kSanitized && n * m > 4) break;
    const int changes = 2 * n * m - n - m;
    expect_counts("comb " + size(n, m), comb(n, m),
                  {{"width_2", "", changes},
                   {"min_area_rectangle_2", "", changes},
                   {"min_perimeter_rectangle_2", "", changes}});
  }
}

// Of the changes of the comb those after which the attribute is flush with another edge.
TEST(ReferenceCounts, FlushEdgesOfTheComb) {
  for (const auto& [n, m] : {std::pair{1, 3}, {2, 2}, {2, 3}, {3, 2}}) {
    if (kSanitized && n * m > 4) break;
    for (const std::string& hull : kHulls) {
      for (const char* structure :
           {"width_2", "min_area_rectangle_2", "min_perimeter_rectangle_2"}) {
        SCOPED_TRACE("comb " + size(n, m) + ": " + structure + " over " + hull);
        for (const char* arithmetic : {"exact", "sturm"}) {
          const CaliperRun run(comb(n, m), structure, hull, arithmetic);
          EXPECT_EQ(flush_changes(run), n * (m - 1) + 2 * (n - 1)) << arithmetic;
        }
      }
      const CaliperRun calipers(comb(n, m), "calipers_2", hull);
      EXPECT_GE(calipers.count("antiparallel"), static_cast<std::uint64_t>((n - 1) * m));
    }
  }
}

TEST(ReferenceCounts, SeeSaw) {
  for (const auto& [n, m] : {std::pair{2, 2}, {3, 2}, {2, 3}, {3, 3}}) {
    const int circle = 3 * n * m - n - m - 1;
    expect_counts("see-saw " + size(n, m), see_saw(n, m),
                  {{"min_circle_2", "", circle},
                   {"min_circle_2", "hull", 0},
                   {"min_circle_2_brute_force", "", circle},
                   {"farthest_delaunay_2", "", (n - 1) * (m - 1)},
                   {"farthest_delaunay_2", "flip", (n - 1) * (m - 1)},
                   {"diameter_2", "", n * m - 1}});
  }
}

// Two points: each change of an axis exchanges both of its sides.
TEST(ReferenceCounts, BoxOfTwoPoints) {
  expect_counts("two points", dual_circles(2),
                {{"bounding_box", "", 2}, {"bounding_box_2_hull", "", 2}});
  for (const std::string& hull : kAllHulls) {
    SCOPED_TRACE(hull);
    const CaliperRun run(dual_circles(2), "bounding_box_2_hull", hull);
    EXPECT_EQ(sides_changed(run), 4);
  }
}

// The axes are among the directions, so the box is exact.
TEST(ReferenceCounts, BoxAlongDirections) {
  for (const int n : {2, 3, 4, 5, 6}) {
    for (const std::vector<std::string>& same : kHullsOfDirections) {
      for (const std::string& hull : same) {
        SCOPED_TRACE("dual circles " + std::to_string(n) + " over " + hull);
        const CaliperRun exact(dual_circles(n), "bounding_box_2_hull", hull);
        const CaliperRun sturm(dual_circles(n), "bounding_box_2_hull", hull, "sturm");
        const CaliperRun box(dual_circles(n), "bounding_box", "");
        EXPECT_EQ(exact.ledger().external, n == 2 ? 2u : 2u * static_cast<unsigned>(n));
        EXPECT_EQ(exact.values(), box.values());
        EXPECT_EQ(exact.sink.lines, sturm.sink.lines);
      }
    }
  }
}

TEST(ReferenceCounts, BoxOfDualCircles) {
  for (const int n : {3, 4, 5, 6}) {
    expect_counts("dual circles " + std::to_string(n), dual_circles(n),
                  {{"bounding_box", "", 2 * n}, {"bounding_box_2_hull", "", 2 * n}});
  }
}

TEST(ReferenceCounts, Remainders) {
  struct Row {
    int n, hull, box, antipodal, contacts, diameter, width, area, perimeter, diagonals, circle,
        antiparallel, perpendicular, flips;
  };
  for (const Row& row : {Row{4, 3, 1, 5, 7, 1, 3, 5, 5, 4, 1, 2, 2, 1},
                         Row{6, 2, 2, 4, 6, 1, 4, 5, 6, 3, 1, 2, 2, 1},
                         Row{8, 3, 2, 6, 9, 1, 4, 4, 4, 6, 2, 3, 3, 3},
                         Row{10, 6, 2, 9, 12, 1, 4, 4, 4, 13, 2, 3, 3, 7}}) {
    if (kSanitized && row.n > 6) break;
    expect_counts("remainders " + std::to_string(row.n), remainders(row.n),
                  {{"bounding_box", "", row.box},
                   {"bounding_box_2_hull", "", row.box},
                   {"calipers_2", "", row.antipodal},
                   {"calipers_2", "hull", row.hull},
                   {"calipers_2", "antiparallel", row.antiparallel},
                   {"calipers_2_4", "", row.contacts},
                   {"calipers_2_4", "perpendicular", row.perpendicular},
                   {"diameter_2", "", row.diameter},
                   {"diameter_all_pairs", "", row.diameter},
                   {"width_2", "", row.width},
                   {"min_area_rectangle_2", "", row.area},
                   {"min_perimeter_rectangle_2", "", row.perimeter},
                   {"farthest_delaunay_2", "", row.diagonals},
                   {"farthest_delaunay_2", "flip", row.flips},
                   {"min_circle_2", "", row.circle},
                   {"min_circle_2_brute_force", "", row.circle}});
  }
}

// T1: a vertex passes over the opposite side.
TEST(ReferenceCounts, Triangle) {
  expect_counts("triangle",
                scene_of({path({{0}, {0}}), path({{4}, {0}}), path({{-2, 1}, {1}})}, 0, Rational(8)),
                {{"bounding_box", "", 2},
                 {"bounding_box_2_hull", "", 2},
                 {"calipers_2", "", 0},
                 {"calipers_2", "hull", 0},
                 {"calipers_2_4", "perpendicular", 4},
                 {"diameter_2", "", 2},
                 {"width_2", "", 2},
                 {"min_area_rectangle_2", "", 2},
                 {"min_perimeter_rectangle_2", "", 8},
                 {"farthest_delaunay_2", "", 0},
                 {"min_circle_2", "", 4},
                 {"min_circle_2_brute_force", "", 4}});
}

// T2: a point passes through two opposite vertices of a square.
TEST(ReferenceCounts, ThroughVertices) {
  expect_counts("through vertices",
                scene_of({path({{1}, {0}}), path({{0}, {1}}), path({{-1}, {0}}), path({{0}, {-1}}),
                          path({{-3, 1}, {0}})},
                         0, Rational(6)),
                {{"bounding_box", "", 2},
                 {"bounding_box_2_hull", "", 2},
                 {"diameter_2", "", 2},
                 {"width_2", "", 2},
                 {"min_area_rectangle_2", "", 4},
                 {"min_perimeter_rectangle_2", "", 2},
                 {"min_circle_2", "", 2},
                 {"min_circle_2_brute_force", "", 2}});
}

// T3: all points in one place at one instant. T4: a square of common velocity.
TEST(ReferenceCounts, NothingButTheBox) {
  const Scene square = scene_of({path({{0, 1}, {0, 2}}), path({{1, 1}, {0, 2}}),
                                 path({{1, 1}, {1, 2}}), path({{0, 1}, {1, 2}})},
                                0, Rational(9));
  std::vector<Count> counts{{"calipers_2", "", 0},           {"calipers_2_4", "", 0},
                            {"diameter_2", "", 0},           {"width_2", "", 0},
                            {"min_area_rectangle_2", "", 0}, {"min_perimeter_rectangle_2", "", 0},
                            {"farthest_delaunay_2", "", 0},  {"min_circle_2", "", 0},
                            {"bounding_box", "", 0},         {"bounding_box_2_hull", "", 0},
                            {"diameter_all_pairs", "", 0},   {"min_circle_2_brute_force", "", 0}};
  expect_counts("square", square, counts);
  counts[8].events = counts[9].events = 1;  // four sides, at one instant
  expect_counts("through one point", through_origin(8, Rational(-1)), counts);
}

// Over hulls of directions there is no count to compare: `sturm` agrees, and the audits find the errors
// within the guarantees.
TEST(ReferenceCounts, AlongDirections) {
  std::vector<std::pair<std::string, Scene>> scenes{
      {"vernier", vernier(3, 3)},           {"comb", comb(2, 3)},
      {"see-saw", see_saw(3, 3)},           {"dual circles", dual_circles(5)},
      {"remainders", remainders(8)},        {"one point", through_origin(8, Rational(-1))},
      {"vernier turned", vernier_turned(3, 3)}};
  std::vector<std::string> structures = kAllCaliperStructures;
  for (const char* other : {"farthest_delaunay_2", "min_circle_2", "bounding_box_2_hull"}) {
    structures.emplace_back(other);
  }
  for (const auto& [what, scene] : scenes) {
    for (const std::string& structure : structures) {
      for (const char* hull : {"directions_2:1", "directions_2", "directions_2_tournament:2"}) {
        SCOPED_TRACE(what + ": " + structure + " over " + hull);
        const CaliperRun exact(scene, structure, hull), sturm(scene, structure, hull, "sturm");
        EXPECT_EQ(exact.sink.lines, sturm.sink.lines);
        EXPECT_EQ(exact.values(), sturm.values());
      }
    }
    if (kSanitized) break;
  }
}

}  // namespace reference_counts_test
}  // namespace kinex::test

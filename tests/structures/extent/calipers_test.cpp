// SPDX-License-Identifier: GPL-3.0-or-later
// Diameter, width and rectangles of known scenes: exact counts, under every hull.
#include <array>
#include <string>
#include <vector>

#include "tests/structures/extent/calipers_support.h"

namespace kinex::test {
namespace calipers_test {

struct Size {
  int n, m;
};

// Attributes with the times at which they begin, but for the digits behind the sixth.
std::vector<std::string> brief(const CaliperRun& run) {
  std::vector<std::string> result;
  for (const std::string& value : run.values()) {
    const std::size_t colon = value.find(':');
    std::string time = value.substr(0, colon);
    if (time.find('e') == std::string::npos && time.size() > 6) time.resize(6);
    result.push_back(time + value.substr(colon));
  }
  return result;
}

TEST(Calipers, VernierChangesTheDiameterForEveryPair) {
  for (const auto [n, m] : {Size{2, 2}, {3, 2}, {2, 3}, {3, 3}, {4, 3}, {4, 4}, {5, 4}}) {
    SCOPED_TRACE(std::to_string(n) + ", " + std::to_string(m));
    for (const std::string& hull : kHulls) {
      SCOPED_TRACE(hull);
      const CaliperRun run(vernier(n, m), "diameter_2", hull);
      EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n * m - 1));
      EXPECT_EQ(run.count("antiparallel") + run.count("split") + run.count("merge"),
                static_cast<std::uint64_t>((n - 1) * (m - 1) + n));
    }
    const CaliperRun width(vernier(n, m), "width_2");
    EXPECT_EQ(width.ledger().external, 2u);
    const CaliperRun all(vernier(n, m), "diameter_all_pairs", "");
    EXPECT_EQ(all.ledger().external, static_cast<std::uint64_t>(n * m - 1));
  }
}

TEST(Calipers, CombChangesWidthAndRectangles) {
  for (const auto [n, m] : {Size{1, 3}, {2, 2}, {2, 3}, {3, 2}, {3, 3}, {3, 4}, {4, 3}, {4, 4}}) {
    for (const std::string& structure : kCaliperStructures) {
      if (structure == "diameter_2") continue;
      SCOPED_TRACE(structure + " " + std::to_string(n) + ", " + std::to_string(m));
      const CaliperRun run(comb(n, m), structure);
      EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(2 * n * m - n - m));
    }
  }
}

// Hull, diameter, width, area, perimeter; antiparallel and perpendicular events.
TEST(Calipers, ReferenceScenes) {
  struct Row {
    int n;
    std::uint64_t hull, diameter, width, area, perimeter, antiparallel, perpendicular;
  };
  for (const Row& row : {Row{4, 3, 1, 3, 5, 5, 2, 2}, Row{6, 2, 1, 4, 5, 6, 2, 2},
                         Row{8, 3, 1, 4, 4, 4, 3, 3}, Row{10, 6, 1, 4, 4, 4, 3, 3}}) {
    for (const std::string& hull : kHulls) {
      SCOPED_TRACE(std::to_string(row.n) + " points, " + hull);
      const Scene scene = remainders(row.n);
      const CaliperRun diameter(scene, "diameter_2", hull), width(scene, "width_2", hull),
          area(scene, "min_area_rectangle_2", hull),
          perimeter(scene, "min_perimeter_rectangle_2", hull);
      EXPECT_EQ(diameter.ledger().external, row.diameter);
      EXPECT_EQ(width.ledger().external, row.width);
      EXPECT_EQ(area.ledger().external, row.area);
      EXPECT_EQ(perimeter.ledger().external, row.perimeter);
      EXPECT_EQ(width.count("antiparallel"), row.antiparallel);
      EXPECT_EQ(area.count("antiparallel"), row.antiparallel);
      EXPECT_EQ(area.count("perpendicular"), row.perpendicular);
      EXPECT_EQ(width.count("split") + width.count("merge"), row.hull);
    }
  }
}

// A triangle whose third vertex passes over a side.
TEST(Calipers, Triangle) {
  const Scene scene =
      scene_of({path({{0}, {0}}), path({{4}, {0}}), path({{-2, 1}, {1}})}, 0, Rational(8));
  for (const std::string& hull : kHulls) {
    SCOPED_TRACE(hull);
    const CaliperRun diameter(scene, "diameter_2", hull);
    EXPECT_EQ(diameter.begins_with, (Ids{1, 2}));
    EXPECT_EQ(brief(diameter), (std::vector<std::string>{"2.1270: 0 1", "5.8729: 0 2"}));
    const CaliperRun width(scene, "width_2", hull);
    EXPECT_EQ(brief(width).size(), 2u);
    EXPECT_EQ(width.ledger().external, 2u);
    EXPECT_EQ(width.count("antiparallel"), 0u);
    const CaliperRun area(scene, "min_area_rectangle_2", hull);
    EXPECT_EQ(area.ledger().external, 2u);
    EXPECT_EQ(area.count("perpendicular"), 4u);
    const CaliperRun perimeter(scene, "min_perimeter_rectangle_2", hull);
    EXPECT_EQ(perimeter.ledger().external, 8u);
  }
}

// A point passes through two corners of a square at rest, which is symmetric to its path.
TEST(Calipers, ThroughTheCornersOfASquare) {
  const Scene scene = scene_of({path({{1}, {0}}), path({{0}, {1}}), path({{-1}, {0}}),
                                path({{0}, {-1}}), path({{-3, 1}, {0}})},
                               0, Rational(6));
  for (const std::string& hull : kHulls) {
    SCOPED_TRACE(hull);
    const CaliperRun diameter(scene, "diameter_2", hull);
    EXPECT_EQ(diameter.begins_with, (Ids{0, 4}));
    EXPECT_EQ(brief(diameter), (std::vector<std::string>{"2.0000: 0 2", "4.0000: 2 4"}));
    const CaliperRun width(scene, "width_2", hull);
    EXPECT_EQ(width.begins_with, (Ids{1, 4, 3}));
    EXPECT_EQ(brief(width), (std::vector<std::string>{"2.0000: 0 1 2", "4.0000: 3 4 1"}));
    const CaliperRun area(scene, "min_area_rectangle_2", hull);
    EXPECT_EQ(area.begins_with, (Ids{1, 4, 4, 3, 0}));
    EXPECT_EQ(brief(area),
              (std::vector<std::string>{"0.5857: 0 1 4 4 0", "2.0000: 0 1 1 2 0", "4.0000: 1 2 2 4 4",
                                        "5.4142: 3 4 4 1 2"}));
    const CaliperRun perimeter(scene, "min_perimeter_rectangle_2", hull);
    EXPECT_EQ(perimeter.ledger().external, 2u);
  }
}

// All points pass through one place at one instant, and nothing changes; the same from there on.
TEST(Calipers, ThroughOnePoint) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 8; ++i) {
    const int s = i * i;
    t.push_back(path({{0, (17 * s + 5 * i + 3) % 21 - 10}, {0, (19 * s + 7 * i + 1) % 23 - 11}}));
  }
  const std::array<Ids, 4> known{Ids{0, 2}, {2, 4, 5}, {2, 4, 0, 5, 2}, {2, 4, 0, 5, 2}};
  for (const int start : {-1, 0}) {
    for (const std::string& hull : kHulls) {
      for (std::size_t i = 0; i < 4; ++i) {
        SCOPED_TRACE(kCaliperStructures[i] + " over " + hull + " from " + std::to_string(start));
        const CaliperRun run(scene_of(t, start, Rational(1)), kCaliperStructures[i], hull);
        EXPECT_EQ(run.begins_with, known[i]);
        EXPECT_EQ(run.ids(), known[i]);
        EXPECT_EQ(run.ledger().external, 0u);
      }
    }
  }
}

TEST(Calipers, ASquareAtCommonVelocity) {
  const Scene scene = scene_of({path({{0, 1}, {0, 2}}), path({{1, 1}, {0, 2}}),
                                path({{1, 1}, {1, 2}}), path({{0, 1}, {1, 2}})},
                               0, Rational(9));
  const std::array<Ids, 4> known{Ids{0, 2}, {0, 1, 2}, {0, 1, 1, 2, 0}, {0, 1, 1, 2, 0}};
  for (const std::string& hull : kHulls) {
    for (std::size_t i = 0; i < 4; ++i) {
      SCOPED_TRACE(kCaliperStructures[i] + " over " + hull);
      const CaliperRun run(scene, kCaliperStructures[i], hull);
      EXPECT_EQ(run.begins_with, known[i]);
      EXPECT_EQ(run.ledger().external, 0u);
    }
  }
}

TEST(Calipers, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    for (const std::string& structure : kCaliperStructures) {
      SCOPED_TRACE(structure + ", " + std::to_string(n) + " points");
      const CaliperRun run(scene, structure);
      const std::size_t most = structure == "diameter_2" ? 2 : structure == "width_2" ? 3 : 5;
      EXPECT_EQ(run.ids().size(), n == 3 || (n == 2 && most == 2) ? most : 0u);
    }
  }
  // All are one point, or on one line.
  const CaliperRun one(scene_of(std::vector<Trajectory>(4, path({{1, 1}, {2}})), 0, Rational(2)),
                       "diameter_2");
  EXPECT_EQ(one.ids(), (Ids{0, 1}));
  const Scene line = scene_of(
      {path({{0}, {0}}), path({{1, 1}, {1, 1}}), path({{5, -1}, {5, -1}})}, 0, Rational(4));
  for (const std::string& structure : kCaliperStructures) {
    const CaliperRun run(line, structure);
    EXPECT_EQ(run.ids(), structure == "diameter_2" ? (Ids{0, 1}) : Ids{}) << structure;
  }
}

// Where all three points are on one line every two edges of the triangle become antiparallel, though they
// share a vertex: 2 roots for each of 3 pairs of edges, which is 6d C(3,3), and more than 6d C(3,4) = 0.
// (Over convex_hull_2_brute_force the calipers are made anew at these instants instead.)
TEST(Calipers, ATriangleHasAntiparallelEdges) {
  const Scene scene =
      scene_of({path({{2, -1}, {2, -2}}), path({{-2, -1}, {1, 2}}), path({{-1, 2}, {1, 2}})}, -3,
               Rational(3));
  for (const char* arithmetic : {"exact", "sturm"}) {
    const CaliperRun run(scene, "calipers_2", "convex_hull_2", arithmetic);
    EXPECT_EQ(run.count("antiparallel"), 6u) << arithmetic;
  }
}

}  // namespace calipers_test
}  // namespace kinex::test

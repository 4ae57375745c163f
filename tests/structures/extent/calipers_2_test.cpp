// SPDX-License-Identifier: GPL-3.0-or-later
// calipers_2 on known scenes: exact counts, under every hull.
//
// Broken on purpose, and seen to fail here: in Calipers, a contact that a swap leaves as it was
// (ReferenceScenes, Triangle, VernierTurned), a claim of a quarter turn that is not negated (Triangle,
// ThroughOnePoint), ties in the reverse order (ASquareAtCommonVelocity), contacts that are built one
// edge late (ATriangleThroughOneLine, FoldsAgree).
#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/extent/calipers_support.h"

namespace kinex::test {
namespace calipers_2_test {

struct Size {
  int n, m;
};

TEST(Calipers2, ReferenceScenes) {
  struct Row {
    int n;
    std::uint64_t hull, antipodal, contacts, antiparallel, perpendicular;
  };
  for (const Row& row : {Row{4, 3, 5, 7, 2, 2}, Row{6, 2, 4, 6, 2, 2}, Row{8, 3, 6, 9, 3, 3},
                         Row{10, 6, 9, 12, 3, 3}}) {
    for (const std::string& hull : kHulls) {
      SCOPED_TRACE(std::to_string(row.n) + " points, " + hull);
      const CaliperRun two(remainders(row.n), "calipers_2", hull),
          four(remainders(row.n), "calipers_2_4", hull);
      EXPECT_EQ(two.ledger().external, row.antipodal);
      EXPECT_EQ(four.ledger().external, row.contacts);
      for (const CaliperRun* run : {&two, &four}) {
        EXPECT_EQ(run->count("antiparallel"), row.antiparallel);
        EXPECT_EQ(run->count("split") + run->count("merge"), row.hull);
        EXPECT_LE(run->ledger().max_per_object, 4u);
      }
      EXPECT_EQ(two.count("perpendicular"), 0u);
      EXPECT_EQ(four.count("perpendicular"), row.perpendicular);
    }
  }
}

TEST(Calipers2, VernierChangesTheAntipodalPairs) {
  for (const auto [n, m] : {Size{2, 2}, {3, 3}, {4, 3}, {4, 4}, {5, 4}}) {
    SCOPED_TRACE(std::to_string(n) + ", " + std::to_string(m));
    const CaliperRun run(vernier(n, m), "calipers_2");
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>((n - 1) * (m - 1) + n));
  }
}

// Beside the (n - 1)(m - 1) pairs of edges of the two arcs, the edges between the arcs become
// perpendicular 2m times.
TEST(Calipers2, VernierTurned) {
  for (const auto [n, m] : {Size{2, 2}, {3, 3}, {4, 3}, {4, 4}}) {
    SCOPED_TRACE(std::to_string(n) + ", " + std::to_string(m));
    const CaliperRun run(vernier_turned(n, m), "calipers_2_4");
    const auto pairs = static_cast<std::uint64_t>((n - 1) * (m - 1));
    EXPECT_EQ(run.count("perpendicular"), pairs + static_cast<std::uint64_t>(2 * m));
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(m * (n + 2)));
  }
}

// A triangle whose third vertex passes over a side: no edges become antiparallel.
TEST(Calipers2, Triangle) {
  const Scene scene =
      scene_of({path({{0}, {0}}), path({{4}, {0}}), path({{-2, 1}, {1}})}, 0, Rational(8));
  for (const std::string& hull : kHulls) {
    const CaliperRun two(scene, "calipers_2", hull), four(scene, "calipers_2_4", hull);
    EXPECT_EQ(two.begins_with, (Ids{0, 1, 0, 2, 1, 2}));
    EXPECT_EQ(two.ledger().external, 0u);
    EXPECT_EQ(four.ledger().external, 4u);
    EXPECT_EQ(four.count("perpendicular"), 4u);
  }
}

// A square has two directions modulo half a turn: its parallel edges are in the order of their ids.
TEST(Calipers2, ASquareAtCommonVelocity) {
  const Scene scene = scene_of({path({{0, 1}, {0, 2}}), path({{1, 1}, {0, 2}}),
                                path({{1, 1}, {1, 2}}), path({{0, 1}, {1, 2}})},
                               0, Rational(9));
  for (const std::string& hull : kHulls) {
    const CaliperRun two(scene, "calipers_2", hull), four(scene, "calipers_2_4", hull);
    EXPECT_EQ(two.begins_with, (Ids{0, 2, 1, 2, 1, 3, 2, 3}));
    EXPECT_EQ(two.ledger().external, 0u);
    EXPECT_EQ(four.begins_with.size(), 16u);
    EXPECT_EQ(four.ledger().external, 0u);
  }
}

// All points pass through one place at one instant, and the same pairs are antipodal afterwards.
TEST(Calipers2, ThroughOnePoint) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 8; ++i) {
    const int s = i * i;
    t.push_back(path({{0, (17 * s + 5 * i + 3) % 21 - 10}, {0, (19 * s + 7 * i + 1) % 23 - 11}}));
  }
  for (const char* structure : {"calipers_2", "calipers_2_4"}) {
    for (const std::string& hull : kHulls) {
      SCOPED_TRACE(std::string(structure) + " over " + hull);
      const CaliperRun before(scene_of(t, -1, Rational(1)), structure, hull);
      const CaliperRun from(scene_of(t, 0, Rational(1)), structure, hull);
      EXPECT_EQ(before.ledger().external, 0u);
      EXPECT_EQ(from.ledger().external, 0u);
      EXPECT_EQ(before.ids(), from.ids());
      EXPECT_EQ(before.begins_with, from.begins_with);
    }
  }
}

TEST(Calipers2, NoPointToThree) {
  const Ids two[] = {{}, {}, {0, 1}, {0, 1, 0, 2, 1, 2}};
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    EXPECT_EQ(CaliperRun(scene, "calipers_2").begins_with, two[n]);
    const Ids four = CaliperRun(scene, "calipers_2_4").begins_with;
    EXPECT_EQ(four.size(), n < 2 ? 0u : n == 2 ? 4u : 12u);
    if (n == 2) {
      EXPECT_EQ(four, (Ids{0, 0, 1, 1}));
    }
  }
}

// What the calipers of 2 folds touch is part of what those of 4 folds touch.
TEST(Calipers2, FoldsAgree) {
  for (std::uint64_t seed = 1; seed <= test::fewer(40u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = seed % 2 == 0 ? caliper_lattice(seed) : random_flights(seed, 8, 2, 1, true);
    const CaliperRun two(scene, "calipers_2"), four(scene, "calipers_2_4");
    for (const auto& [pairs, fours] :
         {std::pair{two.begins_with, four.begins_with}, std::pair{two.ids(), four.ids()}}) {
      ASSERT_EQ(2 * pairs.size(), fours.size());
      for (std::size_t i = 0; i < pairs.size(); i += 2) {
        bool found = false;
        for (std::size_t k = 0; k < fours.size(); k += 4) {
          const auto from = fours.begin() + static_cast<std::ptrdiff_t>(k);
          found =
              found || std::includes(from, from + 4, pairs.begin() + static_cast<std::ptrdiff_t>(i),
                                     pairs.begin() + static_cast<std::ptrdiff_t>(i) + 2);
        }
        EXPECT_TRUE(found) << pairs[i] << " " << pairs[i + 1];
      }
    }
  }
}

// Two edges that share a vertex are antiparallel while all points are on one line: no bound of the
// form 6d C(n,4), which is 0 of three points, holds for the events of such an instant.
TEST(Calipers2, ATriangleThroughOneLine) {
  const Scene scene =
      scene_of({path({{0}, {0}}), path({{5}, {0}}), path({{2}, {-1, 1}})}, 0, Rational(2));
  std::uint64_t antiparallel = 0;
  for (const std::string& hull : kHulls) {
    SCOPED_TRACE(hull);
    const CaliperRun run(scene, "calipers_2", hull);
    EXPECT_EQ(run.ledger().external, 0u);  // the three pairs stay antipodal
    antiparallel += run.count("antiparallel");
  }
  EXPECT_GT(antiparallel, 0u);
}

TEST(Calipers2, FoldsAreTwoOrFour) {
  const StructureInfo& info = *find_structure_info("calipers_2");
  EXPECT_FALSE(refusal_of_parameter(info, {"folds", Rational(2)}));
  EXPECT_FALSE(refusal_of_parameter(info, {"folds", Rational(4)}));
  const auto refusal = refusal_of_parameter(info, {"folds", Rational(3)});
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->problem, "cannot have folds = 3");
  EXPECT_EQ(refusal->remedy, "write an integer of at least 2 and at most 4, in steps of 2");
}

}  // namespace calipers_2_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
// The closest pair among points in near cells of a grid: the box, the cells, scenes that come and
// go. That it agrees with all other structures for the closest pair: pairs_test.cpp.
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "structures/proximity/point_grid.h"
#include "structures/registry.h"
#include "tests/sanitized.h"
#include "tests/structures/proximity/meetings_support.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace closest_pair_bins_test {

std::vector<Request> twins() { return {ask("closest_pair_bins"), ask("closest_pair_all")}; }

std::uint64_t cells_changed(const TwinRun& run) {
  const auto found = run.ledger().by_kind.find("cell");
  return found == run.ledger().by_kind.end() ? 0 : found->second;
}

TEST(ClosestPairBins, BoxOfLinearFlightsIsTight) {
  Scene scene = scene_of({path({{1, 2}, {5, -1}}), path({{-3}, {0, 1}})}, 1, Rational(4));
  scene.objects[1].motion.pieces[0].to = Rational(2);
  const FlightBox box = FlightBox::of(scene);
  EXPECT_EQ(box.low[0], Rational(-3));
  EXPECT_EQ(box.high[0], Rational(9));
  EXPECT_EQ(box.low[1], Rational(1));
  EXPECT_EQ(box.high[1], Rational(4));
}

TEST(ClosestPairBins, BoxHoldsCurvedFlights) {
  for (std::uint64_t seed = 1; seed <= test::fewer(20u); ++seed) {
    const Scene scene = random_flights(seed, 5, 2, 3, seed % 2 == 0);
    const FlightBox box = FlightBox::of(scene);
    const Rational step = (*scene.end - scene.start) / Rational(50);
    for (const SceneObject& object : scene.objects) {
      for (int i = 0; i < 50; ++i) {
        const Rational t = scene.start + step * Rational(i);
        const MotionPiece* const piece = object.motion.piece_after(t);
        if (piece == nullptr) continue;
        for (const int axis : {0, 1}) {
          const Rational x = piece->trajectory.position(axis, t);
          EXPECT_LE(box.low[static_cast<std::size_t>(axis)], x);
          EXPECT_LE(x, box.high[static_cast<std::size_t>(axis)]);
        }
      }
    }
  }
}

// A point that runs along a row of 25 squares meets every line; far pairs are no candidates.
TEST(ClosestPairBins, FarPairsAreNoCandidates) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 25; ++i) t.push_back(path({{4 * i}, {0}}));
  t.push_back(path({{0, 1}, {0, 0}}));
  const TwinRun run(scene_of(t, 0, Rational(96)), twins());
  EXPECT_EQ(cells_changed(run), 24u);
  // Each of the 26 points has those of two cells on either side.
  EXPECT_LT(run.ledger().max_live, 150u);
  EXPECT_EQ(run.ledger(1).max_live, 324u);
}

TEST(ClosestPairBins, AllAtOnePlace) {
  const TwinRun run(
      scene_of({path({{7}, {7}}), path({{7}, {7}}), path({{7}, {7}})}, 0, Rational(1)), twins());
  EXPECT_EQ(run.attribute(), (std::vector<ObjectId>{0, 1}));
}

// From nothing to 12 points, and back to nothing: the grid is laid several times.
TEST(ClosestPairBins, GridsThatGrowAndShrink) {
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = reference_scene(12, 2, seed);
    for (int i = 0; i < 12; ++i) {
      MotionPiece& piece = scene.objects[static_cast<std::size_t>(i)].motion.pieces[0];
      piece.from = Rational(Integer(i), Integer(4));
      piece.to = Rational(10) - Rational(Integer((5 * i) % 12), Integer(3));
    }
    const TwinRun run(scene, twins());
    EXPECT_GT(cells_changed(run), 0u);
  }
}

// Lattices stand on the lines of the grid.
TEST(ClosestPairBins, PointsOnLines) {
  std::uint64_t cells = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(80u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = lattice_scene(seed, 10, 2);
    const TwinRun run(scene, twins());
    cells += cells_changed(run);
  }
  EXPECT_GT(cells, test::seen_in_fewer(500u));
}

TEST(ClosestPairBins, NeedsAnEnd) {
  Scene scene = reference_scene(5, 2, 1);
  const StructureInfo& info = *find_structure_info("closest_pair_bins");
  EXPECT_FALSE(refusal_of(info, scene));
  scene.end.reset();
  const auto refusal = refusal_of(info, scene);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->problem.find("no end"), std::string::npos);
  EXPECT_NE(refusal->remedy.find("closest_pair_all"), std::string::npos);
}

// A motion that is not in the scene could leave the box, or make a disc larger than a cell.
TEST(ClosestPairBins, GridsTakeNoPlansFromOutside) {
  for (const char* const structure : {"closest_pair_bins", "disc_pairs_grid", "closest_pair_all"}) {
    Scene scene = reference_scene(5, 2, 1);
    Trajectory other = path({{1000}, {0}});
    if (std::string_view(structure) == "disc_pairs_grid") {
      scene = extended_reference(5, 2, 1, Extents::kRadius);
      other.coordinates.push_back({1});
    }
    Trial run(scene, structure);
    run.erase(Rational(1), 0);
    if (std::string_view(structure) == "closest_pair_all") {
      run.insert(Rational(2), 0, other);
    } else {
      EXPECT_THROW(run.insert(Rational(2), 0, other), std::invalid_argument);
      EXPECT_THROW(run.simulator.schedule_update(Rational(2), 1, other), std::invalid_argument);
    }
    run.to_end().expect_clean();
  }
}

}  // namespace closest_pair_bins_test
}  // namespace kinex::test

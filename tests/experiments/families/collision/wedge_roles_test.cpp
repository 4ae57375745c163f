// SPDX-License-Identifier: GPL-3.0-or-later
// Wedges of either role: what they cost does not depend on which body is called the first one.
#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "experiments/families/collision/ball_cover.h"
#include "experiments/families/collision/polygons.h"
#include "structures/collision/separation_hysteresis.h"
#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace wedge_roles_test {

struct Counted {
  std::uint64_t events = 0;
  double displacement = 0;
};

Counted count(const Scene& scene, AuditLevel audit) {
  Trial trial(scene, "separation_hysteresis", "exact", audit);
  trial.without_twin().to_end();
  trial.expect_clean();
  const auto& structure = proof_of<SeparationHysteresis>(trial.simulator.structure(0));
  EXPECT_GE(structure.search().least_displacement(), 0.23);
  return {trial.ledger().processed, structure.search().least_displacement()};
}

// The events in both orders.
std::pair<std::uint64_t, std::uint64_t> both_ways(Scene scene,
                                                  AuditLevel audit = AuditLevel::kEvents) {
  const Counted plain = count(scene, audit);
  std::swap(scene.objects[0], scene.objects[1]);
  return {plain.events, count(scene, audit).events};
}

Rational number(const char* text) { return *Rational::parse(text); }

Scene scene_from_0_to(int end) { return scene_of_bodies({}, 0, Rational(end)); }

// A square turns once beside one at rest; its corners pass the edge at this distance of centres,
// from 0.6 to 6e-6 above it.
Scene corners(const char* distance) {
  Scene scene = scene_from_0_to(2);
  families::add_turning_body(scene, "turning", square_of(1), 0, 0, families::half_turns(2, 2));
  families::add_body(scene, "resting", square_of(1), {number(distance)}, {0});
  return scene;
}

TEST(WedgeRoles, ACornerPassesOverAnEdge) {
  for (const char* distance : {"3", "2.5", "2.42", "2.4143", "2.41422"}) {
    SCOPED_TRACE(distance);
    const auto [plain, exchanged] = both_ways(corners(distance));
    EXPECT_EQ(plain, exchanged);
    EXPECT_LE(plain, 40u);  // with the line on the turning body: 50 to 33247
    EXPECT_GE(plain, 4u);   // every corner goes by
  }
}

// The larger body turns about its middle: in the frame of the other one nothing moves but its
// farthest points, and they measure what a wedge withstands.
TEST(WedgeRoles, ALargeSquareTurnsBesideASmallOne) {
  Scene scene = scene_from_0_to(2);
  families::add_turning_body(scene, "large", square_of(8), 0, 0, families::half_turns(2, 2));
  families::add_body(scene, "small", square_of(1), {number("12.5")}, {0});
  const auto [plain, exchanged] = both_ways(scene);
  EXPECT_EQ(plain, exchanged);
  EXPECT_LE(plain, 60u);
}

TEST(WedgeRoles, ABarSweepsOverASquare) {
  Scene scene = scene_from_0_to(2);
  families::add_turning_body(scene, "bar", box(-10, -1, 10, 1), 0, 0, families::half_turns(2, 2));
  families::add_body(scene, "square", square_of(1), {number("11.2")}, {0});
  const auto [plain, exchanged] = both_ways(scene);
  EXPECT_EQ(plain, exchanged);
  EXPECT_LE(plain, 25u);
  // Measured: 0.92; by the reach of the body that has the line it would be 0.28.
  EXPECT_GE(count(scene, AuditLevel::kEnd).displacement, 0.5);
}

// Alike, and both turn: the line is always that of the first one where they lie alike.
TEST(WedgeRoles, EqualBodiesBothTurn) {
  Scene scene = scene_from_0_to(2);
  families::add_turning_body(scene, "a", square_of(1), 0, 0, families::half_turns(2, 2));
  families::add_turning_body(scene, "b", square_of(1), number("2.82843"), 0, families::half_turns(2, 2));
  const auto [plain, exchanged] = both_ways(scene);
  EXPECT_EQ(plain, exchanged);
  EXPECT_LE(plain, 60u);
  scene = scene_from_0_to(6);
  families::add_turning_body(scene, "a", square_of(1), 0, 0, families::half_turns(2, 6));
  families::add_turning_body(scene, "b", square_of(1), number("2.83"), 0, families::half_turns(6, 6));
  const auto [slow, fast] = both_ways(scene, AuditLevel::kEnd);
  EXPECT_NEAR(static_cast<double>(slow), static_cast<double>(fast),
              0.02 * static_cast<double>(slow));
}

TEST(WedgeRoles, NothingTurns) {
  for (const char* workload : {"polygon-line", "polygon-kinks", "polygon-approach"}) {
    SCOPED_TRACE(workload);
    lab::WorkloadParameters parameters;
    parameters.n = 16;
    if (std::string_view(workload) == "polygon-kinks") parameters.m = 20;
    parameters.separation = number("1/16");
    const auto [plain, exchanged] = both_ways(lab::generate_scene(*lab::find_workload(workload), parameters));
    EXPECT_EQ(plain, exchanged);
    EXPECT_GE(plain, 3u);
  }
}

// Bodies of different shapes that turn and move; in some runs they meet.
TEST(WedgeRoles, RandomBodies) {
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 3 : 12); ++seed) {
    SCOPED_TRACE(seed);
    lab::WorkloadParameters parameters;
    parameters.n = 9;
    parameters.m = 6;
    parameters.seed = seed;
    parameters.degree = 1 + static_cast<int>(seed % 2);
    const Scene scene = lab::generate_scene(*lab::find_workload("polygon-random"), parameters);
    const auto [plain, exchanged] = both_ways(scene);
    EXPECT_EQ(plain, exchanged);
  }
}

// The theorem, with turning: in the larger of the metrics of the two frames.
TEST(WedgeRoles, FewerThanBallsThatCoverTheMotion) {
  const Scene scene = corners("2.5");
  const auto [plain, exchanged] = both_ways(scene, AuditLevel::kEnd);
  EXPECT_LE(plain, families::ball_cover(scene));
  EXPECT_LE(exchanged, families::ball_cover(scene));
}

// A point-like square that comes straight down on a wide one from height 8 to height 1/8: balls of
// 0.103 of the height s hold s (1 - 0.103) .. s (1 + 0.103), so log(64) / log(1.103 / 0.897)
// balls, and a few more for what is kept to spare.
TEST(BallCover, OfAStraightFall) {
  Scene scene = scene_from_0_to(1);
  families::add_body(scene, "ground", box(-4, -1, 4, 0), {0}, {0});
  families::add_body(scene, "falling", {{0, 0}, {1, 1}, {-1, 1}}, {0}, {8, number("-7.875")});
  const double fewest = std::log(64.0) / std::log(1.103 / 0.897);
  const double balls = static_cast<double>(families::ball_cover(scene));
  EXPECT_GE(balls, std::floor(fewest));
  EXPECT_LE(balls, 1.35 * fewest);
  std::swap(scene.objects[0], scene.objects[1]);
  EXPECT_EQ(static_cast<double>(families::ball_cover(scene)), balls);
}

// A square with reach sqrt(2) turns by a whole turn, nothing else moves, in a frame whose origin is
// its middle: the length of the motion is (|t| + sqrt(2)) 2 pi in its own frame, and no ball is
// longer than 0.206 of the largest separation.
TEST(BallCover, OfATurn) {
  const double far = 8, length = (far + std::sqrt(2.0)) * 2 * std::acos(-1.0);
  Scene scene = scene_from_0_to(2);
  families::add_turning_body(scene, "turning", square_of(1), 0, 0, families::half_turns(2, 2));
  families::add_body(scene, "resting", square_of(1), {8}, {0});
  const double least = far - 1 - std::sqrt(2.0), most = far - 2;
  EXPECT_GE(static_cast<double>(families::ball_cover(scene)), length / (0.206 * most));
  EXPECT_LE(static_cast<double>(families::ball_cover(scene)), 1.35 * length / (0.206 * least) + 1);
  const std::uint64_t balls = families::ball_cover(scene);
  std::swap(scene.objects[0], scene.objects[1]);
  EXPECT_EQ(families::ball_cover(scene), balls);
  EXPECT_EQ(families::ball_cover(scene_of_bodies({body("a", square_of(1), {{0}, {0}, {1}, {0}}),
                                        body("b", square_of(1), {{3}, {0}, {1}, {0}})},
                                       0, Rational(1))),
            1u);
}

}  // namespace wedge_roles_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that are level in a direction identically: from the start, and from a new flight plan on.
#include <string>
#include <utility>
#include <vector>

#include "tests/structures/extent/directions_support.h"

namespace kinex::test {
namespace directions_ties_test {

using Ids = std::vector<ObjectId>;

constexpr const char* kBoth[] = {"directions_2", "directions_2_tournament"};

// The object goes on along `to` from t = 1 on, where it is by then.
void stop_at_one(Scene& scene, ObjectId object, Trajectory to) {
  auto& pieces = scene.objects[object].motion.pieces;
  pieces[0].to = Rational(1);
  pieces.push_back({Rational(1), std::nullopt, std::move(to)});
}

// A corner that is extreme in two directions, level with the corners beside it in both.
TEST(Directions, CornersAreVertices) {
  for (const char* structure : kBoth) {
    const Scene square = scene_of({path({{1, 2}, {1, 3}}), path({{-1, 2}, {1, 3}}),
                                   path({{1, 2}, {-1, 3}}), path({{-1, 2}, {-1, 3}})},
                                  0, 2);
    EXPECT_EQ(DirectionsRun(square, structure, 1).begins_with, (Ids{0, 1, 2}));
  }
}

// 0 reaches 1, and stays beside it: it is extreme, since its id is smaller.
TEST(Directions, ThePlanThatMakesATieGivesWayToTheSmallerId) {
  for (const char* structure : kBoth) {
    Scene scene = scene_of(
        {path({{0, 5}, {1}}), path({{5}, {-1}}), path({{-3}, {4}}), path({{-3}, {-4}})}, 0, 2);
    stop_at_one(scene, 0, path({{5}, {1}}));
    const DirectionsRun run(scene, structure, 1);
    EXPECT_EQ(run.begins_with, (Ids{1, 2, 3}));
    EXPECT_EQ(run.ids(), (Ids{0, 2, 3}));
    EXPECT_EQ(run.ledger().by_kind.at("tie"), 1u);
    // The other way round nothing changes.
    std::swap(scene.objects[0].motion, scene.objects[1].motion);
    const DirectionsRun other(scene, structure, 1);
    EXPECT_EQ(other.ids(), other.begins_with);
    EXPECT_EQ(other.ledger().external, 0u);
  }
}

// 1 and 2 come to stand above and below 0: the extreme objects stay, but 0 is no vertex any more.
TEST(Directions, ThePlanThatMakesAnEdge) {
  for (const char* structure : kBoth) {
    Scene scene = scene_of(
        {path({{2}, {0}}), path({{1, 1}, {3}}), path({{1, 1}, {-4}}), path({{-1}, {0}})}, 0, 2);
    for (const ObjectId object : {1u, 2u}) {
      stop_at_one(scene, object, path({{2}, {object == 1 ? 3 : -4}}));
    }
    const DirectionsRun run(scene, structure, 1);
    EXPECT_EQ(run.begins_with, (Ids{0, 1, 3, 2}));
    EXPECT_EQ(run.ids(), (Ids{1, 3, 2}));
    EXPECT_EQ(run.changes(), std::vector<std::string>{"leave 0 !"});
  }
}

// The extents along x and y become equal and stay so: that along x is the first.
TEST(ExtentDirections, ThePlanThatMakesExtentsEqual) {
  for (const bool is_first : {false, true}) {
    // 1 recedes from 0 until the two are as far apart as 2 and 3.
    const auto along = [is_first](std::vector<Rational> u) -> Trajectory {
      return is_first ? path({std::move(u), {0}}) : path({{0}, std::move(u)});
    };
    const auto across = [is_first](int u) -> Trajectory {
      return is_first ? path({{0}, {u}}) : path({{u}, {0}});
    };
    Scene scene = scene_of({along({-5}), along({0, 5}), across(5), across(-5)}, 0, 2);
    stop_at_one(scene, 1, along({5}));
    const DirectionsRun run(scene, "diameter_directions", 1);
    EXPECT_EQ(run.begins_with, (Ids{2, 3}));
    EXPECT_EQ(run.ids(), is_first ? (Ids{0, 1}) : (Ids{2, 3}));
    EXPECT_EQ(run.ledger().external, is_first ? 1u : 0u);
  }
}

}  // namespace directions_ties_test
}  // namespace kinex::test

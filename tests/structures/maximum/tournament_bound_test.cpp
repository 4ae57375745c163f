// SPDX-License-Identifier: GPL-3.0-or-later
// The bound on the events of a tournament through flight plans, insertions and erasures: scenes
// that reach it exactly, and the terms added by a change.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace tournament_bound_test {

BoundCheck events_bound(const Trial& run) {
  for (const BoundCheck& b : run.simulator.bounds(0)) {
    if (b.id == "maximum_tournament.events") return b;
  }
  ADD_FAILURE() << "there is no bound on events";
  return {};
}

void expect_reached(const Trial& run, std::int64_t events) {
  run.expect_clean();
  const BoundCheck bound = events_bound(run);
  EXPECT_EQ(bound.bound, Integer(events));
  EXPECT_EQ(bound.observed, Integer(events));
}

// All turn back at `turn` and retrace their motion.
Scene there_and_back(Scene scene, const Rational& turn) {
  scene.end = turn * Rational(2) - scene.start;
  for (SceneObject& object : scene.objects) {
    MotionPiece back = object.motion.pieces[0];
    object.motion.pieces[0].to = back.from = turn;
    for (auto& axis : back.trajectory.coordinates) {  // of degree 1
      axis.resize(2);
      axis[0] += turn * Rational(2) * axis[1];
      axis[1] = -axis[1];
    }
    back.trajectory.normalise();
    object.motion.pieces.push_back(std::move(back));
  }
  return scene;
}

TEST(TournamentBound, IsReachedThereAndBack) {
  for (int k = 1; k <= 4; ++k) {
    const int n = 1 << k;
    // All crossings are over at 2^n.
    const Scene scene = there_and_back(
        bit_reversed_lines(k), Rational(Integer::power_of_two(static_cast<unsigned long>(n))));
    Trial run(scene, "maximum_tournament", "exact",
              n <= 8 ? AuditLevel::kEvents : AuditLevel::kEnd);
    run.to_end();
    expect_reached(run, 2 * (n * k - n + 1));
  }
}

TEST(TournamentBound, IsReachedByOneThatTurnsAgainAndAgain) {
  // Object 1 goes up and down through object 0: one crossing for each of its pieces.
  Scene scene = scene_of({path({{0}}), path({{-1, 1}})}, 0, Rational(20));
  auto& pieces = scene.objects[1].motion.pieces;
  for (int i = 1; i < 10; ++i) {
    pieces.back().to = Rational(2 * i);
    const int slope = i % 2 == 0 ? 1 : -1;
    pieces.push_back({Rational(2 * i), std::nullopt,
                      continued(pieces.back().trajectory, path({{0, slope}}), Rational(2 * i))});
  }
  Trial run(scene, "maximum_tournament");
  run.to_end();
  expect_reached(run, 10);
}

TEST(TournamentBound, IsReachedByThoseThatComeAndGo) {
  // Each newcomer starts below and overtakes; a tree of one has no events.
  Scene scene = scene_of({path({{0}})}, 0, Rational(30));
  for (int i = 1; i <= 5; ++i) {
    SceneObject guest = moving(name_of(static_cast<std::size_t>(i)), path({{-4 * i - 1, 1}}));
    guest.motion.pieces[0].from = Rational(4 * i);
    guest.motion.pieces[0].to = Rational(4 * i + 2);
    scene.objects.push_back(std::move(guest));
  }
  Trial run(scene, "maximum_tournament");
  run.to_end();
  expect_reached(run, 5);
}

// A change of all motions at once counts every node once more, whatever the shape of the tree.
TEST(TournamentBound, AChangeOfAllDoublesIt) {
  for (const int degree : {1, 2, 3}) {
    for (int n = 1; n <= 40; n += degree == 1 ? 1 : 7) {
      Random random(static_cast<std::uint64_t>(n));
      std::vector<Trajectory> paths;
      for (int i = 0; i < n; ++i) paths.push_back(random.small_path(1, degree, 1000));
      Scene scene = scene_of(paths, 0, Rational(1));
      Trial plain(scene, "maximum_tournament", "exact", AuditLevel::kEnd);
      plain.without_twin().to_end().expect_clean();
      const Rational half(Integer(1), Integer(2));
      for (SceneObject& object : scene.objects) {
        MotionPiece next = object.motion.pieces[0];
        object.motion.pieces[0].to = next.from = half;
        object.motion.pieces.push_back(std::move(next));
      }
      Trial changed(scene, "maximum_tournament", "exact", AuditLevel::kEnd);
      changed.without_twin().to_end().expect_clean();
      EXPECT_EQ(events_bound(changed).bound, events_bound(plain).bound * Integer(2)) << n;
      EXPECT_EQ(events_bound(changed).observed, events_bound(plain).observed) << n;
    }
  }
}

// One object's change counts the nodes on its path: of 8 leaves 1 + 3 + 7.
TEST(TournamentBound, AChangeOfOneCountsItsPath) {
  std::vector<Trajectory> paths;
  for (int i = 0; i < 8; ++i) paths.push_back(path({{10 * i}}));
  Scene scene = scene_of(paths, 0, Rational(2));
  scene.objects[3].motion.pieces[0].to = Rational(1);
  scene.objects[3].motion.pieces.push_back({Rational(1), std::nullopt, path({{29, 1}})});
  Trial run(scene, "maximum_tournament");
  run.to_end().expect_clean();
  EXPECT_EQ(events_bound(run).bound, Integer(4 + 2 * 3 + 7 + 1 + 3 + 7));
}

// A new motion of the reference of distances changes all keys.
TEST(TournamentBound, ANewMotionOfTheReferenceCountsAllNodes) {
  std::vector<Trajectory> paths;
  for (int i = 0; i < 7; ++i) paths.push_back(path({{i}, {i * i}}));
  const Scene still = scene_of(paths, 0, Rational(2));
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = 0;
  Trial plain(still, "maximum_tournament", "exact", AuditLevel::kEvents, key);
  plain.to_end().expect_clean();
  Scene scene = still;
  scene.objects[0].motion.pieces[0].to = Rational(1);
  scene.objects[0].motion.pieces.push_back({Rational(1), std::nullopt, path({{-50, 50}, {0}})});
  scene.objects[0].motion.pieces[0].trajectory = path({{0}, {0}});
  Trial changed(scene, "maximum_tournament", "exact", AuditLevel::kEvents, key);
  changed.to_end().expect_clean();
  // Six leaves, keys of degree 2: lambda_2(m) - 1 = 2 (m - 1) at each of five nodes, twice.
  EXPECT_EQ(events_bound(changed).bound, Integer(2 * 2 * (5 + 3 + 1 + 1 + 1)));
}

}  // namespace tournament_bound_test
}  // namespace kinex::test

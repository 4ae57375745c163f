// SPDX-License-Identifier: GPL-3.0-or-later
// Many bodies, and what a scene may demand of the broad phase and of doubles.
#include <gtest/gtest.h>

#include "experiments/lab/workload.h"
#include "structures/collision/separation_hysteresis.h"
#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace collision_crowd_test {

using Axes = std::vector<std::vector<Rational>>;

// Of squares of side 2 at x = from + speed t, y = 5 i.
Scene squares(const std::vector<std::pair<Rational, Rational>>& bodies,
              std::optional<Rational> end) {
  std::vector<SceneObject> all;
  int y = 0;
  for (const auto& [from, speed] : bodies) {
    all.push_back(body("b" + std::to_string(y), square_of(1), {{from, speed}, {5 * y}, {1}, {0}}));
    ++y;
  }
  return scene_of_bodies(std::move(all), 0, std::move(end));
}

std::uint64_t events_of(const Scene& scene, const std::string& name) {
  Trial trial(scene, name, "exact", AuditLevel::kEnd);
  trial.without_twin().to_end();
  trial.expect_clean();
  return trial.sink.lines.size();
}

// In a grid with cells of the bodies' size it would cross some million of them.
TEST(CollisionCrowd, AFastBodyCostsLittle) {
  const Scene scene = squares({{-1000000, 2000000}, {0, 0}, {3, 1}}, Rational(1));
  for (const std::string& name : collision_structures(false)) {
    EXPECT_LT(events_of(scene, name), 400u) << name;
  }
}

TEST(CollisionCrowd, FarFromTheOrigin) {
  const Rational far = Rational(Integer(10)) * Rational(Integer::power_of_two(80));
  const Scene scene = squares({{far, 0}, {far - Rational(4), 1}, {-far, 1}}, Rational(2));
  for (const std::string& name : collision_structures(false)) {
    EXPECT_LT(events_of(scene, name), 100u) << name;
  }
}

// They would cross cells without end.
TEST(CollisionCrowd, WithoutAnEnd) {
  Scene scene = squares({{0, 0}, {-20, 1}, {-40, 3}}, std::nullopt);
  for (SceneObject& object : scene.objects) {
    object.motion.pieces[0].trajectory.coordinates[1] = {Rational(0)};
  }
  for (const std::string& name : collision_structures(false)) {
    Trial trial(scene, name, "exact", AuditLevel::kNone);
    trial.without_twin().to_end();
    const auto contacts = contacts_of(trial);
    EXPECT_EQ(contacts.size(), 3u) << name;  // all pairs, each once
    EXPECT_LT(trial.sink.lines.size(), 100u) << name;
  }
}

// A certificate that has failed is not taken up again where its root was rounded down: generic
// motions are followed in every arithmetic.
TEST(CollisionCrowd, InexactRunsGoOn) {
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 2 : 8); ++seed) {
    for (const char* family : {"polygons-in-box", "polygon-random"}) {
      lab::WorkloadParameters parameters;
      parameters.n = parameters.m = 8;
      parameters.seed = seed;
      const Scene scene = lab::generate_scene(*lab::find_workload(family), parameters);
      for (const std::string& name : collision_structures(true)) {
        for (const char* arithmetic : {"double", "gsl", "mpfr:53", "mpfr:1000"}) {
          if (kSanitized && arithmetic != std::string("double")) continue;
          Trial trial(scene, name, arithmetic, AuditLevel::kNone);
          trial.to_end();
          EXPECT_FALSE(trial.ledger().corrupt)
              << family << " " << seed << ": " << name << " in " << arithmetic;
        }
      }
    }
  }
}

// Doubles know a body's place only roughly where it is far from its frame's origin.
TEST(CollisionCrowd, WedgesOfBodiesFarFromTheirFrame) {
  for (const int far : {10000, 100000, 1000000, 10000000}) {
    for (const int small : {1, 1000000, 100000000}) {
      SCOPED_TRACE(std::to_string(far) + ", 1 / " + std::to_string(small));
      formats::Polygon2 p{{8, 4}, {-4, 8}, {-8, -4}, {4, -8}};
      for (Vertex2& v : p) v[0] -= Rational(far);
      const Rational r = ratio(1, small);
      const formats::Polygon2 q{{r, 0}, {0, r}, {-r, 0}, {0, -r}};
      const Scene scene = scene_of_bodies(
          {body("a", p, {{far - 9, 5}, {2, -1}, {1}, {0}}), body("b", q, {{3}, {-1}, {1}, {0}})}, 0,
          Rational(2));
      Trial trial(scene, "separation_hysteresis", "exact", AuditLevel::kEnd);
      trial.to_end();
      trial.expect_clean();
      const auto& structure = proof_of<SeparationHysteresis>(trial.simulator.structure(0));
      EXPECT_GE(structure.search().least_displacement(), 0.23);
    }
  }
}

}  // namespace collision_crowd_test
}  // namespace kinex::test

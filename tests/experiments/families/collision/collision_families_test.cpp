// SPDX-License-Identifier: GPL-3.0-or-later
// Families of scenes whose events can be counted beforehand: exactly, or from below and above.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "experiments/families/collision/ball_cover.h"
#include "experiments/lab/workload.h"
#include "structures/collision/separation_hysteresis.h"
#include "structures/collision/separation_mixed.h"
#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace collision_families_test {

Scene family(const char* name, int n, int m, const char* separation, int turns = -1) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.m = m;
  parameters.turns = turns;
  if (separation != nullptr) parameters.separation = Rational::parse(separation);
  return lab::generate_scene(*lab::find_workload(name), parameters);
}

struct Counted {
  std::uint64_t processed = 0;
  std::uint64_t external = 0;
};

Counted count(const Scene& scene, const std::string& structure, bool twin = false) {
  Trial trial(scene, structure, "exact", AuditLevel::kEnd);
  if (!twin) trial.without_twin();
  trial.to_end();
  trial.expect_clean();
  return {trial.ledger().processed, trial.ledger().external};
}

struct Sizes {
  int n, m;
  const char* separation;
};

// A fan that the direction of the shortest way sweeps twice for every tooth: n (3m + 2) changes of
// the closest features, while the mixed hierarchy sees a polygon far away.
TEST(CollisionFamilies, ClosestFeaturesChangeQuadraticallyOften) {
  for (const Sizes& s : {Sizes{8, 8, "2"}, Sizes{8, 3, "29"}, Sizes{5, 1, "1/2"},
                         Sizes{16, kSanitized ? 4 : 16, "2"}}) {
    SCOPED_TRACE(std::to_string(s.n) + " " + std::to_string(s.m));
    const Scene scene = family("polygon-fan", s.n, s.m, s.separation);
    EXPECT_EQ(count(scene, "closest_features").processed,
              static_cast<std::uint64_t>(s.n * (3 * s.m + 2)));
    if (s.n >= 8) {
      EXPECT_LE(count(scene, "separation_mixed", true).processed, 12u);
      EXPECT_LE(count(scene, "separation_hysteresis", true).processed, 40u);
    }
  }
}

// n (2m + 1) changes of the tangent at the fan, and n of the other one.
TEST(CollisionFamilies, TangentsChangeQuadraticallyOften) {
  for (const Sizes& s :
       {Sizes{8, 8, "2"}, Sizes{16, kSanitized ? 4 : 16, "2"}, Sizes{16, 5, "29"}}) {
    SCOPED_TRACE(std::to_string(s.n) + " " + std::to_string(s.m));
    const Scene scene = family("polygon-tangents", s.n, s.m, s.separation);
    const std::uint64_t changes = count(scene, "inner_tangents").processed;
    EXPECT_EQ(changes, static_cast<std::uint64_t>(s.n * (2 * s.m + 2)));
    EXPECT_LE(count(scene, "separation_mixed", true).processed, 12u);
  }
}

// Going round: convex proofs are at least pi / arccos(rho / R) many, as every tile covers an arc of
// the circle whose chord stays outside of the disc in M; and not many times more.
TEST(CollisionFamilies, AnOrbitNeedsManyTiles) {
  for (const Sizes& s : {Sizes{64, 64, "1/10"}, Sizes{64, 64, "1/100"}, Sizes{128, 64, "1/1000"}}) {
    SCOPED_TRACE(s.separation);
    if (kSanitized && s.n > 64) continue;
    const double sigma = Rational::parse(s.separation)->to_double();
    const double pi = 3.14159265358979;
    const double rho = std::cos(pi / s.n) + std::cos(pi / s.m);
    const double least = std::ceil(pi / std::acos(rho / (2 + sigma)) - 1e-6);
    const Scene scene = family("polygon-orbit", s.n, s.m, s.separation);
    for (const char* name : {"separation_mixed", "separation_minkowski"}) {
      SCOPED_TRACE(name);
      Trial trial(scene, name, "exact", AuditLevel::kEnd);
      trial.without_twin();
      class Sink final : public EventSink {
       public:
        explicit Sink(const SeparationMixed& s) : structure(s) { look(); }
        void event(const Event&, Arithmetic&) override { look(); }
        void look() {
          const auto tile = structure.tile(0, 1);
          if (tile) seen.insert({static_cast<int>(tile->kind), tile->x, tile->v, tile->other});
        }
        const SeparationMixed& structure;
        std::set<std::tuple<int, int, std::uint32_t, std::uint32_t>> seen;
      } sink(proof_of<SeparationMixed>(trial.simulator.structure(0)));
      trial.simulator.set_sink(&sink);
      trial.to_end();
      trial.expect_clean();
      EXPECT_EQ(trial.ledger().external, 0u);
      EXPECT_GE(static_cast<double>(sink.seen.size()), least);
      EXPECT_LE(static_cast<double>(trial.ledger().processed), 20 * std::sqrt(2 / sigma) + 20);
    }
    EXPECT_GE(static_cast<double>(count(scene, "separation_hysteresis").processed), least - 1);
  }
}

// Passing by on a line: events grow with the logarithm of 1 / separation. (The hard bound, two per
// level, is checked too.)
TEST(CollisionFamilies, ALineNeedsFewTiles) {
  for (int j = 2; j <= 20; j += 3) {
    const std::string separation = "1/" + std::to_string(1 << j);
    const Scene scene = family("polygon-line", 64, 64, separation.c_str());
    EXPECT_LE(count(scene, "separation_minkowski").processed, static_cast<std::uint64_t>(8 + j));
    EXPECT_LE(count(scene, "separation_mixed").processed, static_cast<std::uint64_t>(12 + 4 * j));
  }
}

// Trembling across a corner of the tiles: they change every time, a wedge does not notice.
TEST(CollisionFamilies, WedgesDoNotTremble) {
  const int times = kSanitized ? 40 : 200;
  const Scene scene = family("polygon-jitter", 8, times, nullptr);
  EXPECT_GE(count(scene, "separation_mixed").processed, static_cast<std::uint64_t>(2 * times));
  EXPECT_LE(count(scene, "separation_hysteresis", true).processed, 1u);
}

// Wedges are at most as many as balls that cover the path, however jagged it is.
TEST(SlowCollisionFamilies, WedgesFollowTheBallCover) {
  for (const int kinks : {5, kSanitized ? 6 : 15}) {
    const Scene scene = family("polygon-kinks", 12, kinks, "1/4");
    EXPECT_LE(count(scene, "separation_hysteresis", true).processed, families::ball_cover(scene));
  }
}

// Closer by halves: a constant number of wedges for each.
TEST(CollisionFamilies, WedgesFollowAnApproach) {
  std::uint64_t last = 0;
  for (const int j : {4, 8, 12, 16}) {
    const std::string separation = "1/" + std::to_string(1 << j);
    const std::uint64_t wedges =
        count(family("polygon-approach", 16, 0, separation.c_str()), "separation_hysteresis")
            .processed;
    EXPECT_LE(wedges, static_cast<std::uint64_t>(40 * (j + 2)));
    if (last > 0) {
      EXPECT_LE(wedges, 2 * last + 40);
    }
    last = wedges;
  }
}

// No wedge fails before 0.23 of the separation has been travelled, turning or not.
TEST(SlowCollisionFamilies, WedgesLast) {
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 4 : 20); ++seed) {
    lab::WorkloadParameters parameters;
    parameters.n = 12;
    parameters.seed = seed;
    parameters.degree = 1 + static_cast<int>(seed % 3);
    const Scene scene = lab::generate_scene(*lab::find_workload("polygon-random"), parameters);
    Trial trial(scene, "separation_hysteresis", "exact", AuditLevel::kEnd);
    trial.to_end();
    trial.expect_clean();
    const auto& structure = proof_of<SeparationHysteresis>(trial.simulator.structure(0));
    EXPECT_GE(structure.search().least_displacement(), 0.23);
  }
}

// Every pair has a proof of constant size, far apart of one certificate.
TEST(CollisionFamilies, ProofsAreSmall) {
  const Scene scene = family("polygons-in-box", 9, 8, nullptr);
  for (const std::string& name : collision_structures(true)) {
    Trial trial(scene, name, "exact", AuditLevel::kEnd);
    trial.without_twin().to_end();
    trial.expect_clean();
    const std::uint64_t most = name == "inner_tangents"          ? 8
                               : name == "closest_features"      ? 5
                               : name == "separation_hysteresis" ? 5
                                                                 : 6;
    EXPECT_LE(trial.ledger().max_live, most * 36) << name;
    EXPECT_LE(trial.ledger().max_per_object, most * 8) << name;
  }
}

}  // namespace collision_families_test
}  // namespace kinex::test

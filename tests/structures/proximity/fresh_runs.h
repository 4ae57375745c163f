// SPDX-License-Identifier: GPL-3.0-or-later
// From a rational instant on, a run goes on as a fresh one does whose scene begins there. Where that is the
// instant of a change, the fresh run begins with the new flight plan, with the object that comes, and without
// the one that goes: both runs are read right after the instant.
#ifndef KINEX_TESTS_STRUCTURES_PROXIMITY_FRESH_RUNS_H
#define KINEX_TESTS_STRUCTURES_PROXIMITY_FRESH_RUNS_H

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {

// Of flights with this seed: the scenes of a test have either in turn.
inline PlanInstants plan_instants(std::uint64_t seed) {
  return seed % 2 == 0 ? PlanInstants::kQuarters : PlanInstants::kOddParts;
}

// The instants at which flight plans change, objects come, and objects go, strictly within the scene's time.
struct ChangeInstants {
  explicit ChangeInstants(const Scene& scene) {
    const auto add = [&scene](std::vector<Rational>& to, const std::optional<Rational>& t) {
      if (t && scene.start < *t && *t < *scene.end) to.push_back(*t);
    };
    for (const SceneObject& object : scene.objects) {
      const std::vector<MotionPiece>& pieces = object.motion.pieces;
      if (pieces.empty()) continue;
      add(insertions, pieces.front().from);
      add(erasures, pieces.back().to);
      for (std::size_t p = 1; p < pieces.size(); ++p) add(updates, pieces[p].from);
    }
  }
  std::vector<Rational> updates, insertions, erasures;
};

// Runs from the start of a scene, each beside fresh ones that begin on its way: at one instant of each kind
// of change, and at two others, multiples of 1/7, 1/11 or 1/13 of the scene's time; drawn at random.
struct FreshRuns {
  // Requires a scene with an end.
  void expect_to_go_on(const Scene& scene, const std::vector<Request>& requests, std::uint64_t seed) {
    const std::vector<Rational> begins = instants_to_begin_at(scene, seed);
    const TwinRun whole(scene, requests, "exact", begins);
    for (std::size_t i = 0; i < begins.size(); ++i) {
      SCOPED_TRACE("from " + begins[i].to_string() + " on");
      const TwinRun::Stop& then = whole.at_stops[i];
      const std::vector<Rational> stops(begins.begin() + static_cast<std::ptrdiff_t>(i) + 1, begins.end());
      Scene late = scene;
      late.start = begins[i];
      // The whole run is audited after every event; this one has to agree with it.
      const TwinRun fresh(late, requests, "exact", stops, AuditLevel::kEnd);
      EXPECT_EQ(fresh.begins_with, then.attribute);
      for (std::size_t k = 0; k < stops.size(); ++k) {
        SCOPED_TRACE("at " + stops[k].to_string());
        const TwinRun::Stop &one = fresh.at_stops[k], &other = whole.at_stops[i + 1 + k];
        EXPECT_EQ(one.attribute, other.attribute);
        EXPECT_EQ(then.external + one.external, other.external);
      }
      EXPECT_EQ(fresh.attribute(), whole.attribute());
      EXPECT_EQ(then.external + fresh.ledger().external, whole.ledger().external);
    }
    external += whole.ledger().external;
  }
  // There were events, and some fresh runs began where something changed.
  void expect_changes() const {
    EXPECT_GT(external, 0u);
    EXPECT_GT(updates, 0u);
    EXPECT_GT(insertions + erasures, 0u);
  }

  std::uint64_t external = 0;                             // events of the whole runs
  std::size_t updates = 0, insertions = 0, erasures = 0;  // instants of these at which a fresh run began

 private:
  std::vector<Rational> instants_to_begin_at(const Scene& scene, std::uint64_t seed) {
    Random random(seed + 900);
    std::vector<Rational> result;
    const auto add_one_of = [&](const std::vector<Rational>& instants, std::size_t& count) {
      if (instants.empty()) return;
      result.push_back(instants[static_cast<std::size_t>(
          random.between(0, static_cast<int>(instants.size()) - 1))]);
      ++count;
    };
    const ChangeInstants changes(scene);
    add_one_of(changes.updates, updates);
    add_one_of(changes.insertions, insertions);
    add_one_of(changes.erasures, erasures);
    const Rational length = *scene.end - scene.start;
    constexpr std::array<int, 3> kParts{7, 11, 13};
    for (int others = 0; others < 2; ++others) {
      const int parts = kParts[static_cast<std::size_t>(random.between(0, 2))];
      const Rational share(Integer(random.between(1, parts - 1)), Integer(parts));
      result.push_back(scene.start + length * share);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
};

}  // namespace kinex::test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of the Delaunay triangulation in space, in one run over one triangulation: each is
// audited after every instant against brute force.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "structures/plan.h"
#include "tests/structures/event_replay.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace proximity_in_space_test {

constexpr const char* kReaders[] = {"closest_pair_delaunay", "emst_list", "emst_cycles"};

struct SpaceRun {
  explicit SpaceRun(Scene given, const std::string& arithmetic = "exact",
                    AuditLevel audit = AuditLevel::kEvents)
      : scene(asking(std::move(given))),
        simulator(scene, planned_arithmetic(arithmetic, scene), Trial::options(audit)),
        replay(simulator) {
    replay.add_structures(scene);
    simulator.set_sink(&replay);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      for (const BoundCheck& bound : simulator.bounds(id)) {
        EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                                 << bound.bound.to_string();
      }
    }
  }
  static Scene asking(Scene scene) {
    scene.maintain.clear();
    for (const char* name : kReaders) scene.maintain.push_back({name, name, {}});
    return scene;
  }
  // The triangulation is the first structure.
  const StructureLedger& ledger(StructureId reader) const { return simulator.ledger(reader + 1); }

  Scene scene;
  Simulator simulator;
  EventReplay replay;
};

TEST(ProximityInSpace, ReferenceCounts) {
  struct Row {
    int n;
    std::uint64_t seed, pairs, swaps;
  };
  for (const Row& row : {Row{6, 1, 4, 7}, Row{7, 2, 7, 11}, Row{8, 1, 5, 13}}) {
    SCOPED_TRACE(row.n);
    const SpaceRun run(reference_scene(row.n, 3, row.seed));
    EXPECT_EQ(run.simulator.structure(0).name(), "delaunay_3");
    EXPECT_EQ(run.ledger(0).external, row.pairs);
    EXPECT_EQ(run.ledger(1).external, row.swaps);
    EXPECT_EQ(run.ledger(2).external, row.swaps);
    EXPECT_GE(run.ledger(2).failures, row.swaps);
    EXPECT_LT(run.ledger(2).failures, run.ledger(1).failures);
  }
}

TEST(ProximityInSpace, TinyLattices) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    SpaceRun(lattice_scene(seed, 4 + static_cast<int>(seed % 4), 3));
  }
}
TEST(SlowProximityInSpace, TinyLattices) {
  for (std::uint64_t seed = 8; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    SpaceRun(lattice_scene(seed, 4 + static_cast<int>(seed % 5), 3));
  }
}

// Points come and go, change their flight plans, and some fly together.
TEST(ProximityInSpace, RandomFlights) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    SpaceRun(random_flights(seed, 7, 3, 1 + static_cast<int>(seed % 2), seed % 2 == 0));
  }
}

// All in one plane: every pair is an edge.
TEST(ProximityInSpace, OnePlane) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Scene scene = lattice_scene(seed, 6, 2);
    scene.dimension = 3;
    for (SceneObject& object : scene.objects) {
      auto& axes = object.motion.pieces[0].trajectory.coordinates;
      axes.push_back(axes[0]);
    }
    SpaceRun{scene};
  }
}

}  // namespace proximity_in_space_test
}  // namespace kinex::test

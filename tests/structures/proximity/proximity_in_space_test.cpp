// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of the Delaunay triangulation in space, in one run over one triangulation: each is
// audited after every instant against brute force, and those for one attribute report the same changes at
// the same instants.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "structures/plan.h"
#include "tests/sanitized.h"
#include "tests/structures/event_replay.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace proximity_in_space_test {

// And those without a triangulation for the same attributes.
enum Reader : StructureId {
  kPair,
  kPairOfAll,
  kColours,
  kColoursOfAll,
  kList,
  kCycles,
  kClusters,
  kSmallClusters
};
const std::vector<Request> kReaders{ask("closest_pair_delaunay"),
                                    ask("closest_pair_all"),
                                    ask("bichromatic_pair_delaunay"),
                                    ask("bichromatic_pair_all"),
                                    ask("emst_list"),
                                    ask("emst_cycles"),
                                    ask("emst_clusters"),
                                    ask("emst_clusters", "cluster", 1)};

struct SpaceRun {
  // Replays the events, and keeps the external ones of each structure.
  class Sink final : public EventSink {
   public:
    explicit Sink(Simulator& simulator) : replay(simulator), changes(simulator) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      replay.event(event, arithmetic);
      changes.event(event, arithmetic);
    }
    EventReplay replay;
    ChangesSink changes;
  };

  explicit SpaceRun(Scene given, const std::string& arithmetic = "exact",
                    AuditLevel audit = AuditLevel::kEvents)
      : scene(asking(std::move(given))),
        simulator(scene, planned_arithmetic(arithmetic, scene), Trial::options(audit)),
        sink(simulator) {
    sink.replay.add_structures(scene);
    simulator.set_sink(&sink);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      for (const BoundCheck& bound : simulator.bounds(id)) {
        EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                                 << bound.bound.to_string();
      }
    }
    for (const auto& [one, other] : {std::pair(kPair, kPairOfAll),
                                     {kColours, kColoursOfAll},
                                     {kList, kCycles},
                                     {kList, kClusters},
                                     {kList, kSmallClusters}}) {
      EXPECT_EQ(changes(one), changes(other)) << simulator.label(other + 1);
    }
  }
  static Scene asking(Scene scene) { return TwinRun::asking(std::move(scene), kReaders); }
  // The triangulation is the first structure.
  const StructureLedger& ledger(Reader reader) const { return simulator.ledger(reader + 1); }
  std::vector<std::string> changes(Reader reader) const {
    const auto found = sink.changes.external.find(reader + 1);
    return found == sink.changes.external.end() ? std::vector<std::string>{} : found->second;
  }

  Scene scene;
  Simulator simulator;
  Sink sink;
};

TEST(ProximityInSpace, ReferenceCounts) {
  struct Row {
    int n;
    std::uint64_t seed, pairs, colours, nearest, swaps;
  };
  for (const Row& row : {Row{6, 1, 4, 3, 1, 7}, Row{7, 2, 7, 5, 3, 11}, Row{8, 1, 5, 4, 1, 13}}) {
    SCOPED_TRACE(row.n);
    const Scene scene = reference_scene(row.n, 3, row.seed);
    const SpaceRun run(scene);
    EXPECT_EQ(run.simulator.structure(0).name(), "delaunay_3");
    EXPECT_EQ(run.ledger(kPair).external, row.pairs);
    EXPECT_EQ(run.ledger(kColours).external, row.colours);
    for (const Reader tree : {kList, kCycles, kClusters, kSmallClusters}) {
      EXPECT_EQ(run.ledger(tree).external, row.swaps);
    }
    EXPECT_GE(run.ledger(kCycles).failures, row.swaps);
    EXPECT_LT(run.ledger(kCycles).failures, run.ledger(kList).failures);
    // nearest_site has the same counts beside this tournament (nearest_site_test.cpp).
    Key to_first;
    to_first.kind = Key::Kind::kSquaredDistance;
    to_first.object = 0;
    Trial nearest(scene, "minimum_tournament", "exact", AuditLevel::kEvents, to_first);
    nearest.to_end().expect_clean();
    EXPECT_EQ(nearest.ledger().external, row.nearest);
  }
}

TEST(SlowProximityInSpace, ReferenceCountsInSturm) {
  for (const auto& [n, seed] : {std::pair(6, 1), {7, 2}, {8, 1}}) {
    SCOPED_TRACE(n);
    const Scene scene = reference_scene(n, 3, static_cast<std::uint64_t>(seed));
    EXPECT_EQ(SpaceRun(scene).sink.changes.log.lines,
              SpaceRun(scene, "sturm", AuditLevel::kEnd).sink.changes.log.lines);
  }
}

// Of 5 to 9 points, all structures in one run. That takes long for more than 7: from the seed `apart` on
// pairs and trees of these have runs of their own, without replays.
void on_lattices(std::uint64_t first, std::uint64_t last, std::uint64_t apart) {
  for (std::uint64_t seed = first; seed < last; ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5);
    const Scene scene = lattice_scene(seed, n, 3);
    if (n <= 7 || seed < apart) {
      SpaceRun{scene};
    } else {
      const TwinRun pairs(scene, {kReaders[kPair], kReaders[kPairOfAll]});
      const TwinRun trees(scene, {kReaders[kList], kReaders[kCycles]});
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ProximityInSpace, TinyLattices) { on_lattices(0, test::fewer(5u), 0); }

TEST(SlowProximityInSpace, TinyLattices) { on_lattices(5, 300, 50); }

// Points come and go, change their flight plans, and some fly together.
TEST(ProximityInSpace, RandomFlights) {
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    SpaceRun(random_flights(seed, 7, 3, 1 + static_cast<int>(seed % 2), seed % 2 == 0));
  }
}

// All in one plane.
TEST(ProximityInSpace, OnePlane) {
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
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

// SPDX-License-Identifier: GPL-3.0-or-later
// Every change of an attribute is reported by an external event: replayed at every instant, on
// scenes in which points meet, coincide, separate, line up, come, go and jump.
#include "tests/structures/event_replay.h"
#include "tests/sanitized.h"

#include <gtest/gtest.h>

#include "structures/plan.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace event_replay_test {

const std::vector<std::string>& point_structures() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const StructureInfo& info : structure_infos()) {
      if (!info.bodies) result.emplace_back(info.name);
    }
    return result;
  }();
  return names;
}

struct Replay {
  Replay(const Scene& given, const std::vector<std::string>& structures,
         const std::string& arithmetic = "exact", std::uint64_t rebuild_seed = 0)
      : scene(asking(given, structures)),
        simulator(scene, planned_arithmetic(arithmetic, scene), options()),
        replay(simulator) {
    if (rebuild_seed != 0) replay.rebuild_at_random(rebuild_seed, 4);
    replay.add_structures(scene);
    simulator.set_sink(&replay);
    simulator.start();
  }
  static Scene asking(Scene scene, const std::vector<std::string>& structures) {
    for (const std::string& name : structures) {
      const StructureInfo* info = find_structure_info(name);
      if (info->linear() && scene.degree() > 1) continue;
      scene = suited(std::move(scene), *info);
      scene.maintain.push_back({name, name, {}});
    }
    return scene;
  }
  static SimulatorOptions options() {
    SimulatorOptions result;
    result.audit = AuditLevel::kEvents;
    return result;
  }
  // Corrupt structures are exempt.
  void expect_clean() {
    simulator.run_until(std::nullopt);
    for (const std::string& what : simulator.violations()) {
      if (what.find("replay: ") != std::string::npos || simulator.kernel().is_exact()) {
        ADD_FAILURE() << what;
      }
    }
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      const StructureLedger& l = simulator.ledger(id);
      EXPECT_EQ(l.processed, l.external + l.internal) << simulator.label(id);
      if (!simulator.kernel().is_exact()) continue;
      for (const BoundCheck& bound : simulator.bounds(id)) {
        EXPECT_TRUE(bound.holds) << bound.id << " " << bound.observed.to_string() << " of "
                                 << bound.bound.to_string();
      }
    }
  }

  Scene scene;
  Simulator simulator;
  EventReplay replay;
};

// Starts on the lattice {0 .. 2}^2, velocities in {-1, 0, 1}: new motions at
// multiples of 1/2, at which points coincide, are in line and on circles; some jump, some are away
// for a while, some move with others.
Scene lattice_flights(std::uint64_t seed, int n, bool lives, bool jumps) {
  Random random(seed);
  Scene scene;
  scene.name = "lattice";
  scene.dimension = 2;
  scene.start = 0;
  scene.end = Rational(4);
  scene.jumps = jumps;
  const auto step = [&random](const Rational& t, Trajectory before) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < 2; ++axis) {
      const Rational v = random.between(-1, 1);
      axes.push_back({before.position(axis, t) - v * t, v});
    }
    return path(std::move(axes));
  };
  for (int i = 0; i < n; ++i) {
    SceneObject object;
    object.id = name_of(static_cast<std::size_t>(i));
    Rational at = lives && random.chance(25) ? Rational(random.between(1, 3)) : Rational(0);
    Trajectory now = step(at, path({{random.between(0, 2)}, {random.between(0, 2)}}));
    if (i > 0 && random.chance(20)) {
      now = scene.objects[static_cast<std::size_t>(random.between(0, i - 1))]
                .motion.pieces[0]
                .trajectory;
    }
    while (at < Rational(4)) {
      Rational to = at + Rational(Integer(random.between(1, 4)), Integer(2));
      if (Rational(4) < to) to = Rational(4);
      object.motion.pieces.push_back({at, to, now});
      if (lives && random.chance(10)) {
        to = to + Rational(Integer(1), Integer(2));
        now = step(to, path({{random.between(0, 2)}, {random.between(0, 2)}}));
      } else if (jumps && random.chance(20)) {
        now = step(to, path({{random.between(0, 2)}, {random.between(0, 2)}}));
      } else {
        now = step(to, now);
      }
      at = to;
    }
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

class EveryPointStructure : public testing::TestWithParam<std::string> {};

void replay_lattices(const std::string& structure, std::uint64_t seeds) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int n = 2 + static_cast<int>(seed % 7);
    Replay run(lattice_flights(seed, n, seed % 3 == 0, seed % 4 == 0), {structure});
    run.expect_clean();
    external += run.replay.external;
    if (testing::Test::HasFailure()) return;
  }
  // A structure without events of its own has none.
  const bool has_events = !find_structure_info(structure)->kinds.empty();
  EXPECT_GE(external, has_events ? test::seen_in_fewer(seeds) / 2 + 1 : 0u);
}

TEST_P(EveryPointStructure, TellsEveryChangeOnALattice) { replay_lattices(GetParam(), 60); }

TEST_P(EveryPointStructure, SlowTellsEveryChangeOnALattice) { replay_lattices(GetParam(), 500); }

TEST_P(EveryPointStructure, TellsEveryChangeOfRandomFlights) {
  for (std::uint64_t seed = 1; seed <= test::fewer(24u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Replay run(random_flights(seed, 4 + static_cast<int>(seed % 6), 2,
                              1 + static_cast<int>(seed % 2), seed % 2 == 0),
               {GetParam()});
    run.expect_clean();
  }
}

TEST_P(EveryPointStructure, TellsEveryChangeWhenBuiltAnew) {
  for (std::uint64_t seed = 1; seed <= test::fewer(24u); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Replay run(lattice_flights(seed, 6, seed % 2 == 0, false), {GetParam()}, "exact", seed);
    run.expect_clean();
    Replay wild(random_flights(seed, 8, 2, 1, false), {GetParam()}, "exact", seed);
    wild.expect_clean();
  }
}

TEST_P(EveryPointStructure, TellsEveryChangeInEveryArithmetic) {
  for (const char* arithmetic : {"sturm", "double", "gsl", "mpfr:24"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
      SCOPED_TRACE(std::string(arithmetic) + ", seed " + std::to_string(seed));
      Replay run(lattice_flights(seed, 6, seed % 2 == 0, seed % 3 == 0), {GetParam()}, arithmetic);
      run.expect_clean();
      Replay wild(random_flights(seed, 6, 2, 2, true), {GetParam()}, arithmetic);
      wild.expect_clean();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryPointStructure, testing::ValuesIn(point_structures()),
                         [](const auto& tested) { return tested.param; });

// Two points that coincide up to 3/2 and separate there: delaunay_2 has one edge before, and three
// after.
TEST(EventReplay, PointsThatPartWithNewMotions) {
  const Rational half(Integer(3), Integer(2));
  Scene scene = scene_of({path({{0}, {0}}), path({{3}, {0}}), path({{3}, {0}})}, 0, Rational(3));
  for (const ObjectId id : {1u, 2u}) {
    auto& pieces = scene.objects[id].motion.pieces;
    pieces[0].to = half;
    const Rational up = id == 1 ? Rational(1) : Rational(-1);
    pieces.push_back({half, std::nullopt, path({{3}, {-up * half, up}})});
  }
  Replay run(scene, {"delaunay_2", "convex_hull_2", "convex_hull_2_delaunay",
                     "convex_hull_2_brute_force", "convex_hull_2_naive"});
  const auto delaunay = [&run] {
    for (StructureId id = 0; id < run.simulator.structures(); ++id) {
      if (run.simulator.label(id) == "delaunay_2") return id;
    }
    return StructureId{0};
  }();
  EXPECT_EQ(run.simulator.structure(delaunay).attribute().ids, (std::vector<ObjectId>{0, 1}));
  run.expect_clean();
  EXPECT_EQ(run.simulator.structure(delaunay).attribute().ids,
            (std::vector<ObjectId>{0, 1, 0, 2, 1, 2}));
  EXPECT_GE(run.simulator.ledger(delaunay).external, 1u);
  EXPECT_EQ(run.replay.counts["settled"] + run.replay.counts["rebuild"], 1u);
}

// A hidden point becomes a vertex while certificates fail that plans have changed at the same instant:
// all triangles are upright afterwards, and the hull turns left everywhere, but twice around.
TEST(EventReplay, APointPartsAmongFailures) {
  Scene scene = lattice_flights(1012, 6, false, true);
  scene.objects.erase(scene.objects.begin());
  Replay run(scene, {"delaunay_2"});
  run.expect_clean();
  EXPECT_EQ(run.replay.counts["rebuild"], 1u);
}

// The test detects a change that is not reported.
TEST(EventReplay, AChangeThatIsNotToldIsSeen) {
  class Silent final : public EventSink {
   public:
    explicit Silent(EventSink& next) : next_(next) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      if (++count_ != 2) next_.event(event, arithmetic);
    }

   private:
    EventSink& next_;
    int count_ = 0;
  };
  Replay run(steep_lines(6), {"sorted_list"});
  Silent silent(run.replay);
  run.simulator.set_sink(&silent);
  run.simulator.run_until(std::nullopt);
  EXPECT_FALSE(run.simulator.violations().empty());
}

}  // namespace event_replay_test
}  // namespace kinex::test

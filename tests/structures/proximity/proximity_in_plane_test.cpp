// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of delaunay_3 of points that are all in one plane, against those of delaunay_2 in that plane: the
// same changes at the same times.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "structures/plan.h"
#include "tests/sanitized.h"
#include "tests/structures/planes_in_space.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {
namespace proximity_in_plane_test {

const std::vector<std::string> kReaders{"closest_pair_delaunay", "bichromatic_pair_delaunay",
                                        "nearest_site",          "emst_list",
                                        "emst_cycles",           "emst_clusters"};

struct PlaneRun {
  // Each reader's attribute whenever it has changed, with the time.
  class Sink final : public EventSink {
   public:
    explicit Sink(const Simulator& simulator) : simulator_(&simulator) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      if (reads(event.structure)) time_ = arithmetic.describe_now().approximate;
    }
    void instant_ended() override {
      for (StructureId id = 0; id < simulator_->structures(); ++id) {
        if (!reads(id)) continue;
        const std::vector<ObjectId> now = simulator_->structure(id).attribute().ids;
        if (now == before_[id]) continue;
        before_[id] = now;
        std::string line = simulator_->label(id) + " at " + time_ + ":";
        for (const ObjectId object : now) line += " " + std::to_string(object);
        changes.push_back(line);
      }
    }
    std::vector<std::string> changes;

   private:
    bool reads(StructureId id) const {
      return !simulator_->structure(id).name().starts_with("delaunay_");
    }
    const Simulator* simulator_;
    std::map<StructureId, std::vector<ObjectId>> before_;
    std::string time_;
  };

  explicit PlaneRun(Scene given)
      : scene(TwinRun::asking(std::move(given), requests())),
        simulator(scene, planned_arithmetic("exact", scene), Trial::options(AuditLevel::kEvents)),
        sink(simulator) {
    add_structures(simulator, scene);
    simulator.set_sink(&sink);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      for (const BoundCheck& bound : simulator.bounds(id)) EXPECT_TRUE(bound.holds) << bound.id;
    }
  }
  static std::vector<Request> requests() {
    std::vector<Request> result;
    for (const std::string& reader : kReaders) result.push_back(ask(reader));
    return result;
  }
  const StructureLedger& ledger(const std::string& label) const {
    StructureId id = 0;
    while (simulator.label(id) != label) ++id;
    return simulator.ledger(id);
  }

  Scene scene;
  Simulator simulator;
  Sink sink;
};

void expect_the_same(const Scene& flat, const Turn& turn) {
  const PlaneRun plane(flat), space(in_space(flat, turn));
  EXPECT_EQ(plane.simulator.structure(0).name(), "delaunay_2");
  EXPECT_EQ(space.simulator.structure(0).name(), "delaunay_3");
  EXPECT_FALSE(plane.sink.changes.empty());
  EXPECT_EQ(plane.sink.changes, space.sink.changes);
}

TEST(ProximityInPlane, ReferenceScenes) {
  expect_the_same(reference_scene(6, 2, 1), kOblique);
  const PlaneRun plane(reference_scene(8, 2, 1)),
      space(in_space(reference_scene(8, 2, 1), kUpright));
  EXPECT_EQ(plane.sink.changes, space.sink.changes);
  // No more certificates than in the plane, and not the 27 that all pairs would have.
  for (const char* reader : {"closest_pair_delaunay", "emst_list"}) {
    EXPECT_EQ(space.ledger(reader).max_live, plane.ledger(reader).max_live);
    EXPECT_LE(space.ledger(reader).max_live, 17u);
  }
}

TEST(ProximityInPlane, TinyLattices) {
  for (std::uint64_t seed = 0; seed < test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene flat = lattice_scene(seed, 5 + static_cast<int>(seed % 4), 2);
    expect_the_same(flat, seed % 3 == 0 ? kFlat : seed % 3 == 1 ? kSideways : kOblique);
    if (testing::Test::HasFailure()) return;
  }
}
TEST(SlowProximityInPlane, TinyLattices) {
  for (std::uint64_t seed = 6; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    expect_the_same(lattice_scene(seed, 5 + static_cast<int>(seed % 4), 2), kFlat);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ProximityInPlane, ThePlaneTurns) {
  Scene flat = reference_scene(6, 2, 1);
  flat.start = -2;
  flat.end = Rational(3);
  // Lengths are those of the plane times 1 + t^2.
  expect_the_same(flat, kTurning);
}

TEST(ProximityInPlane, OneLine) {
  Scene flat = reference_scene(7, 2, 2);
  for (SceneObject& object : flat.objects) {
    auto& axes = object.motion.pieces[0].trajectory.coordinates;
    axes[1] = axes[0];
  }
  expect_the_same(flat, kOblique);
}

TEST(ProximityInPlane, RandomFlights) {
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
    SCOPED_TRACE(seed);
    expect_the_same(random_flights(seed, 7, 2, 1, seed % 2 == 0), kOblique);
  }
}

}  // namespace proximity_in_plane_test
}  // namespace kinex::test

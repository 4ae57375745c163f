// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and runs for the tests of Regular2.
#ifndef KINEX_TESTS_STRUCTURES_TRIANGULATION_REGULAR_2_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_TRIANGULATION_REGULAR_2_SUPPORT_H

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/triangulation/regular_2.h"
#include "tests/structures/event_replay.h"
#include "tests/structures/proximity/reference_scenes.h"

namespace kinex::regular_2_test {

using Coefficients = std::vector<Rational>;

inline Rational fraction(std::int64_t a, std::int64_t b) {
  return Rational(Integer(a), Integer(b));
}
// Points with weights.
inline Scene weighted_scene(const std::vector<Trajectory>& motions, Rational start, Rational end) {
  Scene scene = test::scene_of(motions, std::move(start), std::move(end));
  scene.dimension = 2;
  scene.extents = Extents::kWeight;
  return scene;
}

// S(n, 2, seed) with weights in 0 .. 1499; `linear`: that change by -200 .. 200 per unit of time.
inline Scene weighted_reference(int n, std::uint64_t seed, bool linear) {
  test::ReferenceNumbers numbers(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    std::vector<Coefficients> axes;
    for (int axis = 0; axis < 2; ++axis) {
      const int position = numbers.next() % 100, velocity = numbers.next() % 41 - 20;
      axes.push_back({position, velocity});
    }
    axes.push_back({numbers.next() % 1500});
    if (linear) axes.back().push_back(numbers.next() % 401 - 200);
    motions.push_back(test::path(std::move(axes)));
  }
  return weighted_scene(motions, 0, Rational(10));
}

// n points of {0, 1, 2}^2 with weights in 0 .. 4, velocities in {-1, 0, 1}^2, and with `moving` also
// rates of change of the weights in {-1, 0, 1}; -3 < t < 3.
inline Scene weighted_lattice(std::uint64_t seed, int n, bool moving) {
  test::Random random(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    std::vector<Coefficients> axes;
    for (int axis = 0; axis < 2; ++axis) {
      axes.push_back({random.between(0, 2), random.between(-1, 1)});
    }
    axes.push_back({random.between(0, 4)});
    if (moving) axes.back().push_back(random.between(-1, 1));
    motions.push_back(test::path(std::move(axes)));
  }
  return weighted_scene(motions, -3, Rational(3));
}

// The weight that lifts the object's motion to the height h: x^2 + y^2 - w = h.
inline Trajectory lifted_to(const Coefficients& x, const Coefficients& y, const Coefficients& h) {
  Coefficients w(2 * std::max(x.size(), y.size()));
  for (const Coefficients* axis : {&x, &y}) {
    for (std::size_t i = 0; i < axis->size(); ++i) {
      for (std::size_t j = 0; j < axis->size(); ++j) w[i + j] += (*axis)[i] * (*axis)[j];
    }
  }
  w.resize(std::max(w.size(), h.size()));
  for (std::size_t i = 0; i < h.size(); ++i) w[i] -= h[i];
  return test::path({x, y, w});
}

// One run with this structure alone, audited after every event by default, and replayed.
class World {
 public:
  explicit World(const Scene& scene, const std::string& arithmetic = "exact",
                 AuditLevel audit = AuditLevel::kEvents)
      : scene_(scene),
        simulator_(scene_, make_arithmetic(arithmetic, scene_, needs_of(scene_)), options(audit)),
        replay_(simulator_),
        sink_(*this) {
    simulator_.set_sink(&sink_);
    const StructureId id = simulator_.reserve();
    auto structure = std::make_unique<Regular2>(simulator_.kernel(), id, scene_);
    structure_ = structure.get();
    simulator_.add(id, replay_.watch(id, std::move(structure)), "regular_2");
    simulator_.start();
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  World& run() { return run_until(*scene_.end); }
  World& run_until(const Rational& t) {
    status = simulator_.run_until(t);
    return *this;
  }
  void expect_clean() {
    EXPECT_EQ(status, RunStatus::kDone);
    EXPECT_EQ(simulator_.violations(), std::vector<std::string>{});
    EXPECT_FALSE(ledger().corrupt) << ledger().corruption;
    for (const BoundCheck& b : simulator_.bounds(0)) {
      EXPECT_TRUE(b.holds) << b.id << " " << b.observed.to_string() << " / " << b.bound.to_string();
    }
  }
  std::uint64_t count(const std::string& kind) const {
    const auto it = ledger().by_kind.find(kind);
    return it == ledger().by_kind.end() ? 0 : it->second;
  }
  const StructureLedger& ledger() const { return simulator_.ledger(0); }
  const Regular2& structure() const { return *structure_; }
  Simulator& simulator() { return simulator_; }
  std::vector<ObjectId> triangles() const { return structure_->attribute().ids; }
  const std::vector<std::string>& lines() const { return sink_.lines; }

  RunStatus status = RunStatus::kDone;

 private:
  class Sink final : public EventSink {
   public:
    explicit Sink(World& world) : world_(&world) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      world_->replay_.event(event, arithmetic);
      std::string line(world_->simulator_.event_kinds(event.structure)[event.kind]);
      for (std::size_t i = 0; i < event.count; ++i) line += " " + std::to_string(event.ids[i]);
      lines.push_back(line + (event.external ? " !" : ""));
    }
    std::vector<std::string> lines;

   private:
    World* world_;
  };

  static SimulatorOptions options(AuditLevel audit) {
    SimulatorOptions result;
    result.audit = audit;
    result.max_events = 1000000;
    return result;
  }
  static NumberNeeds needs_of(const Scene& scene) {
    NumberNeeds needs = needs_of_objects(scene);
    needs.add_weights(scene);
    return needs;
  }

  Scene scene_;
  Simulator simulator_;
  test::EventReplay replay_;
  Sink sink_;
  Regular2* structure_ = nullptr;
};

// The triangles that the static algorithm finds at time t.
inline std::vector<ObjectId> static_triangles(Scene scene, const Rational& t) {
  scene.start = t;
  scene.end = t + Rational(1);
  return World(scene, "exact", AuditLevel::kNone).triangles();
}

}  // namespace kinex::regular_2_test

#endif

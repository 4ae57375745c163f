// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and runs for the tests of regular triangulations in the plane and in space.
#ifndef KINEX_TESTS_STRUCTURES_TRIANGULATION_REGULAR_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_TRIANGULATION_REGULAR_SUPPORT_H

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/triangulation/regular_2.h"
#include "structures/triangulation/regular_3.h"
#include "tests/structures/event_replay.h"
#include "tests/structures/proximity/reference_scenes.h"

namespace kinex::regular_test {

using Coefficients = std::vector<Rational>;

inline Rational fraction(std::int64_t a, std::int64_t b) {
  return Rational(Integer(a), Integer(b));
}
// Points with weights, the last axis of their motions.
inline Scene weighted_scene(const std::vector<Trajectory>& motions, Rational start, Rational end) {
  Scene scene = test::scene_of(motions, std::move(start), std::move(end));
  scene.dimension = motions.empty() ? 2 : motions[0].dimension() - 1;
  scene.extents = Extents::kWeight;
  return scene;
}

// S(n, axes, seed) with weights in 0 .. 1499; `linear`: that change by -200 .. 200 per unit of time. In space
// in 0 .. 5999, and -400 .. 400.
inline Scene weighted_reference(int n, std::uint64_t seed, bool linear, int dimension = 2) {
  test::ReferenceNumbers numbers(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    std::vector<Coefficients> axes;
    for (int axis = 0; axis < dimension; ++axis) {
      const int position = numbers.next() % 100, velocity = numbers.next() % 41 - 20;
      axes.push_back({position, velocity});
    }
    axes.push_back({numbers.next() % (dimension == 2 ? 1500 : 6000)});
    const int most = dimension == 2 ? 200 : 400;
    if (linear) axes.back().push_back(numbers.next() % (2 * most + 1) - most);
    motions.push_back(test::path(std::move(axes)));
  }
  return weighted_scene(motions, 0, Rational(10));
}

// theta + (t - 1)(t - 2)..(t - k): the weight of a point that crosses theta k times.
inline Coefficients crossing_weight(int k, int theta) {
  Coefficients weight{1};
  for (int root = 1; root <= k; ++root) {
    Coefficients next(weight.size() + 1);
    for (std::size_t i = 0; i < weight.size(); ++i) {
      next[i + 1] += weight[i];
      next[i] -= weight[i] * Rational(root);
    }
    weight = std::move(next);
  }
  weight[0] += Rational(theta);
  return weight;
}

// n points of {0, 1, 2}^d, d = 2 by default, with weights in 0 .. 4, velocities in {-1, 0, 1}^d, and with
// `moving` also rates of change of the weights in {-1, 0, 1}; -3 < t < 3.
inline Scene weighted_lattice(std::uint64_t seed, int n, bool moving, int dimension = 2) {
  test::Random random(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    std::vector<Coefficients> axes;
    for (int axis = 0; axis < dimension; ++axis) {
      axes.push_back({random.between(0, 2), random.between(-1, 1)});
    }
    axes.push_back({random.between(0, 4)});
    if (moving) axes.back().push_back(random.between(-1, 1));
    motions.push_back(test::path(std::move(axes)));
  }
  return weighted_scene(motions, -3, Rational(3));
}

// n points of {0 .. 99}^d with weights in 0 .. 99, and a twin of every fourth of them: in scenes of so many points
// the audit looks at no hidden point, and the witness may keep the other one of two.
inline Scene weighted_twins(int n, std::uint64_t seed, int dimension) {
  test::Random random(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    std::vector<Coefficients> axes;
    for (int axis = 0; axis <= dimension; ++axis) axes.push_back({random.between(0, 99)});
    motions.push_back(test::path(axes));
    if (i % 4 == 0) motions.push_back(motions.back());
  }
  return weighted_scene(motions, 0, Rational(1));
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
template <class Regular>
class RegularWorld {
 public:
  explicit RegularWorld(const Scene& scene, const std::string& arithmetic = "exact",
                        AuditLevel audit = AuditLevel::kEvents)
      : scene_(scene),
        simulator_(scene_, make_arithmetic(arithmetic, scene_, needs_of(scene_)), options(audit)),
        replay_(simulator_),
        sink_(*this) {
    simulator_.set_sink(&sink_);
    const StructureId id = simulator_.reserve();
    auto structure = std::make_unique<Regular>(simulator_.kernel(), id, scene_);
    structure_ = structure.get();
    simulator_.add(id, replay_.watch(id, std::move(structure)), std::string(structure_->name()));
    simulator_.start();
  }
  RegularWorld(const RegularWorld&) = delete;
  RegularWorld& operator=(const RegularWorld&) = delete;

  RegularWorld& run() { return run_until(*scene_.end); }
  RegularWorld& run_until(const Rational& t) {
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
  const Regular& structure() const { return *structure_; }
  Simulator& simulator() { return simulator_; }
  std::vector<ObjectId> cells() const { return structure_->attribute().ids; }
  const std::vector<std::string>& lines() const { return sink_.lines; }

  RunStatus status = RunStatus::kDone;

 private:
  class Sink final : public EventSink {
   public:
    explicit Sink(RegularWorld& world) : world_(&world) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      world_->replay_.event(event, arithmetic);
      std::string line(world_->simulator_.event_kinds(event.structure)[event.kind]);
      for (std::size_t i = 0; i < event.count; ++i) line += " " + std::to_string(event.ids[i]);
      lines.push_back(line + (event.external ? " !" : ""));
    }
    std::vector<std::string> lines;

   private:
    RegularWorld* world_;
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
  Regular* structure_ = nullptr;
};

// The cells that the static algorithm finds at time t.
template <class Regular>
std::vector<ObjectId> static_cells(Scene scene, const Rational& t) {
  scene.start = t;
  scene.end = t + Rational(1);
  return RegularWorld<Regular>(scene, "exact", AuditLevel::kNone).cells();
}

// Objects come, go, and get other motions at random instants of a run on a lattice, all of it audited.
template <class Regular>
void come_and_go(std::uint64_t seed, int dimension) {
  test::Random random(seed);
  const bool moving = seed % 2 == 0;
  const Scene others = weighted_lattice(seed + 1000, 8, moving, dimension);
  RegularWorld<Regular> world(weighted_lattice(seed, 8, moving, dimension));
  std::vector<bool> alive(8, true);
  for (int i = 1; i < 30; ++i) {
    const Rational t = Rational(-3) + fraction(i, 5);
    const auto object = static_cast<ObjectId>(random.between(0, 7));
    if (alive[object]) {
      world.simulator().schedule_erasure(t, object);
    } else {
      world.simulator().schedule_insertion(t, object,
                                           others.objects[object].motion.pieces[0].trajectory);
    }
    alive[object] = !alive[object];
    world.run_until(t);
  }
  world.expect_clean();
}

}  // namespace kinex::regular_test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and runs for the tests of Delaunay2.
#ifndef KINEX_TESTS_STRUCTURES_TRIANGULATION_DELAUNAY_2_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_TRIANGULATION_DELAUNAY_2_SUPPORT_H

#include <gtest/gtest.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/triangulation/delaunay_2.h"
#include "tests/structures/sturm_twin.h"

namespace kinex::delaunay_2_test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // Uniform enough for tests, and the same everywhere.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[static_cast<std::size_t>(between(0, static_cast<int>(i) - 1))]);
    }
  }

 private:
  std::mt19937_64 engine_;
};

using Coefficients = std::vector<Rational>;

inline Rational fraction(std::int64_t a, std::int64_t b) {
  return Rational(Integer(a), Integer(b));
}

inline Trajectory moving(Coefficients x, Coefficients y) {
  Trajectory t;
  t.coordinates = {std::move(x), std::move(y)};
  t.normalise();
  return t;
}

inline Trajectory integers(std::int64_t x, std::int64_t vx, std::int64_t y, std::int64_t vy) {
  return moving({Rational(x), Rational(vx)}, {Rational(y), Rational(vy)});
}

inline Scene scene_of(const std::vector<Trajectory>& motions, Rational start, Rational end) {
  Scene scene;
  scene.name = "test";
  scene.dimension = 2;
  scene.start = std::move(start);
  scene.end = std::move(end);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    SceneObject object;
    object.id = std::to_string(i);
    object.motion.pieces.push_back({std::nullopt, std::nullopt, motions[i]});
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

// Start and destination (at t = 1) uniform in a square; `degree` 1 to 3.
inline std::vector<Trajectory> random_motions(int n, std::uint64_t seed, int degree = 1) {
  Random random(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    Coefficients axis[2];
    for (Coefficients& c : axis) {
      const std::int64_t start = random.between(0, 1 << 20);
      std::int64_t left = random.between(0, 1 << 20) - start;
      c.push_back(fraction(start, 1 << 20));
      for (int k = 1; k < degree; ++k) {
        const std::int64_t part = random.between(-(1 << 21), 1 << 21);
        c.push_back(fraction(part, 1 << 20));
        left -= part;
      }
      c.push_back(fraction(left, 1 << 20));
    }
    motions.push_back(moving(axis[0], axis[1]));
  }
  return motions;
}

using test::Recorded;
using test::Recorder;

// One run of one scene with this structure alone. A run in `exact` is compared with `sturm` when it
// is over (sturm_twin.h).
class World {
 public:
  explicit World(Scene scene, std::string_view arithmetic = "exact",
                 AuditLevel audit = AuditLevel::kEvents)
      : scene_(std::move(scene)), twin_(test::has_twin(scene_, std::string(arithmetic))) {
    SimulatorOptions options;
    options.audit = audit;
    options.max_events = 1000000;
    simulator_ = std::make_unique<Simulator>(scene_, make_arithmetic(arithmetic, scene_), options);
    simulator_->set_sink(&recorder);
    id_ = simulator_->reserve();
    auto structure = std::make_unique<Delaunay2>(simulator_->kernel(), id_, scene_);
    structure_ = structure.get();
    simulator_->add(id_, std::move(structure), "delaunay_2");
    if (twin_) recorder.instants = 2 * test::twin_failures(scene_, "delaunay_2");
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() {
    if (!twin_ || !started_) return;
    try {
      test::expect_same_in_sturm(*simulator_, recorder, {"delaunay_2", "delaunay_2", {}}, changes_);
    } catch (const std::exception& error) {
      ADD_FAILURE() << "in sturm: " << error.what();
    }
  }

  World& start() {
    simulator_->start();
    started_ = true;
    return *this;
  }
  // Not compared with `sturm`, for the reason given.
  World& without_twin(const std::string& reason) {
    if (twin_) ::testing::Test::RecordProperty("sturm", "not compared: " + reason);
    twin_ = false;
    return *this;
  }
  World& run() {
    start();
    return run_until(*scene_.end);
  }
  World& run_until(const Rational& t) {
    status = simulator_->run_until(t);
    return *this;
  }
  void update(const Rational& t, ObjectId object, Trajectory trajectory) {
    changes_.update(*simulator_, t, object, std::move(trajectory));
  }
  void insert(const Rational& t, ObjectId object, Trajectory trajectory) {
    changes_.insert(*simulator_, t, object, std::move(trajectory));
  }
  void erase(const Rational& t, ObjectId object) { changes_.erase(*simulator_, t, object); }
  // Audits once more: no violation, and every bound holds.
  void expect_clean() {
    EXPECT_EQ(status, RunStatus::kDone);
    EXPECT_TRUE(simulator_->audit());
    for (const std::string& v : simulator_->violations()) ADD_FAILURE() << v;
    EXPECT_FALSE(ledger().corrupt) << ledger().corruption;
    for (const BoundCheck& b : simulator_->bounds(id_)) {
      EXPECT_TRUE(b.holds) << b.id << " " << b.observed.to_string() << " / " << b.bound.to_string();
    }
    EXPECT_GT(ledger().audit_checks, 0u);
  }

  Simulator& simulator() { return *simulator_; }
  Delaunay2& structure() { return *structure_; }
  const StructureLedger& ledger() const { return simulator_->ledger(id_); }
  std::uint64_t count(const std::string& kind) const {
    const auto it = ledger().by_kind.find(kind);
    return it == ledger().by_kind.end() ? 0 : it->second;
  }
  std::vector<BoundCheck> bounds() const { return simulator_->bounds(id_); }
  std::string reasons() const {
    std::string text;
    for (const auto& [reason, times] : ledger().rebuild_reasons) {
      text += reason + ": " + std::to_string(times) + "; ";
    }
    return text;
  }

  Recorder recorder;
  RunStatus status = RunStatus::kDone;

 private:
  Scene scene_;
  std::unique_ptr<Simulator> simulator_;
  StructureId id_ = 0;
  Delaunay2* structure_ = nullptr;
  test::OutsideChanges changes_;
  bool twin_;
  bool started_ = false;
};

// Runs to each time and compares with the static algorithm started there.
inline void expect_same_as_static(const std::vector<Trajectory>& motions, const Rational& start,
                                  const std::vector<Rational>& times) {
  World kinetic(scene_of(motions, start, times.back()));
  kinetic.start();
  for (const Rational& t : times) {
    kinetic.run_until(t);
    World fresh(scene_of(motions, t, times.back() + Rational(1)));
    fresh.start();
    EXPECT_EQ(kinetic.structure().attribute(), fresh.structure().attribute())
        << "at t = " << t.to_string();
    EXPECT_EQ(kinetic.structure().hull(), fresh.structure().hull()) << "at t = " << t.to_string();
    fresh.expect_clean();
  }
  kinetic.expect_clean();
  ::testing::Test::RecordProperty("rebuilds", std::to_string(kinetic.ledger().rebuilds));
}

}  // namespace kinex::delaunay_2_test

#endif

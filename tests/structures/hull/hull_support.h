// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and runs for the tests of convex hulls.
#ifndef KINEX_TESTS_STRUCTURES_HULL_HULL_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_HULL_HULL_SUPPORT_H

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "structures/hull/convex_hull_2.h"
#include "structures/plan.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/structure_names.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {

// Start and destination (at t = 1) uniform in a square; `degree` 1 to 3.
inline Scene random_plane(int n, std::uint64_t seed, int degree = 1) {
  Random random(seed);
  const int unit = 1 << 20;
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int a = 0; a < 2; ++a) {
      std::vector<Rational> c{Rational(Integer(random.between(0, unit)), Integer(unit))};
      for (int k = 1; k <= degree; ++k) {
        c.push_back(Rational(Integer(random.between(-unit, unit)), Integer(unit)));
      }
      axes.push_back(std::move(c));
    }
    motions.push_back(path(std::move(axes)));
  }
  Scene scene = scene_of(motions, 0, Rational(1));
  scene.dimension = 2;
  return scene;
}

// Small integers: points that meet, lines of points, equal motions.
inline Scene small_plane(int n, std::uint64_t seed, int degree, int size) {
  Random random(seed);
  std::vector<Trajectory> motions;
  for (int i = 0; i < n; ++i) motions.push_back(random.small_path(2, degree, size));
  return scene_of(motions, Rational(-3), Rational(3));
}

// The family of 2 n m - 1 changes: m points that rise on vertical lines and are always on a
// parabola, and n points just below it that run along.
inline Scene hull_worst(int m, int n) {
  std::vector<Trajectory> motions;
  for (int j = 0; j < m; ++j) motions.push_back(path({{j}, {-j * j, j}}));
  Rational g;
  for (int i = 0; i < n; ++i) {
    g = Rational(Integer(i * (n + 2)), Integer(n + 1));
    motions.push_back(path({{-g, 1}, {-(g * g) - Rational(Integer(1), Integer(8)), g}}));
  }
  return scene_of(motions, 0, g + Rational(m + 2));
}

// The report of one method about the hull: external events with their instants, and the hull at the
// end.
struct HullStory {
  std::vector<Recorded> events;
  std::vector<ObjectId> last;
  std::vector<std::string> violations;
  StructureLedger ledger;
};

class HullSink final : public EventSink {
 public:
  explicit HullSink(StructureId id) : id_(id) { recorder.instants = 1u << 20; }
  void event(const Event& event, Arithmetic& arithmetic) override {
    if (event.structure == id_ && event.external) recorder.event(event, arithmetic);
  }
  Recorder recorder;

 private:
  StructureId id_;
};

inline HullStory tell(Scene scene, const std::string& structure,
                      const std::string& arithmetic = "exact",
                      AuditLevel audit = AuditLevel::kEvents,
                      const OutsideChanges* changes = nullptr) {
  scene.maintain = {{structure, structure, {}}};
  SimulatorOptions options;
  options.audit = audit;
  Simulator simulator(scene, make_arithmetic(arithmetic, scene), options);
  add_structures(simulator, scene);
  const auto id = static_cast<StructureId>(simulator.structures() - 1);
  HullSink sink(id);
  simulator.set_sink(&sink);
  simulator.start();
  if (changes != nullptr) changes->repeat(simulator);
  simulator.run_until(std::nullopt);
  HullStory story;
  story.events = std::move(sink.recorder.events);
  story.last = simulator.structure(id).attribute().ids;
  story.violations = simulator.violations();
  story.ledger = simulator.ledger(id);
  if (story.ledger.corrupt) return story;
  for (const BoundCheck& b : simulator.bounds(id)) {
    EXPECT_TRUE(b.holds) << b.id << " " << b.observed.to_string() << " > " << b.bound.to_string();
  }
  return story;
}

// The same events at the same instants, which may be roots of different polynomials.
inline void expect_same_events(std::vector<Recorded> expected, std::vector<Recorded> found) {
  ASSERT_EQ(expected.size(), found.size());
  RootCounters counters;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    RealRoot a = instant_of(expected[i], Image{}), b = instant_of(found[i], Image{});
    ASSERT_EQ(compare(a, b, counters), 0) << "event " << i;
    for (Recorded* r : {&expected[i], &found[i]}) {
      r->polynomial.clear();
      r->root = 0;
      r->lower = r->upper = r->decimal = "";
    }
    ASSERT_EQ(expected[i], found[i]) << "event " << i;
  }
}

// All methods report the same story.
inline void expect_one_story(const Scene& scene, AuditLevel audit = AuditLevel::kEvents,
                             const OutsideChanges* changes = nullptr) {
  const HullStory first = tell(scene, kHulls[0], "exact", audit, changes);
  EXPECT_EQ(first.violations, std::vector<std::string>{}) << kHulls[0];
  for (const std::string& other : kHulls) {
    if (other == kHulls[0]) continue;
    SCOPED_TRACE(other);
    const HullStory story = tell(scene, other, "exact", audit, changes);
    EXPECT_EQ(story.violations, std::vector<std::string>{}) << other;
    expect_same_events(first.events, story.events);
    EXPECT_EQ(story.last, first.last) << other;
  }
}

// One run of one structure, audited at every event, and compared with `sturm`.
class HullRun {
 public:
  explicit HullRun(Scene scene, const std::string& structure = "convex_hull_2",
                   const std::string& arithmetic = "exact", AuditLevel audit = AuditLevel::kEvents)
      : scene_(std::move(scene)), trial(scene_, structure, arithmetic, audit) {}
  const ConvexHull2& hull() {
    return dynamic_cast<const ConvexHull2&>(trial.simulator.structure(0));
  }

 private:
  Scene scene_;

 public:
  Trial trial;
};

}  // namespace kinex::test

#endif

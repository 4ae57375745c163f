// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the structures that measure along directions: audited after every instant, every bound
// checked.
#ifndef KINEX_TESTS_STRUCTURES_EXTENT_DIRECTIONS_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_EXTENT_DIRECTIONS_SUPPORT_H

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "structures/plan.h"
#include "tests/structures/special_scenes.h"
#include "tests/structures/test_run.h"

namespace kinex::test {

inline Scene asking_along(Scene scene, const std::string& structure, int k) {
  Request request{structure, structure, {}};
  request.parameters = {{"k", Rational(k)}};
  scene.maintain = {std::move(request)};
  return scene;
}

struct DirectionsRun {
  DirectionsRun(const Scene& given, const std::string& structure, int k,
                const std::string& arithmetic = "exact")
      : scene(asking_along(given, structure, k)),
        simulator(scene, planned_arithmetic(arithmetic, scene),
                  Trial::options(AuditLevel::kEvents)),
        id(asked_structure(scene)),
        sink(simulator) {
    add_structures(simulator, scene);
    simulator.set_sink(&sink);
    simulator.start();
    begins_with = ids();
    simulator.run_until(std::nullopt);
    if (simulator.kernel().is_exact()) expect_clean();
  }
  void expect_clean() const {
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    EXPECT_EQ(ledger().rebuilds, 0u);
    for (const BoundCheck& bound : simulator.bounds(id)) {
      EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                               << bound.bound.to_string();
    }
  }
  std::vector<ObjectId> ids() const { return simulator.structure(id).attribute().ids; }
  const StructureLedger& ledger() const { return simulator.ledger(id); }
  // External events, without the label.
  std::vector<std::string> changes() const {
    std::vector<std::string> result;
    for (const std::string& line : sink.lines) {
      if (line.back() == '!') result.push_back(line.substr(line.find(' ') + 1));
    }
    return result;
  }

  Scene scene;
  Simulator simulator;
  StructureId id;
  LogSink sink;
  std::vector<ObjectId> begins_with;
};

// 3 to 8 points with tiny coordinates and velocities: ties and meetings abound.
inline Scene direction_lattice(std::uint64_t seed, int degree) {
  Random random(seed);
  std::vector<Trajectory> t;
  const int n = random.between(3, 8);
  for (int i = 0; i < n; ++i) t.push_back(random.small_path(2, degree, degree == 1 ? 2 : 1));
  return scene_of(t, -2, Rational(3));
}

// All 2 n changes of a bounding box in two axes: the dual points of either axis are on a circle.
inline Scene dual_circles(int n) {
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < 2; ++axis) {
      const Rational a = Rational(6 - axis) / Rational(n) *
                         (Rational(2 * i - n + 1) / Rational(2) +
                          Rational(1) / Rational(7 - 2 * axis));
      const Rational all = Rational(1) + a * a;
      const Rational u = (Rational(1) - a * a) / all, v = Rational(2) * a / all;
      axes.push_back(axis == 0 ? std::vector<Rational>{u, v} : std::vector<Rational>{v, u});
    }
    t.push_back(path(std::move(axes)));
  }
  return scene_of(t, -1000000, Rational(1000000));
}

}  // namespace kinex::test

#endif

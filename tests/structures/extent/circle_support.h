// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of structures that read a hull, directly or through others, and their scenes.
#ifndef KINEX_TESTS_STRUCTURES_EXTENT_CIRCLE_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_EXTENT_CIRCLE_SUPPORT_H

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "structures/plan.h"
#include "tests/structures/extent/hulls_below.h"
#include "tests/structures/special_scenes.h"
#include "tests/structures/structure_names.h"
#include "tests/structures/test_run.h"

namespace kinex::test {

// `hull`: empty for a structure that reads none.
inline Request asked_over(const std::string& structure, const std::string& hull) {
  Request request{structure, structure, {}};
  if (!hull.empty() && hull != "convex_hull_2") request.over = {hull_request(hull)};
  return request;
}

// The values of an attribute, each with the instant from which it holds.
using History = std::vector<std::pair<std::string, std::vector<ObjectId>>>;

class HistorySink final : public EventSink {
 public:
  HistorySink(const Simulator& simulator, StructureId id) : simulator_(&simulator), id_(id) {}
  void event(const Event& event, Arithmetic& arithmetic) override {
    instant_ = arithmetic.describe_now().approximate;
    if (event.structure == id_ && event.external) most = std::max(most, ++external_);
  }
  void instant_ended() override {
    external_ = 0;
    if (!simulator_->ledger(id_).corrupt) note();
  }
  void note() {
    std::vector<ObjectId> ids = simulator_->structure(id_).attribute().ids;
    if (history.empty() || history.back().second != ids) {
      history.emplace_back(instant_, std::move(ids));
    }
  }
  History history;
  int most = 0;  // external events at one instant

 private:
  const Simulator* simulator_;
  StructureId id_;
  std::string instant_;
  int external_ = 0;
};

// Audited after every instant; in an exact arithmetic every audit and every bound is checked.
struct LayeredRun {
  LayeredRun(const Scene& given, const std::string& structure, const std::string& hull = "",
             const std::string& arithmetic = "exact", AuditLevel audit = AuditLevel::kEvents)
      : scene(asking(given, asked_over(structure, hull))),
        simulator(scene, planned_arithmetic(arithmetic, scene), Trial::options(audit)),
        id(asked_structure(scene)),
        sink(simulator, id) {
    add_structures(simulator, scene);
    simulator.set_sink(&sink);
    simulator.start();
    sink.note();
    simulator.run_until(std::nullopt);
    if (simulator.kernel().is_exact()) expect_clean();
  }
  static Scene asking(Scene scene, Request request) {
    scene.maintain = {std::move(request)};
    return scene;
  }
  void expect_clean() const {
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    EXPECT_EQ(ledger().rebuilds, 0u);
    EXPECT_LE(sink.most, 1);
    for (const BoundCheck& bound : simulator.bounds(id)) {
      EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                               << bound.bound.to_string();
    }
  }
  const StructureLedger& ledger() const { return simulator.ledger(id); }
  // Something is corrupt, or was found wrong by an audit.
  bool noticed() const {
    bool corrupt = false;
    for (StructureId i = 0; i < simulator.structures(); ++i) {
      corrupt = corrupt || simulator.ledger(i).corrupt;
    }
    return corrupt || !simulator.violations().empty();
  }
  std::uint64_t external() const { return ledger().external; }
  std::uint64_t events_of(const char* kind) const {
    const auto at = ledger().by_kind.find(kind);
    return at == ledger().by_kind.end() ? 0 : at->second;
  }
  std::vector<std::vector<ObjectId>> values() const {
    std::vector<std::vector<ObjectId>> result;
    for (const auto& [instant, ids] : sink.history) result.push_back(ids);
    return result;
  }

  Scene scene;
  Simulator simulator;
  StructureId id;
  HistorySink sink;
};

// n points at rest on an arc on the left, and m points that pass one after another on the right; each
// is the farthest from the others for a while.
inline Scene see_saw(int n, int m) {
  const Rational far(10000000), bend = Rational(Integer(3), Integer(2)) / far;
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    const Rational a = Rational(-1) + Rational(Integer(2 * i), Integer(n - 1));
    t.push_back(path({{bend * a * a}, {a}}));
  }
  for (int j = 0; j < m; ++j) {
    const Rational middle = Rational(6) * (Rational(j) + Rational(Integer(1), Integer(2)));
    t.push_back(path({{far - bend * middle * middle, bend * middle * Rational(2)}, {-middle, 1}}));
  }
  return scene_of(t, 0, Rational(6 * m));
}

// The velocities of remainders(n), through the origin at 0.
inline Scene through_origin(int n, Rational start) {
  std::vector<Trajectory> t;
  for (const SceneObject& object : remainders(n).objects) {
    const auto& c = object.motion.pieces[0].trajectory.coordinates;
    const auto velocity = [&c](std::size_t axis) {
      return c[axis].size() > 1 ? c[axis][1] : Rational(0);
    };
    t.push_back(path({{0, velocity(0)}, {0, velocity(1)}}));
  }
  return scene_of(t, std::move(start), Rational(1));
}

// Small integers: points that meet, lie on a line or a circle, or move alike.
inline Scene circle_lattice(std::uint64_t seed, int degree) {
  Random random(seed);
  const int n = random.between(3, 8), size = random.between(1, 4);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) t.push_back(random.small_path(2, degree, size));
  return scene_of(t, Rational(-2), Rational(2));
}

}  // namespace kinex::test

#endif

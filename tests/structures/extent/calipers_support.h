// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the structures of rotating calipers over a hull of any kind, and the scenes whose counts
// are known.
#ifndef KINEX_TESTS_STRUCTURES_EXTENT_CALIPERS_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_EXTENT_CALIPERS_SUPPORT_H

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

using Ids = std::vector<ObjectId>;

// In the order of the descriptors: the diameter, the width, the two rectangles.
inline const std::vector<std::string> kCaliperStructures = structures_where(
    [](const StructureInfo& info) { return info.shares.structure == "calipers_2"; });

inline const std::vector<std::string> kAllCaliperStructures = {
    "diameter_2",  "width_2",     "min_area_rectangle_2", "min_perimeter_rectangle_2",
    "calipers_2", "calipers_2_4"};

// "calipers_2_4" is calipers_2 of 4 folds, "directions_2:3" has k = 3.
inline Request request_for(const std::string& structure, const std::string& hull) {
  Request request = hull_request(structure);
  request.label = structure;
  if (structure == "calipers_2_4") {
    request.structure = "calipers_2";
    request.parameters = {{"folds", Rational(4)}};
  }
  if (!hull.empty() && hull != "convex_hull_2") request.over = {hull_request(hull)};
  return request;
}

inline Scene asking(Scene scene, const std::string& structure, const std::string& hull) {
  scene.maintain = {request_for(structure, hull)};
  return scene;
}

// Audited after every instant; in an exact arithmetic every audit and every bound is checked.
struct CaliperRun {
  CaliperRun(const Scene& given, const std::string& structure,
             const std::string& hull = "convex_hull_2", const std::string& arithmetic = "exact",
             AuditLevel audit = AuditLevel::kEvents)
      : scene(asking(given, structure, hull)),
        simulator(scene, planned_arithmetic(arithmetic, scene), Trial::options(audit)),
        id(asked_structure(scene)),
        sink(*this) {
    add_structures(simulator, scene);
    simulator.set_sink(&sink);
    simulator.start();
    begins_with = ids();
    simulator.run_until(std::nullopt);
    if (simulator.kernel().is_exact()) expect_clean();
  }
  CaliperRun(const CaliperRun&) = delete;
  CaliperRun& operator=(const CaliperRun&) = delete;

  void expect_clean() const {
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    EXPECT_EQ(ledger().rebuilds, 0u);
    EXPECT_FALSE(ledger().corrupt);
    EXPECT_LE(sink.most, 1) << "external events at one instant";
    for (const BoundCheck& bound : simulator.bounds(id)) {
      EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                               << bound.bound.to_string();
    }
  }
  Ids ids() const { return simulator.structure(id).attribute().ids; }
  const StructureLedger& ledger() const { return simulator.ledger(id); }
  // Something is corrupt, or was found wrong by an audit.
  bool noticed() const {
    bool corrupt = false;
    for (StructureId i = 0; i < simulator.structures(); ++i) {
      corrupt = corrupt || simulator.ledger(i).corrupt;
    }
    return corrupt || !simulator.violations().empty();
  }
  // The attribute after each change at an instant, with the time: "0.5: 0 1".
  const std::vector<std::string>& values() const { return sink.values; }
  std::uint64_t count(const std::string& kind) const {
    const auto found = sink.kinds.find(kind);
    return found == sink.kinds.end() ? 0 : found->second;
  }

  class Sink final : public EventSink {
   public:
    explicit Sink(CaliperRun& run) : run_(&run) {}
    void event(const Event& event, Arithmetic& arithmetic) override {
      if (event.structure != run_->id) return;
      const std::string kind(run_->simulator.event_kinds(event.structure)[event.kind]);
      ++kinds[kind];
      lines.push_back(kind);
      for (std::size_t i = 0; i < event.count; ++i) lines.back() += " " + std::to_string(event.ids[i]);
      if (!event.external) return;
      changed_ = arithmetic.describe_now().approximate;
      most = std::max(most, ++at_[run_->simulator.kernel().instant_number()]);
    }
    void instant_ended() override {
      if (changed_.empty()) return;
      history.emplace_back(changed_, run_->ids());
      std::string value = changed_ + ":";
      for (const ObjectId object : run_->ids()) value += " " + std::to_string(object);
      values.push_back(std::move(value));
      changed_.clear();
    }
    std::vector<std::string> lines, values;
    std::vector<std::pair<std::string, Ids>> history;  // `values` as data
    std::map<std::string, std::uint64_t> kinds;
    int most = 0;

   private:
    CaliperRun* run_;
    std::map<std::uint64_t, int> at_;
    std::string changed_;
  };

  Scene scene;
  Simulator simulator;
  StructureId id;
  Sink sink;
  Ids begins_with;
};

inline Rational quotient(std::int64_t a, std::int64_t b) { return Rational(Integer(a), Integer(b)); }

// The point of the unit circle at the angle 2 atan q.
inline std::pair<Rational, Rational> at_half_angle(const Rational& q) {
  const Rational all = Rational(1) + q * q;
  return {(Rational(1) - q * q) / all, Rational(2) * q / all};
}

// n points at rest and m on tangents of the same circle: nm - 1 changes of the diameter.
inline Scene vernier(int n, int m) {
  const std::int64_t d = std::int64_t{m} * n * n;
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    const auto [x, y] = at_half_angle(quotient(i, d));
    t.push_back(path({{-x}, {-y}}));
  }
  for (int j = 0; j < m; ++j) {
    const auto [x, y] = at_half_angle(quotient(-j * n, d));
    t.push_back(path({{x, -y}, {y, x}}));
  }
  return scene_of(t, -1000000, Rational(1000000));
}

// The points at rest turned by 90 degrees: their edges become perpendicular to those of the moving
// points, as they become antiparallel in the scene as it is.
inline Scene vernier_turned(int n, int m) {
  Scene scene = vernier(n, m);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    auto& axes = scene.objects[i].motion.pieces[0].trajectory.coordinates;
    const Rational x = axes[0][0];
    axes[0] = {-axes[1][0]};
    axes[1] = {x};
  }
  return scene;
}

// n tips pass below m edges: 2nm - n - m changes of the width and of both rectangles.
inline Scene comb(int n, int m) {
  const std::int64_t end = std::int64_t{n} * (m - 1);
  const Rational g = quotient(1, 100 * end * end), s = g / Rational(100000 * m);
  std::vector<Trajectory> t;
  for (int j = 0; j <= m; ++j) t.push_back(path({{j}, {s * Rational(j * (m - j))}}));
  t.push_back(path({{-1000}, {quotient(-1, 10)}}));
  t.push_back(path({{1000}, {quotient(-1, 10)}}));
  for (int i = 0; i < n; ++i) {
    const Rational at = quotient((m - 1) * (2 * i + 1), 2);
    t.push_back(path({{quotient(m, 2) - at, 1}, {g * at * at - Rational(1), Rational(-2) * g * at}}));
  }
  return scene_of(t, 0, Rational(end));
}

// Few points with tiny coordinates: ties and meetings everywhere.
inline Scene caliper_lattice(std::uint64_t seed, int degree = 1) {
  Random random(seed);
  const int n = random.between(3, 8), size = random.between(1, 4), speed = random.between(1, 3);
  const bool one_place = random.chance(10);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < 2; ++axis) {
      std::vector<Rational> c{one_place ? 0 : random.between(-size, size)};
      for (int k = 1; k <= degree; ++k) c.emplace_back(random.between(-speed, speed));
      axes.push_back(c);
    }
    t.push_back(path(axes));
  }
  return scene_of(t, one_place ? 0 : -2, Rational(6));
}

}  // namespace kinex::test

#endif

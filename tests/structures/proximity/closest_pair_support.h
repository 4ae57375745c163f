// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of closest_pair_delaunay, each with the triangulation that it reads, and in both exact
// arithmetics.
#ifndef KINEX_TESTS_STRUCTURES_PROXIMITY_CLOSEST_PAIR_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_PROXIMITY_CLOSEST_PAIR_SUPPORT_H

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "structures/plan.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {

inline Scene asking_for_pair(Scene scene) {
  scene.maintain = {{"closest_pair_delaunay", "closest_pair_delaunay", {}}};
  return scene;
}

// A log, and the largest number of external events of one structure at one instant.
class OnceAnInstant final : public EventSink {
 public:
  OnceAnInstant(const Simulator& simulator, StructureId id)
      : log(simulator), simulator_(&simulator), id_(id) {}
  void event(const Event& event, Arithmetic& arithmetic) override {
    log.event(event, arithmetic);
    if (event.structure == id_ && event.external) {
      most = std::max(most, ++count_[simulator_->kernel().instant_number()]);
    }
  }
  LogSink log;
  int most = 0;

 private:
  const Simulator* simulator_;
  StructureId id_;
  std::map<std::uint64_t, int> count_;
};

// In an exact arithmetic audited after every instant, and every bound is checked.
struct PairRun {
  explicit PairRun(const Scene& given, const std::string& arithmetic = "exact")
      : scene(asking_for_pair(given)),
        simulator(scene, make_arithmetic(arithmetic, scene), Trial::options(AuditLevel::kEvents)),
        id(asked_structure(scene)),
        sink(simulator, id) {
    add_structures(simulator, scene);
    simulator.set_sink(&sink);
    simulator.start();
    begins_with = pair();
    simulator.run_until(std::nullopt);
    if (simulator.kernel().is_exact()) expect_clean();
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
  std::vector<ObjectId> pair() const { return simulator.structure(id).attribute().ids; }
  const StructureLedger& ledger() const { return simulator.ledger(id); }
  // Of this structure, without its label.
  std::vector<std::string> lines(bool external) const {
    std::vector<std::string> result;
    const std::string label = simulator.label(id) + " ";
    for (const std::string& line : sink.log.lines) {
      if (line.rfind(label, 0) != 0 || (external && line.back() != '!')) continue;
      result.push_back(line.substr(label.size()));
    }
    return result;
  }

  Scene scene;
  Simulator simulator;
  StructureId id;
  OnceAnInstant sink;
  std::vector<ObjectId> begins_with;
};

}  // namespace kinex::test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one structure over a scene and keeps its event log. A run in `exact` is compared with
// `sturm` when it is over (sturm_twin.h).
#ifndef KINEX_TESTS_STRUCTURES_TEST_RUN_H
#define KINEX_TESTS_STRUCTURES_TEST_RUN_H

#include <gtest/gtest.h>

#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/registry.h"
#include "tests/structures/sturm_twin.h"

namespace kinex::test {

// "kind a b" per event, and the same as data.
class LogSink final : public EventSink {
 public:
  explicit LogSink(const Simulator& simulator) : simulator_(&simulator) {}
  void event(const Event& event, Arithmetic& arithmetic) override {
    recorder.event(event, arithmetic);
    std::string line = simulator_->label(event.structure) + " " +
                       std::string(simulator_->event_kinds(event.structure)[event.kind]);
    for (std::size_t i = 0; i < event.count; ++i) line += " " + std::to_string(event.ids[i]);
    if (event.external) line += " !";
    lines.push_back(std::move(line));
  }
  std::vector<std::string> lines;
  Recorder recorder;

 private:
  const Simulator* simulator_;
};

struct Trial {
  Trial(const Scene& scene, const std::string& structure, const std::string& arithmetic = "exact",
        AuditLevel audit = AuditLevel::kEvents, const Key& key = {})
      : simulator(scene, arithmetic_for(structure, arithmetic, scene), options(audit)),
        sink(simulator),
        request_{structure, structure, key},
        twin_(has_twin(scene, arithmetic)) {
    const StructureId id = simulator.reserve();
    simulator.add(id, make_structure(request_, scene, simulator.kernel(), id), structure);
    if (twin_) sink.recorder.instants = 2 * twin_failures(scene, structure);
    simulator.set_sink(&sink);
    simulator.start();
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial() {
    if (!twin_ || thrown_) return;
    try {
      expect_same_in_sturm(simulator, sink.recorder, request_, changes_);
    } catch (const std::exception& error) {
      ADD_FAILURE() << "in sturm: " << error.what();
    }
  }
  static SimulatorOptions options(AuditLevel audit) {
    SimulatorOptions result;
    result.audit = audit;
    return result;
  }

  Trial& to_end() { return run_until(std::nullopt); }
  Trial& run_until(const std::optional<Rational>& t) {
    thrown_ = true;
    simulator.run_until(t);
    thrown_ = false;
    return *this;
  }
  // For a run that was compared before.
  Trial& without_twin() {
    twin_ = false;
    return *this;
  }
  void insert(const Rational& t, ObjectId object, Trajectory trajectory) {
    changes_.insert(simulator, t, object, std::move(trajectory));
  }
  void erase(const Rational& t, ObjectId object) { changes_.erase(simulator, t, object); }
  const StructureLedger& ledger() const { return simulator.ledger(0); }
  std::vector<ObjectId> ids() const { return simulator.structure(0).attribute().ids; }
  // Exact arithmetics: no violation, every bound holds.
  void expect_clean() const {
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    EXPECT_EQ(ledger().audit_violations, 0u);
    EXPECT_EQ(ledger().rebuilds, 0u);
    EXPECT_FALSE(ledger().corrupt);
    for (const BoundCheck& bound : simulator.bounds(0)) {
      EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                               << bound.bound.to_string();
    }
  }

  Simulator simulator;
  LogSink sink;

 private:
  Request request_;
  OutsideChanges changes_;
  bool twin_;
  bool thrown_ = false;  // by run_until: the run is not over
};

}  // namespace kinex::test

#endif

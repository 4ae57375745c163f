// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one structure over a scene and keeps its event log.
#ifndef KINEX_TESTS_STRUCTURES_TEST_RUN_H
#define KINEX_TESTS_STRUCTURES_TEST_RUN_H

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/simulator.h"
#include "structures/registry.h"

namespace kinex::test {

// "kind a b" per event.
class LogSink final : public EventSink {
 public:
  explicit LogSink(const Simulator& simulator) : simulator_(&simulator) {}
  void event(const Event& event, Arithmetic&) override {
    std::string line = simulator_->label(event.structure) + " " +
                       std::string(simulator_->event_kinds(event.structure)[event.kind]);
    for (std::size_t i = 0; i < event.count; ++i) line += " " + std::to_string(event.ids[i]);
    if (event.external) line += " !";
    lines.push_back(std::move(line));
  }
  std::vector<std::string> lines;

 private:
  const Simulator* simulator_;
};

struct Trial {
  Trial(const Scene& scene, const std::string& structure, const std::string& arithmetic = "exact",
        AuditLevel audit = AuditLevel::kEvents, const Key& key = {})
      : simulator(scene, make_arithmetic(arithmetic, scene), options(audit)), sink(simulator) {
    const StructureId id = simulator.reserve();
    Request request{structure, structure, key};
    simulator.add(id, make_structure(request, scene, simulator.kernel(), id), structure);
    simulator.set_sink(&sink);
    simulator.start();
  }
  static SimulatorOptions options(AuditLevel audit) {
    SimulatorOptions result;
    result.audit = audit;
    return result;
  }

  Trial& to_end() {
    simulator.run_until(std::nullopt);
    return *this;
  }
  const StructureLedger& ledger() const { return simulator.kernel().ledger(0); }
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
};

}  // namespace kinex::test

#endif

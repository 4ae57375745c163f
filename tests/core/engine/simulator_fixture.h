// SPDX-License-Identifier: GPL-3.0-or-later
// For tests of the simulator: a simulator with one plain list, incorrect lists, recorded reports.
#ifndef KINEX_TESTS_CORE_ENGINE_SIMULATOR_FIXTURE_H
#define KINEX_TESTS_CORE_ENGINE_SIMULATOR_FIXTURE_H

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "tests/core/engine/plain_list.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {

using Calls = std::vector<std::string>;

template <class List = PlainList>
struct Fixture {
  explicit Fixture(const Scene& scene, SimulatorOptions options = every(),
                   const std::string& arithmetic = "exact")
      : simulator(scene, make_arithmetic(arithmetic, scene), std::move(options)) {
    auto made = std::make_unique<List>(simulator.kernel(), simulator.reserve());
    list = made.get();
    simulator.add(0, std::move(made), "list");
    simulator.start();
  }
  static SimulatorOptions every() {
    SimulatorOptions options;
    options.audit = AuditLevel::kEvents;
    return options;
  }
  const StructureLedger& ledger() const { return simulator.ledger(0); }
  std::vector<ObjectId> ids() const { return list->attribute().ids; }
  void expect_clean() const { EXPECT_EQ(simulator.violations(), Calls{}); }

  Simulator simulator;
  List* list;
};

// Never swaps its first two objects: claims again that they are in order.
class Stubborn final : public PlainList {
 public:
  using PlainList::PlainList;
  bool learns = true;
  void certificate_failed(CertificateId failed) override {
    kernel_->replace(failed, Query(less_, {order_[0], order_[1]}), 0);
    kernel_->report(id_, 0, {}, false);
  }
  void rebuild() override {
    if (learns) return PlainList::rebuild();
    const std::vector<ObjectId> same = order_;
    PlainList::rebuild();
    order_ = same;
    certify();
  }
};

// Throws at its first failure.
class Fragile final : public PlainList {
 public:
  using PlainList::PlainList;
  void certificate_failed(CertificateId) override { throw std::logic_error("cannot happen"); }
};

// The events that carry a difference: kind, gone, came.
class DifferenceSink final : public EventSink {
 public:
  explicit DifferenceSink(const Simulator& simulator) : simulator_(simulator) {}
  void event(const Event& event, Arithmetic&) override {
    if (!event.has_difference()) return;
    std::string line(simulator_.event_kinds(event.structure)[event.kind]);
    for (const ObjectId id : event.gone) line += " -" + std::to_string(id);
    for (const ObjectId id : event.came) line += " +" + std::to_string(id);
    lines.push_back(line + (event.external ? " !" : ""));
  }
  Calls lines;

 private:
  const Simulator& simulator_;
};

}  // namespace kinex::test

#endif

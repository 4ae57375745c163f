// SPDX-License-Identifier: GPL-3.0-or-later
// Several structures for one attribute in one run, each audited after every instant: they report
// the same changes at the same instants.
#ifndef KINEX_TESTS_STRUCTURES_PROXIMITY_TWIN_RUN_H
#define KINEX_TESTS_STRUCTURES_PROXIMITY_TWIN_RUN_H

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "structures/plan.h"
#include "tests/structures/recorder.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {

// The external events of each structure: the number of the instant, and what it changes.
class ChangesSink final : public EventSink {
 public:
  explicit ChangesSink(const Simulator& simulator) : log(simulator), simulator_(&simulator) {}
  void event(const Event& event, Arithmetic& arithmetic) override {
    log.event(event, arithmetic);
    if (!event.external) return;
    std::string line = std::to_string(simulator_->kernel().instant_number());
    if (event.has_difference()) {
      for (const auto& [sign, ids] : {std::pair(" -", &event.gone), {" +", &event.came}}) {
        for (const ObjectId id : *ids) line += sign + std::to_string(id);
      }
    } else {
      for (std::size_t i = 0; i < event.count; ++i) line += " " + std::to_string(event.ids[i]);
    }
    external[event.structure].push_back(line);
  }
  LogSink log;
  std::map<StructureId, std::vector<std::string>> external;

 private:
  const Simulator* simulator_;
};

struct TwinRun {
  // What there is right after an instant.
  struct Stop {
    std::vector<ObjectId> attribute;
    std::uint64_t external;  // events so far
  };
  // In an exact arithmetic everything is checked when the run is over. It stops at `stops`, which ascend.
  TwinRun(Scene given, std::vector<Request> requests, const std::string& arithmetic = "exact",
          const std::vector<Rational>& stops = {}, AuditLevel audit = AuditLevel::kEvents)
      : scene(asking(std::move(given), std::move(requests))),
        simulator(scene, planned_arithmetic(arithmetic, scene), Trial::options(audit)),
        sink(simulator) {
    add_structures(simulator, scene);
    for (const Request& request : scene.maintain) {
      StructureId id = 0;
      while (simulator.label(id) != request.label) ++id;
      ids.push_back(id);
    }
    simulator.set_sink(&sink);
    simulator.start();
    begins_with = attribute();
    for (const Rational& stop : stops) {
      simulator.run_until(stop);
      at_stops.push_back({attribute(), ledger().external});
    }
    simulator.run_until(std::nullopt);
    if (simulator.kernel().is_exact()) expect_clean();
  }
  static Scene asking(Scene scene, std::vector<Request> requests) {
    for (Request& request : requests) {
      if (request.label.empty()) request.label = request.structure;
    }
    scene.maintain = std::move(requests);
    return scene;
  }
  void expect_clean() const {
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (std::size_t i = 0; i < ids.size(); ++i) {
      EXPECT_EQ(changes(i), changes(0)) << simulator.label(ids[i]);
      EXPECT_EQ(attribute(i), attribute(0)) << simulator.label(ids[i]);
      EXPECT_EQ(ledger(i).rebuilds, 0u);
      for (const BoundCheck& bound : simulator.bounds(ids[i])) {
        EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                                 << bound.bound.to_string();
      }
    }
  }
  const std::vector<std::string>& changes(std::size_t i) const {
    static const std::vector<std::string> kNone;
    const auto found = sink.external.find(ids[i]);
    return found == sink.external.end() ? kNone : found->second;
  }
  const StructureLedger& ledger(std::size_t i = 0) const { return simulator.ledger(ids[i]); }
  std::vector<ObjectId> attribute(std::size_t i = 0) const {
    return simulator.structure(ids[i]).attribute().ids;
  }

  Scene scene;
  Simulator simulator;
  ChangesSink sink;
  std::vector<StructureId> ids;  // of what was asked for, in its order
  std::vector<ObjectId> begins_with;
  std::vector<Stop> at_stops;
};

inline Request ask(std::string structure) {
  Request request;
  request.structure = std::move(structure);
  return request;
}

// The same with a parameter, under a label of its own.
inline Request ask(std::string structure, std::string parameter, int value) {
  Request request = ask(std::move(structure));
  request.label = request.structure + " " + std::to_string(value);
  request.parameters = {{std::move(parameter), Rational(value)}};
  return request;
}

// The external events of one structure, with the exact names of their instants; the run is clean.
inline std::vector<Recorded> external_events(const Scene& given, Request request) {
  class Sink final : public EventSink {
   public:
    explicit Sink(StructureId id) : id_(id) { recorder.instants = 1000000; }
    void event(const Event& event, Arithmetic& arithmetic) override {
      if (event.structure == id_ && event.external) recorder.event(event, arithmetic);
    }
    Recorder recorder;

   private:
    StructureId id_;
  };
  const Scene scene = TwinRun::asking(given, {std::move(request)});
  Simulator simulator(scene, planned_arithmetic("exact", scene),
                      Trial::options(AuditLevel::kEvents));
  Sink sink(asked_structure(scene));
  add_structures(simulator, scene);
  simulator.set_sink(&sink);
  simulator.start();
  simulator.run_until(std::nullopt);
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
  return sink.recorder.events;
}

}  // namespace kinex::test

#endif

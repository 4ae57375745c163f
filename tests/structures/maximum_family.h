// SPDX-License-Identifier: GPL-3.0-or-later
// All structures that maintain one maximum, in one run: what changed it, and at which instants.
#ifndef KINEX_TESTS_STRUCTURES_MAXIMUM_FAMILY_H
#define KINEX_TESTS_STRUCTURES_MAXIMUM_FAMILY_H

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/simulator.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::test {

// The registered structures "maximum_..", or "minimum_..", that can maintain this key in this
// scene.
inline std::vector<std::string> maximum_family(const Scene& scene, const Key& key, bool minimum) {
  std::vector<std::string> names;
  for (const StructureInfo& info : structure_infos()) {
    if (info.name.substr(0, 8) != (minimum ? "minimum_" : "maximum_")) continue;
    if (info.linear && (scene.degree() > 1 || key.kind == Key::Kind::kSquaredDistance)) continue;
    names.emplace_back(info.name);
  }
  return names;
}

// The changes of a maximum, per structure and instant: who was it before the first external event
// of the instant, and who was it after the last. A structure may pass through objects that are
// equal at the instant; where it comes back nothing has changed.
class Changes final : public EventSink {
 public:
  using Change = std::pair<ObjectId, ObjectId>;  // old, new
  explicit Changes(const Simulator& simulator) : simulator_(&simulator) {}
  void event(const Event& event, Arithmetic&) override {
    if (!event.external) return;
    const ObjectId now = simulator_->structure(event.structure).attribute().ids.at(0);
    const auto [place, fresh] = by_structure[event.structure].try_emplace(
        simulator_->ledger().instants, Change{event.ids[0], now});
    if (!fresh) place->second.second = now;
  }
  // The instants are numbered from the start of the run.
  std::map<std::uint64_t, Change> of(StructureId id) const {
    std::map<std::uint64_t, Change> result;
    const auto found = by_structure.find(id);
    if (found == by_structure.end()) return result;
    for (const auto& [instant, change] : found->second) {
      if (change.first != change.second) result.emplace(instant, change);
    }
    return result;
  }

 private:
  const Simulator* simulator_;
  std::map<StructureId, std::map<std::uint64_t, Change>> by_structure;
};

struct FamilyRun {
  FamilyRun(const Scene& base, const Key& key, bool minimum, const std::string& arithmetic,
            AuditLevel audit = AuditLevel::kEvents)
      : scene(base) {
    scene.maintain.clear();
    for (const std::string& name : maximum_family(base, key, minimum)) {
      scene.maintain.push_back({name, name, key});
    }
    SimulatorOptions options;
    options.audit = audit;
    simulator = std::make_unique<Simulator>(scene, make_arithmetic(arithmetic, scene), options);
    add_structures(*simulator, scene);
    changes = std::make_unique<Changes>(*simulator);
    simulator->set_sink(changes.get());
    simulator->start();
  }
  // Those that were asked for: a list that only serves others is none.
  std::vector<StructureId> members() const {
    std::vector<StructureId> result;
    for (StructureId id = 0; id < simulator->structures(); ++id) {
      if (simulator->structure(id).name() != "sorted_list") result.push_back(id);
    }
    return result;
  }
  void expect_agreement() const {
    EXPECT_EQ(simulator->violations(), std::vector<std::string>{});
    const auto expected = changes->of(members().front());
    for (const StructureId id : members()) {
      const std::string& name = simulator->label(id);
      EXPECT_EQ(changes->of(id), expected) << name;
      EXPECT_EQ(simulator->structure(id).attribute(),
                simulator->structure(members().front()).attribute())
          << name;
      EXPECT_EQ(simulator->kernel().ledger(id).rebuilds, 0u) << name;
      for (const BoundCheck& bound : simulator->bounds(id)) {
        EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                                 << bound.bound.to_string();
      }
    }
  }

  Scene scene;
  std::unique_ptr<Simulator> simulator;
  std::unique_ptr<Changes> changes;
};

}  // namespace kinex::test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// All structures that maintain one maximum, in one run: its changes and their instants.
#ifndef KINEX_TESTS_STRUCTURES_MAXIMUM_MAXIMUM_FAMILY_H
#define KINEX_TESTS_STRUCTURES_MAXIMUM_MAXIMUM_FAMILY_H

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::test {

// The registered structures "maximum_..", or "minimum_..", that can maintain this key in this
// scene.
inline std::vector<std::string> maximum_family(const Scene& scene, const Key& key, bool minimum) {
  std::vector<std::string> names;
  for (const StructureInfo& info : structure_infos()) {
    if (info.group != (minimum ? "minimum" : "maximum")) continue;
    if (info.linear() && (scene.degree() > 1 || key.kind == Key::Kind::kSquaredDistance)) continue;
    names.emplace_back(info.name);
  }
  return names;
}

// One external event of a maximum as reported: the number of its instant from the start of the run,
// and its ids.
struct Change {
  std::uint64_t instant = 0;
  ObjectId old = kNoObject, fresh = kNoObject;
  friend bool operator==(const Change&, const Change&) = default;
};

inline void PrintTo(const Change& c, std::ostream* out) {
  *out << c.old << " to " << c.fresh << " at instant " << c.instant;
}

// The external events of each structure, in their order.
class Changes final : public EventSink {
 public:
  explicit Changes(const Simulator& simulator) : simulator_(&simulator) {}
  void event(const Event& event, Arithmetic&) override {
    if (!event.external) return;
    EXPECT_EQ(event.count, 2);
    by_structure_[event.structure].push_back(
        {simulator_->ledger().instants, event.ids[0], event.ids[1]});
  }
  std::vector<Change> of(StructureId id) const {
    const auto found = by_structure_.find(id);
    return found == by_structure_.end() ? std::vector<Change>{} : found->second;
  }

 private:
  const Simulator* simulator_;
  std::map<StructureId, std::vector<Change>> by_structure_;
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
  // The requested structures: a list that is only read by others is none.
  std::vector<StructureId> members() const {
    std::vector<StructureId> result;
    for (StructureId id = 0; id < simulator->structures(); ++id) {
      if (simulator->structure(id).name() != "sorted_list") result.push_back(id);
    }
    return result;
  }
  void expect_agreement() const {
    EXPECT_EQ(simulator->violations(), std::vector<std::string>{});
    const std::vector<Change> expected = changes->of(members().front());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NE(expected[i].old, expected[i].fresh);
      if (i > 0) {
        EXPECT_LT(expected[i - 1].instant, expected[i].instant);
      }
    }
    for (const StructureId id : members()) {
      const std::string& name = simulator->label(id);
      EXPECT_EQ(changes->of(id), expected) << name;
      EXPECT_EQ(simulator->structure(id).attribute(),
                simulator->structure(members().front()).attribute())
          << name;
      EXPECT_EQ(simulator->ledger(id).rebuilds, 0u) << name;
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

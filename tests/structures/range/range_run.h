// SPDX-License-Identifier: GPL-3.0-or-later
// A run of all trees for range search over one scene, replayed and audited after every instant, and
// queries that compare their answers.
#ifndef KINEX_TESTS_STRUCTURES_RANGE_RANGE_RUN_H
#define KINEX_TESTS_STRUCTURES_RANGE_RANGE_RUN_H

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "structures/range/range_structure.h"
#include "structures/range/static_range_audit.h"
#include "tests/structures/event_replay.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {

inline std::vector<Request> all_trees() {
  const auto pseudo = [](const char* label, const Rational& delta) {
    return Request{"pseudo_kd_tree_2", label, {}, {}, {{"delta", delta}}};
  };
  return {{"range_tree_2", "range_tree_2", {}},
          {"rank_kd_tree_2", "rank_kd_tree_2", {}},
          pseudo("median", Rational(0)),
          pseudo("pseudo", Rational(Integer(1), Integer(4))),
          pseudo("loose", Rational(Integer(49), Integer(100)))};
}

class RangeRun {
 public:
  explicit RangeRun(Scene given, const std::string& arithmetic = "exact",
                    AuditLevel audit = AuditLevel::kEvents,
                    std::vector<Request> requests = all_trees())
      : scene_(with(std::move(given), std::move(requests))),
        simulator(scene_, planned_arithmetic(arithmetic, scene_), options(audit)),
        replay(simulator) {
    replay.add_structures(scene_);
    simulator.set_sink(&replay);
    simulator.start();
  }
  static Scene with(Scene scene, std::vector<Request> requests) {
    scene.maintain = std::move(requests);
    return scene;
  }
  static SimulatorOptions options(AuditLevel audit) {
    SimulatorOptions result;
    result.audit = audit;
    return result;
  }
  StructureId id_of(const std::string& label) const {
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      if (simulator.label(id) == label) return id;
    }
    ADD_FAILURE() << "no " << label;
    return 0;
  }
  const StructureLedger& ledger(const std::string& label) const {
    return simulator.ledger(id_of(label));
  }
  std::vector<ObjectId> ids(const std::string& label) const {
    return simulator.structure(id_of(label)).attribute().ids;
  }
  void expect_clean() const {
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      EXPECT_EQ(simulator.ledger(id).rebuilds, 0u);
      for (const BoundCheck& bound : simulator.bounds(id)) {
        EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                                 << bound.bound.to_string();
      }
    }
  }
  RangeRun& run_until(const std::optional<Rational>& t) {
    simulator.run_until(t);
    return *this;
  }

 private:
  Scene scene_;

 public:
  Simulator simulator;
  EventReplay replay;
};

// The same structures without decorators, to be searched.
class SearchedRun {
 public:
  explicit SearchedRun(Scene given, const std::string& arithmetic = "exact",
                       std::vector<Request> requests = all_trees())
      : scene_(RangeRun::with(std::move(given), std::move(requests))),
        simulator(scene_, planned_arithmetic(arithmetic, scene_), {}) {
    ::kinex::add_structures(simulator, scene_);
    simulator.start();
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      if (auto* tree = dynamic_cast<RangeSearch*>(&simulator.structure(id))) trees.push_back(tree);
    }
    low_ = simulator.kernel().constant("low", {Rational(0), Rational(0)});
    high_ = simulator.kernel().constant("high", {Rational(0), Rational(0)});
  }
  // The answer of every tree, ascending.
  std::vector<std::vector<ObjectId>> answers(const ExactBox& box) {
    Kernel& kernel = simulator.kernel();
    kernel.redefine(low_, "low", {box[0][0], box[1][0]});
    kernel.redefine(high_, "high", {box[0][1], box[1][1]});
    std::vector<std::vector<ObjectId>> result;
    counts.assign(trees.size(), {});
    for (std::size_t i = 0; i < trees.size(); ++i) {
      trees[i]->report(low_, high_, result.emplace_back(), counts[i]);
      std::sort(result.back().begin(), result.back().end());
    }
    return result;
  }
  // Every tree finds the points that are in the box right after the time reached. If no point is
  // about to leave it or to enter it, a scan of the positions finds them, too, and CGAL.
  void expect_right(const ExactBox& box) {
    const Snapshot now = simulator.snapshot(simulator.reached());
    std::vector<ObjectId> expected;
    for (ObjectId id = 0; id < now.objects(); ++id) {
      if (now.alive(id) && is_inside_after(id, box)) expected.push_back(id);
    }
    const std::vector<ObjectId> scanned = scanned_range(now, box);
    if (!(box[0][1] < box[0][0]) && !(box[1][1] < box[1][0])) {
      EXPECT_EQ(cgal_range(now, box), scanned);
    }
    // A point that is in a closed box right after now is in it now.
    EXPECT_TRUE(std::includes(scanned.begin(), scanned.end(), expected.begin(), expected.end()));
    stayed += scanned == expected ? 1 : 0;
    for (const std::vector<ObjectId>& found : answers(box)) {
      EXPECT_EQ(found, expected) << "at " << simulator.reached().to_string();
    }
  }
  void expect_bounds() const {
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      for (const BoundCheck& bound : simulator.bounds(id)) {
        EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                                 << bound.bound.to_string();
      }
    }
  }

  std::uint64_t stayed = 0;  // boxes that no point was about to leave

 private:
  // By the first derivative of the difference that is not zero.
  bool is_inside_after(ObjectId id, const ExactBox& box) const {
    const Trajectory& path = simulator.kernel().derived().trajectory(id);
    for (const std::size_t axis : {0, 1}) {
      for (const bool is_high : {false, true}) {
        std::vector<Rational> f = path.coordinates[axis];
        f[0] -= box[axis][is_high ? 1 : 0];
        for (; !f.empty(); f = derivative(f)) {
          Rational value;
          for (std::size_t k = f.size(); k-- > 0;) value = value * simulator.reached() + f[k];
          if (value.is_zero()) continue;
          if ((value < Rational(0)) != is_high) return false;
          break;
        }
      }
    }
    return true;
  }
  static std::vector<Rational> derivative(const std::vector<Rational>& f) {
    std::vector<Rational> result;
    for (std::size_t k = 1; k < f.size(); ++k) {
      result.push_back(f[k] * Rational(static_cast<std::int64_t>(k)));
    }
    return result;
  }

  Scene scene_;
  ObjectId low_ = kNoObject, high_ = kNoObject;

 public:
  Simulator simulator;
  std::vector<RangeSearch*> trees;
  std::vector<QueryCounts> counts;  // of the last answers
};

}  // namespace kinex::test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and runs for the tests of Delaunay3.
#ifndef KINEX_TESTS_STRUCTURES_TRIANGULATION_DELAUNAY_3_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_TRIANGULATION_DELAUNAY_3_SUPPORT_H

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "structures/triangulation/delaunay_3.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/recorder.h"
#include "tests/structures/test_scenes.h"

namespace kinex::delaunay_3_test {

using test::Recorder;

using Coefficients = std::vector<Rational>;

inline Trajectory moving(Coefficients x, Coefficients y, Coefficients z) {
  return test::path({std::move(x), std::move(y), std::move(z)});
}
inline Trajectory integers(std::array<std::int64_t, 3> at, std::array<std::int64_t, 3> velocity) {
  return moving({Rational(at[0]), Rational(velocity[0])}, {Rational(at[1]), Rational(velocity[1])},
                {Rational(at[2]), Rational(velocity[2])});
}

// One run of one scene with this structure alone. It is audited after every event by default. The
// cells are replayed from the external events and compared with the structure's at every instant.
class World {
 public:
  explicit World(const Scene& scene, const std::string& arithmetic = "exact",
                 AuditLevel audit = AuditLevel::kEvents)
      : scene_(scene),
        simulator_(scene_, make_arithmetic(arithmetic, scene_), options(audit)),
        replay_(*this) {
    simulator_.set_sink(&replay_);
    id_ = simulator_.reserve();
    auto structure = std::make_unique<Delaunay3>(simulator_.kernel(), id_, scene_);
    structure_ = structure.get();
    simulator_.add(id_, std::move(structure), "delaunay_3");
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  World& run() { return run_until(*scene_.end); }
  World& start() {
    simulator_.start();
    started_ = true;
    replay_.begin();
    return *this;
  }
  World& run_until(const Rational& t) {
    if (!started_) start();
    status = simulator_.run_until(t);
    return *this;
  }
  void expect_clean() {
    EXPECT_EQ(status, RunStatus::kDone);
    EXPECT_EQ(simulator_.violations(), std::vector<std::string>{});
    EXPECT_FALSE(ledger().corrupt) << ledger().corruption;
    EXPECT_EQ(replay_.wrong, "");
    for (const BoundCheck& b : simulator_.bounds(id_)) {
      EXPECT_TRUE(b.holds) << b.id << " " << b.observed.to_string() << " / " << b.bound.to_string();
    }
  }
  std::uint64_t count(const std::string& kind) const {
    const auto it = ledger().by_kind.find(kind);
    return it == ledger().by_kind.end() ? 0 : it->second;
  }
  const StructureLedger& ledger() const { return simulator_.ledger(id_); }
  const Delaunay3& structure() const { return *structure_; }
  Simulator& simulator() { return simulator_; }
  std::vector<ObjectId> cells() const { return structure_->attribute().ids; }
  const std::vector<std::string>& lines() const { return replay_.lines; }
  // For each "retile" and rebuild that changed cells: cells that left, cells that joined.
  const std::vector<std::pair<std::size_t, std::size_t>>& retiled() const {
    return replay_.retiled;
  }

  RunStatus status = RunStatus::kDone;

 private:
  using Cell = std::array<ObjectId, 4>;

  class Replay final : public EventSink {
   public:
    explicit Replay(World& world) : world_(&world) {}
    void begin() {
      begun_ = true;
      cells_.clear();
      const std::vector<ObjectId> ids = world_->cells();
      for (std::size_t i = 0; i < ids.size(); i += 4)
        cells_.insert({ids[i], ids[i + 1], ids[i + 2], ids[i + 3]});
    }
    void event(const Event& event, Arithmetic&) override {
      const std::string kind(world_->simulator_.event_kinds(event.structure)[event.kind]);
      std::string line = kind;
      for (std::size_t i = 0; i < event.count; ++i) line += " " + std::to_string(event.ids[i]);
      if (event.external) line += " !";
      lines.push_back(line);
      if (kind == "insert" || kind == "erase") reread_ = true;
      if (!event.external) return;
      const auto& v = event.ids;
      if (event.has_difference()) {
        for (std::size_t i = 0; i < event.gone.size(); i += 4)
          go({event.gone[i], event.gone[i + 1], event.gone[i + 2], event.gone[i + 3]});
        for (std::size_t i = 0; i < event.came.size(); i += 4)
          come({event.came[i], event.came[i + 1], event.came[i + 2], event.came[i + 3]});
        retiled.emplace_back(event.gone.size() / 4, event.came.size() / 4);
      } else if (kind == "flip_2_3" || kind == "flip_3_2") {
        const bool joins = kind == "flip_2_3";
        for (const ObjectId end : {v[0], v[1]}) change(!joins, {end, v[2], v[3], v[4]});
        for (const auto& [a, b] :
             {std::pair(v[2], v[3]), std::pair(v[3], v[4]), std::pair(v[2], v[4])}) {
          change(joins, {v[0], v[1], a, b});
        }
      } else {
        change(kind == "leave" || kind == "hull_2_3", {v[0], v[1], v[2], v[3]});
      }
    }
    void instant_ended() override {
      if (!begun_) return;  // the start
      if (reread_) begin();
      reread_ = false;
      std::vector<ObjectId> ids;
      for (const Cell& cell : cells_) ids.insert(ids.end(), cell.begin(), cell.end());
      if (ids != world_->cells() && wrong.empty())
        wrong = "events lead to other cells, after " + (lines.empty() ? "" : lines.back());
    }
    std::vector<std::string> lines;
    std::vector<std::pair<std::size_t, std::size_t>> retiled;
    std::string wrong;

   private:
    void change(bool joins, const Cell& cell) { joins ? come(cell) : go(cell); }
    void come(Cell cell) {
      std::sort(cell.begin(), cell.end());
      if (!cells_.insert(cell).second && !reread_) wrong += "a cell came twice; ";
    }
    void go(Cell cell) {
      std::sort(cell.begin(), cell.end());
      if (cells_.erase(cell) == 0 && !reread_) wrong += "a cell went that was not there; ";
    }
    World* world_;
    std::set<Cell> cells_;
    bool begun_ = false;
    bool reread_ = false;  // an object came or went at this instant
  };

  static SimulatorOptions options(AuditLevel audit) {
    SimulatorOptions result;
    result.audit = audit;
    result.max_events = 1000000;
    return result;
  }

  Scene scene_;
  Simulator simulator_;
  Replay replay_;
  StructureId id_ = 0;
  Delaunay3* structure_ = nullptr;
  bool started_ = false;
};

// The cells that the static algorithm finds at time t.
inline std::vector<ObjectId> static_cells(Scene scene, const Rational& t) {
  scene.start = t;
  scene.end = t + Rational(1);
  World world(scene, "exact", AuditLevel::kNone);
  world.start();
  return world.cells();
}

}  // namespace kinex::delaunay_3_test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Near storms all year round (storms_test.cpp): the closest pair, the Euclidean spanning tree and the
// Delaunay triangulation on positions of tenths of a degree, where storms meet and turn at once.
// Structures of one attribute must report the same changes at the same instants, CGAL's
// triangulation and the structures' own audits must agree between the fixes, and the pair and the
// tree must be those of the table.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/formats/scene_reader.h"
#include "structures/plan.h"
#include "tests/program/spawn.h"
#include "tests/program/storm_witness.h"
#include "tests/shared_data.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace storm_proximity_test {

constexpr int kStops = 60;
constexpr std::int64_t kHour = Storms::kUnits;

// What external events change, by structure, with the number of the instant.
class Changes final : public EventSink {
 public:
  explicit Changes(const Simulator& simulator) : simulator_(&simulator) {}
  void event(const Event& event, Arithmetic&) override {
    if (!event.external) return;
    std::string line = std::to_string(simulator_->kernel().instant_number());
    if (event.has_difference()) {
      for (const auto& [sign, ids] : {std::pair(" -", &event.gone), {" +", &event.came}}) {
        for (const ObjectId id : *ids) line += sign + std::to_string(id);
      }
    } else {
      for (std::size_t i = 0; i < event.count; ++i) line += " " + std::to_string(event.ids[i]);
    }
    lines[event.structure].push_back(std::move(line));
  }
  std::map<StructureId, std::vector<std::string>> lines;

 private:
  const Simulator* simulator_;
};

class StormProximity : public testing::Test {
 protected:
  void SetUp() override {
    KINEX_REQUIRE_DATA(table_);
    const ScratchFolder scratch;
    const std::string file = scratch.file("storms.json");
    const Finished made = run_kinex({"import", table_, "-o", file});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    scene_ = formats::read_scene(file);
    storms_.emplace(table_);
  }

  // Runs all of them through the year, and stops between fixes: audits, and the witness's complaint
  // about the first one's pairs of storms.
  template <class Complaint>
  void expect_year(const std::vector<std::string>& structures, const Complaint& complaint,
                   std::size_t fewest_changes) {
    scene_.maintain.clear();
    for (const std::string& name : structures) scene_.maintain.push_back({name, name, {}});
    Simulator simulator(scene_, planned_arithmetic("exact", scene_),
                        Trial::options(AuditLevel::kEnd));
    add_structures(simulator, scene_);
    std::vector<StructureId> ids;
    for (const std::string& name : structures) {
      StructureId id = 0;
      while (simulator.label(id) != name) ++id;
      ids.push_back(id);
    }
    Changes changes(simulator);
    simulator.set_sink(&changes);
    simulator.start();
    std::size_t most = 0;
    for (int i = 1; i < kStops; ++i) {
      const std::int64_t about =
          storms_->start() + (storms_->end() - storms_->start()) / kStops * i;
      const std::int64_t time = about / (6 * kHour) * (6 * kHour) + 2 * kHour + kHour / 7;
      simulator.run_until(Rational(Integer(time), Integer(Storms::kUnits)));
      EXPECT_TRUE(simulator.audit());
      std::vector<std::pair<std::string, std::string>> pairs;
      const std::vector<ObjectId> told = simulator.structure(ids[0]).attribute().ids;
      for (std::size_t k = 0; k + 1 < told.size(); k += 2) {
        pairs.emplace_back(scene_.objects[told[k]].id, scene_.objects[told[k + 1]].id);
      }
      if (storms_->alive_count(time) < 2) continue;
      EXPECT_EQ(complaint(time, pairs), "") << time;
      most = std::max(most, storms_->alive_count(time));
    }
    EXPECT_GT(most, 100u);  // not all stops are in the quiet months
    simulator.run_until(std::nullopt);
    EXPECT_TRUE(simulator.audit());
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    const std::vector<std::string>& first = changes.lines[ids[0]];
    EXPECT_GT(first.size(), fewest_changes);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      EXPECT_EQ(changes.lines[ids[i]], first) << structures[i];
      for (const BoundCheck& bound : simulator.bounds(ids[i])) EXPECT_TRUE(bound.holds) << bound.id;
    }
    std::printf("%s: %zu changes, %llu events\n", structures[0].c_str(), first.size(),
                static_cast<unsigned long long>(simulator.ledger().events));
  }

  using Pairs = std::vector<std::pair<std::string, std::string>>;
  const std::string table_ = shared_data("hurricanes.csv");
  Scene scene_;
  std::optional<Storms> storms_;
};

TEST_F(StormProximity, TheClosestPairIsThatOfTheTable) {
  expect_year(
      {"closest_pair_local", "closest_pair_delaunay"},
      [this](std::int64_t time, const Pairs& pairs) {
        return pairs.size() != 1 ? "no pair" : storms_->closest_pair_complaint(time, pairs[0]);
      },
      1000);
}

TEST_F(StormProximity, TheTreeIsThatOfTheTable) {
  expect_year(
      {"emst_list", "emst_cycles"},
      [this](std::int64_t time, const Pairs& pairs) { return storms_->tree_complaint(time, pairs); },
      10000);
}

}  // namespace storm_proximity_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
// The convex hull of a year of storms (storms_test.cpp): tenths of a degree, so that points meet,
// stand on one line and turn at once. All methods must report the same changes at the same
// instants, and an independent hull must agree all year round.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/scene_reader.h"
#include "tests/program/spawn.h"
#include "tests/shared_data.h"
#include "tests/structures/hull/hull_support.h"

namespace kinex::test {
namespace storm_hulls_test {

constexpr int kStops = 200;

struct Year {
  std::vector<Recorded> events;  // external, in order, with their instants
  std::vector<std::vector<ObjectId>> hulls;
  std::uint64_t counted = 0;
  std::size_t largest = 0;
};

// Audited at so many times between the six-hour marks; with invariants and all certificates.
Year run_year(Scene scene, const std::string& structure) {
  scene.maintain = {{structure, structure, {}}};
  Simulator simulator(scene, make_arithmetic("exact", scene), Trial::options(AuditLevel::kEnd));
  add_structures(simulator, scene);
  const StructureId id = asked_structure(scene);
  HullSink sink(id);
  simulator.set_sink(&sink);
  simulator.start();
  Year year;
  const Rational step = (*scene.end - scene.start) * Rational(Integer(1), Integer(kStops + 1));
  for (int i = 1; i <= kStops; ++i) {
    simulator.run_until(scene.start + step * Rational(i));
    simulator.audit();
    year.hulls.push_back(simulator.structure(id).attribute().ids);
    year.largest = std::max(year.largest, year.hulls.back().size());
  }
  simulator.run_until(std::nullopt);
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{}) << structure;
  for (StructureId s = 0; s < simulator.structures(); ++s) {
    EXPECT_FALSE(simulator.ledger(s).corrupt) << structure;
    for (const BoundCheck& b : simulator.bounds(s)) EXPECT_TRUE(b.holds) << b.id;
  }
  year.events = std::move(sink.recorder.events);
  year.counted = simulator.ledger(id).external;
  return year;
}

TEST(StormHulls, AllMethodsReportTheSameChanges) {
  const std::string table = shared_data("hurricanes.csv");
  KINEX_REQUIRE_DATA(table);
  const ScratchFolder scratch;
  const std::string file = scratch.file("storms.json");
  const Finished made = run_kinex({"import", table, "-o", file});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Scene scene = formats::read_scene(file);
  const Year year = run_year(scene, kHulls[0]);
  EXPECT_GT(year.events.size(), 500u);
  EXPECT_GE(year.largest, 5u);
  EXPECT_EQ(year.counted, year.events.size());
  for (const std::string& other : {kHulls[1], kHulls[2], kHulls[3]}) {
    SCOPED_TRACE(other);
    const Year again = run_year(scene, other);
    EXPECT_EQ(again.counted, again.events.size());
    EXPECT_EQ(again.hulls, year.hulls);
    expect_same_events(year.events, again.events);
  }
}

}  // namespace storm_hulls_test
}  // namespace kinex::test

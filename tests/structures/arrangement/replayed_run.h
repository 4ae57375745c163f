// SPDX-License-Identifier: GPL-3.0-or-later
// ReplayedRun: a whole run of one structure that is audited and replayed at every instant.
#ifndef KINEX_TESTS_STRUCTURES_ARRANGEMENT_REPLAYED_RUN_H
#define KINEX_TESTS_STRUCTURES_ARRANGEMENT_REPLAYED_RUN_H

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/structures/event_replay.h"
#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {

struct ReplayedRun {
  // `rebuild_seed`: structures are rebuilt instead of repaired now and then; 0: never.
  ReplayedRun(const Scene& given, const std::string& structure, std::uint64_t rebuild_seed = 0)
      : scene(TwinRun::asking(given, {ask(structure)})),
        simulator(scene, planned_arithmetic("exact", scene), Trial::options(AuditLevel::kEvents)),
        replay(simulator) {
    if (rebuild_seed != 0) replay.rebuild_at_random(rebuild_seed, 3);
    replay.add_structures(scene);
    while (simulator.label(id) != structure) ++id;
    simulator.set_sink(&replay);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (const BoundCheck& bound : bounds()) {
      EXPECT_TRUE(bound.holds) << bound.id << ": " << bound.observed.to_string() << " > "
                               << bound.bound.to_string();
    }
  }
  std::uint64_t count(const std::string& kind) { return replay.counts[kind]; }
  const StructureLedger& ledger() const { return simulator.ledger(id); }
  std::vector<BoundCheck> bounds() const { return simulator.bounds(id); }

  Scene scene;
  StructureId id = 0;
  Simulator simulator;
  EventReplay replay;
};

}  // namespace kinex::test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of structures/README.md, "Writing a structure", are compiled as they stand there
// (tests/CMakeLists.txt cuts them out); what they expect is what runs of the page's structure count.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "core/engine/simulator.h"
#include "core/engine/structure.h"
#include "experiments/lab/cell_parts.h"
#include "experiments/lab/workload.h"
#include "predicates/predicates.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"

namespace kinex {
namespace written_cells_test {

#include "block_1.inc"
#include "block_3.inc"

TEST(WrittenCells, ExpectWhatIsCounted) {
  lab::Catalogue quick, full;
  add_left_of_first_cells(quick, lab::Extent::kQuick);
  add_left_of_first_cells(full, lab::Extent::kFull);
  EXPECT_EQ(quick.cells.size(), 2u);
  ASSERT_EQ(full.cells.size(), 3u);
  for (const lab::Cell& cell : full.cells) {
    const Scene scene = lab::generate_scene(cell.workload, cell.parameters, "sorted_list");
    Simulator simulator(scene, make_arithmetic("exact", scene), {});
    const StructureId id = simulator.reserve();
    simulator.add(id, std::make_unique<LeftOfFirst>(simulator.kernel(), id, scene), cell.structure);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
    for (const BoundCheck& bound : simulator.bounds(id)) EXPECT_TRUE(bound.holds) << bound.id;
    ASSERT_EQ(cell.expectations.size(), 1u);
    EXPECT_EQ(cell.expectations[0].exact, counted(simulator.ledger(id).external))
        << cell.parameters.n;
  }
}

}  // namespace written_cells_test
}  // namespace kinex

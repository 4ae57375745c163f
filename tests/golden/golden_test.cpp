// SPDX-License-Identifier: GPL-3.0-or-later
// Event logs are the same on every machine, with every compiler and in both exact arithmetics, byte
// by byte: those of the table are reproduced.
//
// A log that is meant to change: KINEX_GOLDEN_WRITE=1 kinex_golden_tests writes the table anew.
// Read the difference before you commit it: every changed line is a changed answer, or a changed
// format.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "experiments/lab/workload.h"
#include "structures/registry.h"
#include "tests/golden/golden_scene.h"

namespace kinex::golden {
namespace golden_test {

constexpr std::size_t kFewestRows = 60;

void expect_rows(const std::string& arithmetic) {
  for (const Row& row : read_table().rows) {
    if (arithmetic == "sturm" && !row.sturm) continue;
    SCOPED_TRACE(row.scene + " in " + arithmetic);
    const Golden found = run(make_scene(row.scene), arithmetic);
    EXPECT_EQ(found.records, row.golden.records);
    EXPECT_EQ(found.digest, row.golden.digest);
    EXPECT_EQ(found.body, row.golden.body);
  }
}

TEST(Golden, ExactReproducesTheTable) {
  const char* write = std::getenv("KINEX_GOLDEN_WRITE");
  if (write != nullptr && std::string(write) == "1") {
    Table table = read_table();
    for (Row& row : table.rows) {
      try {
        row.golden = run(make_scene(row.scene), "exact");
      } catch (const std::exception& error) {
        ADD_FAILURE() << row.scene << ": " << error.what() << "; its row is what it was";
      }
    }
    write_table(table);
    GTEST_SKIP() << table_path() << " has been written anew";
  }
  expect_rows("exact");
}

TEST(Golden, SturmReproducesTheTable) { expect_rows("sturm"); }

// A table that has lost its rows proves nothing.
TEST(Golden, TheTableCoversWhatThereIs) {
  const Table table = read_table();
  EXPECT_GE(table.rows.size(), kFewestRows);
  std::set<std::string> families, structures, keys, degrees, written;
  for (const Row& row : table.rows) {
    EXPECT_TRUE(written.insert(row.scene).second) << row.scene << " is there twice";
    families.insert(row.scene.substr(0, row.scene.find(' ')));
    const Scene scene = make_scene(row.scene);
    degrees.insert(std::to_string(scene.degree()));
    for (const Request& request : scene.maintain) {
      structures.insert(request.structure);
      if (!find_structure_info(request.structure)->uses_key) continue;
      keys.insert(request.structure + std::to_string(static_cast<int>(request.key.kind)));
    }
  }
  const std::vector<StructureInfo>& infos = structure_infos();
  const bool for_bodies = std::any_of(infos.begin(), infos.end(),
                                      [](const StructureInfo& info) { return info.follows_bodies(); });
  for (const lab::Workload& workload : lab::workloads()) {
    if (workload.bodies && !for_bodies) continue;  // nothing maintains them
    EXPECT_EQ(families.count(std::string(workload.name)), 1u) << workload.name;
  }
  for (const StructureInfo& info : structure_infos()) {
    if (info.bodies && !info.follows_bodies()) continue;  // it has no events
    EXPECT_EQ(structures.count(std::string(info.name)), 1u) << info.name;
  }
  std::size_t kinds = 0;  // of keys, for each that has any
  for (const StructureInfo& info : structure_infos()) {
    if (info.uses_key) kinds += info.linear() ? 2 : 3;
  }
  EXPECT_EQ(keys.size(), kinds);
  for (const char* degree : {"1", "2", "3"}) EXPECT_EQ(degrees.count(degree), 1u) << degree;
}

}  // namespace golden_test
}  // namespace kinex::golden

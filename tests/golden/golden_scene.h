// SPDX-License-Identifier: GPL-3.0-or-later
// The table of golden digests, tests/golden/digests.txt: scenes, and the digests of their event
// logs.
#ifndef KINEX_TESTS_GOLDEN_GOLDEN_SCENE_H
#define KINEX_TESTS_GOLDEN_GOLDEN_SCENE_H

#include <cstdint>
#include <string>
#include <vector>

#include "core/motion/scene.h"

namespace kinex::golden {

// The required results of a run.
struct Golden {
  std::uint64_t records = 0;
  std::string digest;  // of what happened, in which order: "log_digest" of `kinex run --summary`
  std::string body;    // SHA-256 of all its records
  friend bool operator==(const Golden&, const Golden&) = default;
};

struct Row {
  std::string scene;  // as it is written in the table
  bool sturm = true;  // compared in the reference arithmetic too
  Golden golden;
};

struct Table {
  std::string head;  // comments at its top
  std::vector<Row> rows;
};

std::string table_path();
// Throws std::runtime_error naming the line for a table that cannot be read.
Table read_table();
void write_table(const Table& table);

// The scene of a row; throws std::runtime_error for one that does not exist.
Scene make_scene(const std::string& description);

Golden run(const Scene& scene, const std::string& arithmetic);

}  // namespace kinex::golden

#endif

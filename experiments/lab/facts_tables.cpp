// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/facts_tables.h"

namespace kinex::lab {

namespace {

constexpr const char* kSchema = R"(
PRAGMA foreign_keys = ON;
CREATE TABLE build(id INTEGER PRIMARY KEY, program TEXT NOT NULL, git_commit TEXT NOT NULL,
  dirty INTEGER NOT NULL, compiler TEXT NOT NULL, flags TEXT NOT NULL,
  libraries TEXT NOT NULL) STRICT;
CREATE TABLE machine(id INTEGER PRIMARY KEY, cpu TEXT NOT NULL, cores INTEGER NOT NULL,
  memory_kb INTEGER NOT NULL, kernel TEXT NOT NULL) STRICT;
)";

}  // namespace

void write_facts(Database& database, const BuildFacts& build, const MachineFacts& machine) {
  database.execute(kSchema);
  Statement builds(database, "INSERT INTO build VALUES(1, ?, ?, ?, ?, ?, ?)");
  builds.text(build.program).text(build.commit).integer(build.dirty).text(build.compiler);
  builds.text(build.flags).text(build.libraries).run();
  Statement machines(database, "INSERT INTO machine VALUES(1, ?, ?, ?, ?)");
  machines.text(machine.cpu).integer(machine.cores).integer(machine.memory_kb);
  machines.text(machine.kernel).run();
}

}  // namespace kinex::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// The tables `build` and `machine` of every database of results, with one row each (id 1).
#ifndef KINEX_EXPERIMENTS_LAB_FACTS_TABLES_H
#define KINEX_EXPERIMENTS_LAB_FACTS_TABLES_H

#include "experiments/lab/machine.h"
#include "experiments/lab/sqlite.h"

namespace kinex::lab {

void write_facts(Database& database, const BuildFacts& build, const MachineFacts& machine);

}  // namespace kinex::lab

#endif

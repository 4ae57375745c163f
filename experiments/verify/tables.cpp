// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/tables.h"

#include <utility>

#include "experiments/lab/family.h"

namespace kinex {

std::vector<Table> measures_tables(const std::vector<CellResult>& cells) {
  std::vector<Table> tables;
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.tables == nullptr) continue;
    for (Table& table : family.tables(cells)) tables.push_back(std::move(table));
  }
  for (Table& table : comparison_tables(cells)) tables.push_back(std::move(table));
  return tables;
}

}  // namespace kinex

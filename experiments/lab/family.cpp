// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/family.h"

#include <utility>

#include "structures/registry.h"

namespace kinex::lab {

const FamilyExperiments* experiments_on(std::string_view structure) {
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.name == family_of(structure)) return &family;
  }
  return nullptr;
}

std::vector<Table> family_tables(const std::vector<CellResult>& cells) {
  std::vector<Table> tables;
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.tables == nullptr) continue;
    for (Table& table : family.tables(cells)) tables.push_back(std::move(table));
  }
  for (Table& table : comparison_tables(cells)) tables.push_back(std::move(table));
  return tables;
}

std::vector<Figure> family_figures(const std::vector<CellResult>& cells) {
  std::vector<Figure> figures;
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.figures == nullptr) continue;
    for (Figure& figure : family.figures(cells)) figures.push_back(std::move(figure));
  }
  return figures;
}

const Thinning* known_thinning() {
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.thinning != nullptr) return family.thinning;
  }
  return nullptr;
}

std::string usual_structure(bool bodies, int dimension) {
  std::string_view found;
  for (const FamilyExperiments& family : experiment_families()) {
    for (const UsualStructure& usual : family.usual) {
      if (usual.bodies != bodies) continue;
      if (usual.dimension == dimension || (usual.dimension == 0 && found.empty())) {
        found = usual.structure;
      }
    }
  }
  return std::string(found);
}

}  // namespace kinex::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/family.h"

#include <algorithm>
#include <stdexcept>
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
    const std::vector<std::string_view>& titles = family.figure_titles;
    for (Figure& figure : family.figures(cells)) {
      if (std::find(titles.begin(), titles.end(), figure.title) == titles.end()) {
        throw std::logic_error("a figure of a title that its family does not list: " + figure.title);
      }
      figures.push_back(std::move(figure));
    }
  }
  return figures;
}

std::vector<std::string> family_figure_titles(const std::vector<Cell>& cells) {
  std::vector<std::string> titles;
  for (const FamilyExperiments& family : experiment_families()) {
    const bool has_cell = std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) {
      return family_of(cell.structure) == family.name;
    });
    if (has_cell) titles.insert(titles.end(), family.figure_titles.begin(), family.figure_titles.end());
  }
  return titles;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/catalogue.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/input_error.h"
#include "experiments/verify/collision_studies.h"
#include "experiments/verify/point_studies.h"

namespace kinex {

namespace {

bool is_group(std::string_view structure) {
  const std::vector<std::string_view> groups = structure_groups();
  return structure == "all" ||
         std::find(groups.begin(), groups.end(), structure) != groups.end();
}

bool is_selected(std::string_view structure, const StructureInfo& info) {
  return structure == "all" || structure == info.name ||
         (!info.group.empty() && structure == info.group);
}

// In the registry's order; those of one structure keep theirs.
template <class Item>
void select(std::vector<Item>& items, std::string_view structure) {
  std::vector<Item> selected;
  for (const StructureInfo& info : structure_infos()) {
    if (!is_selected(structure, info)) continue;
    for (Item& item : items) {
      if (item.structure == info.name) selected.push_back(std::move(item));
    }
  }
  items = std::move(selected);
}

// How many means of a structure are judged under one claim.
void count_comparisons(std::vector<Cell>& cells) {
  std::map<std::pair<std::string, std::string>, int> means;
  for (const bool counting : {true, false}) {
    for (Cell& cell : cells) {
      for (Expectation& expectation : cell.expectations) {
        if (expectation.kind != ExpectationKind::kMean) continue;
        int& count = means[{cell.structure, expectation.claim}];
        if (counting) {
          ++count;
        } else {
          expectation.comparisons = count;
        }
      }
    }
  }
}

}  // namespace

Catalogue make_catalogue(std::string_view structure, Extent extent) {
  if (!is_group(structure) && find_structure_info(structure) == nullptr) {
    std::string names = "all";
    for (const std::string_view group : structure_groups()) names += ", " + std::string(group);
    for (const StructureInfo& info : structure_infos()) names += ", " + std::string(info.name);
    throw InputError("verify", "", show_text(structure) + " is not a structure",
                     "choose one of " + names);
  }
  Catalogue catalogue;
  add_worst_cases(catalogue, extent);
  add_random_motion(catalogue, extent);
  for (const StructureInfo& info : structure_infos()) add_common_cells(catalogue, info, extent);
  add_maximum_comparison(catalogue, extent);
  add_collision_cells(catalogue, extent);
  const bool quick = extent == Extent::kQuick;
  const auto asked = [&](std::string_view group, std::string_view one) {
    return structure == "all" || structure == group || structure == one;
  };
  if (asked("maximum", "maximum_hanger")) {
    catalogue.studies.push_back({"maximum_hanger", study_hanger, quick});
  }
  if (asked("convex_hull", "convex_hull_2")) {
    catalogue.studies.push_back({"convex_hull_2", study_hull_locality, quick});
  }
  if (asked("collision", "collision")) {
    catalogue.studies.push_back({"contacts", study_contacts, quick});
  }
  if (asked("collision", "outer_hierarchy")) {
    catalogue.studies.push_back({"outer_hierarchy", study_outer_hierarchies, quick});
  }
  if (asked("collision", "inner_tangents")) {
    catalogue.studies.push_back({"inner_tangents", study_tangents, quick});
  }
  if (asked("collision", "separation_hysteresis")) {
    catalogue.studies.push_back({"wedge_cover", study_wedge_cover, quick});
  }
  select(catalogue.cells, structure);
  count_comparisons(catalogue.cells);
  select(catalogue.growths, structure);
  return catalogue;
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/catalogue.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/input_error.h"
#include "experiments/formats/near_names.h"
#include "experiments/lab/family.h"
#include "structures/registry.h"

namespace kinex::verify {

namespace {

bool is_group(std::string_view structure) {
  const std::vector<std::string_view> groups = structure_groups();
  return structure == "all" || std::find(groups.begin(), groups.end(), structure) != groups.end();
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
void count_comparisons(std::vector<lab::Cell>& cells) {
  std::map<std::pair<std::string, std::string>, int> means;
  for (const bool counting : {true, false}) {
    for (lab::Cell& cell : cells) {
      for (lab::Expectation& expectation : cell.expectations) {
        if (expectation.kind != lab::ExpectationKind::kMean) continue;
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

// How many cells the family of a growth claim has.
void count_sizes(lab::Catalogue& catalogue) {
  for (lab::GrowthClaim& growth : catalogue.growths) {
    growth.sizes = static_cast<std::size_t>(
        std::count_if(catalogue.cells.begin(), catalogue.cells.end(), [&](const lab::Cell& cell) {
          return cell.structure == growth.structure && cell.family == growth.family;
        }));
  }
}

}  // namespace

lab::Catalogue make_catalogue(std::string_view structure, lab::Extent extent) {
  if (!is_group(structure) && find_structure_info(structure) == nullptr) {
    std::vector<std::string> known{"all"};
    for (const std::string_view group : structure_groups()) known.emplace_back(group);
    for (const StructureInfo& info : structure_infos()) known.emplace_back(info.name);
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
    throw formats::InputError("verify", "", show_text(structure) + " is not a structure",
                              formats::did_you_mean(structure, known, "choose one of " + names));
  }
  lab::Catalogue catalogue;
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    if (family.add_cells != nullptr) family.add_cells(catalogue, extent);
  }
  for (const StructureInfo& info : structure_infos()) {
    for (const lab::FamilyExperiments& family : lab::experiment_families()) {
      if (family.add_common_cells != nullptr) family.add_common_cells(catalogue, info, extent);
    }
  }
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    if (family.add_comparisons != nullptr) family.add_comparisons(catalogue, extent);
    for (const lab::FamilyStudy& study : family.studies) {
      if (structure != "all" && structure != study.group && structure != study.structure) continue;
      catalogue.studies.push_back({std::string(study.name), study.run, extent == lab::Extent::kQuick});
    }
  }
  select(catalogue.cells, structure);
  count_comparisons(catalogue.cells);
  select(catalogue.growths, structure);
  count_sizes(catalogue);
  return catalogue;
}

}  // namespace kinex::verify

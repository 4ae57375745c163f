// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/catalogue.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/lab/family.h"
#include "structures/registry.h"

namespace kinex::verify {

namespace {

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_collective(std::string_view structure) {
  return structure == "all" || contains(structure_groups(), structure) ||
         contains(family_names(), structure);
}

bool is_selected(std::string_view structure, const StructureInfo& info) {
  if (structure == "all" || structure == info.name) return true;
  if (contains(structure_groups(), structure)) return structure == info.group;
  return structure == family_of(info.name);
}

// Whether some structure of the family is selected. The cells of others need not be made: that takes
// milliseconds, in every child process.
bool has_selected(const lab::FamilyExperiments& family, std::string_view structure) {
  const std::vector<StructureInfo>& infos = structure_infos();
  return std::any_of(infos.begin(), infos.end(), [&](const StructureInfo& info) {
    return is_selected(structure, info) && family_of(info.name) == family.name;
  });
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

// How many cells the family of a growth claim has, here and in the full experiments.
void count_sizes(lab::Catalogue& catalogue, const std::vector<lab::Cell>& full) {
  const auto count = [](const std::vector<lab::Cell>& cells, const lab::GrowthClaim& growth) {
    return static_cast<std::size_t>(
        std::count_if(cells.begin(), cells.end(), [&](const lab::Cell& cell) {
          return cell.structure == growth.structure && cell.family == growth.family;
        }));
  };
  for (lab::GrowthClaim& growth : catalogue.growths) {
    growth.sizes = count(catalogue.cells, growth);
    growth.full_sizes = count(full, growth);
  }
}

}  // namespace

std::vector<std::string_view> family_names() {
  const std::vector<std::string_view> groups = structure_groups();
  std::vector<std::string_view> names;
  for (const StructureInfo& info : structure_infos()) {
    const std::string_view family = family_of(info.name);
    if (!contains(groups, family) && !contains(names, family)) names.push_back(family);
  }
  return names;
}

lab::Catalogue make_catalogue(std::string_view structure, lab::Extent extent) {
  if (!is_collective(structure) && find_structure_info(structure) == nullptr) {
    std::vector<std::string> known{"all"};
    for (const std::string_view group : structure_groups()) known.emplace_back(group);
    for (const std::string_view family : family_names()) known.emplace_back(family);
    for (const StructureInfo& info : structure_infos()) known.emplace_back(info.name);
    throw formats::InputError(
        "verify", "", show_text(structure) + " is not a structure",
        did_you_mean(structure, known, "kinex list structures names them; or write all"));
  }
  lab::Catalogue catalogue;
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    if (family.add_cells != nullptr && has_selected(family, structure)) {
      family.add_cells(catalogue, extent);
    }
  }
  for (const StructureInfo& info : structure_infos()) {
    if (!is_selected(structure, info)) continue;
    for (const lab::FamilyExperiments& family : lab::experiment_families()) {
      if (family.add_common_cells != nullptr) family.add_common_cells(catalogue, info, extent);
    }
  }
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    if (family.add_comparisons != nullptr) family.add_comparisons(catalogue, extent);
    for (const lab::FamilyStudy& study : family.studies) {
      const bool of_family = structure == family.name && !contains(structure_groups(), structure);
      if (structure != "all" && structure != study.group && structure != study.structure &&
          !of_family) {
        continue;
      }
      catalogue.studies.push_back({std::string(study.name), study.run, extent == lab::Extent::kQuick});
    }
  }
  select(catalogue.cells, structure);
  count_comparisons(catalogue.cells);
  select(catalogue.growths, structure);
  const bool is_part = extent == lab::Extent::kQuick && !catalogue.growths.empty();
  count_sizes(catalogue,
              is_part ? make_catalogue(structure, lab::Extent::kFull).cells : catalogue.cells);
  return catalogue;
}

}  // namespace kinex::verify

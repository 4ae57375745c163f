// SPDX-License-Identifier: GPL-3.0-or-later
// The families of structures, in one line each.
#ifndef KINEX_STRUCTURES_FAMILY_SUMMARY_H
#define KINEX_STRUCTURES_FAMILY_SUMMARY_H

#include <string_view>
#include <vector>

namespace kinex {

// A family by its name, as kinex list names it, and in one line.
struct FamilySummary {
  std::string_view name;
  std::string_view summary;  // what its structures maintain, without a full stop
};

// In the order of structure_infos().
std::vector<FamilySummary> family_summaries();

}  // namespace kinex

#endif

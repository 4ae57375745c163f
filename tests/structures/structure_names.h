// SPDX-License-Identifier: GPL-3.0-or-later
// The names of registered structures, by what their descriptors say: tests of a group take a new
// member without being told.
#ifndef KINEX_TESTS_STRUCTURES_STRUCTURE_NAMES_H
#define KINEX_TESTS_STRUCTURES_STRUCTURE_NAMES_H

#include <string>
#include <string_view>
#include <vector>

#include "structures/registry.h"

namespace kinex::test {

// Those for whose descriptors `fits` holds, as they are listed.
template <class Fits>
std::vector<std::string> structures_where(const Fits& fits) {
  std::vector<std::string> names;
  for (const StructureInfo& info : structure_infos()) {
    if (fits(info)) names.emplace_back(info.name);
  }
  return names;
}

inline std::vector<std::string> structures_of_group(std::string_view group) {
  return structures_where([group](const StructureInfo& info) { return info.group == group; });
}

// All methods for the hull of all points: they have one history.
inline const std::vector<std::string> kHulls = structures_of_group("convex_hull");

}  // namespace kinex::test

#endif

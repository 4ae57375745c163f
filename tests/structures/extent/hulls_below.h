// SPDX-License-Identifier: GPL-3.0-or-later
// The hulls that structures of the extent family can read, by name; "directions_2:3" has k = 3.
#ifndef KINEX_TESTS_STRUCTURES_EXTENT_HULLS_BELOW_H
#define KINEX_TESTS_STRUCTURES_EXTENT_HULLS_BELOW_H

#include <string>
#include <vector>

#include "structures/registry.h"
#include "tests/structures/structure_names.h"

namespace kinex::test {

// To a proven error, which audits check: readers have one history for each k.
inline const std::vector<std::vector<std::string>> kHullsOfDirections = {
    {"directions_2:1", "directions_2_tournament:1"},
    {"directions_2:2", "directions_2_tournament:2"},
    {"directions_2", "directions_2_tournament"},
    {"directions_2:9"}};

inline const std::vector<std::string> kAllHulls = [] {
  std::vector<std::string> all = kHulls;
  for (const std::vector<std::string>& one : kHullsOfDirections) {
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}();

inline Request hull_request(const std::string& hull) {
  const std::size_t colon = hull.find(':');
  Request request{hull.substr(0, colon), "", {}};
  if (colon != std::string::npos) {
    request.parameters = {{"k", Rational(std::stoi(hull.substr(colon + 1)))}};
  }
  return request;
}

}  // namespace kinex::test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/structure.h"

#include <algorithm>
#include <utility>

namespace kinex {
namespace {

// The pairs of `from` that are not in `in`; both ascending.
std::vector<ObjectId> missing_pairs(const std::vector<ObjectId>& from,
                                    const std::vector<ObjectId>& in) {
  std::vector<ObjectId> result;
  std::size_t k = 0;
  for (std::size_t i = 0; i + 1 < from.size(); i += 2) {
    const std::pair<ObjectId, ObjectId> pair{from[i], from[i + 1]};
    while (k + 1 < in.size() && std::pair<ObjectId, ObjectId>{in[k], in[k + 1]} < pair) k += 2;
    if (k + 1 < in.size() && std::pair<ObjectId, ObjectId>{in[k], in[k + 1]} == pair) {
      k += 2;
      continue;
    }
    result.insert(result.end(), {pair.first, pair.second});
  }
  return result;
}

}  // namespace

std::vector<std::string_view> common_event_kinds(std::vector<std::string_view> own) {
  for (const std::string_view kind : {"motion", "insert", "erase", "settled", "rebuild"}) {
    own.push_back(kind);
  }
  return own;
}

AttributeDifference difference_between(const Attribute& before, const Attribute& after) {
  if (before == after) return {};
  if (before.shape == Attribute::Shape::kEdges) {
    return {missing_pairs(before.ids, after.ids), missing_pairs(after.ids, before.ids)};
  }
  return {before.ids, after.ids};
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/edge_changes.h"

#include <iterator>
#include <tuple>
#include <utility>

namespace kinex {

void EdgeChanges::add(const AttributeDifference& difference) {
  for (std::size_t i = 0; i + 1 < difference.gone.size(); i += 2) {
    gone(difference.gone[i], difference.gone[i + 1]);
  }
  for (std::size_t i = 0; i + 1 < difference.came.size(); i += 2) {
    came(difference.came[i], difference.came[i + 1]);
  }
}

AttributeDifference EdgeChanges::net() const {
  std::vector<Change> sorted = changes_;
  std::sort(sorted.begin(), sorted.end(), [](const Change& x, const Change& y) {
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
  });
  AttributeDifference result;
  for (std::size_t i = 0; i < sorted.size();) {
    const ObjectId a = sorted[i].a, b = sorted[i].b;
    int more = 0;
    for (; i < sorted.size() && sorted[i].a == a && sorted[i].b == b; ++i) {
      more += sorted[i].came ? 1 : -1;
    }
    std::vector<ObjectId>& ids = more > 0 ? result.came : result.gone;
    for (; more != 0; more -= more > 0 ? 1 : -1) ids.insert(ids.end(), {a, b});
  }
  return result;
}

Attribute EdgeChanges::undone(Attribute after) const {
  if (changes_.empty()) return after;
  const AttributeDifference change = net();
  using Edge = std::pair<ObjectId, ObjectId>;
  const auto edges = [](const std::vector<ObjectId>& ids) {
    std::vector<Edge> result;
    for (std::size_t i = 0; i + 1 < ids.size(); i += 2) result.emplace_back(ids[i], ids[i + 1]);
    return result;
  };
  const std::vector<Edge> now = edges(after.ids), gone = edges(change.gone);
  const std::vector<Edge> came = edges(change.came);
  std::vector<Edge> kept, before;
  std::set_difference(now.begin(), now.end(), came.begin(), came.end(), std::back_inserter(kept));
  std::merge(kept.begin(), kept.end(), gone.begin(), gone.end(), std::back_inserter(before));
  after.ids.clear();
  for (const auto& [a, b] : before) after.ids.insert(after.ids.end(), {a, b});
  return after;
}

}  // namespace kinex

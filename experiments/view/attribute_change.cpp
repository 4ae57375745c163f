// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/attribute_change.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/numbers/check.h"

namespace kinex {

namespace {

using Edge = std::pair<ObjectId, ObjectId>;

std::vector<Edge> edges_of(const std::vector<ObjectId>& ids) {
  std::vector<Edge> edges;
  edges.reserve(ids.size() / 2);
  for (std::size_t i = 0; i + 1 < ids.size(); i += 2) edges.emplace_back(ids[i], ids[i + 1]);
  return edges;
}

std::vector<ObjectId> flat(const std::vector<Edge>& edges) {
  std::vector<ObjectId> ids;
  ids.reserve(2 * edges.size());
  for (const auto& [a, b] : edges) {
    ids.push_back(a);
    ids.push_back(b);
  }
  return ids;
}

std::vector<Edge> without(const std::vector<Edge>& a, const std::vector<Edge>& b) {
  std::vector<Edge> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

AttributeChange splice(const std::vector<ObjectId>& before, const std::vector<ObjectId>& after) {
  const auto [b, a] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  auto before_end = before.end();
  auto after_end = after.end();
  while (before_end != b && after_end != a && *(before_end - 1) == *(after_end - 1)) {
    --before_end;
    --after_end;
  }
  AttributeChange change;
  change.at = static_cast<std::size_t>(b - before.begin());
  change.removed.assign(b, before_end);
  change.added.assign(a, after_end);
  return change;
}

}  // namespace

AttributeChange difference(const Attribute& before, const Attribute& after) {
  require(before.shape == after.shape, "an attribute changed its shape");
  if (before.shape != Attribute::Shape::kEdges) return splice(before.ids, after.ids);
  const std::vector<ObjectId>& a = before.ids;
  const std::vector<ObjectId>& b = after.ids;
  AttributeChange change;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j] && a[i + 1] == b[j + 1]) {
      i += 2;
      j += 2;
    } else if (j == b.size() || (i < a.size() && Edge(a[i], a[i + 1]) < Edge(b[j], b[j + 1]))) {
      change.removed.insert(change.removed.end(), {a[i], a[i + 1]});
      i += 2;
    } else {
      change.added.insert(change.added.end(), {b[j], b[j + 1]});
      j += 2;
    }
  }
  return change;
}

void apply(const AttributeChange& change, Attribute& attribute) {
  std::vector<ObjectId>& ids = attribute.ids;
  if (attribute.shape != Attribute::Shape::kEdges) {
    const std::size_t end = change.at + change.removed.size();
    require(end <= ids.size(), "a change beyond the end of an attribute");
    const auto first = ids.begin() + static_cast<std::ptrdiff_t>(change.at);
    require(std::equal(change.removed.begin(), change.removed.end(), first),
            "a change of something else");
    const auto place = ids.erase(first, ids.begin() + static_cast<std::ptrdiff_t>(end));
    ids.insert(place, change.added.begin(), change.added.end());
    return;
  }
  const std::vector<Edge> edges = edges_of(ids);
  const std::vector<Edge> removed = edges_of(change.removed);
  require(std::includes(edges.begin(), edges.end(), removed.begin(), removed.end()),
          "a change removes an edge that is not there");
  const std::vector<Edge> kept = without(edges, removed);
  const std::vector<Edge> added = edges_of(change.added);
  std::vector<Edge> result;
  std::merge(kept.begin(), kept.end(), added.begin(), added.end(), std::back_inserter(result));
  ids = flat(result);
}

}  // namespace kinex

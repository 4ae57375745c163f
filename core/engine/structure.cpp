// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/structure.h"

#include <algorithm>
#include <span>

namespace kinex {
namespace {

// The tuples of `from` that are not in `in`; both ascending.
std::vector<ObjectId> missing_tuples(const std::vector<ObjectId>& from,
                                     const std::vector<ObjectId>& in, std::size_t width) {
  std::vector<ObjectId> result;
  const auto tuple = [width](const std::vector<ObjectId>& ids, std::size_t i) {
    return std::span<const ObjectId>(ids).subspan(i, width);
  };
  const auto before = [](std::span<const ObjectId> a, std::span<const ObjectId> b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::size_t k = 0;
  for (std::size_t i = 0; i + width <= from.size(); i += width) {
    const std::span<const ObjectId> one = tuple(from, i);
    while (k + width <= in.size() && before(tuple(in, k), one)) k += width;
    if (k + width <= in.size() && !before(one, tuple(in, k))) {
      k += width;
      continue;
    }
    result.insert(result.end(), one.begin(), one.end());
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
  if (before.shape == Attribute::Shape::kTuples) {
    return {missing_tuples(before.ids, after.ids, before.width),
            missing_tuples(after.ids, before.ids, before.width)};
  }
  return {before.ids, after.ids};
}

}  // namespace kinex

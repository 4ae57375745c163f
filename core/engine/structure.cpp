// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/structure.h"

#include <algorithm>
#include <span>

namespace kinex {
namespace {

// The tuples that only one of two ascending lists has. Most are in both: runs of equal ids are passed
// over without a look at tuples.
AttributeDifference difference_of_tuples(const std::vector<ObjectId>& before,
                                         const std::vector<ObjectId>& after, std::size_t width) {
  AttributeDifference result;
  const auto at = [width](const std::vector<ObjectId>& ids, std::size_t i) {
    return std::span<const ObjectId>(ids).subspan(i, width);
  };
  std::size_t b = 0, a = 0;
  while (b + width <= before.size() || a + width <= after.size()) {
    const auto first = before.begin() + static_cast<std::ptrdiff_t>(b);
    const auto equal = static_cast<std::size_t>(
        std::mismatch(first, before.end(), after.begin() + static_cast<std::ptrdiff_t>(a),
                      after.end())
            .first -
        first);
    b += equal / width * width;
    a += equal / width * width;
    const bool has_before = b + width <= before.size(), has_after = a + width <= after.size();
    if (!has_before && !has_after) break;
    const bool goes = !has_after || (has_before && std::ranges::lexicographical_compare(
                                                       at(before, b), at(after, a)));
    std::vector<ObjectId>& list = goes ? result.gone : result.came;
    const std::span<const ObjectId> one = goes ? at(before, b) : at(after, a);
    list.insert(list.end(), one.begin(), one.end());
    (goes ? b : a) += width;
  }
  return result;
}

}  // namespace

std::size_t width_of_orders(const Attribute& attribute) {
  const std::size_t size = attribute.ids.size();
  std::size_t width = 0, most = size;
  while (width < most) {
    const std::size_t middle = width + (most - width + 1) / 2;
    if (middle < size / middle) {
      width = middle;
    } else {
      most = middle - 1;
    }
  }
  while (width * (width + 1) < size) ++width;
  return width;
}

std::vector<std::string_view> common_event_kinds(std::vector<std::string_view> own) {
  for (const std::string_view kind : {"motion", "insert", "erase", "settled", "rebuild"}) {
    own.push_back(kind);
  }
  return own;
}

AttributeDifference difference_between(const Attribute& before, const Attribute& after) {
  if (before == after) return {};
  if (before.shape == Attribute::Shape::kTuples) {
    return difference_of_tuples(before.ids, after.ids, before.width);
  }
  return {before.ids, after.ids};
}

}  // namespace kinex

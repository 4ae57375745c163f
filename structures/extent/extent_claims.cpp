// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/extent_claims.h"

#include <algorithm>
#include <utility>

#include "predicates/predicates.h"

namespace kinex {

PredicateId ExtentClaims::predicate(ObjectId i, ObjectId j,
                                    const std::array<int, 4>& places, bool negated) const {
  const auto [place, fresh] = bound_.try_emplace({i, j, places, negated}, PredicateId{});
  if (fresh) {
    DirectionVector u = directions_[i], v = directions_[j];
    for (DirectionVector* direction : {&u, &v}) {
      for (auto& part : *direction) {
        if (negated) part = -part;
      }
    }
    place->second = kernel_->bind(make_extent_order(u, v, places));
  }
  return place->second;
}

// The predicate of directions i < j says that the extent in i is the larger one. With the ends of
// both exchanged it says that it is the smaller one. Where the first end is the larger id, the ends are
// exchanged and the directions negated, which says the same: so a claim and the opposite one name the
// same objects in the same order, and an arithmetic finds the roots of one by the other.
Query ExtentClaims::claim(const Value& front, const Value& back) const {
  const bool in_order = front[0] < back[0];
  const Value& first = in_order ? front : back;
  const Value& second = in_order ? back : front;
  const bool first_is_larger = in_order == (extremum_ == Extremum::kMaximum);
  std::array<ObjectId, 4> ends{first[1], first[2], second[1], second[2]};
  if (!first_is_larger) {
    std::swap(ends[0], ends[1]);
    std::swap(ends[2], ends[3]);
  }
  const bool negated = ends[1] < ends[0];
  if (negated) {
    std::swap(ends[0], ends[1]);
    std::swap(ends[2], ends[3]);
  }
  Query query;
  std::array<int, 4> places{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto begin = query.ids.begin(), end = begin + query.arity;
    const auto there = std::find(begin, end, ends[i]);
    places[i] = static_cast<int>(there - begin);
    if (there == end) query.ids[query.arity++] = ends[i];
  }
  query.predicate = predicate(first[0], second[0], places, negated);
  return query;
}

}  // namespace kinex

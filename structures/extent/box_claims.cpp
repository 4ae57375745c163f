// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/box_claims.h"

#include <algorithm>

namespace kinex {

const SharedQueries& BoxClaims::queries(ObjectId i, ObjectId j, SmallerBox smaller) const {
  const auto there = bound_.find({i, j, smaller});
  if (there != bound_.end()) return there->second;
  SharedQueries fresh(*kernel_, make_box_order(measure_, directions_[i], directions_[j], smaller));
  return bound_.emplace(std::tuple{i, j, smaller}, std::move(fresh)).first->second;
}

// The box of the smaller direction comes first in the query, whichever is in front: a claim and the
// opposite one name the same objects in the same order, and an arithmetic finds the roots of one by
// the other.
Query BoxClaims::claim(const Value& front, const Value& back) const {
  const bool in_order = front[0] < back[0];
  const Value &first = in_order ? front : back, &second = in_order ? back : front;
  std::array<ObjectId, 8> ids{};
  std::copy(first.begin() + 1, first.end(), ids.begin());
  std::copy(second.begin() + 1, second.end(), ids.begin() + 4);
  return queries(first[0], second[0], in_order ? SmallerBox::kFirst : SmallerBox::kSecond)
      .query(ids);
}

}  // namespace kinex

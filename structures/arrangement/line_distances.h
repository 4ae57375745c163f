// SPDX-License-Identifier: GPL-3.0-or-later
// LineDistances: claims (structures/parts/claim.h) about pairs of a line and a point: the pair at the
// smaller distance is in front. Distances are vertical, or Euclidean
// (predicates/points/line_distance_order.h): degree 4d or 6d for motions of degree d.
//
// Ties. Of two pairs at identically equal distances the lexicographically smaller one is in front.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_DISTANCES_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_DISTANCES_H

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "predicates/points/line_distance_order.h"
#include "structures/parts/shared_queries.h"

namespace kinex {

class LineDistances {
 public:
  using Value = std::array<ObjectId, 2>;  // a line and a point, ids ascending

  // `is_line`: by object.
  LineDistances(Kernel& kernel, LineMeasure measure, std::vector<bool> is_line)
      : is_line_(std::move(is_line)),
        order_(std::make_shared<SharedQueries>(kernel, make_line_distance_order(measure))) {}

  bool is_line(ObjectId object) const { return is_line_[object]; }
  const std::vector<bool>& is_line() const { return is_line_; }
  // "The point of `front` is at most as far from its line as that of `back`." The pairs must differ;
  // they may share an object.
  Query claim(const Value& front, const Value& back) const {
    return order_->order(line_first(front), line_first(back));
  }
  // Resolves ties.
  bool goes_first(const Value& a, const Value& b) const { return a < b; }
  std::size_t bytes() const { return is_line_.capacity() / 8 + order_->bytes(); }

 private:
  Value line_first(const Value& pair) const {
    return is_line_[pair[0]] ? pair : Value{pair[1], pair[0]};
  }

  std::vector<bool> is_line_;
  std::shared_ptr<SharedQueries> order_;
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// NormOrder: steps between two points of the plane in the order of their lengths in a norm whose
// unit circle is a polygon.
//
// In the cone of a side of the polygon the norm is a linear function: the owner says which one is
// that of a step (NormForm).
//
// Claims are about two extents along two directions, degree d for motions of degree d
// (make_extent_order); where two steps along one direction have an end in common, about the order of
// the other ends along it.
//
// Ties. Lengths that are identically equal are in the order right after an infinitesimal turn of
// the plane, u becoming its image by a quarter turn; if those are identically equal, too, in that of
// the lengths of the points moved by their ids along (2, 1); the last resort is the lexicographic
// order of the pairs. So the order is that of points without three level ones, however they are
// (turned_order.h has the same).
#ifndef KINEX_STRUCTURES_PROXIMITY_NORM_ORDER_H
#define KINEX_STRUCTURES_PROXIMITY_NORM_ORDER_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "core/engine/kernel.h"

namespace kinex {

// A step from one point to another: its length is units[direction].(to - from).
struct NormForm {
  std::uint8_t direction = 0;
  ObjectId from = kNoObject, to = kNoObject;
  std::array<ObjectId, 2> pair() const { return {std::min(from, to), std::max(from, to)}; }
  friend bool operator==(const NormForm&, const NormForm&) = default;
};

class NormOrder {
 public:
  using Vector = std::array<int, 2>;
  // `number`: another one for each form of one pair.
  struct Step {
    const NormForm& form;
    std::uint32_t number;
  };

  // `units`: the linear functions, no two of them equal; neither is opposite to another one.
  NormOrder(Kernel& kernel, std::vector<Vector> units);

  // As structures/parts/claim.h has them: the shorter one is in front.
  Query claim(const Step& a, const Step& b) const;
  bool goes_first(const Step& a, const Step& b) const;
  std::size_t bytes() const { return (orders_.size() + extents_.size()) * 96; }

 private:
  // A direction, or minus it: a direction of units_, or one turned by a quarter, and a sign.
  struct Along {
    std::uint8_t direction;
    bool turned;
    bool negative;
    auto operator<=>(const Along&) const = default;
  };
  Vector vector(const Along& along) const;
  Query difference(const Step& a, const Step& b, bool turned) const;
  std::int64_t by_ids(const NormForm& form) const;
  PredicateId order(const Along& along) const;
  PredicateId extents(const Along& u, const Along& v, const std::array<int, 4>& places) const;

  Kernel* kernel_;
  std::vector<Vector> units_;
  // Bound when they are first needed.
  mutable std::map<Along, PredicateId> orders_;
  mutable std::map<std::tuple<Along, Along, std::array<int, 4>>, PredicateId> extents_;
};

}  // namespace kinex

#endif

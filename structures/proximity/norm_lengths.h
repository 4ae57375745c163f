// SPDX-License-Identifier: GPL-3.0-or-later
// NormLengths: edges between points of the plane, numbered, in the order of their lengths in a norm
// whose unit circle is a polygon.
//
//          \  u1  /          In the cone of a side of the polygon the norm is a linear function: the
//           \    /  u0       length of the edge from p to q is u.(q - p), u being that of the cone in
//     u2     \  /            which q is. In the maximum norm u is (1, 0), (0, 1) or an opposite, in
//     --------p--------      four quadrants between the diagonals.
//
// The owner says which linear function is that of an edge: an edge that comes to another cone gets
// another number.
//
// Claims are about two extents along two directions, degree d for motions of degree d
// (make_extent_order); where two edges of one direction have an end in common, about the order of
// the other ends along it.
//
// Ties. Lengths that are identically equal are in the order right after an infinitesimal turn of
// the plane, u becoming its image by a quarter turn; if those are identically equal, too, in that of
// the lengths of the points moved by their ids along (2, 1); the last resort is the lexicographic
// order of the pairs. So the order is that of points without three level ones, however they are
// (turned_order.h has the same), and every edge of the minimum spanning tree is a pair of a point
// and the first one in a cone around it.
#ifndef KINEX_STRUCTURES_PROXIMITY_NORM_LENGTHS_H
#define KINEX_STRUCTURES_PROXIMITY_NORM_LENGTHS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "core/engine/kernel.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

class NormLengths final : public TreeEdges {
 public:
  using Pair = std::array<ObjectId, 2>;  // ids, ascending
  using Vector = std::array<int, 2>;
  // Its length is units[direction].(to - from).
  struct Form {
    std::uint8_t direction = 0;
    ObjectId from = kNoObject, to = kNoObject;
    friend bool operator==(const Form&, const Form&) = default;
  };

  // `units`: the linear functions, no two of them equal; neither is opposite to another one.
  NormLengths(Kernel& kernel, std::vector<Vector> units);

  Query claim(Item a, Item b) const override;
  bool goes_first(Item a, Item b) const override;
  std::array<std::uint32_t, 2> ends(Item item) const override { return pair_of(forms_[item]); }
  EdgeIds ids(Item item) const override { return pair_of(forms_[item]); }

  // By pair, ascending.
  const std::map<Pair, Item>& items() const { return item_of_; }
  // kNoItem if the pair has no number.
  Item find(const Pair& pair) const;
  const Form& form(Item item) const { return forms_[item]; }
  // Numbers a pair. One that has a number gets another one; the old one stays valid until it is
  // removed.
  Item add(const Form& form);
  // The number may be given to another edge.
  void remove(Item item);
  std::size_t bytes() const;

 private:
  // A direction, or minus it: a direction of units_, or one turned by a quarter, and a sign.
  struct Along {
    std::uint8_t direction;
    bool turned;
    bool negative;
    auto operator<=>(const Along&) const = default;
  };
  static Pair pair_of(const Form& form) {
    return {std::min(form.from, form.to), std::max(form.from, form.to)};
  }
  Vector vector(const Along& along) const;
  Query difference(Item a, Item b, bool turned) const;
  std::int64_t by_ids(const Form& form) const;
  PredicateId order(const Along& along) const;
  PredicateId extents(const Along& u, const Along& v, const std::array<int, 4>& places) const;

  Kernel* kernel_;
  std::vector<Vector> units_;
  std::vector<Form> forms_;  // by item
  std::map<Pair, Item> item_of_;
  std::vector<Item> free_;
  // Bound when they are first needed.
  mutable std::map<Along, PredicateId> orders_;
  mutable std::map<std::tuple<Along, Along, std::array<int, 4>>, PredicateId> extents_;
};

}  // namespace kinex

#endif

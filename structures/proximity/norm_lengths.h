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
// Claims and ties: norm_order.h. So every edge of the minimum spanning tree is a pair of a point and
// the first one in a cone around it.
#ifndef KINEX_STRUCTURES_PROXIMITY_NORM_LENGTHS_H
#define KINEX_STRUCTURES_PROXIMITY_NORM_LENGTHS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "structures/proximity/norm_order.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

class NormLengths final : public TreeEdges {
 public:
  using Pair = std::array<ObjectId, 2>;  // ids, ascending
  using Form = NormForm;

  // `units`: the linear functions, no two of them equal; neither is opposite to another one.
  NormLengths(Kernel& kernel, std::vector<NormOrder::Vector> units)
      : order_(kernel, std::move(units)) {}

  Query claim(Item a, Item b) const override {
    return order_.claim({forms_[a], a}, {forms_[b], b});
  }
  bool goes_first(Item a, Item b) const override {
    return order_.goes_first({forms_[a], a}, {forms_[b], b});
  }
  std::array<std::uint32_t, 2> ends(Item item) const override { return forms_[item].pair(); }
  EdgeIds ids(Item item) const override { return forms_[item].pair(); }

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
  NormOrder order_;
  std::vector<Form> forms_;  // by item
  std::map<Pair, Item> item_of_;
  std::vector<Item> free_;
};

}  // namespace kinex

#endif

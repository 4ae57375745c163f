// SPDX-License-Identifier: GPL-3.0-or-later
// ArrangementChange: the way from the orders of an arrangement of lines just before an instant to
// those just after it, as the triples of lines whose triangle turned over and the pairs of lines that
// passed each other at infinity.
//
//   before on l: m k x    after: k m x    on m, l and k, and on k, l and m change places: a triple
//   before on l: m k x    after: k x m    on m, l goes to the other end too: a parallel
//
// On l the order of m and k changes iff exactly one of these has happened, or all three: the triple
// (l, m, k), the parallel (l, m), the parallel (l, k).
#ifndef KINEX_STRUCTURES_ARRANGEMENT_ORDER_CHANGES_H
#define KINEX_STRUCTURES_ARRANGEMENT_ORDER_CHANGES_H

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

// Lists of lines as in crossing_lists.h, by line; kNoObject: all lines in the order of slopes.
using LineOrders = std::map<ObjectId, std::vector<ObjectId>>;

// Each of its lists ascends, and so do the ids in a pair or triple.
struct ArrangementChange {
  std::vector<std::array<ObjectId, 3>> triples;
  std::vector<std::array<ObjectId, 2>> parallels;  // pairs whose slopes changed their order
  std::vector<std::array<ObjectId, 2>> equals;     // lines parallel identically that coincided
  bool empty() const { return triples.empty() && parallels.empty() && equals.empty(); }
};

// `before` and `after` have the same keys: all lists that changed, and those of the two lines of
// every pair whose slopes did. nullopt if the lists contradict each other, or if two lines are
// identically parallel before or after, but not both. Linear in the lists and the changes, but
// quadratic in the longest stretch of a list that has changed.
std::optional<ArrangementChange> change_between(const LineOrders& before, const LineOrders& after);

}  // namespace kinex

#endif

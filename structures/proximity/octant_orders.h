// SPDX-License-Identifier: GPL-3.0-or-later
// OctantOrder: the claims of a list of points along one of four directions, with the order right
// after an infinitesimal turn where points are level.
//
//   order             first key   of level points   the last resort
//   kAlongX           x           -y                the smaller id
//   kAlongY           y           x                 the smaller id
//   kAlongSum         x + y       x - y             the smaller id
//   kAlongDifference  x - y       -(x + y)          the smaller id
//
// The four orders tell in which of the eight octants around a point p another point q is: those are
// the sectors between the axes and the diagonals. With the second keys all boundary rays belong to
// the octant on their counter-clockwise side, all points equal to p with a larger id to the octant
// 0 <= y < x; so every other point is in one octant of p, and p is in the opposite one of it.
//
// A pair that is identically level by its first key may be so no more after a new motion: renew the
// certificates of moved points (KineticList::renew).
#ifndef KINEX_STRUCTURES_PROXIMITY_OCTANT_ORDERS_H
#define KINEX_STRUCTURES_PROXIMITY_OCTANT_ORDERS_H

#include <array>
#include <cstddef>

#include "structures/parts/claim.h"

namespace kinex {

// A direction by which points are ordered.
enum OctantAxis : std::size_t { kAlongX, kAlongY, kAlongSum, kAlongDifference };
// The number of directions by which points are ordered.
inline constexpr std::size_t kOctantAxes = 4;
// "x", "y", "x + y", "x - y".
const char* octant_axis_name(OctantAxis axis);

class OctantOrder {
 public:
  OctantOrder(Kernel& kernel, OctantAxis axis);

  // By the second key if the two are identically level by the first.
  Query claim(Item a, Item b) const;
  bool goes_first(Item a, Item b) const { return a < b; }

 private:
  Kernel* kernel_;
  PredicateId first_, second_;
  bool second_descends_;  // the second key is the negative of that of `second_`
};

}  // namespace kinex

#endif

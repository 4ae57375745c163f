// SPDX-License-Identifier: GPL-3.0-or-later
// DualPoints: linear motions along one axis as points of the dual plane, in general position.
//
// The coordinate slope t + height is the point (slope, height). The points whose coordinate is at
// least x at time t are those on or above a line: height >= x - slope t. So a query for an interval
// at any time is one for a strip between two parallel lines.
//
// Points may coincide or be on a line. The orders below are those of points that are moved a little:
// point i upwards by e_i, where e_0 >> e_1 >> .., and along the axis of slopes by less than all of
// these, by id, so that no two have one slope and no three are on a line. Sides of lines are
// therefore those of one arrangement, and no set of inputs is special.
//
// Source: Edelsbrunner, Muecke, "Simulation of simplicity" (1990), for the method.
#ifndef KINEX_STRUCTURES_RANGE_DUAL_POINTS_H
#define KINEX_STRUCTURES_RANGE_DUAL_POINTS_H

#include <span>

#include "core/engine/kernel.h"

namespace kinex {

class DualPoints {
 public:
  // Requires motions of degree 1 at most.
  DualPoints(Kernel& kernel, int axis, int dimension);

  int axis() const { return axis_; }
  // A strict total order: by slope, then by height, then by id.
  bool precedes(ObjectId a, ObjectId b) const;
  // True if c is to the left of the directed line from a to b. Requires three objects.
  bool is_left(ObjectId a, ObjectId b, ObjectId c) const;
  // The sign of the turn a, b, c of the points as they are.
  Sign turn(ObjectId a, ObjectId b, ObjectId c) const;
  // Copies of the motions of these objects (Kernel::fill).
  void fill(std::span<const ObjectId> objects, CoordinateTable& table) const {
    kernel_->fill(order_, objects, table);
  }
  // The points coincide.
  bool same(ObjectId a, ObjectId b) const;

 private:
  Kernel* kernel_;
  int axis_;
  PredicateId slope_order_, turn_, order_;
};

}  // namespace kinex

#endif

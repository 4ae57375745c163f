// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/octant_orders.h"

#include "predicates/predicates.h"

namespace kinex {
namespace {

PredicateId bound(Kernel& kernel, OctantAxis axis) {
  switch (axis) {
    case kAlongX:
      return kernel.bind(make_coordinate_order(0));
    case kAlongY:
      return kernel.bind(make_coordinate_order(1));
    case kAlongSum:
      return kernel.bind(make_direction_order({1, 1}));
    default:
      return kernel.bind(make_direction_order({1, -1}));
  }
}

// The direction a quarter turn from this one, or its opposite.
OctantAxis across(OctantAxis axis) {
  constexpr std::array<OctantAxis, kOctantAxes> kAcross{kAlongY, kAlongX, kAlongDifference,
                                                        kAlongSum};
  return kAcross[axis];
}

}  // namespace

const char* octant_axis_name(OctantAxis axis) {
  constexpr std::array<const char*, kOctantAxes> kNames{"x", "y", "x + y", "x - y"};
  return kNames[axis];
}

OctantOrder::OctantOrder(Kernel& kernel, OctantAxis axis)
    : kernel_(&kernel),
      first_(bound(kernel, axis)),
      second_(bound(kernel, across(axis))),
      second_descends_(axis == kAlongX || axis == kAlongDifference) {}

Query OctantOrder::claim(Item a, Item b) const {
  const Query first(first_, {a, b});
  if (kernel_->sign_after(first) != Sign::kZero) return first;
  return second_descends_ ? Query(second_, {b, a}) : Query(second_, {a, b});
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// All families of structures, in the order in which users see them: the one place where a family is
// listed.
#ifndef KINEX_STRUCTURES_FAMILIES_H
#define KINEX_STRUCTURES_FAMILIES_H

#include <array>
#include <string_view>

#include "structures/arrangement/family.h"
#include "structures/collision/family.h"
#include "structures/extent/family.h"
#include "structures/hull/family.h"
#include "structures/maximum/family.h"
#include "structures/order/family.h"
#include "structures/proximity/family.h"
#include "structures/range/family.h"
#include "structures/triangulation/family.h"

namespace kinex {

// What describes a family, and the family in one line.
struct ListedFamily {
  StructureFamily (*describe)();
  std::string_view summary;  // what its structures maintain; one line without a full stop
};

// All of them, in that order.
inline constexpr std::array<ListedFamily, 9> kStructureFamilies{
    {{order_family, "the order of objects by a key"},
     {maximum_family, "the object with the largest or the smallest key"},
     {triangulation_family,
      "Delaunay and regular triangulations of points, in the plane and in space"},
     {hull_family, "the convex hull of points in the plane"},
     {collision_family, "which convex polygons that move rigidly in the plane are in contact"},
     {extent_family,
      "how far points extend: boxes, the smallest circle, diameter, width, rectangles"},
     {proximity_family,
      "what is near: closest pairs, nearest sites, spanning trees, discs and boxes that meet"},
     {range_family, "which points are in a box with sides along the axes"},
     {arrangement_family,
      "the order in which moving lines cross each other, and where points are among them"}}};

}  // namespace kinex

#endif

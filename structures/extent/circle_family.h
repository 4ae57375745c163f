// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptors: the box on a hull, the farthest-point triangulation, and the smallest circle.
#ifndef KINEX_STRUCTURES_EXTENT_CIRCLE_FAMILY_H
#define KINEX_STRUCTURES_EXTENT_CIRCLE_FAMILY_H

#include <vector>

#include "structures/parts/descriptor.h"

namespace kinex {

// The descriptors of the box on a hull, the farthest-point triangulation and the circles.
std::vector<StructureInfo> circle_structures();

}  // namespace kinex

#endif

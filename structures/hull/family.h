// SPDX-License-Identifier: GPL-3.0-or-later
// Convex hulls of points.
#ifndef KINEX_STRUCTURES_HULL_FAMILY_H
#define KINEX_STRUCTURES_HULL_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily hull_family();

}  // namespace kinex

#endif

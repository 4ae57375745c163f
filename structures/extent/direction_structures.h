// SPDX-License-Identifier: GPL-3.0-or-later
// The structures that measure extents along fixed directions, for the family's list.
#ifndef KINEX_STRUCTURES_EXTENT_DIRECTION_STRUCTURES_H
#define KINEX_STRUCTURES_EXTENT_DIRECTION_STRUCTURES_H

#include <vector>

#include "structures/parts/descriptor.h"

namespace kinex {

// The descriptors of what looks along fixed directions.
std::vector<StructureInfo> direction_structures();

}  // namespace kinex

#endif

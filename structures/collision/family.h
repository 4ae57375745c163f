// SPDX-License-Identifier: GPL-3.0-or-later
// The collision family: collisions of convex polygons, and the hierarchies of polygons that some of
// its structures use. Its structures as descriptors (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_COLLISION_FAMILY_H
#define KINEX_STRUCTURES_COLLISION_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily collision_family();  // the descriptors of its structures

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The hull family: convex hulls of points. Its structures as descriptors
// (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_HULL_FAMILY_H
#define KINEX_STRUCTURES_HULL_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily hull_family();  // the descriptors of its structures

}  // namespace kinex

#endif

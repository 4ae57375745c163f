// SPDX-License-Identifier: GPL-3.0-or-later
// How far a set of points extends.
#ifndef KINEX_STRUCTURES_EXTENT_FAMILY_H
#define KINEX_STRUCTURES_EXTENT_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily extent_family();

}  // namespace kinex

#endif

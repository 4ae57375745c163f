// SPDX-License-Identifier: GPL-3.0-or-later
// Which points are near each other.
#ifndef KINEX_STRUCTURES_PROXIMITY_FAMILY_H
#define KINEX_STRUCTURES_PROXIMITY_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily proximity_family();

}  // namespace kinex

#endif

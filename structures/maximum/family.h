// SPDX-License-Identifier: GPL-3.0-or-later
// The object with the largest key, or with the smallest.
#ifndef KINEX_STRUCTURES_MAXIMUM_FAMILY_H
#define KINEX_STRUCTURES_MAXIMUM_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily maximum_family();

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The range family: moving points in boxes. Its structures as descriptors
// (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_RANGE_FAMILY_H
#define KINEX_STRUCTURES_RANGE_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily range_family();  // the descriptors of its structures

}  // namespace kinex

#endif

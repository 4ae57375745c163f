// SPDX-License-Identifier: GPL-3.0-or-later
// The extent family: how far a set of points extends. Its structures as descriptors
// (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_EXTENT_FAMILY_H
#define KINEX_STRUCTURES_EXTENT_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily extent_family();  // the descriptors of its structures

}  // namespace kinex

#endif

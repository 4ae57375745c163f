// SPDX-License-Identifier: GPL-3.0-or-later
// The maximum family: the object with the largest or the smallest key. Its structures as
// descriptors (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_MAXIMUM_FAMILY_H
#define KINEX_STRUCTURES_MAXIMUM_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily maximum_family();  // the descriptors of its structures

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The arrangement family: lines y = a x + b that move, among themselves and against points. Its
// structures as descriptors (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_ARRANGEMENT_FAMILY_H
#define KINEX_STRUCTURES_ARRANGEMENT_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily arrangement_family();  // the descriptors of its structures

}  // namespace kinex

#endif

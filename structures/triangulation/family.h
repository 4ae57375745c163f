// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation family: triangulations of points. Its structures as descriptors
// (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_TRIANGULATION_FAMILY_H
#define KINEX_STRUCTURES_TRIANGULATION_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily triangulation_family();  // the descriptors of its structures

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The proximity family: which points are near each other. Its structures as descriptors
// (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_PROXIMITY_FAMILY_H
#define KINEX_STRUCTURES_PROXIMITY_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily proximity_family();  // the descriptors of its structures

}  // namespace kinex

#endif

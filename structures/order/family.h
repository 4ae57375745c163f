// SPDX-License-Identifier: GPL-3.0-or-later
// The order family: objects in the order of a key. Its structures as descriptors
// (structures/parts/descriptor.h).
#ifndef KINEX_STRUCTURES_ORDER_FAMILY_H
#define KINEX_STRUCTURES_ORDER_FAMILY_H

#include "structures/parts/descriptor.h"

namespace kinex {

StructureFamily order_family();  // the descriptors of its structures

}  // namespace kinex

#endif

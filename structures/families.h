// SPDX-License-Identifier: GPL-3.0-or-later
// All families of structures: the one place where a family is listed.
#ifndef KINEX_STRUCTURES_FAMILIES_H
#define KINEX_STRUCTURES_FAMILIES_H

#include <array>

#include "structures/descriptor.h"

namespace kinex {

// Each in the family.cpp of its folder.
StructureFamily order_family();
StructureFamily maximum_family();
StructureFamily triangulation_family();
StructureFamily hull_family();
StructureFamily collision_family();

inline constexpr std::array kStructureFamilies{&order_family, &maximum_family,
                                               &triangulation_family, &hull_family,
                                               &collision_family};

}  // namespace kinex

#endif

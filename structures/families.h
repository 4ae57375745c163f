// SPDX-License-Identifier: GPL-3.0-or-later
// All families of structures, in the order in which users see them: the one place where a family is
// listed.
#ifndef KINEX_STRUCTURES_FAMILIES_H
#define KINEX_STRUCTURES_FAMILIES_H

#include <array>

#include "structures/arrangement/family.h"
#include "structures/collision/family.h"
#include "structures/extent/family.h"
#include "structures/hull/family.h"
#include "structures/maximum/family.h"
#include "structures/order/family.h"
#include "structures/proximity/family.h"
#include "structures/range/family.h"
#include "structures/triangulation/family.h"

namespace kinex {

// All families, as the functions that describe them.
inline constexpr std::array kStructureFamilies{&order_family, &maximum_family,
                                               &triangulation_family, &hull_family,
                                               &collision_family, &extent_family,
                                               &proximity_family, &range_family,
                                               &arrangement_family};

}  // namespace kinex

#endif

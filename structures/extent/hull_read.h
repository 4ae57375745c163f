// SPDX-License-Identifier: GPL-3.0-or-later
// hull_of: the hull that a structure of the extent family reads.
#ifndef KINEX_STRUCTURES_EXTENT_HULL_READ_H
#define KINEX_STRUCTURES_EXTENT_HULL_READ_H

#include "structures/hull/hull_source.h"
#include "structures/parts/descriptor.h"

namespace kinex {

// The first structure that the one to be made watches. std::bad_cast if it is no hull.
inline const HullSource& hull_of(const MakerInput& in) {
  return dynamic_cast<const HullSource&>(*in.watched[0]);
}

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Finds bodies that turn against each other.
#ifndef KINEX_CORE_MOTION_TURNING_H
#define KINEX_CORE_MOTION_TURNING_H

#include <optional>
#include <utility>

#include "core/motion/scene.h"

namespace kinex {

// The first two bodies of the scene, in its order, whose relative angle changes while both keep to
// a flight plan; nullopt if there are none. A change of the angle from one plan to the next, by a
// jump, does not count. Requires a scene of bodies. Exact. Cost: O(n + k^2) comparisons of plans,
// with k the number of different rotor motions.
std::optional<std::pair<ObjectId, ObjectId>> find_turning_pair(const Scene& scene);

}  // namespace kinex

#endif

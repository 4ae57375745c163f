// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that turn against each other.
#ifndef KINEX_CORE_MOTION_TURNING_H
#define KINEX_CORE_MOTION_TURNING_H

#include <optional>
#include <utility>

#include "core/motion/scene.h"

namespace kinex {

// The first two bodies of the scene, in its order, whose angle to each other is not constant while
// both keep to a flight plan; nullopt if there are none. A change of the angle from plan to plan,
// by a jump, is no turn. Requires a scene of bodies. Exact; O(n + k^2) comparisons of plans, k the
// number of different ways in which bodies turn.
std::optional<std::pair<ObjectId, ObjectId>> find_turning_pair(const Scene& scene);

}  // namespace kinex

#endif

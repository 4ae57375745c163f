// SPDX-License-Identifier: GPL-3.0-or-later
// The weights of points (Extents::kWeight): the axis of a motion behind those of the position.
#ifndef KINEX_EXPERIMENTS_FORMATS_WEIGHTS_H
#define KINEX_EXPERIMENTS_FORMATS_WEIGHTS_H

#include <optional>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/json_node.h"

namespace kinex::formats {

// The weight in the node: a number, or coefficients of powers of t, low degree first.
std::vector<Rational> read_weight(const JsonNode& node);

// Appends the weight of `object`, beside its motion or in each of its flight plans, as an axis of all
// of them. False, with nothing changed, if it has none. Refuses weights of bodies, discs and boxes,
// weights in some flight plans only, and weights that jump in a scene without jumps. The motion must
// have been read.
bool add_weights(const JsonNode& object, const Scene& scene, Motion& motion);

// Appends the same weight to every flight plan.
void append_weight(Motion& motion, const std::vector<Rational>& weight);

// The points of the scene have weights, 0 those without an axis for it.
void complete_weights(Scene& scene);

// The weight that all flight plans of an object have; none: they have different ones. Requires a
// scene of points with weights.
std::optional<std::vector<Rational>> common_weight(const SceneObject& object, const Scene& scene);

}  // namespace kinex::formats

#endif

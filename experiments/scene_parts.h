// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a scene, each read from its own JSON node. For scene_reader.cpp only.
#ifndef KINEX_EXPERIMENTS_SCENE_PARTS_H
#define KINEX_EXPERIMENTS_SCENE_PARTS_H

#include "core/scene.h"
#include "experiments/json_node.h"

namespace kinex {

// [[c0, c1, ..], ..] or a list of pieces {"from", "to", "coordinates"}: ascending, not overlapping,
// continuous where two pieces meet unless `jumps`. A gap between two pieces is a time without the
// object.
Motion read_motion(const JsonNode& node, int dimension, bool jumps);

// Fills scene.maintain; the objects must have been read.
void read_maintain(const JsonNode& node, Scene& scene);

// True if the object exists at every instant of the scene's time.
bool lives_throughout(const Motion& motion, const Scene& scene);

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Attributes as JSON, by the ids of the scene.
#ifndef KINEX_EXPERIMENTS_FORMATS_ATTRIBUTE_JSON_H
#define KINEX_EXPERIMENTS_FORMATS_ATTRIBUTE_JSON_H

#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "experiments/formats/json_writer.h"

namespace kinex::formats {

// A sequence or cycle is a list of ids, one object an id (or null), edges a list of id pairs.
void write_attribute(JsonWriter& json, const Attribute& attribute, const Scene& scene);

}  // namespace kinex::formats

#endif

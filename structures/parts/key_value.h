// SPDX-License-Identifier: GPL-3.0-or-later
// The value of a key at exact positions, for audits: shares no code with the predicates.
#ifndef KINEX_STRUCTURES_PARTS_KEY_VALUE_H
#define KINEX_STRUCTURES_PARTS_KEY_VALUE_H

#include <utility>
#include <vector>

#include "core/engine/audit.h"
#include "core/motion/scene.h"

namespace kinex {

Rational key_value(const Key& key, const Snapshot& snapshot, ObjectId object);  // of one object
// All living objects (of the `objects` in the scene) with their keys, sorted by (key, id), without
// the object that squared distances are measured to.
std::vector<std::pair<Rational, ObjectId>> sorted_keys(const Key& key, const Snapshot& snapshot,
                                                       std::size_t objects);

}  // namespace kinex

#endif

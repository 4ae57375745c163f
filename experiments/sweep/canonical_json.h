// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef KINEX_EXPERIMENTS_SWEEP_CANONICAL_JSON_H
#define KINEX_EXPERIMENTS_SWEEP_CANONICAL_JSON_H

#include <string>

#include "experiments/formats/json_value.h"

namespace kinex::sweep {

// The value without spaces, the members of each object in the order of their names (as bytes), and
// numbers as they were written. Values that differ in nothing else give the same text.
std::string canonical_json(const JsonValue& value);

}  // namespace kinex::sweep

#endif

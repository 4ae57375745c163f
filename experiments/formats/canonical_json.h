// SPDX-License-Identifier: GPL-3.0-or-later
// Canonical JSON: one text for equal values, for hashes and comparisons.
#ifndef KINEX_EXPERIMENTS_FORMATS_CANONICAL_JSON_H
#define KINEX_EXPERIMENTS_FORMATS_CANONICAL_JSON_H

#include <string>

#include "experiments/formats/json_value.h"

namespace kinex::formats {

// The value without spaces, with the members of each object in the order of their names (as bytes).
// Numbers stay as they were written: 1.0 and 1 give different texts.
std::string canonical_json(const JsonValue& value);

}  // namespace kinex::formats

#endif

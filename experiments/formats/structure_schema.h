// SPDX-License-Identifier: GPL-3.0-or-later
// The part of scene.schema.json that the descriptors of structures determine: what an entry of
// "maintain" may be.
#ifndef KINEX_EXPERIMENTS_FORMATS_STRUCTURE_SCHEMA_H
#define KINEX_EXPERIMENTS_FORMATS_STRUCTURE_SCHEMA_H

#include <string>

namespace kinex::formats {

// The members "request" and what it refers to, of an object "definitions" (JSON Schema, draft 07),
// indented by four spaces, without a comma at the end:
//
//   request      the name of a structure; or an object with the members that this structure takes:
//                its parameters with their ranges, and "key", "query", "colours", "over", "of", "as"
//   over_ROLE    the structures that can be read in that role
//   linear_key   the keys of structures for linear motions
//
// It refers to the definitions number_text, id, key, subset, label and two_colours of the file. Ranges
// that no finite decimal states are left to the reader.
std::string structure_definitions();

}  // namespace kinex::formats

#endif

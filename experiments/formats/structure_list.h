// SPDX-License-Identifier: GPL-3.0-or-later
// The descriptors of structures as JSON, for other programs and for tests: kinex list structures
// --json.
#ifndef KINEX_EXPERIMENTS_FORMATS_STRUCTURE_LIST_H
#define KINEX_EXPERIMENTS_FORMATS_STRUCTURE_LIST_H

#include <string>
#include <string_view>

namespace kinex::formats {

// An array with an object a line for each structure of the family; empty: of all families.
//   {"name", "summary", "family", "group" (if it has one),
//    "objects": "points" | "discs" | "boxes" | "lines" | "lines and points" | "edges" | "bodies",
//    "axes": the fewest, "more_axes": it takes scenes of more, "follows_motion",
//    "largest_degree" (if there is one), "takes": the members of its entry in "maintain",
//    "parameters": [{"name", "summary", "usual", "least", "most", ..}], "reads": [NAME, ..],
//    "role" (if it has one), "kinds": [{"kind", "effect", "text"}]}
std::string structure_list(std::string_view family);

}  // namespace kinex::formats

#endif

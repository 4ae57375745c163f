// SPDX-License-Identifier: GPL-3.0-or-later
// Queries for boxes: read from scenes and from the command line, and checked.
#ifndef KINEX_EXPERIMENTS_FORMATS_BOX_QUERIES_H
#define KINEX_EXPERIMENTS_FORMATS_BOX_QUERIES_H

#include <array>
#include <string>
#include <vector>

#include "core/motion/scene.h"

namespace kinex::formats {

// A box on the command line: X1,X2 for every axis, with commas between them. Throws InputError that
// names --query.
std::vector<std::array<Rational, 2>> read_box_option(const std::string& text, const Scene& scene);

// The scene has no queries, or a structure of "maintain" answers them.
bool answers_queries(const Scene& scene);
// Throws InputError if the scene has queries, and no structure of "maintain" answers them, or if one
// does whose label is "box". `file`, `place`: where a query stands.
void check_answered(const Scene& scene, const std::string& file, const std::string& place);

}  // namespace kinex::formats

#endif

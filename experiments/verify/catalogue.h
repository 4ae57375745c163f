// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments, as a list of cells. Each source file states its question, the sources of the
// expected answers, and its cost.
//
// It covers every structure of the registry: those without experiments of their own get the common
// ones, so the hard bounds of a new structure are checked as soon as it is registered.
#ifndef KINEX_EXPERIMENTS_VERIFY_CATALOGUE_H
#define KINEX_EXPERIMENTS_VERIFY_CATALOGUE_H

#include <string_view>

#include "experiments/verify/cell.h"
#include "structures/registry.h"

namespace kinex {

enum class Extent { kQuick, kFull };

// `structure`: a registered name, "maximum", "minimum" or "convex_hull" (all structures for it),
// "collision" (all for bodies), or "all". Throws InputError for any other name.
Catalogue make_catalogue(std::string_view structure, Extent extent);

// ---- the parts, for structures that are registered or not

// worst_cases.cpp: families that reach a bound exactly.
void add_worst_cases(Catalogue& catalogue, Extent extent);
// random_motion.cpp: expected counts and growth under random motion.
void add_random_motion(Catalogue& catalogue, Extent extent);
// maximum_cells.cpp: all structures for a maximum on the same scenes.
void add_maximum_comparison(Catalogue& catalogue, Extent extent);
// collision_cells.cpp: all structures for collisions on the same scenes.
void add_collision_cells(Catalogue& catalogue, Extent extent);
// common_cells.cpp: hard bounds and audits of one structure on every kind of scene.
void add_common_cells(Catalogue& catalogue, const StructureInfo& structure, Extent extent);

}  // namespace kinex

#endif

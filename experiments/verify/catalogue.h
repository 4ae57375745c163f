// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments of all families, as a list of cells. Each source file of a family states its
// question, the sources of the expected answers, and its cost.
//
// It covers every structure of the registry: those without experiments of their own get the common
// ones, so the hard bounds of a new structure are checked as soon as it is registered.
#ifndef KINEX_EXPERIMENTS_VERIFY_CATALOGUE_H
#define KINEX_EXPERIMENTS_VERIFY_CATALOGUE_H

#include <string_view>
#include <vector>

#include "experiments/lab/cell.h"

namespace kinex::verify {

// The families of structures, in the registry's order, but for those that have the name of a group.
std::vector<std::string_view> family_names();

// `structure`: a registered name, a group (all structures for the same attribute), a family (all of a
// folder of structures/; a group of the same name comes first), or "all". Throws InputError for any
// other name.
lab::Catalogue make_catalogue(std::string_view structure, lab::Extent extent);

}  // namespace kinex::verify

#endif

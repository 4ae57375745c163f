// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of random motion: origin and destination independent and uniform in the unit square
// (interval), t in [0, 1].
//
// Parameters: seeds 1, 2, .. until the standard error of the mean number of events is below 2 %
//   (or below the values in `precise`), at least 8.
// Expected: means within two standard errors of the difference, all sizes of a family together (see
//   allowed_errors); exponents within 0.03.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_RANDOM_MOTION_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_RANDOM_MOTION_H

#include <string>

#include "experiments/lab/cell.h"

namespace kinex::families {

lab::Cell uniform_cell(std::string structure, int n, int dimension);

// The events of the structure's uniform_cells of at least `smallest` objects grow like n^exponent.
void add_uniform_growth(lab::Catalogue& catalogue, std::string claim, std::string structure,
                        double smallest, double exponent, std::string source);

// The relative standard error, of the mean, to which changes of an attribute are counted.
inline constexpr double kChangesError = 0.05;

}  // namespace kinex::families

#endif

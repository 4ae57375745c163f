// SPDX-License-Identifier: GPL-3.0-or-later
// SharedBound: a hard bound that several families have: it is drawn once.
#ifndef KINEX_EXPERIMENTS_VERIFY_SHARED_BOUND_H
#define KINEX_EXPERIMENTS_VERIFY_SHARED_BOUND_H

#include <cstddef>
#include <vector>

#include "experiments/lab/fit.h"

namespace kinex::verify {

struct SharedBound {
  std::vector<std::size_t> families;  // ascending
  std::vector<lab::FitPoint> points;  // of all of them, ascending n
};

// The bounds of families, each ascending in n; families with an empty one have none.
std::vector<SharedBound> shared_bounds(const std::vector<std::vector<lab::FitPoint>>& bounds);

}  // namespace kinex::verify

#endif

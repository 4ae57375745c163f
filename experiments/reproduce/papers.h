// SPDX-License-Identifier: GPL-3.0-or-later
// The papers that the program reproduces.
#ifndef KINEX_EXPERIMENTS_REPRODUCE_PAPERS_H
#define KINEX_EXPERIMENTS_REPRODUCE_PAPERS_H

#include <vector>

#include "experiments/lab/part.h"

namespace kinex::reproduce {

// Those of all families; the parts of one paper together, by their places.
const std::vector<lab::Paper>& papers();

}  // namespace kinex::reproduce

#endif

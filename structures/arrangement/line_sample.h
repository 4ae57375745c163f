// SPDX-License-Identifier: GPL-3.0-or-later
// The random sample of lines that a cutting is made of.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_SAMPLE_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_SAMPLE_H

#include "core/motion/scene.h"

namespace kinex {

// Of the n lines that the request is about those in the sample: as many as its parameter "r" says, or
// all; for 0 the cube root of n, rounded up. Random, but always the same for the same numbers of objects.
Subset sample_of_lines(const Request& request, const Scene& scene);

}  // namespace kinex

#endif

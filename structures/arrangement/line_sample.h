// SPDX-License-Identifier: GPL-3.0-or-later
// The random sample of lines that a cutting is made of.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_SAMPLE_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_SAMPLE_H

#include <cstddef>

#include "core/motion/scene.h"

namespace kinex {

// Of the n lines among these objects those in the sample: as many as `size` says, or all; for 0 the cube
// root of n, rounded up. Random, but always the same for the same numbers of objects.
Subset sample_of_lines(const Subset& of, const Scene& scene, std::size_t size);

}  // namespace kinex

#endif

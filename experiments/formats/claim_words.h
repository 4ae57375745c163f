// SPDX-License-Identifier: GPL-3.0-or-later
// What a certificate claims, in words, about the objects of a scene.
#ifndef KINEX_EXPERIMENTS_FORMATS_CLAIM_WORDS_H
#define KINEX_EXPERIMENTS_FORMATS_CLAIM_WORDS_H

#include "core/arithmetic/predicate.h"
#include "core/motion/scene.h"

namespace kinex::formats {

// The form of the predicate. A line y = a x + b is given by the point (a, b): in a scene of lines the words of predicates
// of points are those of lines ("the slope of {0} is at most that of {1}").
ClaimForm claim_form(const Predicate& predicate, const Scene& scene);

}  // namespace kinex::formats

#endif

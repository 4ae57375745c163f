// SPDX-License-Identifier: GPL-3.0-or-later
// LineSides: pairs of a line and a point, each with a certificate that the point is above the line
// or below it. A part of the structures incidences_..; the owner says which pairs there are.
//
// Certificates. One a pair, line_side or line_under: degree 2d for motions of degree d. A failure
// is a change of the pair, and renews its certificate.
//
// Ties. A point that is identically on a line is below it.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_SIDES_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_SIDES_H

#include "predicates/points/line_predicates.h"
#include "structures/parts/pair_sides.h"

namespace kinex {

// Pairs: a line, a point. Above is the positive side.
class LineSides : public PairSides {
 public:
  LineSides(Kernel& kernel, StructureId id)
      : PairSides(kernel, id, "sides", "line and point",
                  {.positive = {kernel.bind(make_line_side()), "the point is above", "above"},
                   .negative = {kernel.bind(make_line_under()), "the point is not above", "below"},
                   .tie = false}) {}
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/family.h"

#include "structures/proximity/closest_pair_delaunay.h"

namespace kinex {

StructureFamily proximity_family() {
  StructureInfo pair{.name = "closest_pair_delaunay",
                     .summary = "the closest pair of points in the plane, among Delaunay edges"};
  pair.min_dimension = 2;
  pair.shape = Attribute::Shape::kTuples;
  pair.reads = "delaunay_2";
  pair.kinds = {{"replace", Effect::kSometimes}, {"tie", Effect::kNever}};
  pair.certificates =
      "at most 3n - 7, one for each match in the tournament of Delaunay edges; those of "
      "delaunay_2 besides";
  pair.ties = "of pairs with identically equal distances the lexicographically smallest one";
  pair.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 9";
  pair.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<ClosestPairDelaunay>(in.kernel, in.id,
                                                 dynamic_cast<const Delaunay2&>(*in.watched));
  };
  return {"proximity", {pair}};
}

}  // namespace kinex

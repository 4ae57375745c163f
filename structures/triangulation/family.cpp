// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/family.h"

#include "structures/triangulation/delaunay_2.h"

namespace kinex {

StructureFamily triangulation_family() {
  StructureInfo delaunay{.name = "delaunay_2",
                         .summary = "the Delaunay triangulation of points in the plane"};
  delaunay.min_dimension = 2;
  delaunay.shape = Attribute::Shape::kTuples;
  delaunay.kinds = {{"flip", Effect::kSometimes},  {"enter", Effect::kSometimes},
                    {"leave", Effect::kSometimes}, {"pass", Effect::kSometimes},
                    {"blocked", Effect::kNever},   {"reinsert", Effect::kNever}};
  delaunay.make = make_plain<Delaunay2>;
  return {"triangulation", {delaunay}};
}

}  // namespace kinex

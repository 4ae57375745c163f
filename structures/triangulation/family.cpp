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
  delaunay.certificates = "3n - 3, one for each edge, those to the vertex at infinity included";
  delaunay.ties =
      "of four identically cocircular points the diagonal has the smallest id; identically "
      "collinear points of the hull are its vertices; of identically equal points the "
      "smallest id is the vertex";
  delaunay.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), section 7; "
      "Guibas, Mitchell, Roos (1991)";
  delaunay.make = make_plain<Delaunay2>;
  return {"triangulation", {delaunay}};
}

}  // namespace kinex

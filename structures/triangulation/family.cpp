// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/family.h"

#include "structures/triangulation/delaunay_2.h"
#include "structures/triangulation/delaunay_3.h"
#include "structures/triangulation/regular_2.h"

namespace kinex {

namespace {

StructureInfo delaunay_in_space() {
  StructureInfo info{.name = "delaunay_3",
                     .summary = "the Delaunay triangulation of points in space"};
  info.min_dimension = 3;
  info.shape = Attribute::Shape::kTuples;
  info.width = 4;
  info.kinds = {{"flip_2_3", Effect::kAlways}, {"flip_3_2", Effect::kAlways},
                {"enter", Effect::kAlways},    {"leave", Effect::kAlways},
                {"hull_2_3", Effect::kAlways}, {"hull_3_2", Effect::kAlways},
                {"retile", Effect::kSometimes}, {"blocked", Effect::kNever}};
  info.certificates =
      "at most (n + 1)(n - 2), one for each facet, those with the vertex at infinity included";
  info.ties =
      "of points identically on one sphere those with smaller ids have their lifted heights lowered "
      "more; of identically equal points the smallest id is the vertex; points identically in one "
      "plane have no cells";
  info.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), section 7; Joe (1991); "
      "Devillers, Teillaud (2011)";
  info.make = make_plain<Delaunay3>;
  return info;
}

StructureInfo regular_in_the_plane() {
  StructureInfo info{.name = "regular_2",
                     .summary = "the regular triangulation of points with weights in the plane"};
  info.min_dimension = 2;
  info.weights = true;
  info.shape = Attribute::Shape::kTuples;
  info.width = 3;
  info.kinds = {{"flip", Effect::kAlways},   {"enter", Effect::kAlways},
                {"leave", Effect::kAlways},  {"show", Effect::kAlways},
                {"hide", Effect::kAlways},   {"witness", Effect::kNever},
                {"retile", Effect::kSometimes}, {"blocked", Effect::kNever}};
  info.certificates =
      "at most 4n - 6: one for each edge, those to the vertex at infinity included, and four for each "
      "hidden point";
  info.ties =
      "of points identically in one lifted plane those with smaller ids have their heights lowered "
      "more; points identically on one line have no triangles";
  info.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), section 7; Edelsbrunner, "
      "Shah (1996); Devillers, Teillaud (2011)";
  info.make = make_plain<Regular2>;
  return info;
}

}  // namespace

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
  return {"triangulation", {delaunay, delaunay_in_space(), regular_in_the_plane()}};
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/family.h"

#include <string_view>
#include <utility>
#include <vector>

#include "structures/triangulation/delaunay_2.h"
#include "structures/triangulation/delaunay_3.h"
#include "structures/triangulation/regular_2.h"
#include "structures/triangulation/regular_3.h"

namespace kinex {

namespace {

StructureInfo delaunay_in_space() {
  StructureInfo info{.name = "delaunay_3",
                     .summary = "the Delaunay triangulation of points in space"};
  info.min_dimension = 3;
  info.shape = Attribute::Shape::kTuples;
  info.width = 4;
  info.kinds = {
      {"flip_2_3", Effect::kAlways, "a facet gives way to an edge: three cells replace two"},
      {"flip_3_2", Effect::kAlways, "an edge gives way to a facet: two cells replace three"},
      {"enter", Effect::kAlways, "a point reaches the hull: a cell goes"},
      {"leave", Effect::kAlways, "a point sinks below a facet of the hull: a cell comes"},
      {"hull_2_3", Effect::kAlways, "an edge of the hull goes in front of another: a cell comes"},
      {"hull_3_2", Effect::kAlways, "an edge of the hull gives way to another: a cell goes"},
      {"retile", Effect::kSometimes, "at a degenerate instant: cells are cut out and filled anew"},
      {"blocked", Effect::kNever, "at a degenerate instant: no flip repairs the facet yet"},
      {"touch", Effect::kNever,
       "at a degenerate instant: a certificate touches zero, and holds again"},
      {"plane_flip", Effect::kNever,
       "all points are in one plane: an edge there gives way to another"},
      {"plane_enter", Effect::kNever, "all points are in one plane: one reaches the hull there"},
      {"plane_leave", Effect::kNever, "all points are in one plane: one leaves the hull there"},
      {"plane_retile", Effect::kNever,
       "all are in one plane, at a degenerate instant: triangles are filled anew"},
      {"plane_blocked", Effect::kNever,
       "all are in one plane, at a degenerate instant: no flip is possible yet"},
      {"plane_touch", Effect::kNever,
       "all are in one plane, at a degenerate instant: a certificate touches zero"},
      {"line_pass", Effect::kNever,
       "all points are on one line, and two neighbours change places"}};
  info.fails_at_touch = true;
  info.certificates =
      "at most (n + 1)(n - 2), one for each facet, those with the vertex at infinity included";
  info.ties =
      "of points identically on one sphere those with smaller ids have their lifted heights "
      "lowered "
      "more; of identically equal points the smallest id is the vertex; points identically in one "
      "plane have no cells, but the triangulation of the plane for those that read edges";
  info.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), section 7; Joe (1991); "
      "Devillers, Teillaud (2011)";
  info.make = make_plain<Delaunay3>;
  return info;
}

// What regular triangulations have in common.
StructureInfo regular(std::string_view name, std::string_view summary,
                      std::vector<KindRule> kinds) {
  StructureInfo info{.name = name, .summary = summary};
  info.weights = true;
  info.fails_at_touch = true;
  info.shape = Attribute::Shape::kTuples;
  info.kinds = std::move(kinds);
  info.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), section 7; Edelsbrunner, "
      "Shah (1996); Devillers, Teillaud (2011)";
  return info;
}

StructureInfo regular_in_the_plane() {
  StructureInfo info = regular(
      "regular_2", "the regular triangulation of points with weights in the plane",
      {{"flip", Effect::kAlways, "an edge gives way to the other diagonal of its two triangles"},
       {"enter", Effect::kAlways, "a vertex reaches the hull: a triangle goes"},
       {"leave", Effect::kAlways, "a vertex sinks below an edge of the hull: a triangle comes"},
       {"show", Effect::kAlways, "a hidden point becomes a vertex"},
       {"hide", Effect::kAlways, "a vertex sinks below the plane of its neighbours, and is hidden"},
       {"witness", Effect::kNever, "a hidden point has, or waits for, another witness"},
       {"retile", Effect::kSometimes,
        "at a degenerate instant: triangles are cut out and filled anew"},
       {"blocked", Effect::kNever, "at a degenerate instant: no flip repairs the edge yet"},
       {"touch", Effect::kNever,
        "at a degenerate instant: a certificate touches zero, and holds again"}});
  info.min_dimension = 2;
  info.width = 3;
  info.certificates =
      "at most 4n - 6: one for each edge, those to the vertex at infinity included, and four for "
      "each "
      "hidden point";
  info.ties =
      "of points identically in one lifted plane those with smaller ids have their heights lowered "
      "more; of identically equal points the one of largest weight, then of smallest id, can be a "
      "vertex; points identically on one line have no triangles";
  info.make = make_plain<Regular2>;
  return info;
}

StructureInfo regular_in_space() {
  StructureInfo info = regular(
      "regular_3", "the regular triangulation of points with weights in space",
      {{"flip_2_3", Effect::kAlways, "a facet gives way to an edge: three cells replace two"},
       {"flip_3_2", Effect::kAlways, "an edge gives way to a facet: two cells replace three"},
       {"enter", Effect::kAlways, "a vertex reaches the hull: a cell goes"},
       {"leave", Effect::kAlways, "a vertex sinks below a facet of the hull: a cell comes"},
       {"hull_2_3", Effect::kAlways, "an edge of the hull goes in front of another: a cell comes"},
       {"hull_3_2", Effect::kAlways, "an edge of the hull gives way to another: a cell goes"},
       {"show", Effect::kAlways, "a hidden point becomes a vertex"},
       {"hide", Effect::kAlways, "a vertex sinks below the plane of its neighbours, and is hidden"},
       {"witness", Effect::kNever, "a hidden point has, or waits for, another witness"},
       {"retile", Effect::kSometimes, "at a degenerate instant: cells are cut out and filled anew"},
       {"blocked", Effect::kNever, "at a degenerate instant: no flip repairs the facet yet"},
       {"touch", Effect::kNever,
        "at a degenerate instant: a certificate touches zero, and holds again"},
       {"plane_flip", Effect::kNever,
        "all points are in one plane: an edge there gives way to another"},
       {"plane_enter", Effect::kNever, "all points are in one plane: one reaches the hull there"},
       {"plane_leave", Effect::kNever, "all points are in one plane: one leaves the hull there"},
       {"plane_show", Effect::kNever, "all points are in one plane: a hidden one shows there"},
       {"plane_hide", Effect::kNever, "all points are in one plane: one is hidden there"},
       {"plane_witness", Effect::kNever,
        "all are in one plane: a hidden point has, or waits for, another witness"},
       {"plane_retile", Effect::kNever,
        "all are in one plane, at a degenerate instant: triangles are filled anew"},
       {"plane_blocked", Effect::kNever,
        "all are in one plane, at a degenerate instant: no flip is possible yet"},
       {"plane_touch", Effect::kNever,
        "all are in one plane, at a degenerate instant: a certificate touches zero"}});
  info.min_dimension = 3;
  info.width = 4;
  info.certificates =
      "at most (n + 1)(n - 2): one for each facet, those with the vertex at infinity included, and "
      "five "
      "for each hidden point";
  info.ties =
      "of points identically in one lifted plane those with smaller ids have their heights lowered "
      "more; of identically equal points the one of largest weight, then of smallest id, can be a "
      "vertex; points identically in one plane have no cells, but the triangulation of the plane "
      "for those that read edges";
  info.make = make_plain<Regular3>;
  return info;
}

}  // namespace

StructureFamily triangulation_family() {
  StructureInfo delaunay{.name = "delaunay_2",
                         .summary = "the Delaunay triangulation of points in the plane"};
  delaunay.min_dimension = 2;
  delaunay.shape = Attribute::Shape::kTuples;
  delaunay.kinds = {
      {"flip", Effect::kSometimes, "an edge gives way to the other diagonal of its two triangles"},
      {"enter", Effect::kSometimes, "a point becomes a vertex of the hull"},
      {"leave", Effect::kSometimes, "a point ceases to be a vertex of the hull"},
      {"pass", Effect::kSometimes, "all points are on one line, and two neighbours change places"},
      {"blocked", Effect::kNever, "at a degenerate instant: no flip repairs the edge yet"},
      {"reinsert", Effect::kNever,
       "the instant is settled: a point is taken out and put in again"}};
  delaunay.certificates = "3n - 3, one for each edge, those to the vertex at infinity included";
  delaunay.ties =
      "of four identically cocircular points the diagonal has the smallest id; identically "
      "collinear points of the hull are its vertices; of identically equal points the "
      "smallest id is the vertex";
  delaunay.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), section 7; "
      "Guibas, Mitchell, Roos (1991)";
  delaunay.make = make_plain<Delaunay2>;
  return {"triangulation",
          {delaunay, delaunay_in_space(), regular_in_the_plane(), regular_in_space()}};
}

}  // namespace kinex

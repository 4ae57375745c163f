// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/family.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "structures/proximity/box_pairs.h"
#include "structures/proximity/closest_pair_all.h"
#include "structures/proximity/closest_pair_bins.h"
#include "structures/proximity/closest_pair_delaunay.h"
#include "structures/proximity/closest_pair_octants.h"
#include "structures/proximity/closest_pair_range_tree.h"
#include "structures/proximity/delaunay_tree.h"
#include "structures/proximity/disc_pairs.h"
#include "structures/proximity/disc_pairs_grid.h"
#include "structures/proximity/graph_tree.h"
#include "structures/proximity/nearest_site.h"
#include "structures/proximity/octant_tree.h"
#include "structures/proximity/octants_listed.h"
#include "structures/proximity/octants_local.h"
#include "structures/proximity/voronoi_cell_2.h"

namespace kinex {
namespace {

DelaunayGraph triangulation(const MakerInput& in) { return DelaunayGraph::of(*in.watched[0]); }

std::optional<Refusal> beyond_space(const Scene& scene) {
  if (scene.dimension <= 3) return std::nullopt;
  return Refusal{"is for 2 or 3 axes, the scene has " + std::to_string(scene.dimension),
                 "leave axes out, or maintain something else"};
}

std::optional<Refusal> endless(const Scene& scene) {
  if (scene.end) return std::nullopt;
  return Refusal{"keeps points in a grid over all that they pass, the scene has no end",
                 "give it an \"end\", or maintain closest_pair_all"};
}

std::optional<Refusal> endless_discs(const Scene& scene) {
  if (scene.end) return std::nullopt;
  return Refusal{"keeps discs in a grid over all that they pass, the scene has no end",
                 "give it an \"end\", or maintain disc_pairs_all"};
}

template <TreeProof proof>
std::unique_ptr<Structure> make_tree(const MakerInput& in) {
  return std::make_unique<DelaunayTree>(in.kernel, in.id, triangulation(in), proof);
}
template <TreeProof proof>
std::unique_ptr<Structure> make_octant_tree(const MakerInput& in) {
  return std::make_unique<OctantTree>(in.kernel, in.id,
                                      dynamic_cast<const OctantNeighbours&>(*in.watched[0]), proof);
}
template <TreeProof proof>
std::unique_ptr<Structure> make_graph_tree(const MakerInput& in) {
  return std::make_unique<GraphTree>(in.kernel, in.id, in.scene, proof);
}

// The closest pair, of all pairs or of those of two colours.
std::unique_ptr<Structure> make_all(const MakerInput& in, bool classes) {
  std::optional<TwoClasses> two;
  if (classes) two.emplace(in.request, in.scene);
  return std::make_unique<ClosestPairAll>(in.kernel, in.id, in.scene, std::move(two));
}
std::unique_ptr<Structure> make_delaunay(const MakerInput& in, bool classes) {
  std::optional<TwoClasses> two;
  if (classes) two.emplace(in.request, in.scene);
  return std::make_unique<ClosestPairDelaunay>(in.kernel, in.id, triangulation(in), std::move(two));
}

std::unique_ptr<Structure> make_octants_reader(const MakerInput& in, std::string_view name) {
  return std::make_unique<ClosestPairOctants>(
      in.kernel, in.id, dynamic_cast<const OctantNeighbours&>(*in.watched[0]), name);
}

std::vector<StructureInfo> octants() {
  StructureInfo base;
  base.group = "octants";
  base.role = "octants";
  base.min_dimension = 2;
  base.shape = Attribute::Shape::kTuples;
  base.ties =
      "points that are identically level are in the order after an infinitesimal turn, equal "
      "points "
      "along (2, 1) by id";

  StructureInfo listed = base;
  listed.name = "octants_listed";
  listed.summary = "the points that are next in four octants of each other, by four sorted lists";
  listed.kinds = {{"point", Effect::kSometimes}, {"order", Effect::kNever}};
  listed.certificates = "4(n - 1), one for each two neighbours by x, y, x + y and x - y";
  listed.source = "Basch, Guibas, Hershberger, Data structures for mobile data (1997)";
  listed.make = make_plain<OctantsListed>;

  StructureInfo local = base;
  local.name = "octants_local";
  local.summary = "the same, every point against the next one in each of its cones";
  local.kinds = listed.kinds;
  local.certificates =
      "at most 12n, two for each point and cone with a next point: it is in the cone";
  local.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  local.make = make_plain<OctantsLocal>;
  return {listed, local};
}

std::vector<StructureInfo> closest_pairs() {
  StructureInfo base;
  base.group = "closest_pair";
  base.shape = Attribute::Shape::kTuples;
  base.kinds = {{"replace", Effect::kSometimes}, {"tie", Effect::kNever}};
  base.ties = "of pairs with identically equal distances the lexicographically smallest one";
  base.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";

  StructureInfo delaunay = base;
  delaunay.name = "closest_pair_delaunay";
  delaunay.summary = "the closest pair of points in the plane or in space, among Delaunay edges";
  delaunay.min_dimension = 2;
  delaunay.any_dimension = true;
  delaunay.refuse = beyond_space;
  delaunay.reads = {{"delaunay_2"}};
  delaunay.certificates =
      "at most 3n - 7, in space C(n,2) - 1, one for each match in the tournament of Delaunay "
      "edges; "
      "those of delaunay_2 or delaunay_3 besides";
  delaunay.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 9";
  delaunay.make = [](const MakerInput& in) { return make_delaunay(in, false); };

  StructureInfo all = base;
  all.name = "closest_pair_all";
  all.summary = "the same among all pairs, in 1 to 3 axes: the baseline";
  all.any_dimension = true;
  all.certificates = "n(n-1)/2 - 1, one for each match in the tournament of all pairs";
  all.make = [](const MakerInput& in) { return make_all(in, false); };

  StructureInfo tree = base;
  tree.name = "closest_pair_range_tree";
  tree.summary = "the same in the plane, by four sorted lists and range trees over octants";
  tree.min_dimension = 2;
  tree.kinds = {
      {"replace", Effect::kSometimes}, {"tie", Effect::kNever}, {"order", Effect::kSometimes}};
  tree.certificates =
      "n - 1 for each of four sorted lists, fewer than 8 n ceil(log2 n) for the tournament of the "
      "pairs that range trees offer";
  tree.source = "Basch, Guibas, Zhang, Proximity problems on moving points (1997)";
  tree.make = make_plain<ClosestPairRangeTree>;

  StructureInfo cones = base;
  cones.name = "closest_pair_cones";
  cones.summary = "the same in the plane, among points that are next in an octant";
  cones.min_dimension = 2;
  cones.reads = {{"octants_listed"}};
  cones.certificates =
      "at most 4n - 1, one for each match in the tournament of the pairs of a point and the next "
      "one "
      "in an octant; those of octants_listed besides";
  cones.source = "Basch, Guibas, Hershberger, Data structures for mobile data (1997)";
  cones.make = [](const MakerInput& in) { return make_octants_reader(in, "closest_pair_cones"); };

  StructureInfo local = cones;
  local.name = "closest_pair_local";
  local.summary = "the same, without sorted lists";
  local.reads = {{"octants_local"}};
  local.certificates =
      "at most 4n - 1, one for each match in the tournament of the pairs of a point and the next "
      "one "
      "in an octant; those of octants_local besides";
  local.source = base.source;
  local.make = [](const MakerInput& in) { return make_octants_reader(in, "closest_pair_local"); };

  StructureInfo bins = base;
  bins.name = "closest_pair_bins";
  bins.summary = "the same in the plane, among points in near cells of a grid";
  bins.min_dimension = 2;
  bins.kinds = {
      {"replace", Effect::kSometimes}, {"tie", Effect::kNever}, {"cell", Effect::kSometimes}};
  bins.instead = "closest_pair_all";
  bins.refuse = endless;
  bins.certificates =
      "at most 4n for the cells of the points, and one fewer than pairs of points at most two "
      "columns and rows apart";
  bins.make = make_plain<ClosestPairBins>;

  StructureInfo two = delaunay;
  two.name = "bichromatic_pair_delaunay";
  two.group = "bichromatic_pair";
  two.summary = "the closest two points of different colours, among Delaunay edges";
  two.colours = true;
  two.certificates =
      "at most 2n - 5, in space one fewer than pairs of both colours, one for each match in the "
      "tournament of the Delaunay edges between the colours; those of delaunay_2 or delaunay_3, of "
      "the points of both, besides";
  two.source = base.source;
  two.make = [](const MakerInput& in) { return make_delaunay(in, true); };

  StructureInfo two_all = all;
  two_all.name = "bichromatic_pair_all";
  two_all.group = "bichromatic_pair";
  two_all.summary = "the same among all pairs of two colours, in 1 to 3 axes: the baseline";
  two_all.colours = true;
  two_all.certificates =
      "mn - 1 for m and n points of the two colours, one for each match in the tournament of "
      "their pairs";
  two_all.make = [](const MakerInput& in) { return make_all(in, true); };
  return {delaunay, all, tree, cones, local, bins, two, two_all};
}

std::vector<StructureInfo> spanning_trees() {
  StructureInfo base;
  base.group = "emst";
  base.min_dimension = 2;
  base.any_dimension = true;
  base.refuse = beyond_space;
  base.shape = Attribute::Shape::kTuples;
  base.reads = {{"delaunay_2"}};
  base.ties =
      "of edges with identically equal lengths the lexicographically smaller one is the shorter";
  base.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";

  StructureInfo list = base;
  list.name = "emst_list";
  list.summary = "the Euclidean minimum spanning tree, by the order of all Delaunay edges";
  list.kinds = {{"swap", Effect::kAlways}, {"order", Effect::kNever}, {"tie", Effect::kNever}};
  list.certificates =
      "at most 3n - 7, in space C(n,2) - 1, one for each two neighbours in the list of Delaunay "
      "edges; those of delaunay_2 or delaunay_3 besides";
  list.make = make_tree<TreeProof::kList>;

  StructureInfo cycles = base;
  cycles.name = "emst_cycles";
  cycles.summary = "the same, every edge outside the tree against those of its cycle";
  cycles.kinds = {{"swap", Effect::kAlways}, {"exchange", Effect::kNever}, {"tie", Effect::kNever}};
  cycles.certificates =
      "at most (2n - 5)(n - 1), in space C(n - 1, 2)(n - 1): every Delaunay edge outside the tree "
      "is the longest of its cycle; those of delaunay_2 or delaunay_3 besides";
  cycles.make = make_tree<TreeProof::kCycles>;
  return {list, cycles};
}

std::vector<StructureInfo> norm_trees() {
  StructureInfo base;
  base.group = "mst_maximum_norm";
  base.min_dimension = 2;
  base.shape = Attribute::Shape::kTuples;
  base.reads = {{"octants_local", "octants"}};
  base.ties =
      "lengths that are identically equal are in the order after an infinitesimal turn, then in "
      "that of the lengths by ids along (2, 1)";
  base.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";

  StructureInfo list = base;
  list.name = "mst_maximum_norm_list";
  list.summary =
      "the minimum spanning tree in the maximum norm, by the order of all pairs of octants";
  list.kinds = {{"swap", Effect::kAlways}, {"order", Effect::kNever}, {"tie", Effect::kNever}};
  list.certificates =
      "at most 4n - 1, one for each two neighbours in the list of the pairs of a point and the next "
      "one in an octant; those of the octants besides";
  list.make = make_octant_tree<TreeProof::kList>;

  StructureInfo cycles = base;
  cycles.name = "mst_maximum_norm_cycles";
  cycles.summary = "the same, every pair outside the tree against those of its cycle";
  cycles.kinds = {{"swap", Effect::kAlways}, {"exchange", Effect::kNever}, {"tie", Effect::kNever}};
  cycles.certificates =
      "at most (3n + 1)(n - 1): every pair of an octant outside the tree is the longest of its "
      "cycle; those of the octants besides";
  cycles.make = make_octant_tree<TreeProof::kCycles>;
  return {list, cycles};
}

StructureInfo nearest_site() {
  StructureInfo info{.name = "nearest_site",
                     .summary = "the site nearest to a moving query, by its Delaunay neighbours"};
  info.min_dimension = 2;
  info.query = true;
  info.shape = Attribute::Shape::kObject;
  info.reads = {{"delaunay_2"}};
  info.kinds = {{"replace", Effect::kSometimes}, {"tie", Effect::kNever}};
  info.certificates =
      "one for each Delaunay neighbour of the nearest site, at most n - 1 for n sites; those of "
      "delaunay_2, of the sites, besides";
  info.ties = "of sites at identically equal distances the smallest id";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  info.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<NearestSite>(
        in.kernel, in.id, dynamic_cast<const Delaunay2&>(*in.watched[0]), query_of(in.request));
  };
  return info;
}

StructureInfo voronoi_cell() {
  StructureInfo info{.name = "voronoi_cell_2",
                     .summary = "the neighbours of a site in the Voronoi diagram, in order"};
  info.min_dimension = 2;
  info.query = true;
  info.query_is_site = true;
  info.shape = Attribute::Shape::kCycle;
  info.reads = {{"delaunay_2"}};
  info.kinds = {{"leave", Effect::kAlways}, {"enter", Effect::kAlways}, {"turn", Effect::kAlways}};
  info.certificates = "none: it reads delaunay_2, of the sites";
  info.ties =
      "of sites that are identically on an empty circle the smallest is a neighbour of the others";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  info.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<VoronoiCell2>(
        in.kernel, in.id, dynamic_cast<const Delaunay2&>(*in.watched[0]), query_of(in.request));
  };
  return info;
}

std::vector<StructureInfo> graph_trees() {
  StructureInfo base;
  base.group = "graph_mst";
  base.graph = true;
  base.shape = Attribute::Shape::kTuples;
  base.width = 1;
  base.ties = "of edges with identically equal weights the smaller object is the lighter";
  base.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";

  StructureInfo list = base;
  list.name = "graph_mst_list";
  list.summary = "the minimum spanning forest of a graph, by the order of all its edges";
  list.kinds = {{"swap", Effect::kAlways}, {"order", Effect::kNever}, {"tie", Effect::kNever}};
  list.certificates = "m - 1 for m edges, one for each two neighbours in their list";
  list.make = make_graph_tree<TreeProof::kList>;

  StructureInfo cycles = base;
  cycles.name = "graph_mst_cycles";
  cycles.summary = "the same, every edge outside the forest against those of its cycle";
  cycles.kinds = {{"swap", Effect::kAlways}, {"exchange", Effect::kNever}, {"tie", Effect::kNever}};
  cycles.certificates =
      "at most (m - n + 1)(n - 1) for m edges and n vertices: every edge outside the forest is the "
      "heaviest of its cycle";
  cycles.make = make_graph_tree<TreeProof::kCycles>;
  return {list, cycles};
}

std::vector<StructureInfo> meetings() {
  StructureInfo base;
  base.any_dimension = true;
  base.shape = Attribute::Shape::kTuples;
  base.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";

  StructureInfo boxes = base;
  boxes.name = "box_pairs";
  boxes.summary = "the pairs of boxes that meet, by the order of their ends along every axis";
  boxes.extents = Extents::kHalfExtents;
  boxes.kinds = {{"meet", Effect::kAlways},
                 {"part", Effect::kAlways},
                 {"swap", Effect::kNever},
                 {"tie", Effect::kNever}};
  boxes.certificates = "2n - 1 an axis, one for each two neighbours among the ends of the boxes";
  boxes.ties = "boxes that touch identically meet; equal ends: lower ones first, then by id";
  boxes.make = make_plain<BoxPairs>;

  StructureInfo all = base;
  all.group = "disc_pairs";
  all.name = "disc_pairs_all";
  all.summary = "the pairs of discs that meet, all pairs watched: the baseline";
  all.extents = Extents::kRadius;
  all.kinds = {{"meet", Effect::kAlways},
               {"part", Effect::kAlways},
               {"change", Effect::kNever},
               {"tie", Effect::kNever}};
  all.certificates = "n(n-1)/2, one a pair";
  all.ties = "discs that touch identically meet";
  all.make = make_plain<DiscPairsAll>;

  StructureInfo in_boxes = all;
  in_boxes.name = "disc_pairs_boxes";
  in_boxes.summary = "the same, only pairs watched whose boxes meet";
  in_boxes.kinds = boxes.kinds;
  in_boxes.certificates =
      "2n - 1 an axis, one for each two neighbours among the ends of the discs' boxes, and one for "
      "each pair of boxes that meet";
  in_boxes.make = make_plain<DiscPairsBoxes>;

  StructureInfo in_cells = all;
  in_cells.name = "disc_pairs_grid";
  in_cells.summary = "the same, only pairs watched in neighbouring cells of a grid";
  in_cells.kinds.push_back({"cell", Effect::kNever});
  in_cells.instead = "disc_pairs_all";
  in_cells.refuse = endless_discs;
  in_cells.certificates =
      "at most 2n an axis for the cells of the centres, and one for each pair in neighbouring "
      "cells";
  in_cells.make = make_plain<DiscPairsGrid>;
  return {boxes, all, in_boxes, in_cells};
}

}  // namespace

StructureFamily proximity_family() {
  std::vector<StructureInfo> all = octants();
  for (StructureInfo& pair : closest_pairs()) all.push_back(std::move(pair));
  all.push_back(nearest_site());
  all.push_back(voronoi_cell());
  for (StructureInfo& tree : spanning_trees()) all.push_back(std::move(tree));
  for (StructureInfo& tree : norm_trees()) all.push_back(std::move(tree));
  for (StructureInfo& tree : graph_trees()) all.push_back(std::move(tree));
  for (StructureInfo& pairs : meetings()) all.push_back(std::move(pairs));
  return {"proximity", std::move(all)};
}

}  // namespace kinex

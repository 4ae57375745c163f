// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/family.h"

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "structures/proximity/bichromatic_pair_maximum_norm.h"
#include "structures/proximity/box_pairs.h"
#include "structures/proximity/closest_pair_all.h"
#include "structures/proximity/closest_pair_bins.h"
#include "structures/proximity/closest_pair_delaunay.h"
#include "structures/proximity/closest_pair_discs.h"
#include "structures/proximity/closest_pair_octants.h"
#include "structures/proximity/closest_pair_range_tree.h"
#include "structures/proximity/cone_frame.h"
#include "structures/proximity/cones_local.h"
#include "structures/proximity/disc_pairs.h"
#include "structures/proximity/disc_pairs_grid.h"
#include "structures/proximity/nearest_site.h"
#include "structures/proximity/octants_listed.h"
#include "structures/proximity/tree_family.h"
#include "structures/proximity/voronoi_cell_2.h"

namespace kinex {
namespace {

DelaunayGraph triangulation(const MakerInput& in) { return DelaunayGraph::of(*in.watched[0]); }

std::optional<Refusal> endless(const Scene& scene) {
  if (scene.end) return std::nullopt;
  return Refusal{"keeps points in a grid over all that they pass, and the scene has no end",
                 "give it an \"end\" in its file, which --until does not replace, or maintain "
                 "closest_pair_all"};
}

std::optional<Refusal> endless_discs(const Scene& scene) {
  if (scene.end) return std::nullopt;
  return Refusal{
      "keeps discs in a grid over all that they pass, and the scene has no end",
      "give it an \"end\" in its file, which --until does not replace, or maintain disc_pairs_all"};
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
  return std::make_unique<ClosestPairDelaunay>(
      in.kernel, in.id, classes ? "bichromatic_pair_delaunay" : "closest_pair_delaunay",
      CountedEdges(triangulation(in), std::move(two)));
}

std::unique_ptr<Structure> make_octants_reader(const MakerInput& in, std::string_view name) {
  return std::make_unique<ClosestPairOctants>(
      in.kernel, in.id, dynamic_cast<const ConeNeighbours&>(*in.watched[0]), name);
}

// The parameters of cones_local and of closest_pair_range_tree.
constexpr std::string_view kCorners = "corners", kCones = "cones";

std::vector<StructureInfo> cones() {
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
  constexpr KindRule point{"point", Effect::kSometimes, "another point is next in a cone"};
  listed.kinds = {point, {"order", Effect::kNever, "two neighbours of a list change places"}};
  listed.certificates =
      "4(n - 1), one for each two neighbours by x, y, x + y and x - y; a wood is the next points in "
      "three cones, as three of these orders tell them";
  listed.source = "Basch, Guibas, Hershberger, Data structures for mobile data (1997)";
  listed.make = make_plain<OctantsListed>;

  StructureInfo local = base;
  local.name = "octants_local";
  local.summary =
      "the points that are next in four octants of each other, every point against the next one in "
      "each of its cones";
  local.kinds = {point,
                 {"order", Effect::kNever, "a point leaves a cone in which it was the next one"}};
  local.certificates =
      "at most 12n, two for each point and cone with a next point: it is in the cone; a wood is the "
      "next points in three cones, as three orders of the points tell them";
  local.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  local.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<ConesLocal>(in.kernel, in.id, in.scene, octant_frame(), in.info().name);
  };

  StructureInfo polygon = local;
  polygon.name = "cones_local";
  polygon.group = {};
  polygon.role = "cones";
  polygon.summary =
      "the points that are next in the cones of a polygon around each other, every point against the "
      "next one in each of its cones";
  polygon.parameters = {{.name = kCorners,
                         .summary = "the corners of the polygon, on a circle: 12 or 20",
                         .usual = "12",
                         .least = "12",
                         .most = "20",
                         .step = "8"}};
  polygon.certificates =
      "at most 3cn for c corners, two for each point and cone with a next point: it is in the cone; "
      "a wood is the next points in three cones, as three orders of the points tell them";
  polygon.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    const auto corners = static_cast<int>(in.parameter(kCorners).numerator().to_int64());
    return std::make_unique<ConesLocal>(in.kernel, in.id, in.scene, polygon_frame(corners),
                                        in.info().name);
  };
  return {listed, local, polygon};
}

std::vector<StructureInfo> closest_pairs() {
  StructureInfo base;
  base.group = "closest_pair";
  base.role = "diameter";
  base.shape = Attribute::Shape::kTuples;
  base.kinds = {
      {"replace", Effect::kSometimes, "another pair wins a duel"},
      {"tie", Effect::kNever, "another pair wins a duel: the distances are identically equal"}};
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
  all.summary = "the closest pair among all pairs, in 1 to 3 axes: the baseline";
  all.any_dimension = true;
  all.certificates = "n(n-1)/2 - 1, one for each match in the tournament of all pairs";
  all.make = [](const MakerInput& in) { return make_all(in, false); };

  StructureInfo tree = base;
  tree.name = "closest_pair_range_tree";
  tree.summary =
      "the closest pair in the plane, by four sorted lists and range trees over octants or quadrants";
  tree.min_dimension = 2;
  tree.kinds.push_back({"order", Effect::kSometimes, "two neighbours of a list change places"});
  tree.parameters = {{.name = kCones,
                      .summary = "the cones around a point: 8 octants, or 4 quadrants",
                      .usual = "8",
                      .least = "4",
                      .most = "8",
                      .step = "4"}};
  tree.certificates =
      "n - 1 for each of four sorted lists, fewer than 8 n ceil(log2 n), by quadrants 10 n ceil(log2 "
      "n), for the tournament of the pairs that range trees offer";
  tree.source = "Basch, Guibas, Zhang, Proximity problems on moving points (1997)";
  tree.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    const bool octants = in.parameter(kCones).numerator().to_int64() == 8;
    return std::make_unique<ClosestPairRangeTree>(
        in.kernel, in.id, in.scene,
        octants ? ConeOffers::Cones::kOctants : ConeOffers::Cones::kQuadrants);
  };

  StructureInfo cones = base;
  cones.name = "closest_pair_cones";
  cones.summary = "the closest pair in the plane, among points that are next in an octant";
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
  local.summary =
      "the closest pair in the plane, among points that are next in an octant, without sorted lists";
  local.reads = {{"octants_local"}};
  local.certificates =
      "at most 4n - 1, one for each match in the tournament of the pairs of a point and the next "
      "one "
      "in an octant; those of octants_local besides";
  local.source = base.source;
  local.make = [](const MakerInput& in) { return make_octants_reader(in, "closest_pair_local"); };

  StructureInfo bins = base;
  bins.name = "closest_pair_bins";
  bins.summary = "the closest pair in the plane, among points in near cells of a grid";
  bins.min_dimension = 2;
  bins.kinds.push_back({"cell", Effect::kSometimes, "a point moves to the next cell"});
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
  two_all.summary = "the closest two points of different colours among all pairs, in 1 to 3 axes: the baseline";
  two_all.colours = true;
  two_all.certificates =
      "mn - 1 for m and n points of the two colours, one for each match in the tournament of "
      "their pairs";
  two_all.make = [](const MakerInput& in) { return make_all(in, true); };

  StructureInfo maximum = tree;
  maximum.name = "bichromatic_pair_maximum_norm";
  maximum.group = {};
  maximum.role = "square";
  maximum.summary =
      "the nearest two points of different colours in the maximum norm, in the plane, by four sorted "
      "lists and range trees over octants";
  maximum.colours = true;
  maximum.parameters = {};
  maximum.kinds[1].text = "another pair wins a duel: the lengths are identically equal";
  maximum.certificates =
      "n - 1 for each of four sorted lists, fewer than 12 n ceil(log2 n) for the tournament of the "
      "pairs that range trees offer";
  maximum.ties =
      "of pairs with identically equal lengths the one that is shortest after an infinitesimal turn, "
      "then after steps along (2, 1) by id, then the lexicographically smallest one";
  maximum.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<BichromaticPairMaximumNorm>(in.kernel, in.id, in.scene,
                                                        TwoClasses(in.request, in.scene));
  };
  return {delaunay, all, tree, cones, local, bins, two, two_all, maximum};
}

StructureInfo nearest_site() {
  StructureInfo info{.name = "nearest_site",
                     .summary =
                         "the site nearest to a moving query, in the plane or in space, by its "
                         "Delaunay neighbours"};
  info.min_dimension = 2;
  info.any_dimension = true;
  info.refuse = beyond_space;
  info.query = true;
  info.shape = Attribute::Shape::kObject;
  info.reads = {{"delaunay_2"}};
  info.kinds = {
      {"replace", Effect::kSometimes, "another site is nearer than the nearest one"},
      {"tie", Effect::kNever, "a smaller site is as near as the nearest one, identically"}};
  info.certificates =
      "one for each Delaunay neighbour of the nearest site, at most n - 1 for n sites; those of "
      "delaunay_2 or delaunay_3, of the sites, besides";
  info.ties = "of sites at identically equal distances the smallest id";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  info.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<NearestSite>(in.kernel, in.id, triangulation(in), query_of(in.request));
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
  info.kinds = {{"leave", Effect::kAlways, "a site ceases to be a neighbour"},
                {"enter", Effect::kAlways, "a site becomes a neighbour"},
                {"turn", Effect::kAlways, "the neighbours that stay are in another cyclic order"}};
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

std::vector<StructureInfo> meetings() {
  StructureInfo base;
  base.any_dimension = true;
  base.shape = Attribute::Shape::kTuples;
  base.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";

  StructureInfo boxes = base;
  boxes.name = "box_pairs";
  boxes.summary = "the pairs of boxes that meet, by the order of their ends along every axis";
  boxes.extents = Extents::kHalfExtents;
  boxes.kinds = {{"meet", Effect::kAlways, "two objects meet"},
                 {"part", Effect::kAlways, "two objects part"},
                 {"swap", Effect::kNever, "two neighbouring ends of boxes change places"},
                 {"tie", Effect::kNever, "two objects touch identically from now on"}};
  boxes.certificates = "2n - 1 an axis, one for each two neighbours among the ends of the boxes";
  boxes.ties = "boxes that touch identically meet; equal ends: lower ones first, then by id";
  boxes.make = make_plain<BoxPairs>;

  StructureInfo all = base;
  all.group = "disc_pairs";
  all.name = "disc_pairs_all";
  all.summary = "the pairs of discs that meet, all pairs watched: the baseline";
  all.extents = Extents::kRadius;
  all.kinds = boxes.kinds;
  all.kinds[2] = {"change", Effect::kNever, "two discs touch, at an instant that is not over"};
  all.certificates = "n(n-1)/2, one a pair";
  all.ties = "discs that touch identically meet";
  all.make = make_plain<DiscPairsAll>;

  StructureInfo in_boxes = all;
  in_boxes.name = "disc_pairs_boxes";
  in_boxes.summary = "the pairs of discs that meet, only pairs watched whose boxes meet";
  in_boxes.kinds = boxes.kinds;
  in_boxes.kinds[2].text = "two ends of boxes change places, or two discs touch";
  in_boxes.certificates =
      "2n - 1 an axis, one for each two neighbours among the ends of the discs' boxes, and one for "
      "each pair of boxes that meet";
  in_boxes.make = make_plain<DiscPairsBoxes>;

  StructureInfo in_cells = all;
  in_cells.name = "disc_pairs_grid";
  in_cells.summary = "the pairs of discs that meet, only pairs watched in neighbouring cells of a grid";
  in_cells.kinds.push_back({"cell", Effect::kNever, "a disc moves to the next cell"});
  in_cells.instead = "disc_pairs_all";
  in_cells.refuse = endless_discs;
  in_cells.certificates =
      "at most 2n an axis for the cells of the centres, and one for each pair in neighbouring "
      "cells";
  in_cells.make = make_plain<DiscPairsGrid>;
  return {boxes, all, in_boxes, in_cells};
}

StructureInfo closest_discs() {
  StructureInfo info{.name = "closest_pair_discs",
                     .summary = "the pair of discs of the smallest gap, while no two meet, among edges of "
                                "their regular triangulation"};
  info.min_dimension = 2;
  info.any_dimension = true;
  info.refuse = beyond_space;
  info.shape = Attribute::Shape::kTuples;
  info.extents = Extents::kRadius;
  info.role = "gap";
  info.reads = {{"regular_2"}};
  info.kinds = {
      {"replace", Effect::kSometimes, "another pair wins a duel"},
      {"tie", Effect::kNever, "another pair wins a duel: the gaps are identically equal"},
      {"case", Effect::kNever, "another case proves the result of a duel"},
      {"touch", Effect::kNever, "the discs of the winner meet from now on, or are apart"},
      {"contact", Effect::kAlways, "two discs meet, none did"},
      {"apart", Effect::kAlways, "no two discs meet any longer"}};
  info.certificates =
      "at most 9n - 20, in space or on a line 3 C(n,2) - 2, two or three for each match in the "
      "tournament of the edges of the regular triangulation, and one for the discs of its winner; those "
      "of regular_2 or regular_3 besides";
  info.ties =
      "of pairs with identically equal gaps the lexicographically smallest one; discs that touch "
      "identically meet";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  info.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<ClosestPairDiscs>(in.kernel, in.id, RegularGraph::of(*in.watched[0]));
  };
  return info;
}

}  // namespace

std::optional<Refusal> beyond_space(const Scene& scene) {
  if (scene.dimension <= 3) return std::nullopt;
  return Refusal{"is for 2 or 3 axes, the scene has " + std::to_string(scene.dimension),
                 "leave axes out, or maintain something else"};
}

StructureFamily proximity_family() {
  std::vector<StructureInfo> all = cones();
  for (StructureInfo& pair : closest_pairs()) all.push_back(std::move(pair));
  all.push_back(nearest_site());
  all.push_back(voronoi_cell());
  for (StructureInfo& tree : spanning_trees()) all.push_back(std::move(tree));
  for (StructureInfo& pairs : meetings()) all.push_back(std::move(pairs));
  all.push_back(closest_discs());
  return {"proximity", std::move(all)};
}

}  // namespace kinex

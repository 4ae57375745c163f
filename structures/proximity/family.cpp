// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/family.h"

#include <memory>
#include <utility>
#include <vector>

#include "structures/proximity/closest_pair_delaunay.h"
#include "structures/proximity/emst_cycles.h"
#include "structures/proximity/emst_list.h"

namespace kinex {
namespace {

std::optional<Refusal> beyond_space(const Scene& scene) {
  if (scene.dimension <= 3) return std::nullopt;
  return Refusal{"is for 2 or 3 axes, the scene has " + std::to_string(scene.dimension),
                 "leave axes out, or maintain something else"};
}

// Makes a reader of the Delaunay triangulation, that of space where the scene has three axes.
template <class S>
std::unique_ptr<Structure> make_reader(const MakerInput& in) {
  return std::make_unique<S>(in.kernel, in.id, DelaunayGraph::of(*in.watched[0]));
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
  list.make = make_reader<EmstList>;

  StructureInfo cycles = base;
  cycles.name = "emst_cycles";
  cycles.summary = "the same, every edge outside the tree against those of its cycle";
  cycles.kinds = {{"swap", Effect::kAlways}, {"exchange", Effect::kNever}, {"tie", Effect::kNever}};
  cycles.certificates =
      "at most (2n - 5)(n - 1), in space C(n - 1, 2)(n - 1): every Delaunay edge outside the tree "
      "is the longest of its cycle; those of delaunay_2 or delaunay_3 besides";
  cycles.make = make_reader<EmstCycles>;
  return {list, cycles};
}

}  // namespace

StructureFamily proximity_family() {
  StructureInfo pair{.name = "closest_pair_delaunay",
                     .summary = "the closest pair of points in the plane or in space, among Delaunay edges"};
  pair.min_dimension = 2;
  pair.any_dimension = true;
  pair.refuse = beyond_space;
  pair.shape = Attribute::Shape::kTuples;
  pair.reads = {{"delaunay_2"}};
  pair.kinds = {{"replace", Effect::kSometimes}, {"tie", Effect::kNever}};
  pair.certificates =
      "at most 3n - 7, in space C(n,2) - 1, one for each match in the tournament of Delaunay edges; "
      "those of delaunay_2 or delaunay_3 besides";
  pair.ties = "of pairs with identically equal distances the lexicographically smallest one";
  pair.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 9";
  pair.make = make_reader<ClosestPairDelaunay>;
  std::vector<StructureInfo> all{pair};
  for (StructureInfo& tree : spanning_trees()) all.push_back(std::move(tree));
  return {"proximity", std::move(all)};
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_family.h"

#include <array>
#include <memory>
#include <string_view>
#include <utility>

#include "structures/proximity/cone_tree.h"
#include "structures/proximity/delaunay_tree.h"
#include "structures/proximity/graph_tree.h"

namespace kinex {
namespace {

// Of spanning trees (TreeEventKind): what a failure does that leaves the tree as it is.
KindRule inside_rule(TreeProof proof) {
  switch (proof) {
    case TreeProof::kList:
      return {"order", Effect::kNever, "two neighbours in the list change places"};
    case TreeProof::kCycles:
      return {"exchange", Effect::kNever,
              "an edge takes the place of another, at an instant that is not over"};
    case TreeProof::kShortCycles:
      return {"cycle", Effect::kNever,
              "a proof by a cycle changes, or the tree does at an instant that is not over"};
    case TreeProof::kForests:
      return {"forest", Effect::kNever,
              "an edge takes the place of another in a forest of some edges"};
    default:
      return {"extremum", Effect::kNever,
              "the extreme edge of a path, or between two clusters, is another"};
  }
}

constexpr ParameterInfo kClusterSize{
    .name = "cluster",
    .summary = "the size of a cluster, in vertices; 0: n^(2/3) for n vertices",
    .usual = "0",
    .least = "0",
    .most = "1000000"};

// What the structures for one spanning tree do not share.
struct TreeTexts {
  std::string_view name, summary, certificates;
  TreeProof proof;
  std::unique_ptr<Structure> (*make)(const MakerInput& input);
};

// The structures for one spanning tree, each by one of these engines.
template <std::size_t size>
std::vector<StructureInfo> trees(StructureInfo base, const std::array<TreeTexts, size>& engines) {
  base.shape = Attribute::Shape::kTuples;
  base.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  std::vector<StructureInfo> result;
  for (const TreeTexts& engine : engines) {
    StructureInfo info = base;
    info.name = engine.name;
    info.summary = engine.summary;
    info.certificates = engine.certificates;
    info.make = engine.make;
    if (engine.proof == TreeProof::kClusters) info.parameters = {kClusterSize};
    info.kinds = {{"swap", Effect::kAlways, "an edge of the tree gives way to another one"},
                  inside_rule(engine.proof),
                  {"tie", Effect::kNever,
                   "two edges change places: their lengths are identically equal"}};
    result.push_back(std::move(info));
  }
  return result;
}

TreeMethod method_of(TreeProof proof, const MakerInput& in) {
  TreeMethod method{proof, 0, in.scene.objects.size()};
  if (proof == TreeProof::kClusters) {
    method.cluster =
        static_cast<std::size_t>(in.parameter(kClusterSize.name).numerator().to_int64());
  }
  return method;
}

template <TreeProof proof>
std::unique_ptr<Structure> make_delaunay_tree(const MakerInput& in) {
  return std::make_unique<DelaunayTree>(in.kernel, in.id, DelaunayGraph::of(*in.watched[0]),
                                        method_of(proof, in), in.info().name);
}
template <TreeProof proof>
std::unique_ptr<Structure> make_cone_tree(const MakerInput& in) {
  return std::make_unique<ConeTree>(in.kernel, in.id,
                                    dynamic_cast<const ConeNeighbours&>(*in.watched[0]),
                                    method_of(proof, in), in.info().name);
}
template <TreeProof proof>
std::unique_ptr<Structure> make_graph_tree(const MakerInput& in) {
  return std::make_unique<GraphTree>(in.kernel, in.id, in.scene, method_of(proof, in),
                                     in.info().name);
}

std::vector<StructureInfo> euclidean_trees() {
  StructureInfo base;
  base.group = "emst";
  base.min_dimension = 2;
  base.any_dimension = true;
  base.refuse = beyond_space;
  base.reads = {{"delaunay_2"}};
  base.ties =
      "of edges with identically equal lengths the lexicographically smaller one is the shorter";
  return trees(
      base,
      std::array{
          TreeTexts{
              "emst_list", "the Euclidean minimum spanning tree, by the order of all Delaunay edges",
              "at most 3n - 7, in space C(n,2) - 1, one for each two neighbours in the list of "
              "Delaunay edges; those of delaunay_2 or delaunay_3 besides",
              TreeProof::kList, make_delaunay_tree<TreeProof::kList>},
          TreeTexts{
              "emst_cycles",
              "the Euclidean minimum spanning tree, every edge outside it the longest of a cycle",
              "at most (2n - 5)(n - 1), in space C(n - 1, 2)(n - 1): every Delaunay edge outside the "
              "tree is the longest of a cycle, mostly of a triangle; those of delaunay_2 or "
              "delaunay_3 besides",
              TreeProof::kShortCycles, make_delaunay_tree<TreeProof::kShortCycles>},
          TreeTexts{
              "emst_clusters",
              "the Euclidean minimum spanning tree, by tournaments of groups of Delaunay edges between "
              "clusters of its vertices",
              "at most 9n + n (log2 n + 1) + nk + 2k^2 for k clusters: three a Delaunay edge, in space "
              "a pair, and the longest edges of paths in and between clusters; those of delaunay_2 or "
              "delaunay_3 besides",
              TreeProof::kClusters, make_delaunay_tree<TreeProof::kClusters>}});
}

std::vector<StructureInfo> norm_trees() {
  StructureInfo base;
  base.group = "mst_maximum_norm";
  base.min_dimension = 2;
  base.reads = {{"octants_local", "octants"}};
  base.ties =
      "lengths that are identically equal are in the order after an infinitesimal turn, then in "
      "that of the lengths by ids along (2, 1)";
  std::vector<StructureInfo> result = trees(
      base,
      std::array{
          TreeTexts{
              "mst_maximum_norm_list",
              "the minimum spanning tree in the maximum norm, by the order of all pairs of "
              "octants",
              "at most 4n - 1, one for each two neighbours in the list of the pairs of a point "
              "and the next one in an octant, 8n - 1 while pointers change; those of the octants "
              "besides",
              TreeProof::kList, make_cone_tree<TreeProof::kList>},
          TreeTexts{
              "mst_maximum_norm_cycles",
              "the minimum spanning tree in the maximum norm, every pair outside it against "
              "those of its cycle",
              "at most (3n + 1)(n - 1): every pair of an octant outside the tree is the longest "
              "of its cycle; (7n + 1)(n - 1) while pointers change; those of the octants besides",
              TreeProof::kCycles, make_cone_tree<TreeProof::kCycles>},
          TreeTexts{
              "mst_maximum_norm_clusters",
              "the minimum spanning tree in the maximum norm, by tournaments of groups of pairs "
              "of octants between clusters of the points",
              "at most 24n + n (log2 n + 1) + nk + 2k^2 for k clusters: three a pair of an "
              "octant, and the longest edges of paths in and between clusters; those of the "
              "octants besides",
              TreeProof::kClusters, make_cone_tree<TreeProof::kClusters>}});
  base.group = "mst_polygon";
  base.reads = {{"cones_local", "cones"}};
  const std::vector<StructureInfo> polygon = trees(
      base,
      std::array{
          TreeTexts{
              "mst_polygon_list",
              "a minimum spanning tree in the norm of a polygon, nearly the Euclidean one, by "
              "the order of all pairs of its cones",
              "at most cn/2 - 1 for c corners, one for each two neighbours in the list of the "
              "pairs of a point and the next one in a cone, cn - 1 while pointers change; those "
              "of the cones besides; "
              "12 corners, or 20 where \"over\" names cones_local with \"corners\": 20",
              TreeProof::kList, make_cone_tree<TreeProof::kList>},
          TreeTexts{
              "mst_polygon_cycles",
              "a minimum spanning tree in the norm of a polygon, nearly the Euclidean one, "
              "every pair outside it against those of its cycle",
              "at most ((c/2 - 1)n + 1)(n - 1) for c corners: every pair of a cone outside the "
              "tree is the longest of its cycle; ((c - 1)n + 1)(n - 1) while pointers change; "
              "those of the cones besides; "
              "12 corners, or 20 where \"over\" names cones_local with \"corners\": 20",
              TreeProof::kCycles, make_cone_tree<TreeProof::kCycles>},
          TreeTexts{
              "mst_polygon_clusters",
              "a minimum spanning tree in the norm of a polygon, nearly the Euclidean one, by "
              "tournaments of groups of pairs of its cones between clusters of the points",
              "at most 3cn + n (log2 n + 1) + nk + 2k^2 for c corners and k clusters: three a "
              "pair of a cone, and the longest edges of paths in and between clusters; those of "
              "the cones besides; "
              "12 corners, or 20 where \"over\" names cones_local with \"corners\": 20",
              TreeProof::kClusters, make_cone_tree<TreeProof::kClusters>}});
  result.insert(result.end(), polygon.begin(), polygon.end());
  return result;
}

std::vector<StructureInfo> graph_trees() {
  StructureInfo base;
  base.group = "graph_mst";
  base.graph = true;
  base.width = 1;
  base.ties = "of edges with identically equal weights the smaller object is the lighter";
  std::vector<StructureInfo> result = trees(
      base,
      std::array{
          TreeTexts{"graph_mst_list",
                    "the minimum spanning forest of a graph, by the order of all its edges",
                    "m - 1 for m edges, one for each two neighbours in their list",
                    TreeProof::kList, make_graph_tree<TreeProof::kList>},
          TreeTexts{
              "graph_mst_cycles",
              "the minimum spanning forest of a graph, every edge outside it against those of "
              "its cycle",
              "at most (m - n + 1)(n - 1) for m edges and n vertices: every edge outside the "
              "forest is the heaviest of its cycle",
              TreeProof::kCycles, make_graph_tree<TreeProof::kCycles>},
          TreeTexts{
              "graph_mst_clusters",
              "the minimum spanning forest of a graph, by tournaments of groups of edges between "
              "clusters of its vertices",
              "at most 3m + n (log2 n + 1) + nk + 2k^2 for m edges, n vertices and k clusters: "
              "three an edge, and the heaviest edges of paths in and between clusters",
              TreeProof::kClusters, make_graph_tree<TreeProof::kClusters>},
          TreeTexts{
              "graph_mst_sparsified",
              "the minimum spanning forest of a graph of many more edges than vertices, by a "
              "tournament of the forests of groups of edges",
              "at most (n - 1)^2 for each of about 2m/n nodes, m edges and n vertices: every edge "
              "outside the forest of a node is the heaviest of its cycle",
              TreeProof::kForests, make_graph_tree<TreeProof::kForests>}});
  for (StructureInfo& info : result) {
    info.kinds.back().text = "two edges change places: their weights are identically equal";
  }
  return result;
}

}  // namespace

std::vector<StructureInfo> spanning_trees() {
  std::vector<StructureInfo> all = euclidean_trees();
  for (StructureInfo& tree : norm_trees()) all.push_back(std::move(tree));
  for (StructureInfo& tree : graph_trees()) all.push_back(std::move(tree));
  return all;
}

}  // namespace kinex

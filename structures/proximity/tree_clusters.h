// SPDX-License-Identifier: GPL-3.0-or-later
// TreeClusters: the vertices of a changing forest in connected clusters of about one size.
//
// A tree is cut above a vertex wherever the vertices below it that are not cut off yet, and itself,
// are `size` or more:
//
//           a                 size 3: below d there are d, f, g, so that the edge bd is cut;
//         b   c               below b then b, e, h, so that ab is cut; what is left, a and c, is the
//       d   e                 cluster of the root, which may be smaller.
//      f g  h
//
// So a forest of n vertices in t trees has at most n / size + t clusters, each of at most
// (size - 1) D + 1 vertices if no vertex has more than D edges. Clusters that are touched by a change
// are dissolved and their vertices cut anew; they may leave one small cluster for each tree among
// them.
//
// Source: after Frederickson, "Data structures for on-line updating of minimum spanning trees"
// (1985).
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_CLUSTERS_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_CLUSTERS_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "structures/parts/claim.h"

namespace kinex {

class TreeClusters {
 public:
  using Vertex = std::uint32_t;
  using Cluster = std::uint32_t;
  static constexpr Cluster kNone = 0xffffffffu;
  struct Arc {  // of a vertex
    Item edge;
    Vertex other;
  };

  explicit TreeClusters(std::size_t vertices)
      : arcs_(vertices), cluster_of_(vertices, kNone), place_(vertices, 0), is_loose_(vertices) {}

  void clear();
  // An edge comes or goes between two vertices. Requires that the clusters of both are dissolved.
  void link(Item edge, Vertex u, Vertex v);
  void cut(Item edge, Vertex u, Vertex v);
  // Its vertices belong to no cluster.
  void dissolve(Cluster cluster);
  // A vertex in no cluster is to be in one.
  void loosen(Vertex v);
  bool any_loose() const { return !loose_.empty(); }
  // Puts all such vertices that have edges in new clusters, and returns these. O(k) for k vertices.
  std::vector<Cluster> gather(std::size_t size);

  const std::vector<Arc>& arcs(Vertex v) const { return arcs_[v]; }
  Cluster of(Vertex v) const { return cluster_of_[v]; }
  // Its place among the vertices of its cluster.
  std::size_t place(Vertex v) const { return place_[v]; }
  const std::vector<Vertex>& vertices(Cluster cluster) const { return vertices_[cluster]; }
  // Clusters are numbers below this one; those without vertices are none.
  std::size_t most() const { return vertices_.size(); }
  std::size_t count() const { return vertices_.size() - free_.size(); }
  // The number of vertices with edges.
  std::size_t linked() const { return linked_; }
  // What is wrong; empty: nothing.
  std::string defect() const;
  std::size_t bytes() const;

 private:
  Cluster fresh();

  std::vector<std::vector<Arc>> arcs_;  // by vertex
  std::vector<Cluster> cluster_of_;
  std::vector<std::size_t> place_;
  std::vector<std::vector<Vertex>> vertices_;  // by cluster
  std::vector<Cluster> free_;
  std::vector<Vertex> loose_;
  std::vector<bool> is_loose_;
  std::size_t linked_ = 0;
};

}  // namespace kinex

#endif

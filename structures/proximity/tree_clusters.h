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
// Where they are more than 2 size - 1, the vertex is split: some of its children go to a copy of it,
// until the vertices below the copy are `size` or more; the copy and these are a cluster. So on with
// further copies, until 2 size - 1 or fewer are left to the vertex itself:
//
//            h                      h . . . h  . . . h         size 2; of seven vertices two
//        / / | \ \ \               / \     / \      / \        copies take two each
//       a b  c  d e f             e   f   a   b    c   d
//
// The copies of a vertex are joined by virtual edges, which are shorter than all edges: the longest
// edge of a path is none of them. A path that enters a vertex at one copy leaves it at any other.
//
// Bounds, with s the largest `size` since the forest was cut as a whole:
//   - a cluster has at most 2s - 1 vertices, copies among them: below a copy there were fewer than
//     `size` before its last child came, which brought fewer than `size` (else it was cut off);
//   - a forest of n vertices in t trees, cut as a whole, has at most n / size + t clusters: each but
//     those of the roots has `size` vertices that are no copies for lack of room.
// A cluster has at most one copy of a vertex. Clusters that are touched by a change are dissolved:
// their copies of one vertex become one, and they are cut anew. They may leave one small cluster for
// each tree among them.
//
// Source: after Frederickson, "Data structures for on-line updating of minimum spanning trees"
// (1985), where each vertex is split into copies of degree 3; here only where there is need.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_CLUSTERS_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_CLUSTERS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "structures/parts/claim.h"

namespace kinex {

class TreeClusters {
 public:
  using Vertex = std::uint32_t;
  using Copy = std::uint32_t;  // of a vertex; the first one has its number
  using Cluster = std::uint32_t;
  static constexpr Cluster kNone = 0xffffffffu;

  explicit TreeClusters(std::size_t vertices);

  void clear();
  // The copy of a vertex to which its next edge goes: one in no cluster, if there is one.
  Copy hook(Vertex v);
  // An edge comes or goes between two copies. Requires that the clusters of both are dissolved.
  void link(Item edge, Copy a, Copy b);
  void cut(Item edge);
  // Its copies belong to no cluster.
  void dissolve(Cluster cluster);
  // A copy in no cluster is to be in one.
  void loosen(Copy copy);
  bool any_loose() const { return !loose_.empty(); }
  // Puts all such copies that have edges in new clusters, and returns these. O(k log k) for k copies
  // and their edges, and c for each of c copies of a vertex.
  std::vector<Cluster> gather(std::size_t size);

  // The edges at a copy, and the ends of an edge.
  const std::vector<Item>& edges(Copy copy) const { return edges_[copy]; }
  const std::array<Copy, 2>& ends(Item edge) const { return ends_[edge]; }
  Copy other(Item edge, Copy end) const { return ends_[edge][ends_[edge][0] == end ? 1 : 0]; }
  Vertex vertex(Copy copy) const { return vertex_of_[copy]; }
  // Ascending; none: the vertex has no edges.
  const std::vector<Copy>& copies(Vertex v) const { return copies_[v]; }
  Cluster of(Copy copy) const { return cluster_of_[copy]; }
  // Its place among the members of its cluster.
  std::size_t place(Copy copy) const { return place_[copy]; }
  const std::vector<Copy>& members(Cluster cluster) const { return members_[cluster]; }
  // Clusters are numbers below this one; those without members are none.
  std::size_t most() const { return members_.size(); }
  std::size_t count() const { return members_.size() - free_.size(); }
  // The number of members of the largest one.
  std::size_t largest() const;
  // The number of vertices with edges.
  std::size_t linked() const { return linked_; }
  // What is wrong; empty: nothing.
  std::string defect() const;
  std::size_t bytes() const;

 private:
  struct Visit {  // of a copy, from the root of its tree on
    Copy copy;
    Item from;                // the edge to it
    Copy above;               // to which this edge goes in the end
    std::size_t first, last;  // its children, in the list
    std::size_t below;        // vertices below it that are not cut off, and itself
    std::size_t group;        // 0: stays with its parent; else the number of a copy of that
  };

  Cluster fresh();
  Copy copy_of(Vertex v);
  void put(Copy copy, Cluster cluster);
  void hang(Item edge, Copy from, Copy to);
  void merge();
  void visit(Copy root);
  void share(Visit& parent, std::size_t size);
  void split(const Visit& parent, std::vector<Cluster>& result);
  std::string defect_of(Vertex v) const;
  std::string defect_in(Cluster cluster) const;

  // By copy.
  std::vector<std::vector<Item>> edges_;
  std::vector<Vertex> vertex_of_;
  std::vector<Cluster> cluster_of_;
  std::vector<std::size_t> place_;
  std::vector<bool> is_loose_;

  std::vector<std::vector<Copy>> copies_;   // by vertex
  std::vector<std::size_t> degrees_;        // by vertex
  std::vector<std::array<Copy, 2>> ends_;   // by edge
  std::vector<std::vector<Copy>> members_;  // by cluster
  std::vector<Cluster> free_;               // without members
  std::vector<Copy> unused_;                // copies that are none, beside the first ones
  std::vector<Copy> loose_;
  std::vector<Visit> visits_;
  std::size_t linked_ = 0;
};

}  // namespace kinex

#endif

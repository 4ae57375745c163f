// SPDX-License-Identifier: GPL-3.0-or-later
// LinkCutForest: a forest whose edges come and go, and the paths in it.
//
// Vertices are 0 .. n-1. Edges are numbered by the owner, from 0; an edge is a node of its own
// between its two ends, so that a path contains its edges:
//
//     vertices   a       b       c                a --- 0 --- b --- 1 --- c
//     edges          0       1
//
// A tree is cut into paths that go down. Each path is kept in a splay tree (Sleator, Tarjan 1985)
// in the order of depth, and the root of the splay tree knows the node above the path. An access to
// a node makes the path from the root of the tree to that node one splay tree:
//
//         r          before     node above         after access(d)     node above
//        / \         r, a, c    none               r, a, d             none
//       a   b        d          a                  c                   a
//      / \           b          r                  b                   r
//     c   d
//
// A flag that reverses the order of a splay tree moves the root of the tree to the end of its path.
//
// Cost: O(log n) amortised a call; path() also the length of the path. Deterministic.
#ifndef KINEX_STRUCTURES_PARTS_LINK_CUT_FOREST_H
#define KINEX_STRUCTURES_PARTS_LINK_CUT_FOREST_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kinex {

class LinkCutForest {
 public:
  using Node = std::uint32_t;  // a vertex, or an edge

  explicit LinkCutForest(std::size_t vertices)
      : vertices_(static_cast<Node>(vertices)), nodes_(vertices) {}

  // Removes all edges.
  void clear() { nodes_.assign(vertices_, {}); }
  // True if there is a path between two vertices.
  bool connected(Node u, Node v) { return u == v || (make_root(u), find_root(v) == u); }
  // Adds an edge between two vertices that are not connected.
  void link(Node edge, Node u, Node v);
  // Removes an edge, which is in the forest, between its ends.
  void cut(Node edge, Node u, Node v);
  // True if the edge is on the path between two vertices, which are connected.
  bool on_path(Node edge, Node u, Node v);
  // The edges on the path between two connected vertices, from u to v.
  std::vector<Node> path(Node u, Node v);
  std::size_t bytes() const { return nodes_.capacity() * sizeof(Links); }

 private:
  static constexpr Node kNone = 0xffffffffu;
  struct Links {
    std::array<Node, 2> child{kNone, kNone};
    Node parent = kNone;  // in the splay tree; of its root: the node above the path
    bool reversed = false;
  };

  // The node of an edge.
  Node node_of(Node edge);
  bool is_splay_root(Node x) const;
  void push_down(Node x);
  void rotate(Node x);
  void splay(Node x);
  void access(Node x);
  void make_root(Node x);
  Node find_root(Node x);
  void join(Node x, Node y);
  void part(Node x, Node y);

  Node vertices_;
  std::vector<Links> nodes_;
  std::vector<Node> above_;  // scratch
};

}  // namespace kinex

#endif

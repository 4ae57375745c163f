// SPDX-License-Identifier: GPL-3.0-or-later
// OuterHierarchy: the boomerang hierarchies of one convex polygon P. Starting from its bounding
// box, vertices are cut off by lines tangent to P; the pieces cut off tile the box minus P.
//
// Level k performs all cuts of level k at once. Between two levels there is a polygon, a stage: it
// is convex and holds P, and the next stage lies inside it. A node (boomerang) is a vertex of some
// stage: the apex, where its left edge and its right edge meet (counter-clockwise), and the chain,
// the edges of P with normals strictly between theirs. A leaf has an empty chain; its apex is a
// vertex of P. A cut makes one new edge with a child at each end:
//
//     left edge .           . right edge     P lies above
//                .         .
//               a *---c---* b                c: the new edge, tangent to P; a, b: the children
//                  .  T  .                   T: the tile of the cut
//                   .   .
//                     v                      v: the node that is cut
//
// Policies, by the line that cuts a node, and their bounds (r: radius of a disc that holds P;
// D: diameter of P; n: number of its vertices):
//   kMedian          The line of the middle edge of the chain. Depth floor(log2 n) + 1.
//   kCompass         The tangent whose normal is the middle of the node's range of directions. The
//                    range of a root is a quadrant; a cut halves it.
//   kDudley          The tangent at the point of P nearest to the middle of the node's part of the
//                    outline of a square about P (Dudley's approximation). A cut halves this part;
//                    a node below i such cuts has its apex within 5.5 r / 4^i of P.
//   kBalancedDudley  Dudley's cut at even levels. At odd level 2i + 1 nodes with more than
//                    n / 2^(i+1) edges in the chain are cut along the middle edge, the others wait.
//                    Depth O(log min(n, sqrt(D / s))) for nodes at distance s.
// For every policy there are at most sqrt(2 pi D / s) pairwise disjoint nodes with apexes at
// distance s or more. The bounds with constants are checked in every run: hierarchy_bounds.h. A cut
// whose normal would split nothing off the chain takes the chain's first or last edge instead, so
// there are at most 2 n cuts in all.
//
// All numbers are exact. Cost: built once per polygon, in O(n depth) operations on rationals of a
// few times the input's bits.
// Source: Erickson, Guibas, Stolfi, Zhang, Separation-sensitive collision detection for convex
// objects (1999), introduction; definitions, policies and constants are worked out here.
#ifndef KINEX_PREDICATES_BODIES_OUTER_HIERARCHY_H
#define KINEX_PREDICATES_BODIES_OUTER_HIERARCHY_H

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "predicates/bodies/frame_geometry.h"

namespace kinex {

enum class CutPolicy : std::uint8_t { kMedian, kCompass, kDudley, kBalancedDudley };  // of corners
std::string_view cut_policy_name(CutPolicy policy);  // its name

class OuterHierarchy {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr int kNever = 0x3fffffff;

  struct Edge {  // an edge of a polygon of the hierarchy
    FrameLine line;
    int level = -1;                             // of the cut that made it; -1: an edge of the box
    std::uint32_t creator = kNone;              // the node that was cut; kNone: an edge of the box
    std::uint32_t polygon_edge = kNone;         // the edge of P on this line, if there is one
    std::uint32_t first = kNone, last = kNone;  // the nodes at its ends when it was made
  };
  struct Node {  // a boomerang: a corner that may be cut
    FramePoint apex;
    std::uint32_t point = kNone;  // number of the apex among the distinct apexes
    std::uint32_t left_edge = kNone, right_edge = kNone;
    std::uint32_t parent = kNone;
    bool is_left = false;                // the left child of its parent
    std::uint32_t begin = 0, count = 0;  // its chain: edges begin, .. of P, cyclically
    int depth = 0;                       // cuts above it
    int dudley_depth = 0;                // Dudley cuts above it
    // set by the cut:
    int cut_level = kNever;
    std::uint32_t cut = kNone, left = kNone, right = kNone;  // the new edge, the children
  };

  // A single point: one node, no edges.
  static OuterHierarchy of_point(FramePoint point);
  static OuterHierarchy of_origin() { return of_point(frame_point(0, 0)); }
  OuterHierarchy(FramePolygon polygon, CutPolicy policy);

  const FramePolygon& polygon() const { return polygon_; }
  bool is_point() const { return edges_.empty(); }
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const Edge& edge(std::uint32_t e) const { return edges_[e]; }
  // The edge on the line of edge i of P.
  std::uint32_t edge_on(std::uint32_t i) const { return edge_on_[i]; }
  const Node& node(std::uint32_t v) const { return nodes_[v]; }
  // The leaf at the first end of an edge, in the last stage.
  std::uint32_t first_leaf(std::uint32_t e) const {
    std::uint32_t end = edges_[e].first;
    while (nodes_[end].right != kNone) end = nodes_[end].right;
    return end;
  }
  // The vertex of P at the apex of a leaf.
  std::uint32_t vertex_of(std::uint32_t leaf) const {
    return nodes_[leaf].begin % static_cast<std::uint32_t>(polygon_.size());
  }
  // The distinct apexes, in the order in which they were made.
  const std::vector<FramePoint>& points() const { return points_; }
  // The nodes that are cut, by level, then by number.
  const std::vector<std::uint32_t>& cuts() const { return cuts_; }
  // The roots: the corners of the box, counter-clockwise; corner i lies between edges i and i + 1.
  // (One node for a point.)
  std::uint32_t roots() const { return is_point() ? 1 : 4; }
  int levels() const { return levels_; }
  int depth() const;
  // A rational upper bound on the radius of the smallest disc about the box's centre that holds P,
  // at most a hundredth too large.
  const Rational& radius() const { return radius_; }
  // The least k with 2 radius() 4^k > larger.radius(): the number of quarterings that bring the larger
  // polygon's error down to the size of this one's.
  int quarterings_below(const OuterHierarchy& larger) const;
  const FramePoint& centre() const { return centre_; }
  std::size_t bytes() const;

 private:
  struct Range {  // the ends of a node's part of a square's outline, by distance along it
    Rational from, to;
  };
  OuterHierarchy() = default;
  void make_box();
  std::uint32_t add_node(std::uint32_t left_edge, std::uint32_t right_edge, std::uint32_t begin,
                         std::uint32_t count);
  void cut(std::uint32_t v, CutPolicy how, int level);
  // outer_hierarchy_cuts.cpp
  struct Choice {
    std::optional<FrameLine> line;  // nullopt: that of a polygon edge
    std::uint32_t split = 0;        // edges of the chain before the cut
    bool consumes = false;          // the cut is along edge `split` of the chain
    Rational middle;                // of the range
  };
  Choice choose(std::uint32_t v, CutPolicy how) const;
  Choice by_normal(const Node& node, const FrameLine& normal) const;
  Choice median(const Node& node) const;
  Choice compass(std::uint32_t v) const;
  Choice dudley(std::uint32_t v) const;
  std::uint32_t chain_edge(const Node& node, std::uint32_t k) const {
    return static_cast<std::uint32_t>((node.begin + k) % polygon_.size());
  }

  FramePolygon polygon_;
  std::vector<Edge> edges_;
  std::vector<Node> nodes_;
  std::vector<Range> ranges_;           // per node
  std::vector<std::uint32_t> edge_on_;  // per edge of P
  std::vector<FramePoint> points_;
  std::vector<std::uint32_t> cuts_;
  int levels_ = 0;
  Rational radius_;
  FramePoint centre_;
};

}  // namespace kinex

#endif

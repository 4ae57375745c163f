// SPDX-License-Identifier: GPL-3.0-or-later
// HierarchyBounds: the hard bounds of outer hierarchies (predicates/bodies/outer_hierarchy.h),
// checked on the hierarchies built in a run.
//
// The height s of a node is the distance of its apex from the chord between the two points where
// its chain begins and ends. It is no less than the apex's distance from P, so bounds for heights
// are bounds for distances. With the exterior angle a <= pi/2 between the node's lines,
//   s <= |chord| / 2 * tan(a / 2) <= |chord| a / pi,
// and no child is higher than its parent. r: radius(); n: number of vertices; D: diameter;
// L <= pi D: perimeter.
//   antichain  Pairwise disjoint nodes of height s or more: at most sqrt(2 L / s) <=
//              sqrt(2 pi D / s). Their chords sum to at most L, their angles to at most 2 pi;
//              Cauchy-Schwarz.
//   cuts       At most 2 n: every cut consumes an edge or splits a chain at a vertex.
//   depth      kMedian: floor(log2 n) + 1, as every cut halves the chain.
//              kCompass: floor(log2(1.1 r / s)) for a node of height s below at least one cut.
//              Below i cuts a / 2 <= 2^-i, and tan x <= 1.093 x there.
//              kDudley: floor(log4(5.5 r / s)). A cut halves the range, the node's part of the
//              square's outline; that of a root is at most 5.42 r long. Let x be its length, and m,
//              m' the vectors from the nearest points of P to its ends, both of length r or more.
//              Then |chord|^2 + |m - m'|^2 <= x^2 and sin(a / 2) <= |m - m'| / (2 r), so
//              s <= x^2 / (8 r cos(a / 2)).
//              kBalancedDudley: 2 min(floor(log2 n) + 1, floor(log4(5.5 r / s))): at least every
//              other cut above a node is Dudley's, and two levels halve the chain.
//
// Heights are computed in exact integers and rounded only at the end, to ScaledNumbers: relative
// error below 1e-12 at any scale, however small they are relative to the radius. Comparisons allow
// for 1e-9. Cost: O(n log n), a few integer products per node.
#ifndef KINEX_STRUCTURES_COLLISION_HIERARCHY_BOUNDS_H
#define KINEX_STRUCTURES_COLLISION_HIERARCHY_BOUNDS_H

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/engine/bound.h"
#include "predicates/bodies/outer_hierarchy.h"

namespace kinex {

// m 2^e with 1 <= m < 2, or 0: as precise as a double, without overflow and underflow.
struct ScaledNumber {
  double m = 0;
  long e = 0;

  bool is_zero() const { return m == 0; }
  friend bool operator<(const ScaledNumber& a, const ScaledNumber& b) {
    if (a.is_zero() || b.is_zero()) return !b.is_zero() && a.is_zero();
    return a.e != b.e ? a.e < b.e : a.m < b.m;
  }
};

// The heights of the nodes divided by the radius, indexed by node; 0 for leaves.
std::vector<ScaledNumber> relative_heights(const OuterHierarchy& tree);

// Of many counts, each with a hard bound of its own, the one with the largest ratio to its bound;
// one that violates it stays.
struct WorstRatio {
  std::int64_t bound = 0, observed = -1;  // -1: none yet
  void note(std::int64_t limit, std::int64_t seen);
};

class HierarchyBounds {
 public:
  explicit HierarchyBounds(CutPolicy policy) : policy_(policy) {}

  // Checks the bounds on a hierarchy of this policy. A point has nothing to check.
  void add(const OuterHierarchy& tree);
  // For each bound the worst case of all hierarchies added: "PREFIX.antichain", "PREFIX.depth",
  // "PREFIX.cuts"; none if there were none.
  std::vector<BoundCheck> checks(const std::string& prefix) const;

 private:
  void look_at_depths(const OuterHierarchy& tree, const std::vector<ScaledNumber>& heights);

  CutPolicy policy_;
  WorstRatio antichain_, depth_, cuts_;
};

}  // namespace kinex

#endif

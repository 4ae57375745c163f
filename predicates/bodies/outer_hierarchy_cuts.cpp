// SPDX-License-Identifier: GPL-3.0-or-later
// OuterHierarchy: the cuts chosen by each policy.
#include <optional>
#include <utility>

#include "predicates/bodies/outer_hierarchy.h"

namespace kinex {

OuterHierarchy::Choice OuterHierarchy::choose(std::uint32_t v, CutPolicy how) const {
  switch (how) {
    case CutPolicy::kMedian:
      return median(nodes_[v]);
    case CutPolicy::kCompass:
      return compass(v);
    case CutPolicy::kDudley:
    case CutPolicy::kBalancedDudley:
      break;
  }
  return dudley(v);
}

// The cut with this normal, or, if it would split nothing off the chain, along the chain's end.
OuterHierarchy::Choice OuterHierarchy::by_normal(const Node& node, const FrameLine& normal) const {
  Choice choice;
  std::uint32_t low = 0, high = node.count;  // the first edge whose normal is not before this one
  while (low < high) {
    const std::uint32_t k = (low + high) / 2;
    if (turn(polygon_.edges[chain_edge(node, k)], normal) == Sign::kPositive) {
      low = k + 1;
    } else {
      high = k;
    }
  }
  choice.split = low;
  if (low == node.count) {
    choice.split = node.count - 1;
    choice.consumes = true;
  } else if (low == 0 || turn(polygon_.edges[chain_edge(node, low)], normal) == Sign::kZero) {
    choice.consumes = true;
  } else {
    choice.line = frame_line(Rational(normal.nx), Rational(normal.ny),
                             polygon_.vertices[chain_edge(node, low)]);
  }
  return choice;
}

OuterHierarchy::Choice OuterHierarchy::median(const Node& node) const {
  Choice choice;
  choice.split = node.count / 2;
  choice.consumes = true;
  return choice;
}

// Direction k + f, for 0 <= f <= 1: on the line from axis k to axis k + 1.
OuterHierarchy::Choice OuterHierarchy::compass(std::uint32_t v) const {
  const Range& range = ranges_[v];
  const Rational middle = (range.from + range.to) / Rational(2);
  int k = 0;
  while (Rational(k + 1) <= middle) ++k;
  const Rational f = middle - Rational(k), g = Rational(1) - f;
  Rational x = g, y = f;
  for (int turn = 0; turn < k % 4; ++turn) {
    std::swap(x, y);
    x = -x;
  }
  Choice choice = by_normal(nodes_[v], frame_line(x, y, frame_point(0, 0)));
  choice.middle = middle;
  return choice;
}

// The outline of the square of half-side 2 r about the centre, parametrised by s in [-1, 7], 2 for
// a side: s = 0, 2, 4, 6 at the middles of its sides, counter-clockwise from the right one. Every
// point of it is at least r away from P, and nearest points on P move no faster than it.
OuterHierarchy::Choice OuterHierarchy::dudley(std::uint32_t v) const {
  const Node& node = nodes_[v];
  const Range& range = ranges_[v];
  const Rational middle = (range.from + range.to) / Rational(2);
  int side = 0;
  while (Rational(2 * side + 1) < middle) ++side;
  const Rational along = middle - Rational(2 * side);  // in [-1, 1], counter-clockwise
  Rational ux(1), uy = along;
  for (int turn = 0; turn < side % 4; ++turn) {
    std::swap(ux, uy);
    ux = -ux;
  }
  const Rational half = Rational(2) * radius_;
  const Rational x = Rational(centre_.x, centre_.w) + half * ux;
  const Rational y = Rational(centre_.y, centre_.w) + half * uy;

  // The nearest point of the chain: along an edge, or at a vertex.
  Choice choice;
  const std::size_t n = polygon_.size();
  for (std::uint32_t k = 0; k < node.count; ++k) {
    const std::uint32_t e = chain_edge(node, k);
    const FramePoint& p = polygon_.vertices[e];
    const FramePoint& q = polygon_.vertices[(e + 1) % n];
    const Rational px(p.x, p.w), py(p.y, p.w), qx(q.x, q.w), qy(q.y, q.w);
    const Rational dx = qx - px, dy = qy - py;
    if (((x - px) * dx + (y - py) * dy).sign() < 0) {  // nearest to p, the end of the edge before
      choice = by_normal(node, frame_line(x - px, y - py, p));
      break;
    }
    if (((x - qx) * dx + (y - qy) * dy).sign() <= 0) {
      choice.split = k;
      choice.consumes = true;
      break;
    }
    if (k + 1 == node.count) choice = by_normal(node, frame_line(x - qx, y - qy, q));
  }
  choice.middle = middle;
  return choice;
}

}  // namespace kinex

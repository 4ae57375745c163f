// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/outer_hierarchy.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace kinex {

std::string_view cut_policy_name(CutPolicy policy) {
  switch (policy) {
    case CutPolicy::kMedian:
      return "median";
    case CutPolicy::kCompass:
      return "compass";
    case CutPolicy::kDudley:
      return "dudley";
    case CutPolicy::kBalancedDudley:
      return "balanced_dudley";
  }
  return "?";
}

OuterHierarchy OuterHierarchy::of_point(FramePoint point) {
  OuterHierarchy hierarchy;
  hierarchy.centre_ = point;
  hierarchy.points_ = {point};
  Node node;
  node.apex = point;
  node.point = 0;
  hierarchy.nodes_.push_back(std::move(node));
  hierarchy.polygon_.vertices = {std::move(point)};
  return hierarchy;
}

OuterHierarchy::OuterHierarchy(FramePolygon polygon, CutPolicy policy)
    : polygon_(std::move(polygon)) {
  make_box();
  std::vector<std::uint32_t> open;  // nodes not yet cut, at this level
  for (std::uint32_t v = 0; v < 4; ++v) {
    ranges_.resize(nodes_.size());
    if (nodes_[v].count > 0) open.push_back(v);
  }
  if (policy == CutPolicy::kCompass) {
    for (std::uint32_t v = 0; v < 4; ++v) {
      ranges_[v] = {Rational(static_cast<int>(v)), Rational(static_cast<int>(v) + 1)};
    }
  } else {
    // Where the square's outline faces the first and the last vertex of the chain, see dudley().
    const Rational cx(centre_.x, centre_.w), cy(centre_.y, centre_.w), side = Rational(2) * radius_;
    const auto anchor = [&](int axis, const FramePoint& p) {
      const Rational x = (Rational(p.x, p.w) - cx) / side, y = (Rational(p.y, p.w) - cy) / side;
      switch (axis) {
        case 0:
          return y;
        case 1:
          return Rational(2) - x;
        case 2:
          return Rational(4) - y;
        case 3:
          return Rational(6) + x;
        default:
          return Rational(8) + y;
      }
    };
    for (std::uint32_t v = 0; v < 4; ++v) {
      const Node& node = nodes_[v];
      const std::size_t n = polygon_.size();
      ranges_[v] = {
          anchor(static_cast<int>(v), polygon_.vertices[node.begin % n]),
          anchor(static_cast<int>(v) + 1, polygon_.vertices[(node.begin + node.count) % n])};
    }
  }
  for (int level = 0; !open.empty(); ++level) {
    const bool median_level = policy == CutPolicy::kBalancedDudley && level % 2 == 1;
    const CutPolicy how = policy == CutPolicy::kBalancedDudley
                              ? (median_level ? CutPolicy::kMedian : CutPolicy::kDudley)
                              : policy;
    std::vector<std::uint32_t> next;
    for (const std::uint32_t v : open) {
      // More than n / 2^(i+1) edges at level 2i + 1.
      const int phase = std::min(level / 2 + 1, 40);
      if (median_level && !((std::uint64_t{nodes_[v].count} << phase) > polygon_.size())) {
        next.push_back(v);
        continue;
      }
      cut(v, how, level);
      for (const std::uint32_t child : {nodes_[v].left, nodes_[v].right}) {
        if (nodes_[child].count > 0) next.push_back(child);
      }
    }
    open = std::move(next);
    levels_ = level + 1;
  }
  ranges_.clear();
  ranges_.shrink_to_fit();
  std::map<FramePoint, std::uint32_t> numbers;
  for (Node& node : nodes_) {
    const auto [place, is_new] =
        numbers.try_emplace(node.apex, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(node.apex);
    node.point = place->second;
  }
  for (std::uint32_t v = 0; v < nodes_.size(); ++v) {
    if (nodes_[v].cut_level != kNever) cuts_.push_back(v);
  }
  std::stable_sort(cuts_.begin(), cuts_.end(), [this](std::uint32_t a, std::uint32_t b) {
    return nodes_[a].cut_level < nodes_[b].cut_level;
  });
  edge_on_.resize(polygon_.size());
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    if (edges_[e].polygon_edge != kNone) edge_on_[edges_[e].polygon_edge] = e;
  }
}

void OuterHierarchy::make_box() {
  const std::size_t n = polygon_.size();
  const Rational one(1), zero(0);
  const std::array<std::array<Rational, 2>, 4> normals{
      {{one, zero}, {zero, one}, {-one, zero}, {zero, -one}}};
  // The chain of corner q: the edges with normals strictly inside quadrant q. Edges ascend by
  // angle.
  std::array<std::uint32_t, 5> first{};  // of the edges at or beyond axis q
  for (std::uint32_t q = 0; q < 4; ++q) {
    std::uint32_t k = 0;
    while (k < n && quadrant(polygon_.edges[k]) < static_cast<int>(q)) ++k;
    first[q] = k;
  }
  first[4] = static_cast<std::uint32_t>(n);
  std::array<std::uint32_t, 4> begin{}, count{};
  for (std::uint32_t q = 0; q < 4; ++q) {
    Edge edge;
    begin[q] = first[q];
    // The vertex before the first edge at or beyond the axis is extreme there.
    const FramePoint& extreme = polygon_.vertices[first[q] % n];
    edge.line = frame_line(normals[q][0], normals[q][1], extreme);
    if (first[q] < first[q + 1]) {
      const FrameLine& e = polygon_.edges[first[q]];
      if (turn(edge.line, e) == Sign::kZero) {
        edge.polygon_edge = first[q];
        ++begin[q];
      }
    }
    count[q] = first[q + 1] - begin[q];
    edges_.push_back(std::move(edge));
  }
  for (std::uint32_t q = 0; q < 4; ++q) add_node(q, (q + 1) % 4, begin[q], count[q]);
  for (std::uint32_t q = 0; q < 4; ++q) {
    edges_[q].first = (q + 3) % 4;
    edges_[q].last = q;
  }
  // The disc about the box's centre.
  const Rational x0(-edges_[2].line.h), x1(edges_[0].line.h), y0(-edges_[3].line.h),
      y1(edges_[1].line.h);
  // The lines of the box are primitive: their normals may be longer than 1.
  const Rational left = x0 / Rational(-edges_[2].line.nx), right = x1 / Rational(edges_[0].line.nx);
  const Rational low = y0 / Rational(-edges_[3].line.ny), high = y1 / Rational(edges_[1].line.ny);
  const Rational cx = (left + right) / Rational(2), cy = (low + high) / Rational(2);
  centre_ = frame_point(cx, cy);
  Rational most;
  for (const FramePoint& p : polygon_.vertices) {
    const Rational dx = Rational(p.x, p.w) - cx, dy = Rational(p.y, p.w) - cy;
    most = std::max(most, dx * dx + dy * dy);
  }
  radius_ = root_above(most);
}

std::uint32_t OuterHierarchy::add_node(std::uint32_t left_edge, std::uint32_t right_edge,
                                       std::uint32_t begin, std::uint32_t count) {
  Node node;
  node.apex = meeting(edges_[left_edge].line, edges_[right_edge].line);
  node.left_edge = left_edge;
  node.right_edge = right_edge;
  node.begin = begin;
  node.count = count;
  nodes_.push_back(std::move(node));
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void OuterHierarchy::cut(std::uint32_t v, CutPolicy how, int level) {
  const Choice choice = choose(v, how);
  const Node parent = nodes_[v];
  Edge edge;
  edge.level = level;
  edge.creator = v;
  std::uint32_t right_begin = parent.begin + choice.split;
  std::uint32_t right_count = parent.count - choice.split;
  if (choice.consumes) {
    edge.polygon_edge = chain_edge(parent, choice.split);
    edge.line = polygon_.edges[edge.polygon_edge];
    ++right_begin;
    --right_count;
  } else {
    edge.line = *choice.line;
  }
  const std::uint32_t c = static_cast<std::uint32_t>(edges_.size());
  edges_.push_back(std::move(edge));
  const std::uint32_t left = add_node(parent.left_edge, c, parent.begin, choice.split);
  const std::uint32_t right = add_node(c, parent.right_edge, right_begin, right_count);
  edges_[c].first = left;
  edges_[c].last = right;
  const bool halves = how == CutPolicy::kDudley || how == CutPolicy::kCompass;
  ranges_.resize(nodes_.size());
  ranges_[left] = ranges_[right] = ranges_[v];
  if (halves) ranges_[left].to = ranges_[right].from = choice.middle;
  for (const std::uint32_t child : {left, right}) {
    nodes_[child].parent = v;
    nodes_[child].is_left = child == left;
    nodes_[child].depth = parent.depth + 1;
    nodes_[child].dudley_depth = parent.dudley_depth + (how == CutPolicy::kDudley ? 1 : 0);
  }
  Node& node = nodes_[v];
  node.cut_level = level;
  node.cut = c;
  node.left = left;
  node.right = right;
}

int OuterHierarchy::quarterings_below(const OuterHierarchy& larger) const {
  int k = 0;
  for (Rational reach = Rational(2) * radius_; reach <= larger.radius_; ++k) reach *= Rational(4);
  return k;
}

int OuterHierarchy::depth() const {
  int depth = 0;
  for (const Node& node : nodes_) depth = std::max(depth, node.depth);
  return depth;
}

std::size_t OuterHierarchy::bytes() const {
  constexpr std::size_t kNumbers = 3 * 24;  // limbs of a point or a line, roughly
  return nodes_.capacity() * (sizeof(Node) + kNumbers) +
         edges_.capacity() * (sizeof(Edge) + kNumbers) +
         points_.capacity() * (sizeof(FramePoint) + kNumbers) +
         2 * polygon_.size() * (sizeof(FramePoint) + kNumbers) +
         (edge_on_.capacity() + cuts_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace kinex

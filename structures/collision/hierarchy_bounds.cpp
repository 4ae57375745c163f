// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/hierarchy_bounds.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace kinex {
namespace {

constexpr double kRoom = 1 + 1e-9;

// m is finite, not negative.
ScaledNumber magnitude(double m, long e) {
  if (m == 0) return {};
  const int exponent = std::ilogb(m);
  return {std::ldexp(m, -exponent), e + exponent};
}

// m 2^e; 0 or infinity where a double ends.
double to_double(const ScaledNumber& value) {
  return std::ldexp(value.m, static_cast<int>(std::clamp(value.e, -3000L, 3000L)));
}

// |value|, rounded towards zero.
ScaledNumber magnitude(const Integer& value) {
  constexpr std::size_t kEnough = 64;
  const std::size_t bits = value.bit_length();
  const std::size_t dropped = bits > 8 * kEnough ? bits - kEnough : 0;
  return magnitude((abs(value) >> dropped).to_double(), static_cast<long>(dropped));
}

// b is not 0.
ScaledNumber quotient(const ScaledNumber& a, const ScaledNumber& b) {
  return magnitude(a.m / b.m, a.e - b.e);
}

// |a / b|; b is not 0.
ScaledNumber quotient(const Integer& a, const Integer& b) {
  return quotient(magnitude(a), magnitude(b));
}

ScaledNumber hypot(const ScaledNumber& x, const ScaledNumber& y) {
  if (x < y) return hypot(y, x);
  return magnitude(std::hypot(x.m, to_double({y.m, y.e - x.e})), x.e);
}

// floor(log2(factor / value)); value is not 0.
long floor_of_logarithm(double factor, const ScaledNumber& value) {
  return quotient(magnitude(factor, 0), value).e;
}

// floor(x / 2)
long half(long x) { return x >> 1; }

// (x, y) / w
struct Difference {
  Integer x, y, w;
};

Difference difference(const FramePoint& from, const FramePoint& to) {
  return {to.x * from.w - from.x * to.w, to.y * from.w - from.y * to.w, to.w * from.w};
}

ScaledNumber length(const Difference& d, const Rational& unit) {
  const Integer p = unit.numerator(), q = unit.denominator(), w = d.w * p;
  return hypot(quotient(d.x * q, w), quotient(d.y * q, w));
}

double relative_perimeter(const OuterHierarchy& tree) {
  const std::vector<FramePoint>& vertices = tree.polygon().vertices;
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const FramePoint& next = vertices[i + 1 == vertices.size() ? 0 : i + 1];
    sum += to_double(length(difference(vertices[i], next), tree.radius()));
  }
  return sum;
}

// floor(log2 n), n >= 1
int binary_logarithm(std::size_t n) {
  int log = 0;
  while (n > 1) {
    n /= 2;
    ++log;
  }
  return log;
}

std::int64_t floor_of(double x) {
  constexpr double kMost = 1e15;
  return x < kMost ? static_cast<std::int64_t>(std::floor(x)) : static_cast<std::int64_t>(kMost);
}

std::string_view depth_source(CutPolicy policy) {
  switch (policy) {
    case CutPolicy::kMedian:
      return "every cut halves the chain: floor(log2 n) + 1";
    case CutPolicy::kCompass:
      return "every cut halves a range of directions: log2(1.1 r / s) for a node of height s";
    case CutPolicy::kDudley:
      return "nearest points move no faster than what they are nearest to: log4(5.5 r / s)";
    case CutPolicy::kBalancedDudley:
      break;
  }
  return "2 min(floor(log2 n) + 1, log4(5.5 r / s)) for a node of height s";
}

}  // namespace

std::vector<ScaledNumber> relative_heights(const OuterHierarchy& tree) {
  std::vector<ScaledNumber> heights(tree.nodes().size());
  const std::vector<FramePoint>& vertices = tree.polygon().vertices;
  const Integer p = tree.radius().numerator(), q = tree.radius().denominator();
  for (std::size_t v = 0; v < heights.size(); ++v) {
    const OuterHierarchy::Node& node = tree.nodes()[v];
    if (node.count == 0) continue;
    const FramePoint& first = vertices[node.begin % vertices.size()];
    const FramePoint& last = vertices[(node.begin + node.count) % vertices.size()];
    const Difference to_first = difference(node.apex, first), to_last = difference(node.apex, last);
    Integer cross = to_first.x * to_last.y;
    cross.subtract_product(to_first.y, to_last.x);
    // Twice the triangle's area over r^2, and the chord over r.
    const ScaledNumber area = quotient(cross * q * q, to_first.w * to_last.w * p * p);
    const ScaledNumber chord = length(difference(first, last), tree.radius());
    if (!chord.is_zero()) heights[v] = quotient(area, chord);
    // Enforced against rounding: heights never grow downwards.
    if (node.parent != OuterHierarchy::kNone) {
      heights[v] = std::min(heights[v], heights[node.parent]);
    }
  }
  return heights;
}

void WorstRatio::note(std::int64_t limit, std::int64_t seen) {
  if (observed > bound) return;
  if (observed >= 0 && seen <= limit &&
      static_cast<double>(seen) * static_cast<double>(bound) <=
          static_cast<double>(observed) * static_cast<double>(limit)) {
    return;
  }
  bound = limit;
  observed = seen;
}

void HierarchyBounds::add(const OuterHierarchy& tree) {
  if (tree.is_point()) return;
  const std::vector<ScaledNumber> heights = relative_heights(tree);
  const std::size_t n = tree.polygon().size();
  cuts_.note(static_cast<std::int64_t>(2 * n), static_cast<std::int64_t>(tree.edges().size() - 4));
  look_at_depths(tree, heights);

  // From the highest node down: a node adds one to the antichain, unless it replaces its parent.
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < heights.size(); ++v) {
    if (!heights[v].is_zero()) order.push_back(v);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return heights[b] < heights[a]; });
  const ScaledNumber twice_perimeter = magnitude(2 * relative_perimeter(tree), 0);
  std::vector<std::uint8_t> is_end(heights.size(), 0);
  std::int64_t ends = 0;
  for (const std::uint32_t v : order) {
    const std::uint32_t parent = tree.node(v).parent;
    is_end[v] = 1;
    if (parent != OuterHierarchy::kNone && is_end[parent] != 0) {
      is_end[parent] = 0;
    } else {
      ++ends;
    }
    antichain_.note(floor_of(std::sqrt(to_double(quotient(twice_perimeter, heights[v]))) * kRoom),
                    ends);
  }
}

void HierarchyBounds::look_at_depths(const OuterHierarchy& tree,
                                     const std::vector<ScaledNumber>& heights) {
  const int halvings = binary_logarithm(tree.polygon().size()) + 1;
  if (policy_ == CutPolicy::kMedian) {
    depth_.note(halvings, tree.depth());
    return;
  }
  if (policy_ == CutPolicy::kBalancedDudley) depth_.note(2 * halvings, tree.depth());
  for (std::size_t v = 0; v < heights.size(); ++v) {
    const OuterHierarchy::Node& node = tree.nodes()[v];
    if (node.depth == 0 || heights[v].is_zero()) continue;
    switch (policy_) {
      case CutPolicy::kCompass:
        depth_.note(floor_of_logarithm(1.1 * kRoom, heights[v]), node.depth);
        break;
      case CutPolicy::kDudley:
        depth_.note(half(floor_of_logarithm(5.5 * kRoom, heights[v])), node.depth);
        break;
      case CutPolicy::kBalancedDudley:
        depth_.note(2 * half(floor_of_logarithm(5.5 * kRoom, heights[v])), node.depth);
        break;
      case CutPolicy::kMedian:
        break;
    }
  }
}

std::vector<BoundCheck> HierarchyBounds::checks(const std::string& prefix) const {
  std::vector<BoundCheck> result;
  if (cuts_.observed < 0) return result;
  const auto add = [&](const char* what, std::string source, const WorstRatio& worst) {
    result.push_back(at_most(prefix + what, std::move(source), Integer(worst.bound),
                             Integer(std::max<std::int64_t>(worst.observed, 0))));
  };
  add(".antichain", "disjoint nodes of height s or more: sqrt(2 L / s) <= sqrt(2 pi D / s)",
      antichain_);
  add(".depth", std::string(depth_source(policy_)), depth_);
  add(".cuts", "every cut consumes an edge or splits a chain at a vertex: 2 n", cuts_);
  return result;
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// The hierarchies of one polygon: the claims of their header, all policies, exactly.
#include "predicates/bodies/outer_hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/sanitized.h"
#include "tests/structures/collision/body_polygons.h"

namespace kinex::test {
namespace outer_hierarchy_test {

constexpr CutPolicy kPolicies[] = {CutPolicy::kMedian, CutPolicy::kCompass, CutPolicy::kDudley,
                                   CutPolicy::kBalancedDudley};
constexpr std::uint32_t kNone = OuterHierarchy::kNone;
const int kSize = kSanitized ? 12 : 28;

using Node = OuterHierarchy::Node;
using Edge = OuterHierarchy::Edge;

Vertex2 place(const FramePoint& p) { return {Rational(p.x, p.w), Rational(p.y, p.w)}; }

Rational square(const Rational& x) { return x * x; }
Rational squared_way(const Vertex2& a, const Vertex2& b) {
  return square(a[0] - b[0]) + square(a[1] - b[1]);
}

// From a point outside to a polygon, by all its edges.
Rational squared_distance(const Vertex2& p, const std::vector<Vertex2>& polygon) {
  Rational least = squared_way(p, polygon[0]);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex2& a = polygon[i];
    const Vertex2& b = polygon[(i + 1) % polygon.size()];
    const Rational dx = b[0] - a[0], dy = b[1] - a[1], length = dx * dx + dy * dy;
    const Rational along = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy;
    least = std::min(least, squared_way(p, a));
    if (along.sign() <= 0 || along >= length) continue;
    least = std::min(least, square((p[0] - a[0]) * dy - (p[1] - a[1]) * dx) / length);
  }
  return least;
}

Rational double_area(const std::vector<Vertex2>& polygon) {
  Rational area;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex2& a = polygon[i];
    const Vertex2& b = polygon[(i + 1) % polygon.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

struct Built {
  Built(const Polygon& input, CutPolicy how)
      : tree(frame_polygon(input, false), how), policy(how), n(input.size()) {
    for (const FramePoint& p : tree.polygon().vertices) vertices.push_back(place(p));
    for (const Node& node : tree.nodes()) {
      squared.push_back(squared_distance(place(node.apex), vertices));
    }
    for (const Vertex2& a : vertices) {
      for (const Vertex2& b : vertices) diameter = std::max(diameter, squared_way(a, b));
    }
  }
  // The nodes of the stage before level k, counter-clockwise.
  std::vector<std::uint32_t> stage(int k) const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t root = 0; root < 4; ++root) collect(root, k, result);
    return result;
  }
  void collect(std::uint32_t v, int k, std::vector<std::uint32_t>& result) const {
    const Node& node = tree.node(v);
    if (node.cut_level >= k) {
      result.push_back(v);
      return;
    }
    collect(node.left, k, result);
    collect(node.right, k, result);
  }
  std::vector<Vertex2> apexes(const std::vector<std::uint32_t>& nodes) const {
    std::vector<Vertex2> result;
    for (const std::uint32_t v : nodes) result.push_back(place(tree.node(v).apex));
    return result;
  }

  OuterHierarchy tree;
  CutPolicy policy;
  std::size_t n;
  std::vector<Vertex2> vertices;
  std::vector<Rational> squared;  // per node: its apex's distance, squared
  Rational diameter;              // squared
};

struct NamedBuilt {
  std::string name;
  Built built;
};

// All policies for all polygons.
const std::vector<NamedBuilt>& zoo() {
  static const std::vector<NamedBuilt> kZoo = [] {
    std::vector<NamedBuilt> all;
    for (const NamedPolygon& one : polygon_zoo(kSize)) {
      for (const CutPolicy policy : kPolicies) {
        all.push_back(
            {one.name + ", " + std::string(cut_policy_name(policy)), Built(one.polygon, policy)});
      }
    }
    return all;
  }();
  return kZoo;
}

template <class Check>
void for_all(const Check& check) {
  for (const NamedBuilt& one : zoo()) {
    SCOPED_TRACE(one.name);
    check(one.built);
    if (testing::Test::HasFailure()) return;
  }
}

// Every edge of the polygon is the line of one edge of the hierarchy; cuts are at most 2 n.
TEST(OuterHierarchy, ConsumesEveryEdgeOnce) {
  for_all([](const Built& built) {
    std::vector<int> seen(built.n, 0);
    for (const Edge& edge : built.tree.edges()) {
      if (edge.polygon_edge == kNone) continue;
      ++seen[edge.polygon_edge];
      EXPECT_EQ(edge.line, built.tree.polygon().edges[edge.polygon_edge]);
    }
    for (const int times : seen) EXPECT_EQ(times, 1);
    EXPECT_LE(built.tree.edges().size() - 4, 2 * built.n);
    EXPECT_EQ(built.tree.nodes().size(), 4 + 2 * (built.tree.edges().size() - 4));
  });
}

void check_node(const Built& built, std::uint32_t v) {
  const OuterHierarchy& tree = built.tree;
  const Node& node = tree.node(v);
  const FrameLine &left = tree.edge(node.left_edge).line, &right = tree.edge(node.right_edge).line;
  EXPECT_EQ(turn(left, right), Sign::kPositive);
  EXPECT_EQ(side(left, node.apex), Sign::kZero);
  EXPECT_EQ(side(right, node.apex), Sign::kZero);
  EXPECT_EQ(tree.points()[node.point], node.apex);
  const FramePolygon& polygon = tree.polygon();
  for (std::uint32_t k = 0; k < node.count; ++k) {
    const FrameLine& edge = polygon.edges[(node.begin + k) % built.n];
    EXPECT_EQ(turn(left, edge), Sign::kPositive);
    EXPECT_EQ(turn(edge, right), Sign::kPositive);
  }
  if (node.count == 0) {
    EXPECT_EQ(node.cut, kNone);
    EXPECT_EQ(node.cut_level, OuterHierarchy::kNever);
    EXPECT_EQ(node.apex, polygon.vertices[node.begin % built.n]);
    return;
  }
  ASSERT_NE(node.cut, kNone);
  const Edge& cut = tree.edge(node.cut);
  EXPECT_EQ(cut.creator, v);
  EXPECT_EQ(cut.level, node.cut_level);
  EXPECT_EQ(cut.first, node.left);
  EXPECT_EQ(cut.last, node.right);
  EXPECT_EQ(turn(left, cut.line), Sign::kPositive);
  EXPECT_EQ(turn(cut.line, right), Sign::kPositive);
  const Node &a = tree.node(node.left), &b = tree.node(node.right);
  EXPECT_TRUE(a.is_left);
  EXPECT_FALSE(b.is_left);
  EXPECT_EQ(a.left_edge, node.left_edge);
  EXPECT_EQ(a.right_edge, node.cut);
  EXPECT_EQ(b.left_edge, node.cut);
  EXPECT_EQ(b.right_edge, node.right_edge);
  EXPECT_EQ(side(left, a.apex), Sign::kZero);
  EXPECT_EQ(side(right, b.apex), Sign::kZero);
  EXPECT_EQ(side(cut.line, node.apex), Sign::kPositive);
  const std::uint32_t consumed = cut.polygon_edge == kNone ? 0 : 1;
  EXPECT_EQ(a.begin, node.begin);
  EXPECT_EQ(a.count + consumed + b.count, node.count);
  EXPECT_EQ(b.begin, node.begin + a.count + consumed);
  for (const std::uint32_t child : {node.left, node.right}) {
    EXPECT_EQ(tree.node(child).parent, v);
    EXPECT_EQ(tree.node(child).depth, node.depth + 1);
    EXPECT_GT(tree.node(child).cut_level, node.cut_level);
    EXPECT_LE(built.squared[child], built.squared[v]);  // distances never grow downwards
  }
}

TEST(OuterHierarchy, NodesAreBoomerangs) {
  for_all([](const Built& built) {
    for (std::uint32_t v = 0; v < built.tree.nodes().size(); ++v) check_node(built, v);
    for (const Edge& edge : built.tree.edges()) {  // tangents
      bool touches = false;
      for (const FramePoint& p : built.tree.polygon().vertices) {
        const Sign where = side(edge.line, p);
        EXPECT_NE(where, Sign::kPositive);
        touches = touches || where == Sign::kZero;
      }
      EXPECT_TRUE(touches);
    }
  });
}

// Every stage is a convex polygon inside the one before; the last is the polygon itself, and the
// cuts removed exactly what lies between it and the box.
TEST(OuterHierarchy, StagesAreNestedAndConvex) {
  for_all([](const Built& built) {
    const OuterHierarchy& tree = built.tree;
    std::vector<std::uint32_t> outer;
    Rational removed;
    for (int k = 0; k <= tree.levels(); ++k) {
      const std::vector<std::uint32_t> nodes = built.stage(k);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Node& node = tree.node(nodes[i]);
        const Node& next = tree.node(nodes[(i + 1) % nodes.size()]);
        EXPECT_EQ(node.right_edge, next.left_edge);
        for (const std::uint32_t other : nodes) {
          EXPECT_NE(side(tree.edge(node.right_edge).line, tree.node(other).apex), Sign::kPositive);
        }
        for (const std::uint32_t other : outer) {
          EXPECT_NE(side(tree.edge(tree.node(other).left_edge).line, node.apex), Sign::kPositive);
        }
      }
      const std::vector<Vertex2> stage = built.apexes(nodes);
      if (k > 0) {
        EXPECT_LE(double_area(stage), double_area(built.apexes(outer)));
      }
      outer = nodes;
    }
    for (const Node& node : tree.nodes()) {
      if (node.cut == kNone) continue;
      removed += double_area(
          {place(tree.node(node.left).apex), place(node.apex), place(tree.node(node.right).apex)});
    }
    EXPECT_EQ(double_area(built.apexes(built.stage(0))) - removed, double_area(built.vertices));
    std::set<Vertex2> last;
    for (const Vertex2& v : built.apexes(built.stage(tree.levels()))) last.insert(v);
    EXPECT_EQ(last, std::set<Vertex2>(built.vertices.begin(), built.vertices.end()));
  });
}

Rational power(int base, int exponent) {
  Rational result(1);
  for (int i = 0; i < exponent; ++i) result *= Rational(base);
  return result;
}

// Below i of Dudley's cuts an apex is within 5.5 r / 4^i of the polygon.
TEST(OuterHierarchy, DudleyBoundsDistances) {
  for_all([](const Built& built) {
    for (const FramePoint& p : built.tree.polygon().vertices) {
      EXPECT_LE(squared_way(place(p), place(built.tree.centre())), square(built.tree.radius()));
    }
    if (built.policy != CutPolicy::kDudley && built.policy != CutPolicy::kBalancedDudley) return;
    const Rational most = square(over(11, 2) * built.tree.radius());
    for (std::uint32_t v = 0; v < built.tree.nodes().size(); ++v) {
      EXPECT_LE(built.squared[v] * power(16, built.tree.node(v).dudley_depth), most);
    }
  });
}

// Disjoint nodes whose apexes are at distance s or more are at most sqrt(2 pi D / s): the lowest
// ones of those; under kDudley all of them are at most 8 sqrt(5.5 r / s).
TEST(OuterHierarchy, FewNodesAreFarAway) {
  for_all([](const Built& built) {
    for (int j = 0; j < 24; ++j) {
      const Rational s = built.diameter / power(16, j);  // squared
      std::int64_t all = 0, lowest = 0;
      for (std::uint32_t v = 0; v < built.tree.nodes().size(); ++v) {
        if (built.squared[v] < s) continue;
        ++all;
        const Node& node = built.tree.node(v);
        if (node.cut != kNone &&
            (built.squared[node.left] >= s || built.squared[node.right] >= s)) {
          continue;
        }
        ++lowest;
      }
      // count^2 <= 2 pi D / s, squared once more
      EXPECT_LE(square(square(Rational(lowest))) * s,
                square(over(628319, 100000)) * built.diameter);
      if (built.policy == CutPolicy::kDudley) {
        EXPECT_LE(square(square(Rational(all))) * s, square(Rational(352) * built.tree.radius()));
      }
    }
  });
}

TEST(OuterHierarchy, DepthIsBounded) {
  for_all([](const Built& built) {
    const Rational n(static_cast<std::int64_t>(built.n));
    int log = 0;
    while (power(2, log) < n) ++log;
    if (built.policy == CutPolicy::kMedian) {
      EXPECT_LE(built.tree.depth(), log + 1);
    }
    if (built.policy != CutPolicy::kBalancedDudley) return;
    // depth <= 2 (x + 1) with x = log2 n and with x = log4(5.5 r / s), s the node's distance
    for (std::uint32_t v = 0; v < built.tree.nodes().size(); ++v) {
      if (built.squared[v].is_zero()) continue;
      const Rational reach = power(2, std::max(0, built.tree.node(v).depth - 2));
      EXPECT_LE(reach, square(n));
      EXPECT_LE(square(reach) * built.squared[v], square(over(11, 2) * built.tree.radius()));
    }
  });
}

// The policies differ in depth: plain Dudley goes down a corner of n vertices one by one,
// the balanced one halves the chain.
TEST(OuterHierarchy, BalancedIsShallowAtASharpCorner) {
  const Polygon chain = geometric_chain(28);
  EXPECT_GE(Built(chain, CutPolicy::kDudley).tree.depth(), 20);
  EXPECT_LE(Built(chain, CutPolicy::kBalancedDudley).tree.depth(), 12);
  EXPECT_LE(Built(chain, CutPolicy::kMedian).tree.depth(), 6);
}

TEST(OuterHierarchy, DoesNotDependOnTheFirstVertex) {
  for (const NamedPolygon& one : polygon_zoo(kSize / 2)) {
    SCOPED_TRACE(one.name);
    for (const CutPolicy policy : kPolicies) {
      const Built built(one.polygon, policy);
      for (const std::size_t first : {std::size_t{1}, one.polygon.size() / 2}) {
        const Built other(from_vertex(one.polygon, first), policy);
        ASSERT_EQ(built.tree.nodes().size(), other.tree.nodes().size());
        EXPECT_EQ(built.tree.points(), other.tree.points());
        for (std::uint32_t e = 0; e < built.tree.edges().size(); ++e) {
          EXPECT_EQ(built.tree.edge(e).line, other.tree.edge(e).line);
          EXPECT_EQ(built.tree.edge(e).level, other.tree.edge(e).level);
        }
        for (std::uint32_t v = 0; v < built.tree.nodes().size(); ++v) {
          EXPECT_EQ(built.tree.node(v).cut, other.tree.node(v).cut);
        }
      }
    }
  }
}

// The same polygon in other units and at another place is cut alike by the policies that depend on
// normals alone. (Dudley's squares have rounded radii.)
TEST(OuterHierarchy, DoesNotDependOnUnits) {
  Random random(3);
  for (int round = 0; round < 10; ++round) {
    const Polygon polygon = random_hull(random, 12, 50);
    const Rational factor = *Rational::parse(round % 2 == 0 ? "1e25" : "3e-25");
    const Polygon other =
        shifted(scaled(polygon, factor, factor), *Rational::parse("1e9"), over(-1, 7));
    for (const CutPolicy policy : {CutPolicy::kMedian, CutPolicy::kCompass}) {
      const Built a(polygon, policy), b(other, policy);
      ASSERT_EQ(a.tree.nodes().size(), b.tree.nodes().size());
      for (std::uint32_t v = 0; v < a.tree.nodes().size(); ++v) {
        EXPECT_EQ(a.tree.node(v).cut_level, b.tree.node(v).cut_level);
      }
    }
  }
}

TEST(OuterHierarchy, APointHasOneNode) {
  const OuterHierarchy point = OuterHierarchy::of_point(frame_point(over(1, 3), 2));
  EXPECT_TRUE(point.is_point());
  EXPECT_EQ(point.roots(), 1u);
  EXPECT_EQ(point.nodes().size(), 1u);
  EXPECT_EQ(point.levels(), 0);
  EXPECT_EQ(point.depth(), 0);
  EXPECT_EQ(point.node(0).apex, frame_point(over(1, 3), 2));
}

}  // namespace outer_hierarchy_test
}  // namespace kinex::test

// SPDX-License-Identifier: GPL-3.0-or-later
// The hard bounds of outer hierarchies: they hold, they are near the observed values, and the
// observed values agree with exact rationals.
#include "structures/collision/hierarchy_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/sanitized.h"
#include "tests/structures/collision/body_polygons.h"

namespace kinex::test {
namespace hierarchy_bounds_test {

constexpr CutPolicy kPolicies[] = {CutPolicy::kMedian, CutPolicy::kCompass, CutPolicy::kDudley,
                                   CutPolicy::kBalancedDudley};

OuterHierarchy built(const Polygon& polygon, CutPolicy policy) {
  return OuterHierarchy(frame_polygon(polygon, false), policy);
}

std::vector<BoundCheck> checks_of(const OuterHierarchy& tree, CutPolicy policy) {
  HierarchyBounds bounds(policy);
  bounds.add(tree);
  return bounds.checks("h");
}

const BoundCheck& one(const std::vector<BoundCheck>& checks, const std::string& id) {
  return *std::find_if(checks.begin(), checks.end(),
                       [&](const BoundCheck& check) { return check.id == id; });
}

TEST(HierarchyBounds, HoldForEveryPolygonAndPolicy) {
  for (const NamedPolygon& polygon : polygon_zoo(kSanitized ? 12 : 40)) {
    for (const CutPolicy policy : kPolicies) {
      SCOPED_TRACE(polygon.name + ", " + std::string(cut_policy_name(policy)));
      const auto checks = checks_of(built(polygon.polygon, policy), policy);
      ASSERT_EQ(checks.size(), 3u);
      for (const BoundCheck& check : checks) {
        EXPECT_TRUE(check.holds) << check.id << ": " << check.observed.to_string() << " > "
                                 << check.bound.to_string();
      }
    }
  }
}

Vertex2 place(const FramePoint& p) { return {Rational(p.x, p.w), Rational(p.y, p.w)}; }

Rational squared_way(const Vertex2& a, const Vertex2& b) {
  const Rational x = a[0] - b[0], y = a[1] - b[1];
  return x * x + y * y;
}

// The square of the height over the radius, in rationals.
Rational squared_height(const OuterHierarchy& tree, const OuterHierarchy::Node& node) {
  const auto& vertices = tree.polygon().vertices;
  const Vertex2 v = place(node.apex), a = place(vertices[node.begin % vertices.size()]),
                b = place(vertices[(node.begin + node.count) % vertices.size()]);
  const Rational area = (a[0] - v[0]) * (b[1] - v[1]) - (a[1] - v[1]) * (b[0] - v[0]);
  return area * area / squared_way(a, b) / (tree.radius() * tree.radius());
}

Rational exact(const ScaledNumber& value) {
  const Rational scale(Integer::power_of_two(static_cast<unsigned long>(std::abs(value.e))));
  const Rational m = *Rational::from_double(value.m);
  return value.e < 0 ? m / scale : m * scale;
}

void expect_heights(const OuterHierarchy& tree) {
  const std::vector<ScaledNumber> heights = relative_heights(tree);
  for (std::size_t v = 0; v < heights.size(); ++v) {
    const OuterHierarchy::Node& node = tree.nodes()[v];
    if (node.count == 0) {
      EXPECT_TRUE(heights[v].is_zero());
      continue;
    }
    const Rational height = exact(heights[v]), expected = squared_height(tree, node);
    EXPECT_NEAR((height * height / expected).to_double(), 1, 2e-12);
    if (node.parent != OuterHierarchy::kNone) {
      EXPECT_LE(expected, squared_height(tree, tree.node(node.parent)));
    }
  }
}

TEST(HierarchyBounds, HeightsAreThoseOfRationalsAtAnyScale) {
  for (const char* factor : {"1", "1e300", "1e-300", "1e400", "1e-400"}) {
    for (const NamedPolygon& polygon : polygon_zoo(kSanitized ? 8 : 16)) {
      const Rational scale = *Rational::parse(factor);
      const Polygon there = shifted(scaled(polygon.polygon, scale, scale), over(1000001, 3), 7);
      for (const CutPolicy policy : kPolicies) {
        SCOPED_TRACE(polygon.name + " times " + factor);
        expect_heights(built(there, policy));
      }
    }
  }
}

// A corner that is rounded so finely that heights, chords or their products are below all doubles.
TEST(HierarchyBounds, HeightsThatNoDoubleHoldsAreMeasuredToo) {
  for (const char* size : {"1e-100", "1e-157", "1e-162", "1e-200", "1e-310", "1e-400"}) {
    const Rational unit = *Rational::parse(size);
    Polygon polygon{{Rational(-1), Rational(0)}};
    for (int k = -8; k <= 8; ++k) {  // on a parabola that opens towards -x
      polygon.push_back({Rational(1) - Rational(k * k) * unit, Rational(k) * unit});
    }
    for (const CutPolicy policy : kPolicies) {
      SCOPED_TRACE(std::string(size) + ", " + std::string(cut_policy_name(policy)));
      const OuterHierarchy tree = built(polygon, policy);
      expect_heights(tree);
      for (const BoundCheck& check : checks_of(tree, policy)) {
        EXPECT_TRUE(check.holds) << check.id;
        // A bound on fine nodes is looked at: there is more than one of them.
        if (check.id == "h.antichain") {
          EXPECT_GE(check.observed, Integer(1));
        }
      }
    }
  }
}

// The largest set of disjoint nodes of height s or more, by its recurrence, for every s.
std::int64_t largest_antichain(const OuterHierarchy& tree, std::uint32_t v, const Rational& s) {
  const OuterHierarchy::Node& node = tree.node(v);
  if (node.count == 0) return 0;
  const std::int64_t own = squared_height(tree, node) >= s ? 1 : 0;
  return std::max(own,
                  largest_antichain(tree, node.left, s) + largest_antichain(tree, node.right, s));
}

TEST(HierarchyBounds, TheAntichainIsTheWorstOfAllHeights) {
  for (const NamedPolygon& polygon : polygon_zoo(kSanitized ? 6 : 12)) {
    for (const CutPolicy policy : {CutPolicy::kMedian, CutPolicy::kBalancedDudley}) {
      SCOPED_TRACE(polygon.name);
      const OuterHierarchy tree = built(polygon.polygon, policy);
      double perimeter = 0, worst = 0;
      for (std::size_t i = 0; i < polygon.polygon.size(); ++i) {
        const Vertex2& next = polygon.polygon[(i + 1) % polygon.polygon.size()];
        perimeter += std::sqrt(
            (squared_way(polygon.polygon[i], next) / (tree.radius() * tree.radius())).to_double());
      }
      for (const OuterHierarchy::Node& node : tree.nodes()) {
        if (node.count == 0) continue;
        const Rational s = squared_height(tree, node);
        std::int64_t ends = 0;
        for (std::uint32_t root = 0; root < 4; ++root) ends += largest_antichain(tree, root, s);
        const double limit = std::floor(std::sqrt(2 * perimeter / std::sqrt(s.to_double())) + 1e-6);
        worst = std::max(worst, static_cast<double>(ends) / limit);
      }
      const auto checks = checks_of(tree, policy);
      const BoundCheck& check = one(checks, "h.antichain");
      if (worst == 0) {  // a box
        EXPECT_TRUE(check.observed.is_zero());
        continue;
      }
      EXPECT_NEAR(Rational(check.observed).to_double() / Rational(check.bound).to_double(), worst,
                  1e-9);
    }
  }
}

// The bounds are not vacuous: observed values come near them.
TEST(HierarchyBounds, AreNotFarFromWhatIsThere) {
  for (const CutPolicy policy : kPolicies) {
    SCOPED_TRACE(cut_policy_name(policy));
    const auto checks = checks_of(built(regular(128, 0.4), policy), policy);
    for (const BoundCheck& check : checks) {
      EXPECT_GE(Integer(5) * check.observed, Integer(2) * check.bound) << check.id;
    }
  }
}

// A tree is checked against the bounds of its stated policy.
TEST(HierarchyBounds, TellPoliciesApart) {
  const Polygon chain = geometric_chain(28);
  const OuterHierarchy deep = built(chain, CutPolicy::kDudley);
  EXPECT_TRUE(one(checks_of(deep, CutPolicy::kDudley), "h.depth").holds);
  EXPECT_FALSE(one(checks_of(deep, CutPolicy::kMedian), "h.depth").holds);
  EXPECT_FALSE(one(checks_of(deep, CutPolicy::kBalancedDudley), "h.depth").holds);
  // The middle edge of a chain implies nothing about heights.
  const OuterHierarchy flat = built(chain, CutPolicy::kMedian);
  EXPECT_TRUE(one(checks_of(flat, CutPolicy::kMedian), "h.depth").holds);
}

TEST(HierarchyBounds, TheWorstOfSeveralStays) {
  const OuterHierarchy good = built(regular(8), CutPolicy::kMedian);
  const OuterHierarchy bad = built(geometric_chain(28), CutPolicy::kDudley);
  HierarchyBounds bounds(CutPolicy::kMedian);
  EXPECT_TRUE(bounds.checks("h").empty());
  bounds.add(OuterHierarchy::of_point(frame_point(1, 2)));
  EXPECT_TRUE(bounds.checks("h").empty());
  for (const OuterHierarchy* tree : {&good, &bad, &good}) bounds.add(*tree);
  EXPECT_FALSE(one(bounds.checks("h"), "h.depth").holds);
  EXPECT_TRUE(one(bounds.checks("h"), "h.cuts").holds);
}

}  // namespace hierarchy_bounds_test
}  // namespace kinex::test

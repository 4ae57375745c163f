// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of predicates that are known by hand, and their identities.
#include "predicates/points/box_order.h"
#include "predicates/points/edge_predicates.h"
#include "predicates/points/extent_predicates.h"
#include "predicates/points/gap_predicates.h"
#include "predicates/points/line_distance_order.h"
#include "predicates/points/line_predicates.h"
#include "predicates/points/power_predicates.h"
#include "predicates/points/shared_arguments.h"
#include "predicates/points/space_predicates.h"
#include "predicates/predicates.h"
#include "tests/predicates/ring_motions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace kinex {
namespace known_signs_test {

using test::Motions;
using test::unit_of;

// Static points with known answers: signs have the promised meaning.
class KnownSigns : public ::testing::Test {
 protected:
  static int sign(const std::shared_ptr<const Predicate>& p, const std::vector<std::vector<int>>& points) {
    std::vector<std::vector<Integer>> motions;
    std::vector<MotionView<Integer>> views;
    for (const auto& point : points) {
      std::vector<Integer> motion;
      for (int v : point) {
        motion.emplace_back(v);
        motion.emplace_back(0);
      }
      motions.push_back(std::move(motion));
    }
    for (const auto& motion : motions) views.push_back(motion.data());
    views.push_back(&unit_of<Integer>());
    const Polynomial value = p->exact(1, views.data());
    return value.is_zero() ? 0 : value[0].sign();
  }
};

TEST_F(KnownSigns, Orders) {
  EXPECT_EQ(sign(make_coordinate_order(0), {{1, 9}, {2, 0}}), 1);
  EXPECT_EQ(sign(make_coordinate_order(1), {{1, 9}, {2, 0}}), -1);
  EXPECT_EQ(sign(make_direction_order({Rational(1), Rational(1)}), {{1, 9}, {2, 0}}), -1);
  EXPECT_EQ(sign(make_direction_order({Rational(4), Rational(-3)}), {{3, 4}, {0, 0}}), 0);
  EXPECT_EQ(sign(make_squared_distance_order(2), {{1, 0}, {3, 4}, {0, 0}}), 1);
  EXPECT_EQ(sign(make_squared_distance_order(2), {{5, 0}, {3, 4}, {0, 0}}), 0);
}

TEST_F(KnownSigns, Angles) {
  EXPECT_EQ(sign(make_acute_angle_2(), {{4, 0}, {0, 0}, {3, 3}}), 1);
  EXPECT_EQ(sign(make_acute_angle_2(), {{4, 0}, {0, 0}, {0, 3}}), 0);
  EXPECT_EQ(sign(make_acute_angle_2(), {{4, 0}, {0, 0}, {-1, 3}}), -1);
  EXPECT_EQ(sign(make_acute_angle_2(), {{4, 0}, {4, 0}, {-1, 3}}), 0);
  EXPECT_EQ(sign(make_obtuse_angle_2(), {{4, 0}, {0, 0}, {3, 3}}), -1);
  EXPECT_EQ(sign(make_obtuse_angle_2(), {{4, 0}, {0, 0}, {-1, 3}}), 1);
}

TEST_F(KnownSigns, Planar) {
  EXPECT_EQ(sign(make_orientation_2(), {{0, 0}, {1, 0}, {0, 1}}), 1);
  EXPECT_EQ(sign(make_orientation_2(), {{0, 0}, {1, 1}, {2, 2}}), 0);
  EXPECT_EQ(sign(make_in_circle_2(), {{0, 0}, {4, 0}, {0, 4}, {1, 1}}), 1);
  EXPECT_EQ(sign(make_in_circle_2(), {{0, 0}, {4, 0}, {0, 4}, {5, 5}}), -1);
  EXPECT_EQ(sign(make_in_circle_2(), {{0, 0}, {4, 0}, {0, 4}, {4, 4}}), 0);
}

TEST_F(KnownSigns, Spatial) {
  const std::vector<std::vector<int>> corner{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  EXPECT_EQ(sign(make_orientation_3(), corner), 1);
  EXPECT_EQ(sign(make_orientation_3(), {corner[0], corner[1], corner[2], {5, 7, 0}}), 0);
  const auto side = [&corner](std::vector<int> point) {
    std::vector<std::vector<int>> all = corner;
    all.push_back(std::move(point));
    return sign(make_in_sphere_3(), all);
  };
  EXPECT_EQ(side({1, 1, 1}), 1);
  EXPECT_EQ(side({4, 4, 4}), 0);
  EXPECT_EQ(side({4, 4, 5}), -1);
}

// Points of planes in space, and what their projections say.
TEST_F(KnownSigns, OfPlanesInSpace) {
  // In the plane z = 3 x the circle through these three goes down to y = -40/3.
  const std::vector<std::vector<int>> corner{{4, 0, 12}, {0, 12, 0}, {-4, 0, -12}};
  const auto on = [&corner](int u, int v, std::vector<int> point) {
    return sign(make_in_circle_lifted(u, v), {corner[0], corner[1], corner[2], std::move(point)});
  };
  EXPECT_EQ(sign(make_projected_orientation(0, 1), corner), 1);
  EXPECT_EQ(sign(make_projected_orientation_touch(1, 2), corner), -1);
  EXPECT_EQ(sign(make_projected_orientation(0, 2), corner), 0);  // it is upright there
  EXPECT_EQ(on(0, 1, {0, -13, 0}), 1);  // outside of the circle of the projections
  EXPECT_EQ(on(1, 2, {0, -13, 0}), -1);
  EXPECT_EQ(on(0, 2, {0, -13, 0}), 0);
  EXPECT_EQ(on(0, 1, {0, -14, 0}), -1);
  EXPECT_EQ(on(0, 1, {1, 1, 3}), 1);
  EXPECT_EQ(on(1, 2, {1, 1, 3}), -1);
  const auto flat = [](std::vector<int> point) {
    return sign(make_in_circle_lifted_touch(0, 1), {{0, 0, 7}, {4, 0, 7}, {0, 4, 7}, std::move(point)});
  };
  EXPECT_EQ(flat({1, 1, 7}), 1);
  EXPECT_EQ(flat({4, 4, 7}), 0);
  EXPECT_EQ(flat({5, 5, 7}), -1);
  EXPECT_EQ(sign(make_obtuse_angle_3(), {{2, 4, 6}, {1, 2, 3}, {-3, -6, -9}}), 1);
  EXPECT_EQ(sign(make_obtuse_angle_3(), {{2, 4, 6}, {3, 6, 9}, {-3, -6, -9}}), -1);
  EXPECT_EQ(sign(make_obtuse_angle_3(), {{0, 0, 5}, {0, 0, 0}, {7, 1, 0}}), 0);
  EXPECT_THROW(make_in_circle_lifted(1, 1), std::invalid_argument);
}

// The corner of the unit cube, and the point (1/4, 1/4, 1/4): 9/16, here 4^5 times as much.
TEST(InSphere3, HasTheValueOfTheDeterminant) {
  std::vector<std::vector<Rational>> points;
  for (const std::vector<int>& p : {std::vector<int>{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}}) {
    std::vector<Rational>& motion = points.emplace_back();
    for (const int c : p) motion.insert(motion.end(), {Rational(c), Rational(0)});
  }
  std::vector<MotionView<Rational>> views;
  for (const auto& motion : points) views.push_back(motion.data());
  EXPECT_EQ(make_in_sphere_3()->rational(1, views.data())[0], Rational(576));
  EXPECT_EQ(make_orientation_3()->rational(1, views.data())[0], Rational(64));
}

// Weights, or radii, last. A heavy point shows outside the circle, a light one not inside it.
TEST_F(KnownSigns, Powers) {
  const std::vector<std::vector<int>> corner{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
  const auto side = [&corner](const std::shared_ptr<const Predicate>& p, std::vector<int> point) {
    return sign(p, {corner[0], corner[1], corner[2], std::move(point)});
  };
  for (const auto& p : {make_power_2(), make_disc_power_2()}) {
    EXPECT_EQ(side(p, {1, 1, 1}), 1);
    EXPECT_EQ(side(p, {4, 4, 1}), 0);
    EXPECT_EQ(side(p, {4, 4, 2}), 1);
    EXPECT_EQ(side(p, {4, 4, 0}), -1);
    EXPECT_EQ(side(p, {5, 5, 1}), -1);
  }
  EXPECT_EQ(side(make_power_2(), {2, 2, -7}), 0);  // 8 below the circle's
  EXPECT_EQ(side(make_power_2(), {2, 2, -8}), -1);
  EXPECT_EQ(side(make_power_2(), {5, 5, 11}), 0);
  EXPECT_EQ(side(make_disc_power_2(), {5, 4, 2}), -1);  // the square of the tangent is 5
  EXPECT_EQ(side(make_disc_power_2(), {5, 4, 3}), 1);
}

// The same in space; and whether triangles at one edge are folded over each other.
TEST_F(KnownSigns, PowersInSpace) {
  const std::vector<std::vector<int>> corner{{0, 0, 0, 1}, {4, 0, 0, 1}, {0, 4, 0, 1}, {0, 0, 4, 1}};
  const auto side = [&corner](const std::shared_ptr<const Predicate>& p, std::vector<int> point) {
    return sign(p, {corner[0], corner[1], corner[2], corner[3], std::move(point)});
  };
  for (const auto& p : {make_power_3(), make_disc_power_3()}) {
    EXPECT_EQ(side(p, {1, 1, 1, 1}), 1);
    EXPECT_EQ(side(p, {4, 4, 4, 1}), 0);
    EXPECT_EQ(side(p, {4, 4, 4, 2}), 1);
    EXPECT_EQ(side(p, {4, 4, 4, 0}), -1);
    EXPECT_EQ(side(p, {4, 4, 5, 1}), -1);
  }
  EXPECT_EQ(side(make_power_3(), {1, 1, 1, -8}), 0);  // 9 below the sphere's
  EXPECT_EQ(side(make_power_3(), {1, 1, 1, -9}), -1);
  EXPECT_EQ(side(make_power_3(), {5, 5, 5, 16}), 0);
  EXPECT_EQ(side(make_disc_power_3(), {5, 5, 5, 4}), 0);  // the square of the tangent is 16 with radius 1
  EXPECT_EQ(side(make_disc_power_3(), {5, 5, 5, 3}), -1);
  const auto fold = [](std::vector<int> p, std::vector<int> q) {
    return sign(make_unfolded_3(), {std::move(p), {0, 0, 0}, {0, 2, 0}, std::move(q)});
  };
  EXPECT_EQ(fold({1, 5, 0}, {-2, 7, 0}), 1);
  EXPECT_EQ(fold({1, 5, 0}, {2, -7, 0}), -1);
  EXPECT_EQ(fold({1, 5, 0}, {0, 7, 0}), 0);
  EXPECT_EQ(fold({1, 5, 0}, {0, 7, 3}), 0);  // at a right angle
  EXPECT_EQ(fold({0, 0, 3}, {0, 1, -1}), 1);
}

// In the plane z = 3 x; weights, or radii, last.
TEST_F(KnownSigns, PowersInPlanesOfSpace) {
  const std::vector<std::vector<int>> corner{{4, 0, 12, 1}, {0, 12, 0, 1}, {-4, 0, -12, 1}};
  const auto side = [&corner](const std::shared_ptr<const Predicate>& p, std::vector<int> point) {
    return sign(p, {corner[0], corner[1], corner[2], std::move(point)});
  };
  for (const auto make : {make_power_lifted, make_disc_power_lifted, make_power_lifted_touch,
                          make_disc_power_lifted_touch}) {
    EXPECT_EQ(side(make(0, 1), {0, -13, 0, 1}), 1);  // outside of the circle of the projections
    EXPECT_EQ(side(make(1, 2), {0, -13, 0, 1}), -1);
    EXPECT_EQ(side(make(0, 2), {0, -13, 0, 1}), 0);  // it is upright there
    EXPECT_EQ(side(make(0, 1), {0, -14, 0, 1}), -1);
    EXPECT_EQ(side(make(0, 1), {0, -14, 0, 9}),
              make == make_power_lifted || make == make_power_lifted_touch ? -1 : 1);
    EXPECT_THROW(make(1, 0), std::invalid_argument);
  }
  // The power of (0, y, 0) with regard to that circle, of centre (0, -2/3, 0).
  for (const int y : {0, -3, 6, 9, -15}) {
    const int power = y * y + 4 * y / 3 - 160;
    EXPECT_EQ(side(make_power_lifted(0, 1), {0, y, 0, power + 1}), 0) << y;
    EXPECT_EQ(side(make_power_lifted(0, 1), {0, y, 0, power}), -1) << y;
    EXPECT_EQ(side(make_power_lifted(1, 2), {0, y, 0, power + 2}), -1) << y;
    EXPECT_EQ(side(make_power_lifted(0, 2), {0, y, 0, power + 2}), 0) << y;
  }
  const auto flat = [](std::vector<int> point) {
    return sign(make_disc_power_lifted(0, 1),
                {{0, 0, 7, 1}, {4, 0, 7, 1}, {0, 4, 7, 1}, std::move(point)});
  };
  EXPECT_EQ(flat({5, 4, 7, 2}), -1);  // the square of the tangent is 5
  EXPECT_EQ(flat({5, 4, 7, 3}), 1);
  EXPECT_EQ(flat({4, 4, 7, 1}), 0);
}

// Weights of degree 3 on linear motions: the value has degree 5 and not 12, in every form.
TEST(Power2, CoefficientsBeyondItsDegreeAreExactZeros) {
  const auto p = make_power_2();
  std::mt19937_64 random(8);
  constexpr int kDegree = 3;
  constexpr std::size_t kAll = 4 * 3 * (kDegree + 1);
  std::vector<Ball> balls(kAll);
  std::vector<double> doubles(kAll);
  for (std::size_t k = 0; k < kAll; ++k) {
    const bool high = k % (kDegree + 1) > 1, weight = k / (kDegree + 1) % 3 == 2;
    if (high && !weight) continue;
    doubles[k] = static_cast<double>(random() % 1000) - 500.25;
    balls[k] = {doubles[k], 1e-9};
  }
  std::array<MotionView<Ball>, kMaxViews> views{};
  std::array<MotionView<double>, kMaxViews> plain{};
  const Ball one{1, 0};
  const double unit = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    views[i] = &balls[12 * i];
    plain[i] = &doubles[12 * i];
  }
  views[4] = &one;
  plain[4] = &unit;
  std::array<Ball, 13> out;
  std::array<double, 13> value;
  p->ball(kDegree, views.data(), 0.5, out.data());
  p->plain(kDegree, plain.data(), 0.5, value.data());
  for (std::size_t k = 0; k <= 12; ++k) {
    EXPECT_EQ(out[k].error == 0, k > 5) << k;
    EXPECT_EQ(value[k] == 0, k > 5) << k;
    EXPECT_LE(std::fabs(out[k].value - value[k]), out[k].error) << k;
  }
}

TEST_F(KnownSigns, SlopeOrder) {
  EXPECT_EQ(sign(make_slope_order_2(), {{0, 0}, {2, 1}, {5, 5}, {6, 6}}), 1);
  EXPECT_EQ(sign(make_slope_order_2(), {{5, 5}, {6, 6}, {0, 0}, {2, 1}}), -1);
  EXPECT_EQ(sign(make_slope_order_2(), {{0, 0}, {2, 1}, {6, 6}, {5, 5}}), -1);
  EXPECT_EQ(sign(make_slope_order_2(), {{0, 0}, {2, 1}, {7, 3}, {11, 5}}), 0);
  // From a common point it is the orientation.
  EXPECT_EQ(sign(make_slope_order_2(), {{1, 1}, {4, 2}, {1, 1}, {2, 6}}),
            sign(make_orientation_2(), {{1, 1}, {4, 2}, {2, 6}}));
}

TEST(SlopeOrder, ExchangingThePairsChangesTheSign) {
  const auto p = make_slope_order_2();
  std::mt19937_64 random(7);
  const Motions m(random, 4, 2, 2, 1000);
  EXPECT_EQ(p->exact(2, m.views(m.exact, {0, 1, 2, 3}).data()),
            -p->exact(2, m.views(m.exact, {2, 3, 0, 1}).data()));
}

TEST_F(KnownSigns, PairDistances) {
  EXPECT_EQ(sign(make_pair_distance_order(2), {{0, 0}, {3, 4}, {9, 9}, {9, 15}}), 1);
  EXPECT_EQ(sign(make_pair_distance_order(2), {{0, 0}, {3, 4}, {9, 9}, {9, 14}}), 0);
  EXPECT_EQ(sign(make_pair_distance_order(1), {{0, 8}, {5, 0}, {7, 9}, {9, 0}}), -1);
}

// Slope and height of a line; a point.
TEST_F(KnownSigns, Lines) {
  EXPECT_EQ(sign(make_line_side(), {{2, -1}, {3, 6}}), 1);
  EXPECT_EQ(sign(make_line_side(), {{2, -1}, {3, 5}}), 0);
  EXPECT_EQ(sign(make_line_side(), {{2, -1}, {3, 4}}), -1);
  EXPECT_EQ(sign(make_line_under(), {{2, -1}, {3, 4}}), 1);
  // (3): the dual point and line.
  EXPECT_EQ(sign(make_line_side(), {{3, -6}, {2, 1}}), 1);
  EXPECT_EQ(sign(make_line_under(), {{3, -4}, {2, 1}}), 1);
  // At x = 3 the lines y = 2 x - 1 and y = x + b are at 5 and b + 3.
  EXPECT_EQ(sign(make_line_order(), {{2, -1}, {1, 3}, {3, 9}}), 1);
  EXPECT_EQ(sign(make_line_order(), {{2, -1}, {1, 2}, {3, -9}}), 0);
  EXPECT_EQ(sign(make_line_order(), {{2, -1}, {1, 1}, {3, 0}}), -1);
}

// Heights over lines, and distances from them.
TEST_F(KnownSigns, DistancesFromLines) {
  const auto height = make_line_distance_order(LineMeasure::kHeight);
  const auto distance = make_line_distance_order(LineMeasure::kDistance);
  // y = x: (0, 6) is 6 above it, at a distance of sqrt(18); (0, -4) is 4 below y = 0, and 4 away.
  EXPECT_EQ(sign(height, {{1, 0}, {0, 6}, {0, 0}, {0, -4}}), -1);
  EXPECT_EQ(sign(distance, {{1, 0}, {0, 6}, {0, 0}, {0, -4}}), -1);
  EXPECT_EQ(sign(height, {{1, 0}, {0, 5}, {0, 0}, {0, -4}}), -1);
  EXPECT_EQ(sign(distance, {{1, 0}, {0, 5}, {0, 0}, {0, -4}}), 1);  // sqrt(25/2) < 4
  EXPECT_EQ(sign(height, {{1, 0}, {0, -4}, {0, 0}, {0, 4}}), 0);
  // Slope 7: 10 high is sqrt(2) away, as 2 over y = x + 3.
  EXPECT_EQ(sign(distance, {{7, 2}, {1, 19}, {1, 3}, {4, 5}}), 0);
  EXPECT_EQ(sign(distance, {{1, 3}, {4, 5}, {7, 2}, {1, 20}}), 1);
  EXPECT_EQ(sign(distance, {{7, 2}, {1, 20}, {1, 3}, {4, 5}}), -1);
}

// Centre and radius; centre and half extents.
TEST_F(KnownSigns, Extents) {
  EXPECT_EQ(sign(make_disc_overlap(2), {{0, 0, 2}, {3, 4, 2}}), -1);
  EXPECT_EQ(sign(make_disc_overlap(2), {{0, 0, 2}, {3, 4, 3}}), 0);
  EXPECT_EQ(sign(make_disc_overlap(2), {{0, 0, 2}, {3, 4, 4}}), 1);
  EXPECT_EQ(sign(make_disc_apart(3), {{0, 0, 0, 1}, {2, 1, 2, 1}}), 1);
  EXPECT_EQ(sign(make_disc_apart(1), {{0, 4}, {7, 3}}), 0);
  const EndAxes y{1, 3, 2};
  const std::vector<std::vector<int>> boxes{{0, 0, 9, 2}, {0, 5, 9, 3}};
  EXPECT_EQ(sign(make_end_order(EndClaim::kLowerEnds, y), boxes), 1);   // -2, 2
  EXPECT_EQ(sign(make_end_order(EndClaim::kUpperEnds, y), boxes), 1);   // 2, 8
  EXPECT_EQ(sign(make_end_order(EndClaim::kMeeting, y), boxes), 1);     // -2, 8
  EXPECT_EQ(sign(make_end_order(EndClaim::kMeeting, y), {boxes[1], boxes[0]}), 0);  // 2, 2
  EXPECT_EQ(sign(make_end_order(EndClaim::kApart, y), boxes), -1);
  EXPECT_EQ(sign(make_half_width(y), {boxes[0]}), 1);
}

// Identities (1) to (4) of gap_predicates.h, against square roots: small integers, whose gaps differ by
// more than doubles err, or not at all.
TEST_F(KnownSigns, GapsOfDiscs) {
  std::mt19937_64 random(11);
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  int equal = 0, smaller = 0;
  for (int round = 0; round < 4000; ++round) {
    std::vector<std::vector<int>> discs;
    for (int i = 0; i < 4; ++i) discs.push_back({below(9), below(9), below(4)});
    const std::vector<std::vector<int>> exchanged{discs[2], discs[3], discs[0], discs[1]};
    const auto term = [&](GapTerm which, bool other = false, bool negated = false) {
      return sign(make_gap_claim(which, negated, 2), other ? exchanged : discs);
    };
    const auto square = [&](int i, int j) {
      const int x = discs[i][0] - discs[j][0], y = discs[i][1] - discs[j][1];
      return x * x + y * y;
    };
    const double gap = std::sqrt(square(0, 1)) - discs[0][2] - discs[1][2];
    const double other = std::sqrt(square(2, 3)) - discs[2][2] - discs[3][2];
    const bool first = term(GapTerm::kRadii) >= 0 && term(GapTerm::kLeft) >= 0;
    const bool second = term(GapTerm::kRadii) >= 0 && term(GapTerm::kProduct) <= 0;
    const bool third = term(GapTerm::kRadii) <= 0 && term(GapTerm::kRight) >= 0 &&
                       term(GapTerm::kProduct) >= 0;
    EXPECT_EQ(first || second || third, gap <= other + 1e-9) << gap << " " << other;
    equal += std::abs(gap - other) < 1e-9;
    smaller += gap < other - 1e-9;
    EXPECT_EQ(term(GapTerm::kRadii, true), -term(GapTerm::kRadii));
    EXPECT_EQ(term(GapTerm::kRight, true), -term(GapTerm::kLeft));
    EXPECT_EQ(term(GapTerm::kProduct, true), term(GapTerm::kProduct));
    for (const GapTerm which : {GapTerm::kRadii, GapTerm::kLeft, GapTerm::kRight, GapTerm::kProduct}) {
      EXPECT_EQ(term(which, false, true), -term(which));
    }
  }
  EXPECT_GT(equal, 20);
  EXPECT_GT(smaller, 1000);
}

// Discs meet iff their lifted points (p, |p|^2 - r^2) do not see each other past the paraboloid: the
// least height of the segment between them over the paraboloid, a quadratic on [0, 1], is <= 0.
TEST_F(KnownSigns, DiscsMeetWhereTheParaboloidHidesOne) {
  std::mt19937_64 random(5);
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  int both = 0;
  for (int round = 0; round < 400; ++round) {
    const std::vector<int> a{below(9), below(9), below(5)}, b{below(9), below(9), below(5)};
    // At the share s of the way: (1-s) f(a) + s f(b) - |(1-s) a + s b|^2 = s(1-s) D - (1-s) ra^2 - s rb^2
    // with D = |b - a|^2; the segment is strictly above somewhere iff the discs are apart.
    const int d = (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
    const Rational ra(a[2] * a[2]), rb(b[2] * b[2]), distance(d);
    Rational s(0);
    if (d > 0) s = (distance + ra - rb) / (Rational(2) * distance);  // the quadratic's highest place
    s = std::min(std::max(s, Rational(0)), Rational(1));
    const Rational r = Rational(1) - s;
    const bool seen = (r * s * distance - r * ra - s * rb).sign() > 0;
    EXPECT_EQ(sign(make_disc_overlap(2), {a, b}) < 0, seen) << round;
    both += seen ? 1 : 0;
  }
  EXPECT_GT(both, 50);
  EXPECT_LT(both, 350);
}

TEST(PairDistanceOrder, HasItsIdentities) {
  std::mt19937_64 random(8);
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const auto p = make_pair_distance_order(dimension);
    for (int d = 1; d <= 4; ++d) {
      const Motions m(random, 4, 3, d, 1000);
      const auto value = [&](const std::vector<std::size_t>& order) {
        return p->exact(d, m.views(m.exact, order).data());
      };
      const Polynomial abcd = value({0, 1, 2, 3});
      EXPECT_FALSE(abcd.is_zero());
      EXPECT_EQ(value({2, 3, 0, 1}), -abcd);  // (1)
      EXPECT_EQ(value({1, 0, 2, 3}), abcd);   // (2)
      EXPECT_EQ(value({0, 1, 3, 2}), abcd);
      EXPECT_TRUE(value({0, 1, 0, 1}).is_zero());  // (3)
      EXPECT_TRUE(value({0, 1, 1, 0}).is_zero());
      EXPECT_GE(value({0, 0, 2, 3})[0].sign(), 0);  // (4), at t = 0
      const auto to_common = make_squared_distance_order(dimension);  // (5)
      EXPECT_EQ(value({2, 0, 2, 1}), to_common->exact(d, m.views(m.exact, {0, 1, 2}).data()));
    }
  }
  EXPECT_THROW(make_pair_distance_order(4), std::invalid_argument);
}

TEST(DirectionOrder, RefusesTheZeroVector) {
  EXPECT_THROW(make_direction_order({Rational(0), Rational(0)}), std::invalid_argument);
}

}  // namespace known_signs_test
}  // namespace kinex

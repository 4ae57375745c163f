// SPDX-License-Identifier: GPL-3.0-or-later
// Wedges of both roles: the choice of the role, and the proof by the certificates.
#include "predicates/bodies/separating_wedge.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace kinex {
namespace separating_wedge_test {

using Polygon = std::vector<Vertex2>;

Polygon box(int x_low, int y_low, int x_high, int y_high) {
  return {{x_low, y_low}, {x_high, y_low}, {x_high, y_high}, {x_low, y_high}};
}

Trajectory placed(const Rational& x, const Rational& y, int p = 1, int q = 0) {
  Trajectory result{{{x}, {y}, {Rational(p)}, {Rational(q)}}};
  result.normalise();
  return result;
}

Trajectory pose_of(const Trajectory& a, const Trajectory& b) {
  const Trajectory* bases[] = {&a, &b};
  return make_pose_2()->derive(bases);
}

// Two bodies at rest, and the plan for them.
struct Pair {
  Pair(const Polygon& first, const Trajectory& at_first, const Polygon& second,
       const Trajectory& at_second)
      : a(frame_polygon(first, false)),
        b(frame_polygon(second, true)),
        rough_a(a),
        rough_b(b),
        pose(pose_of(at_first, at_second)),
        plan(plan_wedge(rough_a, rough_b, RoughPose(pose, 0, Frame::kA))) {}
  FramePolygon a, b;
  RoughPolygon rough_a, rough_b;
  Trajectory pose;
  std::optional<WedgePlan> plan;
  std::optional<SeparatingWedge> wedge(Frame line_of) const {
    return separating_wedge(*plan, line_of, {a, rough_a}, {b, rough_b},
                            RoughPose(pose, 0, Frame::kA));
  }
};

Rational power_of_ten(int k) {
  const Rational p(power(Integer(10), static_cast<unsigned long>(k < 0 ? -k : k)));
  return k < 0 ? Rational(1) / p : p;
}

Polygon scaled(Polygon polygon, const Rational& size) {
  for (Vertex2& v : polygon) {
    for (Rational& c : v) c *= size;
  }
  return polygon;
}

// Lengths beyond the range of doubles, or with such squares, are left to other proofs.
TEST(SeparatingWedge, IsNotPutWhereDoublesEnd) {
  for (const int exponent : {-400, -320, -300, -170, 170, 300, 308, 310, 400}) {
    const Rational size = power_of_ten(exponent);
    const Pair pair(scaled(box(-1, -1, 1, 1), size), placed(0, 0), scaled(box(-1, -1, 1, 1), size),
                    placed(Rational(9) * size, 0));
    EXPECT_FALSE(pair.plan.has_value()) << exponent;
  }
}

// The lines have integers of any length.
TEST(SeparatingWedge, HoldsForVerticesThatAreNearlyDoubles) {
  Polygon square = box(-1, -1, 1, 1);
  square[1][0] += power_of_ten(-309);
  for (const int far : {4, 40}) {
    const Pair pair(square, placed(0, 0), square, placed(far, 0));
    ASSERT_TRUE(pair.plan.has_value());
    for (const Frame line_of : {Frame::kA, Frame::kB}) {
      const auto wedge = pair.wedge(line_of);
      ASSERT_TRUE(wedge.has_value());
      // The line is slightly outside its body, behind no vertex of it.
      const FramePolygon& own = line_of == Frame::kA ? pair.a : pair.b;
      for (const FramePoint& v : own.vertices) EXPECT_EQ(side(wedge->line, v), Sign::kNegative);
    }
  }
}

// A pose at a time beyond the doubles is unknown; for terms that doubles lose, the error bounds are
// at least as large as the terms.
TEST(RoughPose, KnowsWhatItDoesNotKnow) {
  Trajectory moving = placed(0, 40);
  moving.coordinates[1] = {Rational(40), 0, 0, power_of_ten(-330)};
  const Trajectory pose = pose_of(placed(0, 0), moving);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(RoughPose(pose, infinity, Frame::kA).is_known());
  EXPECT_FALSE(RoughPose(pose, -infinity, Frame::kA).is_known());
  EXPECT_FALSE(RoughPose::precise(pose, infinity, Frame::kA).is_known());
  EXPECT_FALSE(RoughPose::precise(pose, 0x1.8p1023, Frame::kA).is_known());
  EXPECT_TRUE(RoughPose(pose, 1, Frame::kA).is_known());
  EXPECT_LT(RoughPose(pose, 1, Frame::kA).error_t, 1e-9);
  // The term is 1 at 1e110.
  EXPECT_GE(RoughPose(pose, 1e110, Frame::kA).error_t, 1);
  const RoughPose precise = RoughPose::precise(pose, 1e110, Frame::kA);
  EXPECT_NEAR(precise.t[1], 41, 1e-6);
}

Rational half(int k) { return Rational(Integer(k), Integer(2)); }

// A corner over an edge: the line is that of the edge, whichever body has it.
TEST(SeparatingWedge, TheEdgeHasTheLine) {
  const Polygon edge = box(-9, -2, 9, 0), corner{{0, 0}, {1, 1}, {-1, 1}};
  const Trajectory low = placed(0, 0), high = placed(0, half(1));
  const Pair plain(edge, low, corner, high), exchanged(corner, high, edge, low);
  ASSERT_TRUE(plain.plan && exchanged.plan);
  EXPECT_EQ(plain.plan->longer(), Frame::kA);
  EXPECT_EQ(exchanged.plan->longer(), Frame::kB);
  EXPECT_DOUBLE_EQ(plain.plan->separation, 0.5);
  EXPECT_DOUBLE_EQ(exchanged.plan->separation, 0.5);
  EXPECT_DOUBLE_EQ(plain.plan->line_of_a.half_angle, exchanged.plan->line_of_b.half_angle);
  EXPECT_DOUBLE_EQ(plain.plan->line_of_b.half_angle, exchanged.plan->line_of_a.half_angle);
  EXPECT_GT(plain.plan->line_of_a.half_angle, 8 * plain.plan->line_of_b.half_angle);
}

// A quarter turn of A changes only its frame.
TEST(SeparatingWedge, TheFrameOfTheFirstMayBeTurned) {
  const Polygon edge = box(-9, -2, 9, 0), turned = box(-2, -9, 0, 9),
                corner{{0, 0}, {1, 1}, {-1, 1}};
  const Pair plain(edge, placed(0, 0), corner, placed(0, half(1)));
  const Pair other(turned, placed(0, 0, 1, 1), corner, placed(0, half(1)));
  ASSERT_TRUE(plain.plan && other.plan);
  EXPECT_NEAR(other.plan->direction[0], 1, 1e-12);  // up, seen from A
  EXPECT_NEAR(other.plan->direction[1], 0, 1e-12);
  EXPECT_NEAR(plain.plan->line_of_b.loss, other.plan->line_of_b.loss, 1e-12);
  EXPECT_EQ(plain.plan->line_of_a.half_angle, other.plan->line_of_a.half_angle);
}

TEST(SeparatingWedge, OfEqualBodiesTheFirst) {
  const Polygon square = box(-1, -1, 1, 1);
  const Trajectory left = placed(0, 0), right = placed(half(5), 0);
  EXPECT_EQ(Pair(square, left, square, right).plan->longer(), Frame::kA);
  EXPECT_EQ(Pair(square, right, square, left).plan->longer(), Frame::kA);
}

// Equal wedges (equal corners, one of a long triangle): the larger body gets the wedge.
TEST(SeparatingWedge, TiesAreBrokenByShape) {
  const Polygon small{{0, 0}, {1, 1}, {-1, 1}}, large{{-4, -4}, {4, -4}, {0, 0}};
  WedgePlan plan = *Pair(small, placed(0, half(1)), large, placed(0, 0)).plan;
  plan.line_of_a = plan.line_of_b;
  EXPECT_EQ(plan.longer(), Frame::kA);
  std::swap(plan.diameter_a, plan.diameter_b);
  EXPECT_EQ(plan.longer(), Frame::kB);
  plan.line_of_a.loss += 1e-9;  // rounding
  EXPECT_EQ(plan.longer(), Frame::kB);
  plan.line_of_b.loss += plan.separation / 16;
  EXPECT_EQ(plan.longer(), Frame::kA);
}

TEST(SeparatingWedge, TheLargerAngleThenTheSmallerLoss) {
  WedgePlan plan;
  plan.separation = 1;
  plan.line_of_a = {0.2, 0.01};
  plan.line_of_b = {0.4, 0.2};
  EXPECT_EQ(plan.longer(), Frame::kB);
  std::swap(plan.line_of_a, plan.line_of_b);
  EXPECT_EQ(plan.longer(), Frame::kA);
  plan.line_of_b = {0.4, 0.1};
  EXPECT_EQ(plan.longer(), Frame::kB);
}

// Two bodies that turn: in the second one's frame the pose is turned back.
TEST(RoughPose, InBothFrames) {
  const Trajectory pose = pose_of(placed(1, 2, 2, 1), placed(-3, 5, 1, 3));
  const RoughPose a(pose, 0, Frame::kA), b(pose, 0, Frame::kB);
  EXPECT_NEAR(a.c * a.c + a.s * a.s, 1, 1e-14);
  EXPECT_NEAR(std::hypot(a.t[0], a.t[1]), 5, 1e-14);
  EXPECT_NEAR(b.c, a.c, 1e-14);
  EXPECT_NEAR(b.s, -a.s, 1e-14);
  EXPECT_GT(std::fabs(a.s), 0.1);
  EXPECT_NEAR(b.t[0], b.c * a.t[0] - b.s * a.t[1], 1e-14);
  EXPECT_NEAR(b.t[1], b.s * a.t[0] + b.c * a.t[1], 1e-14);
}

TEST(SeparatingWedge, FarAwayADiscWillDo) {
  const Polygon small = box(-1, -1, 1, 1), large = box(-20, -2, 20, 2);
  const Pair pair(small, placed(0, 0), large, placed(0, 13));
  ASSERT_TRUE(pair.plan);
  EXPECT_FALSE(std::isfinite(pair.plan->line_of_b.half_angle));
  EXPECT_TRUE(std::isfinite(pair.plan->line_of_a.half_angle));
  EXPECT_EQ(pair.plan->longer(), Frame::kB);
  EXPECT_FALSE(pair.wedge(Frame::kB)->turns);
  EXPECT_TRUE(pair.wedge(Frame::kA)->turns);
  EXPECT_GE(pair.plan->line_of_b.loss, 0);
}

TEST(SeparatingWedge, NoneWhereTheyMeetOrNearlyDo) {
  const Polygon square = box(-1, -1, 1, 1);
  EXPECT_FALSE(Pair(square, placed(0, 0), square, placed(1, 0)).plan);
  EXPECT_FALSE(Pair(square, placed(0, 0), square, placed(2, 0)).plan);
  const Rational tiny(Integer(1), Integer::power_of_two(30));
  EXPECT_FALSE(Pair(square, placed(0, 0), square, placed(Rational(2) + tiny, 0)).plan);
}

// The certificates of a role, as values right now.
std::array<int, 3> signs(const Pair& pair, Frame line_of, const SeparatingWedge& wedge) {
  const auto value = [&](const std::shared_ptr<const Predicate>& predicate,
                         const std::vector<Rational>& first, const std::vector<Rational>& second) {
    std::vector<Rational> pose;
    for (int axis = 0; axis < kPoseAxes; ++axis) pose.push_back(pair.pose.position(axis, 0));
    const Rational* arguments[] = {pose.data(), first.data(), second.data()};
    return predicate->rational(0, arguments).front().sign();
  };
  const auto line = wedge.line.coordinates(), g1 = wedge.g1.coordinates(),
             g2 = wedge.g2.coordinates(), v = wedge.v.coordinates();
  const auto side = make_pose_side(line_of, false);
  const auto order = make_pose_normal_order(false), reversed = make_pose_normal_order(true);
  if (line_of == Frame::kA) {
    return {value(side, line, v), value(order, line, g1), value(reversed, line, g2)};
  }
  return {value(side, line, v), value(reversed, g1, line), value(order, g2, line)};
}

// Checks exactly, vertex by vertex, that the line has all of its body behind it, and that v bounds
// the other body in the direction of the line's normal.
void expect_proof(const Pair& pair, Frame line_of, const SeparatingWedge& wedge) {
  const bool of_a = line_of == Frame::kA;
  const FramePolygon &own = of_a ? pair.a : pair.b, &other = of_a ? pair.b : pair.a;
  for (const FramePoint& p : own.vertices) EXPECT_EQ(side(wedge.line, p), Sign::kNegative);
  // The normal in the other one's frame, by W (times N): R^T from A to B', R from B' to A.
  const Rational c = pair.pose.position(5, 0), s = pair.pose.position(6, 0);
  const Rational x(wedge.line.nx), y(wedge.line.ny), sine = of_a ? -s : s;
  const Rational mx = c * x - sine * y, my = sine * x + c * y;
  const auto reach = [&](const FramePoint& p) {
    return (mx * Rational(p.x) + my * Rational(p.y)) / Rational(p.w);
  };
  for (const FramePoint& p : other.vertices) EXPECT_LE(reach(p), reach(wedge.v));
}

TEST(SeparatingWedge, BothRolesProve) {
  std::mt19937_64 random(7);
  const auto draw = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  const Polygon shapes[] = {box(-1, -1, 1, 1),
                            box(-6, -1, 3, 0),
                            {{0, 0}, {5, 1}, {1, 3}},
                            {{-2, -1}, {1, -2}, {3, 0}, {2, 2}, {-1, 3}}};
  int wedges = 0;
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const Pair pair(shapes[round % 4],
                    placed(half(draw(-9, 9)), half(draw(-9, 9)), draw(1, 5), draw(-5, 5)),
                    shapes[round / 4 % 4],
                    placed(half(draw(-9, 9)), half(draw(-9, 9)), draw(-5, 5), draw(1, 5)));
    if (!pair.plan) continue;
    for (const Frame line_of : {Frame::kA, Frame::kB}) {
      SCOPED_TRACE(line_of == Frame::kA ? "line of A" : "line of B'");
      const auto wedge = pair.wedge(line_of);
      ASSERT_TRUE(wedge);
      const std::array<int, 3> found = signs(pair, line_of, *wedge);
      EXPECT_EQ(found[0], 1);
      if (!wedge->turns) continue;
      EXPECT_EQ(found[1], 1);
      EXPECT_EQ(found[2], 1);
      expect_proof(pair, line_of, *wedge);
      ++wedges;
    }
  }
  EXPECT_GT(wedges, 60);
}

}  // namespace separating_wedge_test
}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// Every predicate in every ring: identities, agreement, and error bounds that hold.
#include "predicates/predicates.h"
#include "predicates/points/box_order.h"
#include "predicates/points/edge_predicates.h"
#include "predicates/points/extent_predicates.h"
#include "predicates/points/gap_predicates.h"
#include "predicates/points/line_predicates.h"
#include "predicates/points/power_predicates.h"
#include "predicates/points/shared_arguments.h"
#include "predicates/points/space_predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace kinex {
namespace predicates_test {

struct Named {
  std::string name;
  std::shared_ptr<const Predicate> predicate;
};

std::shared_ptr<const Predicate> shared(std::shared_ptr<const Predicate> whole,
                                        std::vector<std::uint8_t> pattern) {
  return make_shared_arguments(std::move(whole), pattern);
}

std::vector<Named> all_predicates() {
  return {{"order_x", make_coordinate_order(0)},
          {"order_y", make_coordinate_order(1)},
          {"direction_3_4", make_direction_order({Rational(3), Rational(4)})},
          {"direction_fraction", make_direction_order({*Rational::parse("1/3"), *Rational::parse("-2/7")})},
          {"extent_4", make_extent_order({Rational(1), Rational(0)},
                                         {*Rational::parse("3/5"), *Rational::parse("4/5")}, {0, 1, 2, 3})},
          {"extent_3", make_extent_order({Rational(1), Rational(0)}, {Rational(0), Rational(1)}, {0, 1, 0, 2})},
          {"extent_2", make_extent_order({Rational(1), Rational(2)}, {Rational(0), Rational(1)}, {0, 1, 0, 1})},
          {"distance_1", make_squared_distance_order(1)},
          {"distance_2", make_squared_distance_order(2)},
          {"distance_3", make_squared_distance_order(3)},
          {"orientation_2", make_orientation_2()},
          {"pair_distance_1", make_pair_distance_order(1)},
          {"pair_distance_2", make_pair_distance_order(2)},
          {"pair_distance_3", make_pair_distance_order(3)},
          {"slope_order_2", make_slope_order_2()},
          {"in_circle_2", make_in_circle_2()},
          {"acute_angle_2", make_acute_angle_2()},
          {"obtuse_angle_2", make_obtuse_angle_2()},
          {"edge_dot_2", make_edge_dot_2()},
          {"strip", make_strip_order_2()},
          {"rectangle_area", make_rectangle_area_order_2()},
          {"rectangle_perimeter", make_rectangle_perimeter_order_2()},
          {"orientation_3", make_orientation_3()},
          {"in_sphere_3", make_in_sphere_3()},
          {"orientation_xz", make_projected_orientation(0, 2)},
          {"lower_ends", make_end_order(EndClaim::kLowerEnds, {1, 3, 2})},
          {"upper_ends", make_end_order(EndClaim::kUpperEnds, {2, 5, 3})},
          {"meeting", make_end_order(EndClaim::kMeeting, {0, 1, 1})},
          {"apart", make_end_order(EndClaim::kApart, {1, 3, 3})},
          {"half_width", make_half_width({0, 2, 2})},
          {"no_width", make_no_width({1, 3, 2})},
          {"power_2", make_power_2()},
          {"disc_power_2", make_disc_power_2()},
          {"power_3", make_power_3()},
          {"disc_power_3", make_disc_power_3()},
          {"unfolded_3", make_unfolded_3()},
          {"disc_overlap_1", make_disc_overlap(1)},
          {"disc_overlap_2", make_disc_overlap(2)},
          {"disc_apart_3", make_disc_apart(3)},
          {"radius_order", make_gap_claim(GapTerm::kRadii, false, 2)},
          {"radius_order_negated", make_gap_claim(GapTerm::kRadii, true, 3)},
          {"gap_left", make_gap_claim(GapTerm::kLeft, false, 2)},
          {"gap_left_negated", make_gap_claim(GapTerm::kLeft, true, 2)},
          {"gap_right", make_gap_claim(GapTerm::kRight, false, 3)},
          {"gap_right_negated", make_gap_claim(GapTerm::kRight, true, 1)},
          {"gap_product", make_gap_claim(GapTerm::kProduct, false, 2)},
          {"gap_product_negated", make_gap_claim(GapTerm::kProduct, true, 3)},
          {"gap_product_shared", shared(make_gap_claim(GapTerm::kProduct, false, 2), {0, 1, 1, 2})},
          {"line_side", make_line_side()},
          {"line_under", make_line_under()},
          {"line_order", make_line_order()},
          {"box_area", make_box_order(BoxMeasure::kArea, {Rational(1), Rational(0)},
                                      {*Rational::parse("3/5"), *Rational::parse("4/5")},
                                      SmallerBox::kFirst)},
          {"box_perimeter", make_box_order(BoxMeasure::kPerimeter, {*Rational::parse("8/17"), *Rational::parse("15/17")},
                                           {Rational(1), Rational(0)}, SmallerBox::kSecond)},
          {"box_shared", shared(make_box_order(BoxMeasure::kArea, {Rational(1), Rational(0)},
                                               {*Rational::parse("3/5"), *Rational::parse("4/5")},
                                               SmallerBox::kSecond), {0, 1, 1, 2, 0, 3, 2, 3})},
          {"edge_dot_shared", shared(make_edge_dot_2(), {0, 1, 1, 2})},
          {"strip_shared", shared(make_strip_order_2(), {0, 1, 2, 1, 3, 0})},
          {"rectangle_shared",
           shared(make_rectangle_area_order_2(), {0, 1, 1, 2, 3, 1, 4, 4, 0, 3})}};
}

// The unit of predicates that have one, in every ring.
template <class R>
const R& unit_of() {
  static const R one = [] {
    if constexpr (std::is_same_v<R, MpFloat>) {
      return MpFloat(300L, Rational(1));
    } else if constexpr (std::is_same_v<R, Ball>) {
      return Ball{1, 0};
    } else {
      return R(1);
    }
  }();
  return one;
}

// Motions of `arity` objects in `axes` axes, in every ring, from the same integers.
struct Motions {
  int degree;
  std::size_t stride;
  std::vector<std::int64_t> narrow;
  std::vector<double> plain;
  std::vector<Ball> ball;
  std::vector<Integer> exact;
  std::vector<Rational> rational;
  std::vector<MpFloat> mp;

  Motions(std::mt19937_64& random, int objects, int axes, int d, std::int64_t bound)
      : degree(d), stride(static_cast<std::size_t>(axes * (d + 1))) {
    for (std::size_t i = 0; i < stride * static_cast<std::size_t>(objects); ++i) {
      const std::int64_t v =
          static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * bound + 1)) - bound;
      narrow.push_back(v);
      plain.push_back(static_cast<double>(v));
      ball.push_back({static_cast<double>(v), 0});
      exact.emplace_back(v);
      rational.emplace_back(v);
      mp.emplace_back(300L, Rational(v));
    }
  }
  template <class R>
  std::vector<MotionView<R>> views(const std::vector<R>& all, const std::vector<std::size_t>& order) const {
    std::vector<MotionView<R>> out;
    for (std::size_t i : order) out.push_back(&all[i * stride]);
    out.push_back(&unit_of<R>());
    return out;
  }
};

// plain_with_reach against the exact polynomial in t - shift, within the unit error bound.
void check_shifted(const Predicate& p, const std::string& name, int d, const Motions& m,
                   const std::vector<std::size_t>& order, const Polynomial& exact, double shift) {
  const std::size_t size = static_cast<std::size_t>(p.degree(d)) + 1;
  std::vector<Rational> wanted(size);
  for (int i = 0; i <= exact.degree(); ++i) wanted[static_cast<std::size_t>(i)] = exact[static_cast<std::size_t>(i)];
  const Rational s = *Rational::from_double(shift);
  for (std::size_t i = 0; i + 1 < size; ++i) {
    for (std::size_t j = size - 1; j-- > i;) wanted[j] += s * wanted[j + 1];
  }
  std::vector<double> c(size), reach(static_cast<std::size_t>(d) + 1);
  p.plain_with_reach(d, m.views(m.plain, order).data(), shift, c.data(), reach.data());
  std::vector<double> power{1.0};
  for (int h = 0; h < p.homogeneity(); ++h) {
    std::vector<double> next(power.size() + reach.size() - 1, 0.0);
    for (std::size_t i = 0; i < power.size(); ++i) {
      for (std::size_t j = 0; j < reach.size(); ++j) next[i + j] += power[i] * reach[j];
    }
    power = next;
  }
  ASSERT_EQ(power.size(), size);
  for (std::size_t i = 0; i < size; ++i) {
    const Rational off = wanted[i] - *Rational::from_double(c[i]);
    ASSERT_LE(std::fabs(off.to_double()), p.reach_error(d) * power[i]) << name << " degree " << d << " at " << i;
  }
}

class EveryPredicate : public ::testing::TestWithParam<std::size_t> {};

TEST_P(EveryPredicate, RingsAgreeAndErrorBoundsHold) {
  const auto [name, p] = all_predicates()[GetParam()];
  std::mt19937_64 random(GetParam() + 1);
  for (int d = 1; d <= 5; ++d) {
    const int bits = p->homogeneity() > 4 ? 13 : 20;  // so that 128 suffice
    const std::vector<double> magnitude(static_cast<std::size_t>(d) + 1, std::ldexp(1.0, bits));
    for (int round = 0; round < 50; ++round) {
      const Motions m(random, p->arity(), std::max(3, p->dimension()), d, 1 << bits);
      std::vector<std::size_t> order;
      for (int i = 0; i < p->arity(); ++i) order.push_back(static_cast<std::size_t>(i));
      const Polynomial exact = p->exact(d, m.views(m.exact, order).data());
      const std::size_t size = static_cast<std::size_t>(p->degree(d)) + 1;
      ASSERT_LT(exact.degree(), static_cast<int>(size));
      const auto coefficient = [&exact](std::size_t i) {
        return static_cast<int>(i) <= exact.degree() ? Rational(exact[i]) : Rational(0);
      };
      const std::vector<Rational> rational = p->rational(d, m.views(m.rational, order).data());
      ASSERT_EQ(rational.size(), size);
      for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(rational[i], coefficient(i)) << name;
      std::vector<MpFloat> mp(size);
      p->multiprecision(d, m.views(m.mp, order).data(), mp.data());
      for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(compare(mp[i], coefficient(i)), 0) << name;
      std::vector<double> plain(size);
      p->plain(d, m.views(m.plain, order).data(), 0.0, plain.data());
      for (std::size_t i = 0; i < size; ++i) {
        ASSERT_NEAR(plain[i], coefficient(i).to_double(), 1e-9 * std::pow(0x1p23, p->homogeneity()));
      }
      std::vector<Ball> ball(size);
      p->ball(d, m.views(m.ball, order).data(), 0.0, ball.data());
      for (std::size_t i = 0; i < size; ++i) {
        const Rational off = coefficient(i) - *Rational::from_double(ball[i].value);
        ASSERT_LE(std::fabs(off.to_double()), ball[i].error) << name;
      }
      if (d > kMaxFixedDegree) continue;
      ASSERT_TRUE(p->narrow_fits(d, magnitude.data(), 1)) << name << " degree " << d;
      std::vector<Int128> narrow(size);
      p->narrow(d, m.views(m.narrow, order).data(), narrow.data());
      for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(Rational(Integer(narrow[i])), coefficient(i)) << name;
      check_shifted(*p, name, d, m, order, exact, static_cast<double>(random() % 64) / 16);
    }
  }
}

TEST_P(EveryPredicate, AlternatesUnderPermutations) {
  const auto [name, p] = all_predicates()[GetParam()];
  if (p->alternating() < 2) GTEST_SKIP() << "it has no such identity";
  std::mt19937_64 random(GetParam() + 100);
  const Motions m(random, p->arity(), std::max(3, p->dimension()), 2, 1000);
  std::vector<std::size_t> identity;
  for (int i = 0; i < p->arity(); ++i) identity.push_back(static_cast<std::size_t>(i));
  const Polynomial value = p->exact(2, m.views(m.exact, identity).data());
  ASSERT_FALSE(value.is_zero()) << name;
  std::vector<std::size_t> order = identity;
  const auto last = order.begin() + p->alternating();
  int count = 0;
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) inversions += order[i] > order[j];
    }
    const Polynomial permuted = p->exact(2, m.views(m.exact, order).data());
    EXPECT_EQ(permuted, inversions % 2 == 0 ? value : -value) << name;
    ++count;
  } while (std::next_permutation(order.begin(), last));
  EXPECT_GE(count, 2) << name;
  // Two equal arguments among the alternating ones give zero.
  std::vector<std::size_t> twice = identity;
  twice[1] = twice[0];
  EXPECT_TRUE(p->exact(2, m.views(m.exact, twice).data()).is_zero()) << name;
}

TEST_P(EveryPredicate, AlternatesInHalves) {
  const auto [name, p] = all_predicates()[GetParam()];
  if (!p->alternates_in_halves()) GTEST_SKIP() << "it has no such identity";
  ASSERT_EQ(p->arity() % 2, 0) << name;
  std::mt19937_64 random(GetParam() + 200);
  const Motions m(random, p->arity(), std::max(3, p->dimension()), 2, 1000);
  std::vector<std::size_t> order;
  for (int i = 0; i < p->arity(); ++i) order.push_back(static_cast<std::size_t>(i));
  const Polynomial value = p->exact(2, m.views(m.exact, order).data());
  ASSERT_FALSE(value.is_zero()) << name;
  std::rotate(order.begin(), order.begin() + p->arity() / 2, order.end());
  EXPECT_EQ(p->exact(2, m.views(m.exact, order).data()), -value) << name;
}

TEST_P(EveryPredicate, NarrowRefusesWhatMightOverflow) {
  const auto [name, p] = all_predicates()[GetParam()];
  const std::vector<double> huge(4, 0x1p62);
  for (int d = 1; d <= kMaxFixedDegree; ++d) EXPECT_FALSE(p->narrow_fits(d, huge.data(), 1)) << name;
}

INSTANTIATE_TEST_SUITE_P(All, EveryPredicate, ::testing::Range<std::size_t>(0, all_predicates().size()),
                         [](const auto& one) { return all_predicates()[one.param].name; });

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
  EXPECT_TRUE(std::isinf(p->reach_error(1)));
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

}  // namespace predicates_test
}  // namespace kinex

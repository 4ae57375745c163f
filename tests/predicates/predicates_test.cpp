// SPDX-License-Identifier: GPL-3.0-or-later
// Every predicate in every ring: identities, agreement, and error bounds that hold.
#include "predicates/predicates.h"
#include "predicates/points/box_order.h"
#include "predicates/points/edge_predicates.h"
#include "predicates/points/extent_predicates.h"
#include "predicates/points/gap_predicates.h"
#include "predicates/points/line_distance_order.h"
#include "predicates/points/line_predicates.h"
#include "predicates/points/power_predicates.h"
#include "predicates/points/shared_arguments.h"
#include "predicates/points/space_predicates.h"
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
namespace predicates_test {

using test::Motions;

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
          {"in_circle_xy", make_in_circle_lifted(0, 1)},
          {"in_circle_xz", make_in_circle_lifted(0, 2)},
          {"in_circle_yz", make_in_circle_lifted(1, 2)},
          {"obtuse_angle_3", make_obtuse_angle_3()},
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
          {"power_xy", make_power_lifted(0, 1)},
          {"power_xz", make_power_lifted(0, 2)},
          {"power_yz", make_power_lifted(1, 2)},
          {"disc_power_xy", make_disc_power_lifted(0, 1)},
          {"disc_power_xz", make_disc_power_lifted(0, 2)},
          {"disc_power_yz", make_disc_power_lifted(1, 2)},
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
          {"line_height_order", make_line_distance_order(LineMeasure::kHeight)},
          {"line_distance_order", make_line_distance_order(LineMeasure::kDistance)},
          {"line_distance_shared", shared(make_line_distance_order(LineMeasure::kDistance), {0, 1, 2, 1})},
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

// Weights of any size beside the squares of distances, of points that move or rest.
TEST(WeightPower, ErrorsAreWithinTheReachWhateverTheWeights) {
  struct Bits {
    int place, weight;  // of the largest coordinate and the largest weight; 0: they are zero
    bool rests;         // coordinates have no velocity
  };
  std::mt19937_64 random(7);
  for (const Bits& bits : {Bits{15, 30, false}, {20, 4, false}, {6, 30, false}, {15, 30, true}, {0, 30, true},
                           {20, 0, false}}) {
    for (const auto& p : {make_power_2(), make_power_3(), make_power_lifted(0, 2)}) {
      const int axes = p->dimension() - 1;
      for (int d = 1; d <= kMaxFixedDegree; ++d) {
        for (int round = 0; round < 40; ++round) {
          Motions m(random, p->arity(), axes + 1, d, std::int64_t{1} << 30);
          for (std::size_t k = 0; k < m.narrow.size(); ++k) {
            const std::size_t place = k % m.stride, axis = place / (static_cast<std::size_t>(d) + 1);
            const bool weight = axis == static_cast<std::size_t>(axes), moves = place % (static_cast<std::size_t>(d) + 1) != 0;
            const int size = weight ? bits.weight : moves && bits.rests ? 0 : bits.place;
            const std::int64_t v = size == 0 ? 0 : m.narrow[k] >> (30 - size);
            m.plain[k] = static_cast<double>(v);
            m.exact[k] = Integer(v);
          }
          std::vector<std::size_t> order;
          for (int i = 0; i < p->arity(); ++i) order.push_back(static_cast<std::size_t>(i));
          check_shifted(*p, std::string(p->name()), d, m, order, p->exact(d, m.views(m.exact, order).data()),
                        static_cast<double>(random() % 64) / 16);
        }
      }
    }
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

}  // namespace predicates_test
}  // namespace kinex

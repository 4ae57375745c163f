// SPDX-License-Identifier: GPL-3.0-or-later
// The predicates on lines: all rings agree, and signs are those of the dual plane.
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "predicates/predicates.h"

namespace kinex {
namespace line_predicates_test {

Key direction(int a, int b) {
  Key key;
  key.kind = Key::Kind::kDirection;
  key.direction = {Rational(a), Rational(b)};
  return key;
}

// The dual point of an object that moves by the coefficients at `motion`, d + 1 for each of two
// axes.
struct Dual {
  Rational slope, height;
};
Dual dual(const Key& key, const Rational* motion, int d) {
  Dual result;
  for (int axis = 0; axis < 2; ++axis) {
    const Rational v = key.kind == Key::Kind::kDirection
                           ? key.direction[static_cast<std::size_t>(axis)]
                           : Rational(axis == key.axis ? 1 : 0);
    result.height += v * motion[axis * (d + 1)];
    result.slope += v * motion[axis * (d + 1) + 1];
  }
  return result;
}

int turn(const Dual& a, const Dual& b, const Dual& c) {
  return ((b.slope - a.slope) * (c.height - a.height) - (b.height - a.height) * (c.slope - a.slope))
      .sign();
}

TEST(LinePredicates, RingsAgreeWithTheDualPlane) {
  std::mt19937_64 random(7);
  Key y;
  y.axis = 1;
  for (const Key& key : {Key{}, y, direction(2, 3), direction(-7, 4)}) {
    const auto order = make_line_slope_order(key, 2), turned = make_line_turn(key, 2),
               meeting = make_line_meeting(key, 2);
    for (int d = 1; d <= 5; ++d) {
      for (int round = 0; round < 100; ++round) {
        const std::size_t stride = 2 * (static_cast<std::size_t>(d) + 1);
        const int size = round % 3 == 0 ? 3 : 1000000;
        std::vector<Rational> q;
        std::vector<Integer> z;
        std::vector<std::int64_t> n;
        std::vector<double> f;
        std::vector<Ball> ball;
        std::vector<MpFloat> mp;
        for (std::size_t i = 0; i < 5 * stride; ++i) {
          const auto v =
              static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * size + 1)) - size;
          q.emplace_back(v);
          z.emplace_back(v);
          n.push_back(v);
          f.push_back(static_cast<double>(v));
          ball.push_back({static_cast<double>(v), 0});
          mp.emplace_back(300L, Rational(v));
        }
        const auto views = [stride](const auto& all) {
          std::vector<decltype(all.data())> result;
          for (std::size_t i = 0; i < 5; ++i) result.push_back(all.data() + i * stride);
          return result;
        };
        std::vector<Dual> p;
        for (std::size_t i = 0; i < 5; ++i) p.push_back(dual(key, &q[i * stride], d));
        const std::vector<double> magnitude(static_cast<std::size_t>(d) + 1, 1e6);
        const auto check = [&](const Predicate& predicate, const Rational& scale, int wanted) {
          const std::vector<Rational> rational = predicate.rational(d, views(q).data());
          ASSERT_EQ(rational.size(), 1u);
          EXPECT_EQ((rational[0] * scale).sign(), wanted) << predicate.name();
          const Polynomial exact = predicate.exact(d, views(z).data());
          EXPECT_EQ(exact.is_zero() ? Rational(0) : Rational(exact[0]), rational[0]);
          MpFloat m;
          predicate.multiprecision(d, views(mp).data(), &m);
          EXPECT_EQ(compare(m, rational[0]), 0);
          Ball b;
          predicate.ball(d, views(ball).data(), 3.0, &b);
          EXPECT_LE((rational[0] - *Rational::from_double(b.value)).to_double(), b.error);
          EXPECT_GE((rational[0] - *Rational::from_double(b.value)).to_double(), -b.error);
          double plain = 0;
          predicate.plain(d, views(f).data(), 0, &plain);
          EXPECT_NEAR(plain, rational[0].to_double(),
                      1e-9 * (1 + std::abs(rational[0].to_double())) + 1e6);
          EXPECT_EQ(predicate.degree(d), 0);
          if (d > kMaxFixedDegree) return;
          ASSERT_TRUE(predicate.narrow_fits(d, magnitude.data(), 1));
          Int128 narrow = 0;
          predicate.narrow(d, views(n).data(), &narrow);
          EXPECT_EQ(Rational(Integer(narrow)), rational[0]) << predicate.name();
        };
        check(*order, Rational(1), (p[1].slope - p[0].slope).sign());
        check(*turned, Rational(1), turn(p[0], p[1], p[2]));
        const Rational ab = p[1].slope - p[0].slope, cd = p[3].slope - p[2].slope;
        if (ab.is_zero() || cd.is_zero()) continue;
        const Rational first =
            p[0].height + (p[1].height - p[0].height) * (p[4].slope - p[0].slope) / ab;
        const Rational second =
            p[2].height + (p[3].height - p[2].height) * (p[4].slope - p[2].slope) / cd;
        check(*meeting, Rational((ab * cd).sign()), (first - second).sign());
      }
    }
  }
}

TEST(LinePredicates, NarrowRefusesWhatMightOverflow) {
  const std::vector<double> huge(4, 0x1p62), large(4, 0x1p50);
  for (int d = 1; d <= kMaxFixedDegree; ++d) {
    EXPECT_FALSE(make_line_slope_order({}, 1)->narrow_fits(d, huge.data(), 1));
    EXPECT_FALSE(make_line_turn({}, 1)->narrow_fits(d, huge.data(), 1));
    EXPECT_TRUE(make_line_turn({}, 1)->narrow_fits(d, large.data(), 1));
    EXPECT_FALSE(make_line_meeting({}, 1)->narrow_fits(d, large.data(), 1));
  }
}

TEST(LinePredicates, SquaredDistancesAreNoLines) {
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = 0;
  EXPECT_THROW(make_line_turn(key, 2), std::invalid_argument);
}

}  // namespace line_predicates_test
}  // namespace kinex

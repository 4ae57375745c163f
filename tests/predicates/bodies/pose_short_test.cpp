// SPDX-License-Identifier: GPL-3.0-or-later
// The fast paths of poses: machine integers, and signs without the polynomial.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "core/arithmetic/linear_form.h"
#include "core/arithmetic/motion_store.h"
#include "predicates/bodies/pose_2.h"

namespace kinex {
namespace pose_short_test {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  int below(int bound) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(bound)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  Rational dyadic(unsigned bits) {
    if (below(8) == 0) return Rational(between(-1, 1));
    Integer n = Integer(static_cast<std::int64_t>(engine_() >> (64 - bits)));
    if (below(2) == 0) n.negate();
    return Rational(
        n, Integer::power_of_two(static_cast<unsigned long>(below(2 * static_cast<int>(bits)))));
  }
  Trajectory body(unsigned bits, int positions, int rotor) {
    Trajectory result;
    for (const int degree : {positions, positions, rotor, rotor}) {
      auto& axis = result.coordinates.emplace_back();
      for (int k = 0; k <= degree; ++k) axis.push_back(dyadic(bits));
    }
    result.normalise();
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

TEST(ShortPose, IsTheSameRationals) {
  const auto any = make_pose_2(), slow = make_long_pose_2();
  for (const unsigned bits : {1u, 4u, 10u, 16u, 20u, 24u, 30u, 60u}) {
    Draw draw(bits);
    for (int round = 0; round < 60; ++round) {
      Trajectory a = draw.body(bits, draw.below(4), draw.below(3));
      const Trajectory b = draw.body(bits, draw.below(4), draw.below(3));
      if (round % 10 == 9) a.coordinates[1][0] = Rational(Integer(1), Integer(3));
      const Trajectory* const bases[] = {&a, &b};
      EXPECT_EQ(any->derive(bases), slow->derive(bases)) << bits << " " << round;
    }
  }
}

// A pose and constants in a store; object 0 is the pose.
struct Stored {
  explicit Stored(double anchor_of_pose) : store(model(), 5), anchor(anchor_of_pose) {}
  static NumberModel model() {
    NumberModel model;
    model.axes = kPoseAxes;
    model.anchored = true;
    return model;
  }
  void set_pose(const Trajectory& pose) { store.set(0, pose, anchor); }
  void set_constant(ObjectId id, const std::array<Rational, 3>& c) {
    constants[id - 1] = {{{c[0]}, {c[1]}, {c[2]}}};
    store.set(id, constants[id - 1]);
  }
  // The exact sign at a rational time.
  Sign sign(const Predicate& predicate, const Query& query, const Rational& t) const {
    const Polynomial p = store.exact(predicate, query.ids.data());
    Rational value;
    for (int k = p.degree(); k >= 0; --k)
      value = value * t + Rational(p[static_cast<std::size_t>(k)]);
    return to_sign(value.sign());
  }
  MotionStore store;
  double anchor;
  std::array<Trajectory, 4> constants;
};

std::vector<std::shared_ptr<const Predicate>> forms() {
  return {make_pose_side(Frame::kA, false),
          make_pose_side(Frame::kA, true),
          make_pose_side(Frame::kB, false),
          make_pose_side(Frame::kB, true),
          make_pose_along(Frame::kA),
          make_pose_along(Frame::kB),
          make_pose_normal_order(false),
          make_pose_normal_order(true),
          make_pose_ray(false),
          make_pose_ray(true),
          make_pose_touch(Frame::kA, false),
          make_pose_touch(Frame::kB, true),
          make_pose_along_touch(Frame::kB, true),
          make_pose_order_touch(false)};
}

TEST(LinearSigns, AreTheExactSigns) {
  Draw draw(1);
  const auto all = forms();
  int known = 0, unknown = 0;
  for (int round = 0; round < 40; ++round) {
    Stored stored(round % 3 == 0 ? 0 : draw.dyadic(8).to_double());
    const auto bits = static_cast<unsigned>(draw.between(2, 24));
    const Trajectory a = draw.body(bits, draw.below(3), draw.below(2));
    const Trajectory b = draw.body(bits, draw.below(3), draw.below(2));
    const Trajectory* const bases[] = {&a, &b};
    stored.set_pose(make_pose_2()->derive(bases));
    for (ObjectId id = 1; id <= 4; ++id) {
      const Rational third(Integer(draw.between(-9, 9)), Integer(3));
      stored.set_constant(id, {draw.dyadic(6), third, Rational(draw.between(1, 5))});
    }
    LinearSigns signs;
    for (int instant = 0; instant < 4; ++instant) {
      const double lo = instant == 0 ? stored.anchor : draw.dyadic(20).to_double();
      const double hi = lo + (instant == 3 ? 0x1p-3 : instant == 2 ? 0x1p-30 : 0);
      for (const auto& predicate : all) {
        const auto* const form = dynamic_cast<const LinearForm*>(predicate.get());
        ASSERT_NE(form, nullptr);
        const Query query = predicate->arity() == 3   ? Query(0, {0, 1, 2})
                            : predicate->arity() == 4 ? Query(0, {0, 1, 2, 3})
                                                      : Query(0, {0, 1, 2, 3, 4});
        const auto sign = signs.over(*form, stored.store, query, lo, hi);
        ++(sign ? known : unknown);
        if (!sign) continue;
        for (const double t : {lo, lo + 0.5 * (hi - lo), hi}) {
          EXPECT_EQ(*sign, stored.sign(*predicate, query, *Rational::from_double(t)))
              << predicate->name() << " at " << t;
        }
      }
    }
  }
  EXPECT_GT(known, 1000);
  EXPECT_GT(unknown, 0);
}

// x = 2^40 (t - 1) - 1: the sign depends on the last bits.
TEST(LinearSigns, AbstainWhereTheStretchHoldsARoot) {
  Stored stored(1);
  const Rational big(Integer::power_of_two(40));
  stored.set_pose({{{-big - Rational(1), big}, {0}, {0}, {0}, {1}, {1}, {0}}});
  stored.set_constant(1, {1, 0, 0});
  stored.set_constant(2, {0, 0, 1});
  const auto side = make_pose_side(Frame::kA, false);
  const auto& form = dynamic_cast<const LinearForm&>(*side);
  const Query query(0, {0, 1, 2});
  LinearSigns signs;
  const auto over = [&](double lo, double hi) {
    return signs.over(form, stored.store, query, lo, hi);
  };
  const double root = 1 + 0x1p-40;
  EXPECT_EQ(over(root, root), std::nullopt);
  EXPECT_EQ(over(1, 1 + 0x1p-39), std::nullopt);
  EXPECT_EQ(over(1, 1), Sign::kNegative);
  EXPECT_EQ(over(1, 1 + 0x1p-44), Sign::kNegative);
  EXPECT_EQ(over(1 + 0x1p-38, 1 + 0x1.8p-38), Sign::kPositive);
}

TEST(LinearSigns, FollowTheMotion) {
  Stored stored(0);
  stored.set_constant(1, {1, 0, 0});
  stored.set_constant(2, {0, 0, 1});
  stored.set_pose({{{1}, {0}, {0}, {0}, {1}, {1}, {0}}});
  const auto side = make_pose_side(Frame::kA, false);
  const auto& form = dynamic_cast<const LinearForm&>(*side);
  const Query query(0, {0, 1, 2});
  LinearSigns signs;
  EXPECT_EQ(signs.over(form, stored.store, query, 0, 0), Sign::kPositive);
  signs.forget(0);
  stored.set_pose({{{-1, 1}, {0}, {0}, {0}, {1}, {1}, {0}}});
  EXPECT_EQ(signs.over(form, stored.store, query, 0, 0), Sign::kNegative);
  EXPECT_EQ(signs.over(form, stored.store, query, 2, 2), Sign::kPositive);
  EXPECT_EQ(signs.over(form, stored.store, query, 0.5, 0.5), Sign::kNegative);
}

// All zero motions share one row of doubles; nothing remains of former values.
TEST(MotionStore, WhatBecomesZeroIsZero) {
  Stored stored(0.5);
  const auto at = [&](ObjectId id, std::size_t k) { return stored.store.ball(id)[k].value; };
  stored.set_constant(1, {0, 0, 0});
  stored.set_constant(2, {3, 4, 5});
  EXPECT_EQ(stored.store.ball(1), stored.store.ball(0));
  EXPECT_EQ(at(1, 0), 0);
  const std::size_t powers = static_cast<std::size_t>(stored.store.degree()) + 1;
  EXPECT_EQ(at(2, powers), 4);
  EXPECT_EQ(stored.store.anchored(2)[2 * powers].value, 5);
  stored.set_pose({{{7, 8}, {0}, {0}, {0}, {1}, {1}, {0}}});
  EXPECT_EQ(at(0, 1), 8);
  EXPECT_EQ(stored.store.anchored(0)[0].value, 11);
  stored.set_pose({{{0}, {0}, {0}, {0}, {0}, {0}, {0}}});
  stored.set_constant(2, {0, 0, 6});
  for (std::size_t k = 0; k < stored.store.stride(); ++k) {
    EXPECT_EQ(at(0, k), 0);
    EXPECT_EQ(stored.store.anchored(0)[k].value, 0);
    EXPECT_EQ(at(2, k), k == 2 * powers ? 6 : 0);
  }
  const auto side = make_pose_side(Frame::kA, false);
  EXPECT_EQ(stored.sign(*side, Query(0, {0, 1, 2}), Rational(3)), Sign::kZero);
}

}  // namespace pose_short_test
}  // namespace kinex

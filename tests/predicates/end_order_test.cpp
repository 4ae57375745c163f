// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates on the ends of intervals: the numbered identities, on random motions.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "predicates/points/extent_predicates.h"

namespace kinex {
namespace end_order_test {

constexpr int kDegree = 2;
constexpr int kDimension = 2;

using Box = std::vector<Integer>;  // coefficients of x, y and the two half extents

Box random_box(std::mt19937_64& random) {
  Box box;
  for (int i = 0; i < 2 * kDimension * (kDegree + 1); ++i) {
    box.emplace_back(static_cast<std::int64_t>(random() % 201) - 100);
  }
  return box;
}

Polynomial value(const std::shared_ptr<const Predicate>& p, const std::vector<const Box*>& boxes) {
  std::vector<MotionView<Integer>> views;
  for (const Box* box : boxes) views.push_back(box->data());
  return p->exact(kDegree, views.data());
}

class EndOrders : public testing::TestWithParam<int> {
 protected:
  EndAxes axes() const { return {GetParam(), kDimension + GetParam(), kDimension}; }
  std::shared_ptr<const Predicate> order(EndClaim claim) const {
    return make_end_order(claim, axes());
  }
  std::mt19937_64 random_{11};
};

TEST_P(EndOrders, HaveTheirIdentities) {
  int meet = 0;
  for (int round = 0; round < 100; ++round) {
    const Box a = random_box(random_), b = random_box(random_);
    for (const EndClaim same : {EndClaim::kLowerEnds, EndClaim::kUpperEnds}) {
      EXPECT_EQ(value(order(same), {&a, &b}), -value(order(same), {&b, &a}));  // (1)
    }
    const auto meeting = order(EndClaim::kMeeting);
    EXPECT_EQ(value(order(EndClaim::kApart), {&a, &b}), -value(meeting, {&a, &b}));  // (2)
    // (3), at the time 0.
    const auto at = [](const Box& box, int axis) {
      return box[static_cast<std::size_t>(axis * (kDegree + 1))];
    };
    const Integer ha = at(a, axes().extent), hb = at(b, axes().extent);
    if (ha.sign() < 0 || hb.sign() < 0) continue;
    const Integer xa = at(a, axes().axis), xb = at(b, axes().axis);
    const bool closed = xa - ha <= xb + hb && xb - hb <= xa + ha;
    const auto holds = [&](const Box& first, const Box& second) {
      const Polynomial claim = value(meeting, {&first, &second});
      return claim.is_zero() || claim[0].sign() >= 0;
    };
    EXPECT_EQ(holds(a, b) && holds(b, a), closed);
    meet += closed ? 1 : 0;
  }
  EXPECT_GT(meet, 5);
}

TEST_P(EndOrders, OfOneObjectAreItsHalfWidth) {
  for (int round = 0; round < 100; ++round) {
    const Box a = random_box(random_);
    const auto width = make_half_width(axes()), none = make_no_width(axes());
    const Polynomial half = value(width, {&a});
    EXPECT_FALSE(half.is_zero());
    EXPECT_EQ(value(none, {&a}), -half);  // (1)
    Box moved = random_box(random_);      // (2): another position, the same half extents
    for (std::size_t i = moved.size() / 2; i < moved.size(); ++i) moved[i] = a[i];
    EXPECT_EQ(value(width, {&moved}), half);
    EXPECT_EQ(value(order(EndClaim::kMeeting), {&a, &a}), half + half);  // (3)
    EXPECT_EQ(value(order(EndClaim::kApart), {&a, &a}), -half - half);
    EXPECT_TRUE(value(order(EndClaim::kLowerEnds), {&a, &a}).is_zero());
    EXPECT_TRUE(value(order(EndClaim::kUpperEnds), {&a, &a}).is_zero());
  }
}

INSTANTIATE_TEST_SUITE_P(Axes, EndOrders, testing::Values(0, 1));

}  // namespace end_order_test
}  // namespace kinex

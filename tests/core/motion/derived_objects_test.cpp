// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/derived_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace kinex {
namespace {

// The difference of two one-dimensional motions.
class Difference final : public Construction {
 public:
  std::string_view name() const override { return "difference"; }
  Trajectory derive(std::span<const Trajectory* const> bases) const override {
    Trajectory result = *bases[1];
    const std::vector<Rational>& first = bases[0]->coordinates[0];
    std::vector<Rational>& c = result.coordinates[0];
    c.resize(std::max(c.size(), first.size()));
    for (std::size_t k = 0; k < first.size(); ++k) c[k] -= first[k];
    result.normalise();
    return result;
  }
};

Trajectory path(std::vector<Rational> coefficients) { return {{std::move(coefficients)}}; }

TEST(DerivedObjects, FollowTheirBases) {
  DerivedObjects objects(3);
  objects.keep_motions();
  objects.set_motion(0, path({1, 2}), Rational(5));
  objects.set_motion(1, path({4}), std::nullopt);
  objects.set_motion(2, path({9, 9}), Rational(1));
  const std::array<ObjectId, 2> first{0, 1}, second{1, 2};
  const ObjectId a = objects.add("a", std::make_shared<Difference>(), first);
  const ObjectId c = objects.add("c", path({7}));
  const ObjectId b = objects.add("b", std::make_shared<Difference>(), second);
  EXPECT_EQ((std::array{a, c, b}), (std::array<ObjectId, 3>{3, 4, 5}));
  EXPECT_FALSE(objects.is_derived(2));
  EXPECT_TRUE(objects.is_derived(3));
  EXPECT_EQ(objects.trajectory(a), path({3, -2}));
  EXPECT_EQ(objects.trajectory(b), path({5, 9}));
  EXPECT_EQ(objects.trajectory(1), path({4}));
  EXPECT_EQ(objects.object(a).name, "a");
  // As long as the flight plans of all bases.
  EXPECT_EQ(objects.object(a).until, Rational(5));
  EXPECT_EQ(objects.object(b).until, Rational(1));
  EXPECT_EQ(objects.object(c).until, std::nullopt);
  const auto dependents = objects.dependents(1);
  EXPECT_EQ(std::vector<ObjectId>(dependents.begin(), dependents.end()),
            (std::vector<ObjectId>{a, b}));
  EXPECT_TRUE(objects.dependents(a).empty());

  objects.set_motion(1, path({0, 0, 1}), Rational(3));
  EXPECT_EQ(objects.trajectory(a), path({3, -2}));  // not before it is renewed
  EXPECT_EQ(objects.renew(a).trajectory, path({-1, -2, 1}));
  EXPECT_EQ(objects.object(a).until, Rational(3));
  EXPECT_EQ(objects.renew(b).until, Rational(1));
  EXPECT_EQ(objects.renew(c).trajectory, path({7}));
}

TEST(DerivedObjects, ConstantsAreRedefined) {
  DerivedObjects objects(0);
  const ObjectId c = objects.add("c", path({7}));
  objects.redefine(c, "d", path({8}));
  EXPECT_EQ(objects.object(c).name, "d");
  EXPECT_EQ(objects.trajectory(c), path({8}));
  EXPECT_EQ(objects.size(), 1u);
}

TEST(DerivedObjects, AreRefusedWhereNobodyKeepsMotions) {
  DerivedObjects objects(1);
  objects.set_motion(0, path({1}), std::nullopt);
  const std::array<ObjectId, 1> base{0};
  EXPECT_ANY_THROW(objects.add("a", std::make_shared<Difference>(), base));
  objects.keep_motions();
  objects.set_motion(0, path({1}), std::nullopt);
  const ObjectId constant = objects.add("c", path({1}));
  const std::array<ObjectId, 1> derived{constant};
  EXPECT_ANY_THROW(objects.add("b", std::make_shared<Difference>(), derived));
}

}  // namespace
}  // namespace kinex

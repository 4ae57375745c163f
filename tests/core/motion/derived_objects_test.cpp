// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/derived_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace kinex {
namespace derived_objects_test {

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

// The diamond a -> m, a -> n, (m, n) -> s: s is renewed once, after both.
TEST(DerivedObjects, Nest) {
  DerivedObjects objects(3);
  objects.set_motion(0, path({1}), std::nullopt);
  objects.set_motion(1, path({10, 1}), Rational(4));
  objects.set_motion(2, path({100}), Rational(3));
  const auto difference = std::make_shared<Difference>();
  const auto add = [&](const char* name, ObjectId first, ObjectId second) {
    const std::array<ObjectId, 2> bases{first, second};
    return objects.add(name, difference, bases);
  };
  const ObjectId seven = objects.add("7", path({7}));
  const ObjectId m = add("m", 0, 1), n = add("n", 0, seven), s = add("s", n, m);
  const ObjectId twice = add("twice", m, m), constant = add("constant", seven, seven);
  EXPECT_EQ(objects.trajectory(s), path({3, 1}));
  EXPECT_EQ(objects.object(s).stands_for, (std::vector<ObjectId>{0, 1}));
  EXPECT_EQ(objects.object(s).until, Rational(4));
  EXPECT_EQ(objects.object(n).until, std::nullopt);
  EXPECT_TRUE(objects.is_constant(constant));
  EXPECT_TRUE(objects.is_constant(seven));
  EXPECT_FALSE(objects.is_constant(twice));
  EXPECT_EQ(objects.all_dependents(0), (std::vector<ObjectId>{m, twice, n, s}));
  EXPECT_EQ(objects.all_dependents(1), (std::vector<ObjectId>{m, s, twice}));
  EXPECT_EQ(objects.all_dependents(seven), (std::vector<ObjectId>{n, s, constant}));
  EXPECT_TRUE(objects.all_dependents(2).empty());

  objects.set_motion(0, path({5, 5}), std::nullopt);
  for (const ObjectId id : objects.all_dependents(0)) objects.renew(id);
  EXPECT_EQ(objects.trajectory(m), path({5, -4}));
  EXPECT_EQ(objects.trajectory(n), path({2, -5}));
  EXPECT_EQ(objects.trajectory(s), path({3, 1}));
  EXPECT_EQ(objects.trajectory(twice), path({0}));

  // An object may get a younger base; then the order of renewal is not that of the ids.
  const ObjectId late = add("late", 2, 1);
  objects.rebase(n, "n'", std::array<ObjectId, 2>{late, 0});
  EXPECT_EQ(objects.object(s).stands_for, (std::vector<ObjectId>{0, 1, 2}));
  EXPECT_EQ(objects.all_dependents(2), (std::vector<ObjectId>{late, n, s}));
  for (const ObjectId id : objects.all_dependents(n)) objects.renew(id);
  EXPECT_EQ(objects.object(s).until, Rational(3));
  EXPECT_EQ(objects.trajectory(s), path({-90, -8}));
  EXPECT_TRUE(objects.all_dependents(seven) == (std::vector<ObjectId>{constant}));
}

TEST(DerivedObjects, AreNotDerivedFromThemselvesOrFromNothing) {
  DerivedObjects objects(1);
  objects.set_motion(0, path({1}), std::nullopt);
  const auto difference = std::make_shared<Difference>();
  const ObjectId m = objects.add("m", difference, std::array<ObjectId, 2>{0, 0});
  const ObjectId n = objects.add("n", difference, std::array<ObjectId, 2>{m, 0});
  EXPECT_THROW(objects.rebase(m, "m", std::array<ObjectId, 2>{0, n}), std::logic_error);
  EXPECT_THROW(objects.rebase(m, "m", std::array<ObjectId, 2>{m, 0}), std::logic_error);
  EXPECT_THROW(objects.rebase(m, "m", std::array<ObjectId, 2>{0, 9}), std::logic_error);
  EXPECT_THROW(objects.add("x", difference, std::array<ObjectId, 2>{0, 3}), std::logic_error);
  EXPECT_EQ(objects.trajectory(n), path({1}));
}

}  // namespace derived_objects_test
}  // namespace kinex

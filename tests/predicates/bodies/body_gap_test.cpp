// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps of bounding volumes, against their meaning at rational times, over every ring.
#include "predicates/bodies/body_gap.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace kinex {
namespace body_gap_test {

constexpr int kDegree = 3;
constexpr std::size_t kPowers = kDegree + 1;

// Two bodies of four axes and a constant of one, small integers.
struct Arguments {
  explicit Arguments(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto draw = [&] { return static_cast<int>(random() % 19) - 9; };
    for (auto& body : bodies) {
      for (std::size_t k = 0; k < body.size(); ++k) {
        body[k] = random() % 4 == 0 ? 0 : draw();
      }
    }
    reach[0] = 1 + static_cast<int>(random() % 9);
  }
  Rational position(std::size_t body, std::size_t axis, const Rational& t) const {
    Rational value;
    for (std::size_t k = kPowers; k-- > 0;) {
      value = value * t + Rational(bodies[body][axis * kPowers + k]);
    }
    return value;
  }
  template <class R>
  std::array<std::vector<R>, 3> in() const {
    std::array<std::vector<R>, 3> result;
    for (std::size_t i = 0; i < 2; ++i) {
      for (const int c : bodies[i]) result[i].push_back(R(c));
    }
    for (const int c : reach) result[2].push_back(R(c));
    return result;
  }
  std::array<std::array<int, 4 * kPowers>, 2> bodies{};
  std::array<int, 4 * kPowers> reach{};
};

template <class Coefficients, class Number>
Rational value_at(const Coefficients& c, const Rational& t, const Number& exact) {
  Rational value;
  for (std::size_t k = c.size(); k-- > 0;) value = value * t + exact(c[k]);
  return value;
}

template <class Meaning>
void check(const Predicate& predicate, const Meaning& meaning) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Arguments arguments(seed);
    const auto rationals = arguments.in<Rational>();
    const std::array<MotionView<Rational>, 3> r{rationals[0].data(), rationals[1].data(),
                                                rationals[2].data()};
    const auto integers = arguments.in<Integer>();
    const std::array<MotionView<Integer>, 3> z{integers[0].data(), integers[1].data(),
                                               integers[2].data()};
    const auto doubles = arguments.in<double>();
    const std::array<MotionView<double>, 3> d{doubles[0].data(), doubles[1].data(),
                                              doubles[2].data()};
    const std::vector<Rational> rational = predicate.rational(kDegree, r.data());
    const Polynomial exact = predicate.exact(kDegree, z.data());
    std::vector<double> plain(static_cast<std::size_t>(predicate.degree(kDegree)) + 1);
    predicate.plain(kDegree, d.data(), 2, plain.data());  // small integers: no rounding
    for (int i = -3; i <= 3; ++i) {
      const Rational t(Integer(i), Integer(3));
      const Rational value = meaning(arguments, t);
      EXPECT_EQ(value_at(rational, t, [](const Rational& c) { return c; }), value);
      EXPECT_EQ(value_at(exact.coefficients(), t, [](const Integer& c) { return Rational(c); }),
                value);
      EXPECT_EQ(
          value_at(plain, t - Rational(2), [](double c) { return *Rational::from_double(c); }),
          value);
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(BodyGap, DiscsApart) {
  for (const bool negated : {false, true}) {
    check(*make_discs_apart(negated), [negated](const Arguments& in, const Rational& t) {
      const Rational dx = in.position(1, 0, t) - in.position(0, 0, t);
      const Rational dy = in.position(1, 1, t) - in.position(0, 1, t);
      const Rational reach(in.reach[0]), gap = dx * dx + dy * dy - reach * reach;
      return negated ? -gap : gap;
    });
  }
  EXPECT_EQ(make_discs_apart(true)->opposite(), make_discs_apart(false)->name());
}

TEST(BodyGap, AxisGap) {
  for (const int axis : {0, 1}) {
    check(*make_axis_gap(axis), [axis](const Arguments& in, const Rational& t) {
      const std::size_t k = static_cast<std::size_t>(axis);
      return in.position(1, k, t) - in.position(0, k, t) - Rational(in.reach[0]);
    });
  }
}

}  // namespace body_gap_test
}  // namespace kinex

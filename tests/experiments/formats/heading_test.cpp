// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/heading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace kinex {
namespace heading_test {

Rational ratio(int p, int q) { return Rational(Integer(p), Integer(q)); }

// p and q are within half of 2^-40, and what 70 bits leave out.
const double kHalfStep = std::ldexp(1, -41) + 1e-15;

double radians(const Rational& degrees) { return degrees.to_double() / 180 * std::numbers::pi; }

Rational at(const std::vector<Rational>& coefficients, const Rational& t) {
  Rational value;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * t + coefficients[k];
  return value;
}

formats::Rotor at(const formats::RotorMotion& motion, const Rational& t) {
  return {at(motion[0], t), at(motion[1], t)};
}

Rational cross(const formats::Rotor& a, const formats::Rotor& b) { return a.p * b.q - a.q * b.p; }
Rational dot(const formats::Rotor& a, const formats::Rotor& b) { return a.p * b.p + a.q * b.q; }

// The angle through which the body turns between two instants less than half a turn apart.
double swept(const formats::RotorMotion& motion, const Rational& t0, const Rational& t1) {
  const formats::Rotor a = at(motion, t0), b = at(motion, t1);
  return 2 * std::atan2(cross(a, b).to_double(), dot(a, b).to_double()) * 180 / std::numbers::pi;
}

TEST(Heading, IsReducedToOneTurn) {
  EXPECT_EQ(formats::reduced_heading(0), Rational(0));
  EXPECT_EQ(formats::reduced_heading(360), Rational(0));
  EXPECT_EQ(formats::reduced_heading(-360), Rational(0));
  EXPECT_EQ(formats::reduced_heading(-1), Rational(359));
  EXPECT_EQ(formats::reduced_heading(ratio(-1, 3)), ratio(1079, 3));
  EXPECT_EQ(formats::reduced_heading(ratio(7201, 10)), ratio(1, 10));
}

TEST(Heading, NorthIsNinetyAndEastIsZero) {
  EXPECT_EQ(formats::heading_of_bearing(0), Rational(90));
  EXPECT_EQ(formats::heading_of_bearing(90), Rational(0));
  EXPECT_EQ(formats::heading_of_bearing(180), Rational(270));
  EXPECT_EQ(formats::heading_of_bearing(270), Rational(180));
  EXPECT_EQ(formats::heading_of_bearing(ratio(1801, 20)), ratio(7199, 20));
}

TEST(Heading, RightAnglesAreExact) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const formats::Rotor rotor = formats::rotor_of_heading(90 * quarter);
    const formats::RotorMotion fixed = formats::fixed_rotor(90 * quarter);
    const int cos[] = {1, 0, -1, 0}, sin[] = {0, 1, 0, -1};
    for (const formats::Rotor& r : {rotor, at(fixed, 7)}) {
      const Rational size = dot(r, r);
      EXPECT_EQ(r.p * r.p - r.q * r.q, size * Rational(cos[quarter]));
      EXPECT_EQ(Rational(2) * r.p * r.q, size * Rational(sin[quarter]));
    }
    EXPECT_TRUE(fixed[0][0].is_integer() && fixed[1][0].is_integer());
  }
}

TEST(Heading, IsAsNearAsPromised) {
  for (int k = 0; k < 7 * 360; ++k) {
    const Rational heading = ratio(k, 7);
    const formats::Rotor rotor = formats::rotor_of_heading(heading);
    const double half = radians(heading) / 2;
    EXPECT_NEAR(rotor.p.to_double(), std::cos(half), kHalfStep) << k;
    EXPECT_NEAR(rotor.q.to_double(), std::sin(half), kHalfStep) << k;
    EXPECT_TRUE(rotor.q.sign() > 0 || (rotor.q.is_zero() && rotor.p.sign() > 0)) << k;
    EXPECT_LE(rotor.p.denominator().bit_length(), 41u) << k;
    // Exactly the same, turned by half a turn or mirrored.
    const formats::Rotor opposite = formats::rotor_of_heading(formats::reduced_heading(heading + Rational(180)));
    EXPECT_TRUE(dot(rotor, opposite).is_zero()) << k;
    const formats::Rotor mirrored = formats::rotor_of_heading(formats::reduced_heading(-heading));
    EXPECT_TRUE((rotor.p * mirrored.q + rotor.q * mirrored.p).is_zero()) << k;
  }
}

TEST(Heading, TinyAndLongAnglesAreAngles) {
  const formats::Rotor tiny = formats::rotor_of_heading(*Rational::parse("1e-400"));
  EXPECT_EQ(tiny.p, Rational(1));
  EXPECT_TRUE(tiny.q.is_zero());
  const formats::Rotor nearly = formats::rotor_of_heading(Rational(360) - *Rational::parse("1e-400"));
  EXPECT_EQ(nearly.p, Rational(-1));
  EXPECT_TRUE(nearly.q.is_zero());
}

TEST(Heading, TurnsTheShortWayAndMeetsItsEnds) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 500; ++trial) {
    // Many right angles among them.
    const auto draw = [&] {
      const int k = static_cast<int>(random() % 1440);
      return trial % 3 == 0 ? Rational(k % 8 * 45) : ratio(k, 4);
    };
    const Rational from = draw(), to = draw(), t0 = ratio(trial, 3) - Rational(50);
    const Rational t1 = t0 + ratio(1 + trial % 5, 7), middle = (t0 + t1) / Rational(2);
    const formats::RotorMotion motion = formats::turning_rotor(from, t0, to, t1);
    EXPECT_TRUE(cross(at(motion, t0), formats::rotor_of_heading(from)).is_zero());
    EXPECT_TRUE(cross(at(motion, t1), formats::rotor_of_heading(to)).is_zero());
    const double way = formats::reduced_heading(to - from).to_double();
    const double expected = way > 180 ? way - 360 : way;  // 180: counter-clockwise
    EXPECT_NEAR(swept(motion, t0, middle), expected / 2, 2e-10)
        << from.to_string() << " " << to.to_string();
    EXPECT_NEAR(swept(motion, middle, t1), expected / 2, 2e-10)
        << from.to_string() << " " << to.to_string();
    EXPECT_LE(motion[0].size(), 2u);
  }
}

TEST(Heading, AcrossZero) {
  const formats::RotorMotion left = formats::turning_rotor(350, 0, 10, 1), right = formats::turning_rotor(10, 0, 350, 1);
  EXPECT_NEAR(swept(left, 0, 1), 20, 1e-9);
  EXPECT_NEAR(swept(right, 0, 1), -20, 1e-9);
  EXPECT_TRUE(at(left, ratio(1, 2)).q.is_zero());  // heading 0
  EXPECT_TRUE(at(right, ratio(1, 2)).q.is_zero());
}

TEST(Heading, HalfTurnsAreCounterClockwiseBothWays) {
  for (const int from : {0, 45, 90, 170, 180, 270, 359}) {
    const formats::RotorMotion motion = formats::turning_rotor(from, 0, (from + 180) % 360, 1);
    EXPECT_GT(cross(at(motion, 0), at(motion, ratio(1, 3))).sign(), 0) << from;
    EXPECT_TRUE(dot(at(motion, 0), at(motion, 1)).is_zero()) << from;
  }
}

}  // namespace heading_test
}  // namespace kinex

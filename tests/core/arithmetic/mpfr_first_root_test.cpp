// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/mpfr_first_root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace kinex {
namespace mpfr_first_root_test {

// scale (x - roots[0]) (x - roots[1]) .., every operation rounded; low degree first.
std::vector<MpFloat> polynomial_of(const std::vector<MpFloat>& roots, const MpFloat& scale) {
  std::vector<MpFloat> c{scale};
  for (const MpFloat& root : roots) {
    c.insert(c.begin(), MpFloat(scale.precision(), 0.0));
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] = c[i] - root * c[i + 1];
  }
  return c;
}

std::vector<MpFloat> negated(std::vector<MpFloat> c) {
  for (MpFloat& x : c) x = -x;
  return c;
}

// A certificate that has failed is replaced by its opposite, which must not fail at the same root.
TEST(MpfrRootDoubt, TheRootAtNowIsNotFoundAgain) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> anywhere(0.5, 2);
  int larger_than_a_few_units = 0;
  for (const long bits : {53, 100, 200}) {
    for (int trial = 0; trial < 300; ++trial) {
      std::vector<MpFloat> roots;
      for (int i = 0; i < 4; ++i) {
        // Three of them near one another: ill-conditioned, but apart by far more than half the digits.
        const double centre = i == 0 ? anywhere(random) + 3 : 1;
        roots.push_back(MpFloat(bits, centre + (i == 0 ? 0 : 0x1p-6 * (i + anywhere(random) / 4))));
      }
      const std::vector<MpFloat> c = polynomial_of(roots, MpFloat(bits, 1 / 3.0));
      const MpFloat start(bits, 0.25);
      const auto first = mpfr_first_sign_change(c, start, std::nullopt);
      ASSERT_TRUE(first.has_value());
      const MpFloat doubt = mpfr_root_doubt(c, *first);
      EXPECT_GT(doubt.sign(), 0);
      if (compare(doubt, *first * MpFloat(bits, 32.0) *
                             MpFloat(bits, std::ldexp(1, -static_cast<int>(bits)))) > 0) {
        ++larger_than_a_few_units;
      }
      const auto second = mpfr_first_sign_change(negated(c), *first + doubt, std::nullopt);
      ASSERT_TRUE(second.has_value());
      EXPECT_GT(compare(*second - *first, MpFloat(bits, 0x1p-10)), 0)
          << bits << " bits, trial " << trial;
    }
  }
  EXPECT_GT(larger_than_a_few_units, 300);
}

TEST(MpfrRootDoubt, AMultipleRootCostsHalfTheDigits) {
  const long bits = 100;
  const MpFloat one(bits, 1.0);
  const std::vector<MpFloat> c = polynomial_of({one, one, MpFloat(bits, 5.0)}, one);
  EXPECT_EQ(compare(mpfr_root_doubt(c, one), MpFloat(bits, 0x1p-50)), 0);
}

TEST(MpfrRootDoubt, AtZeroThereIsNone) {
  const long bits = 53;
  const std::vector<MpFloat> c{MpFloat(bits, 0.0), MpFloat(bits, 1.0), MpFloat(bits, 1.0)};
  EXPECT_EQ(mpfr_root_doubt(c, MpFloat(bits, 0.0)).sign(), 0);
}

}  // namespace mpfr_first_root_test
}  // namespace kinex

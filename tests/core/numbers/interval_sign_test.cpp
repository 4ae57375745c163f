// SPDX-License-Identifier: GPL-3.0-or-later
// Signs over intervals are those of the exact polynomial, and the same for every form of its degree.
#include "core/numbers/interval_sign.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "core/numbers/polynomial.h"

namespace kinex {
namespace interval_sign_test {

template <int D>
void check_degree(std::mt19937_64& random) {
  int known = 0, unknown = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<double, D + 1> c, m;
    std::vector<Integer> exact;
    // Magnitudes far above the coefficients, as where terms cancel.
    const double above = random() % 3 == 0 ? std::ldexp(1.0, static_cast<int>(random() % 64)) : 0;
    for (std::size_t i = 0; i <= D; ++i) {
      const auto v = static_cast<std::int64_t>(random() % 201) - 100;
      exact.emplace_back(v);
      c[i] = static_cast<double>(v);
      m[i] = std::fabs(c[i]) + above;
    }
    const double lo = std::ldexp(static_cast<double>(random() % 4096), -10) - 2;
    const double hi =
        random() % 2 == 0 ? lo : lo + std::ldexp(1.0, -static_cast<int>(random() % 40));
    const filter::Interval interval{lo, hi, hi - lo};
    const auto sign = filter::sign_over<D>(c.data(), m.data(), D, interval);
    ASSERT_EQ(sign, filter::sign_over<-1>(c.data(), m.data(), D, interval));
    ++(sign ? known : unknown);
    if (!sign) continue;
    const Polynomial p(exact);
    for (const double t : {lo, lo + 0.5 * (hi - lo), hi}) {
      EXPECT_EQ(*sign, p.sign_at(*Rational::from_double(t))) << p.to_string() << " at " << t;
    }
  }
  EXPECT_GT(known, 1000);
  EXPECT_GT(unknown, 50);
}

TEST(IntervalSign, IsExactAndTheSameForAnyForm) {
  std::mt19937_64 random(1);
  check_degree<0>(random);
  check_degree<1>(random);
  check_degree<2>(random);
  check_degree<3>(random);
  check_degree<4>(random);
  check_degree<6>(random);
}

}  // namespace interval_sign_test
}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// Every lane is bit for bit what doubles give, whatever the function was compiled for.
#include "core/numbers/lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace kinex {
namespace lanes_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Results {
  Lanes sum, difference, product, chosen, magnitude, mixed;
  LaneMask more, at_least, at_most;
};

[[gnu::always_inline]] inline void compute(const Lanes& a, const Lanes& b, Results& out) {
  out.sum = a + b;
  out.difference = a - b;
  out.product = a * b;
  out.chosen = larger(a, b);
  out.magnitude = magnitude_of(a);
  out.mixed = a;
  out.mixed *= b;
  out.mixed += 3 * a;  // contracted, it would be another number
  out.more = a > b;
  out.at_least = a >= b;
  out.at_most = (a <= b) & (b >= a);
}

KINEX_FOR_AVX2 void compute_avx2(const Lanes& a, const Lanes& b, Results& out) { compute(a, b, out); }

// Not a number is not a number, whatever its bits.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

void check(const std::array<double, kLanes>& a, const std::array<double, kLanes>& b, bool avx2) {
  const Lanes x(a[0], a[1], a[2], a[3]), y(b[0], b[1], b[2], b[3]);
  Results r;
  if (avx2) {
    compute_avx2(x, y, r);
  } else {
    compute(x, y, r);
  }
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double p = a[i], q = b[i];
    ASSERT_TRUE(same(r.sum[i], p + q)) << p << " " << q;
    ASSERT_TRUE(same(r.difference[i], p - q)) << p << " " << q;
    ASSERT_TRUE(same(r.product[i], p * q)) << p << " " << q;
    ASSERT_TRUE(same(r.chosen[i], larger(p, q))) << p << " " << q;
    ASSERT_TRUE(same(r.magnitude[i], std::fabs(p))) << p;
    volatile double product = p * q, three = 3 * p;
    ASSERT_TRUE(same(r.mixed[i], product + three)) << p << " " << q;
    ASSERT_EQ(r.more[i], p > q);
    ASSERT_EQ(r.at_least[i], p >= q);
    ASSERT_EQ(r.at_most[i], p <= q && q >= p);
  }
}

TEST(Lanes, AreDoublesSideBySide) {
  const std::vector<double> special{0.0, -0.0, 1, -1, 0x1p-1074, -0x1p-1030, 0x1p1023, -0x1p1023,
                                    kInfinity, -kInfinity, std::nan(""), 1 + 0x1p-52, 0.1};
  std::mt19937_64 random(1);
  const auto draw = [&] {
    if (random() % 4 == 0) return special[random() % special.size()];
    const double mantissa = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
    return std::ldexp(mantissa, static_cast<int>(random() % 80) - 40);
  };
  for (int i = 0; i < 20000; ++i) {
    std::array<double, kLanes> a, b;
    for (double& v : a) v = draw();
    for (double& v : b) v = draw();
    check(a, b, false);
    if (best_vectors() == Vectors::kAvx2) check(a, b, true);
    if (HasFatalFailure()) return;
  }
}

TEST(Lanes, RowsBecomeColumns) {
  std::array<double, 16> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<double>(i);
  Lanes out[4];
  transpose(&rows[0], &rows[4], &rows[8], &rows[12], out);
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) EXPECT_EQ(out[k][lane], rows[4 * lane + k]);
  }
}

}  // namespace lanes_test
}  // namespace kinex

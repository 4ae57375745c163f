// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/tight_enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/numbers/first_root.h"

namespace kinex {

namespace {

constexpr std::size_t kMostCoefficients = 33;
constexpr double kUnit = 0x1p-53;
// The largest difference of the coefficients' exponents.
constexpr long kRange = 800;

struct Scaled {
  double mantissa = 0;
  long exponent = 0;
};

Scaled scaled(const Integer& value) {
  Scaled result;
  result.mantissa = mpz_get_d_2exp(&result.exponent, value.raw());
  return result;
}

// p(m) 2^(down degree), where m = numerator / 2^down.
void evaluate(const std::vector<Integer>& p, const Integer& numerator, unsigned long down,
              Integer& value) {
  Integer term;
  mpz_set(value.raw(), p.back().raw());
  unsigned long shift = 0;
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    value *= numerator;
    shift += down;
    mpz_mul_2exp(term.raw(), p[i].raw(), shift);
    value += term;
  }
}

}  // namespace

bool tighten(const std::vector<Integer>& p, double& lo, double& hi) {
  if (p.size() < 3 || p.size() > kMostCoefficients) return false;
  const double m = lo + 0.5 * (hi - lo);
  if (!(lo < m && m < hi) || !(std::fabs(m) > 0x1p-900 && std::fabs(m) < 0x1p900)) return false;
  const int binade = std::ilogb(m);
  if (!(std::max(std::fabs(lo), std::fabs(hi)) < std::ldexp(2.0, binade + 1))) return false;

  // In x = t / 2^binade: 1 <= |x| < 4 between the ends, and coefficients of at most 1.
  std::array<Scaled, kMostCoefficients> parts;
  long most = std::numeric_limits<long>::min();
  for (std::size_t i = 0; i < p.size(); ++i) {
    parts[i] = scaled(p[i]);
    if (parts[i].mantissa == 0) continue;
    parts[i].exponent += static_cast<long>(i) * binade;
    most = std::max(most, parts[i].exponent);
  }
  const double x = std::ldexp(m, -binade);
  const double largest = std::ldexp(std::max(std::fabs(lo), std::fabs(hi)), -binade);
  double slope = 0, slope_size = 0, bend = 0;  // p', the same of absolute values, and of p''
  for (std::size_t i = p.size(); i-- > 1;) {
    double c = parts[i].mantissa;
    if (c != 0) {
      if (most - parts[i].exponent > kRange) return false;
      c = std::ldexp(c, static_cast<int>(parts[i].exponent - most));
    }
    const double k = static_cast<double>(i), size = std::fabs(c);
    slope = slope * x + k * c;
    slope_size = slope_size * largest + k * size;
    if (i > 1) bend = bend * largest + k * (k - 1) * size;
  }
  const double width = std::ldexp(hi - lo, -binade);
  const double slope_error =
      (static_cast<double>(4 * p.size()) * kUnit * slope_size + bend * width) * (1 + 0x1p-40);
  const double least_slope = std::fabs(slope) - slope_error;
  if (!(least_slope > 0x1p-900 && least_slope > slope_error)) return false;

  const long down = std::max(0L, 52L - binade);
  Integer numerator, value;
  mpz_set_d(numerator.raw(), std::ldexp(x, 52));
  if (binade > 52) numerator <<= static_cast<unsigned long>(binade - 52);
  evaluate(p, numerator, static_cast<unsigned long>(down), value);
  const Scaled v = scaled(value);
  const long exponent = v.exponent - down * static_cast<long>(p.size() - 1) - most;
  if (v.mantissa != 0 && !(exponent > -kRange && exponent < kRange)) return false;
  // The root lies at x - step, off by at most `error`.
  const double step = std::ldexp(v.mantissa, static_cast<int>(exponent)) / slope;
  const double error = std::fabs(step) * (slope_error / least_slope + 8 * kUnit);
  if (!(std::fabs(step) > 0x1p-900 || v.mantissa == 0)) return false;
  const double from = filter::next_down(x - filter::next_up(step + error));
  const double to = filter::next_up(x - filter::next_down(step - error));
  lo = std::max(lo, std::ldexp(from, binade));
  hi = std::min(hi, std::ldexp(to, binade));
  return true;
}

}  // namespace kinex

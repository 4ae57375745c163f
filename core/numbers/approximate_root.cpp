// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/approximate_root.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kinex {

namespace {

constexpr int kMaxDegree = 32;
constexpr int kMaxSteps = 60;
constexpr double kUnit = 0x1p-53;
constexpr long kFractionBits = 60;

struct Scaled {
  double mantissa;
  long exponent;
};

Scaled scaled(const Integer& value) {
  Scaled result{};
  result.mantissa = mpz_get_d_2exp(&result.exponent, value.raw());
  return result;
}

double times_power(double value, long exponent) {
  return std::ldexp(value, static_cast<int>(std::clamp(exponent, -3000L, 3000L)));
}

}  // namespace

std::optional<ApproximateRoot> approximate_root(const Polynomial& p, const Integer& lower,
                                                const Integer& upper, long exponent,
                                                int sign_at_lower) {
  const int d = p.degree();
  if (d > kMaxDegree) return std::nullopt;
  // In units of 2^unit the interval lies in [-1, 1].
  const long bits = static_cast<long>(std::max(lower.bit_length(), upper.bit_length()));
  const long unit = bits - exponent;
  const Scaled low = scaled(lower);
  const Scaled high = scaled(upper);
  double left = times_power(low.mantissa, low.exponent - bits);
  double right = times_power(high.mantissa, high.exponent - bits);
  if (right - left < 0x1p-40) return std::nullopt;

  std::array<double, kMaxDegree + 1> c{};
  std::array<Scaled, kMaxDegree + 1> parts{};
  bool first = true;
  long top = 0;
  for (int i = 0; i <= d; ++i) {
    const auto k = static_cast<std::size_t>(i);
    parts[k] = scaled(p[k]);
    if (parts[k].mantissa == 0) continue;
    parts[k].exponent += i * unit;
    top = first ? parts[k].exponent : std::max(top, parts[k].exponent);
    first = false;
  }
  for (std::size_t k = 0; k <= static_cast<std::size_t>(d); ++k) {
    if (parts[k].mantissa != 0) c[k] = times_power(parts[k].mantissa, parts[k].exponent - top);
  }

  // Newton, with bisection where it leaves the bracket or does not halve its steps.
  double x = 0.5 * (left + right);
  double last_step = right - left;
  double derivative = 0;
  for (int i = 0; i < kMaxSteps; ++i) {
    double value = c[static_cast<std::size_t>(d)];
    derivative = 0;
    for (int j = d; j-- > 0;) {
      derivative = derivative * x + value;
      value = value * x + c[static_cast<std::size_t>(j)];
    }
    if (value == 0) break;
    ((value > 0) == (sign_at_lower > 0) ? left : right) = x;
    double next = x - value / derivative;
    if (!(next > left && next < right) || std::fabs(next - x) > 0.5 * last_step) {
      next = 0.5 * (left + right);
    }
    last_step = std::fabs(next - x);
    x = next;
    if (last_step < 2 * kUnit) break;
  }
  double size = 0;
  const double magnitude = std::fabs(x);
  for (int j = d; j >= 0; --j) size = size * magnitude + std::fabs(c[static_cast<std::size_t>(j)]);
  const double error = 4 * kUnit * (1 + (d + 1) * size / std::fabs(derivative));
  if (!(error < 0.25) || !std::isfinite(x)) return std::nullopt;
  int log_error = 0;
  std::frexp(error, &log_error);

  ApproximateRoot result;
  mpz_set_d(result.center.raw(), std::ldexp(x, kFractionBits));
  result.center_exponent = kFractionBits - unit;
  result.log_error = log_error + unit;
  return result;
}

}  // namespace kinex

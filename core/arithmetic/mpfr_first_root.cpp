// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/mpfr_first_root.h"

#include <algorithm>
#include <cstdlib>

namespace kinex {
namespace {

constexpr int kMaxNodes = 200;

// Bernstein coefficients on [x, x + length].
std::vector<MpFloat> expand(const std::vector<MpFloat>& c, const MpFloat& x, const MpFloat& length) {
  std::vector<MpFloat> b = c;
  const std::size_t n = b.size() - 1;
  const long bits = x.precision();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = n; j-- > i;) b[j] += x * b[j + 1];
  }
  MpFloat power(bits, 1.0);
  MpFloat binomial(bits, 1.0);
  for (std::size_t i = 1; i <= n; ++i) {
    power = power * length;
    binomial = binomial * MpFloat(bits, static_cast<double>(n - i + 1)) /
               MpFloat(bits, static_cast<double>(i));
    b[i] = b[i] * power / binomial;
  }
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = n; i >= k; --i) b[i] += b[i - 1];
  }
  return b;
}

// 0, 1, or 2 for more: sign variations, the left end taken as positive and zeros as positive.
int variations(const std::vector<MpFloat>& b) {
  int count = 0;
  bool positive = true;
  for (std::size_t i = 1; i < b.size() && count < 2; ++i) {
    const bool p = b[i].sign() >= 0;
    if (p != positive) ++count;
    positive = p;
  }
  return count;
}

MpFloat refine(const std::vector<MpFloat>& c, MpFloat lo, MpFloat hi) {
  const long bits = lo.precision();
  const MpFloat half(bits, 0.5);
  MpFloat t = lo + half * (hi - lo);
  for (long i = 0; i < 2 * bits + 64; ++i) {
    const MpFloat v = mpfr_value(c, t);
    const int s = v.sign();
    if (s == 0) return t;
    if (s > 0) {
      lo = t;
    } else {
      hi = t;
    }
    MpFloat next = t - v / mpfr_slope(c, t);
    if (!next.is_finite() || !(compare(next, lo) > 0 && compare(next, hi) < 0)) {
      next = lo + half * (hi - lo);
      if (!(compare(next, lo) > 0 && compare(next, hi) < 0)) return t;
    }
    if (compare(next, t) == 0) return t;
    t = next;
  }
  return t;
}

// A power of two beyond which there is no root (Fujiwara), from the exponents.
std::optional<MpFloat> root_bound(const std::vector<MpFloat>& c) {
  const std::size_t d = c.size() - 1;
  if (c[d].sign() == 0 || !c[d].is_finite()) return std::nullopt;
  long exponent = -1000000;
  for (std::size_t i = 0; i < d; ++i) {
    if (c[i].sign() == 0) continue;
    if (!c[i].is_finite()) return std::nullopt;
    const long e = mpfr_get_exp(c[i].raw()) - mpfr_get_exp(c[d].raw()) + 1;
    const long n = static_cast<long>(d - i);
    exponent = std::max(exponent, e >= 0 ? (e + n - 1) / n : -((-e) / n));
  }
  MpFloat bound(c[d].precision(), 1.0);
  mpfr_mul_2si(bound.raw(), bound.raw(), exponent + 1, MPFR_RNDU);
  return bound;
}

}  // namespace

MpFloat mpfr_value(const std::vector<MpFloat>& c, const MpFloat& t) {
  MpFloat v = c.back();
  for (std::size_t i = c.size() - 1; i-- > 0;) v = v * t + c[i];
  return v;
}

MpFloat mpfr_slope(const std::vector<MpFloat>& c, const MpFloat& t) {
  MpFloat v(t.precision(), 0.0);
  for (std::size_t i = c.size() - 1; i > 0; --i) {
    v = v * t + c[i] * MpFloat(t.precision(), static_cast<double>(i));
  }
  return v;
}

MpFloat mpfr_root_doubt(const std::vector<MpFloat>& c, const MpFloat& t) {
  const long bits = t.precision();
  const auto scaled = [](MpFloat x, long exponent) {
    mpfr_abs(x.raw(), x.raw(), MPFR_RNDN);
    mpfr_mul_2si(x.raw(), x.raw(), exponent, MPFR_RNDN);
    return x;
  };
  const MpFloat least = scaled(t, 4 - bits), most = scaled(t, -bits / 2);
  const MpFloat size = scaled(t, 0);
  MpFloat sum(bits, 0.0);
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * size + scaled(c[i], 0);
  const MpFloat doubt = scaled(sum / mpfr_slope(c, t), 4 - bits);
  if (!doubt.is_finite() || compare(doubt, most) > 0) return compare(least, most) > 0 ? least : most;
  return compare(doubt, least) < 0 ? least : doubt;
}

std::optional<MpFloat> mpfr_first_sign_change(const std::vector<MpFloat>& c, const MpFloat& a,
                                              const std::optional<MpFloat>& until) {
  const std::optional<MpFloat> b = until ? until : root_bound(c);
  if (!b || compare(a, *b) >= 0) return std::nullopt;
  const long bits = a.precision();
  const MpFloat stretch(bits, 1 + 0x1p-7);
  const MpFloat ratio(bits, 31.0 / 64);
  MpFloat x = a;
  MpFloat y = a + (*b - a) * stretch;
  std::vector<MpFloat> pending;
  for (int nodes = 0; nodes < kMaxNodes; ++nodes) {
    const int v = variations(expand(c, x, y - x));
    if (v == 1) return refine(c, x, y);
    if (v == 0) {
      if (pending.empty()) return std::nullopt;
      x = y;
      y = pending.back();
      pending.pop_back();
      continue;
    }
    const MpFloat middle = x + (y - x) * ratio;
    if (!(compare(middle, x) > 0 && compare(middle, y) < 0)) return std::nullopt;
    pending.push_back(y);
    y = middle;
  }
  return std::nullopt;
}

}  // namespace kinex

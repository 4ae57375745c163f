// SPDX-License-Identifier: GPL-3.0-or-later
// First roots in plain doubles, for floors: no error bounds.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_FLOOR_ROOTS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_FLOOR_ROOTS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace kinex::families::floors {

// coefficient [i] of t^i; N = degree + 1.
template <std::size_t N>
using FloorPolynomial = std::array<double, N>;

template <std::size_t A, std::size_t B>
FloorPolynomial<A + B - 1> operator*(const FloorPolynomial<A>& p, const FloorPolynomial<B>& q) {
  FloorPolynomial<A + B - 1> r{};
  for (std::size_t i = 0; i < A; ++i) {
    for (std::size_t j = 0; j < B; ++j) r[i + j] += p[i] * q[j];
  }
  return r;
}

template <std::size_t N>
FloorPolynomial<N> operator-(FloorPolynomial<N> p, const FloorPolynomial<N>& q) {
  for (std::size_t i = 0; i < N; ++i) p[i] -= q[i];
  return p;
}

template <std::size_t N>
FloorPolynomial<N> operator+(FloorPolynomial<N> p, const FloorPolynomial<N>& q) {
  for (std::size_t i = 0; i < N; ++i) p[i] += q[i];
  return p;
}

// p / (t - root), the remainder left out.
template <std::size_t N>
FloorPolynomial<N - 1> without_root(const FloorPolynomial<N>& p, double root) {
  FloorPolynomial<N - 1> q;
  double carry = 0;
  for (std::size_t i = N - 1; i > 0; --i) q[i - 1] = carry = p[i] + root * carry;
  return q;
}

namespace floor_detail {

// Bernstein coefficients on [x, x + length].
template <std::size_t N>
FloorPolynomial<N> bernstein(FloorPolynomial<N> p, double x, double length) {
  for (std::size_t i = 0; i + 1 < N; ++i) {
    for (std::size_t j = N - 1; j-- > i;) p[j] += x * p[j + 1];
  }
  double factor = 1;
  for (std::size_t j = 1; j < N; ++j) {
    factor *= length * (static_cast<double>(j) / static_cast<double>(N - j));
    p[j] *= factor;
  }
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t k = N - 1; k >= i; --k) p[k] += p[k - 1];
  }
  return p;
}

// The root between lo and hi, where p falls from positive to negative; `t`: a first guess.
template <std::size_t N>
double refine(const FloorPolynomial<N>& p, double lo, double hi, double t) {
  for (int i = 0; i < 64; ++i) {
    double value = p[N - 1], slope = 0;
    for (std::size_t j = N - 1; j-- > 0;) {
      slope = slope * t + value;
      value = value * t + p[j];
    }
    (value > 0 ? lo : hi) = t;
    double next = t - value / slope;
    if (!(next >= lo && next <= hi)) next = 0.5 * (lo + hi);
    const double step = next - t;
    t = next;
    if (std::fabs(step) <= 0x1p-50 * std::fabs(t)) break;
  }
  return t;
}

}  // namespace floor_detail

// The first root in (a, b] of a polynomial that is positive right after a; infinity: none.
template <std::size_t N>
double first_root(const FloorPolynomial<N>& p, double a, double b) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if constexpr (N == 1) return kNever;
  if constexpr (N == 2) {
    if (!(p[1] < 0)) return kNever;
    const double t = -p[0] / p[1];
    return t <= b ? t : kNever;
  }
  std::array<double, 64> ends;
  std::size_t waiting = 0;
  for (double x = a, y = b;;) {
    const FloorPolynomial<N> c = floor_detail::bernstein(p, x, y - x);
    if (x == a && c[0] < 0) return a;
    std::size_t changes = 0, minus = N;
    for (std::size_t i = 1; i < N; ++i) {
      if ((c[i] < 0) == (c[i - 1] < 0)) continue;
      if (++changes == 1) minus = i;
    }
    if (changes == 1) {
      const double part = (static_cast<double>(minus) - c[minus] / (c[minus] - c[minus - 1])) /
                          static_cast<double>(N - 1);
      return floor_detail::refine(p, x, y, x + (y - x) * part);
    }
    if (changes != 0 && y - x <= 0x1p-48 * std::fabs(y)) return x;
    if (changes != 0 && waiting < ends.size()) {
      ends[waiting++] = y;
      y = 0.5 * (x + y);
    } else if (waiting == 0) {
      return kNever;
    } else {
      x = y;
      y = ends[--waiting];
    }
  }
}

}  // namespace kinex::families::floors

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials in plain doubles, for the simulations of this folder.
#ifndef KINEX_TESTS_ORACLES_POLYNOMIALS_H
#define KINEX_TESTS_ORACLES_POLYNOMIALS_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace oracles {

using Polynomial = std::vector<double>;  // low degree first

inline double value(const Polynomial& p, double t) {
  double sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
  return sum;
}
inline Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}
inline Polynomial difference(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()), 0);
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  return a;
}
inline Polynomial sum(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()), 0);
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
  return a;
}

// All points of (from, to) at which p changes its sign, in order: between the zeros of its derivative it is
// monotone, and bisection finds at most one.
inline void zeros(const Polynomial& p, double from, double to, std::vector<double>& out) {
  out.clear();
  if (p.size() < 2) return;
  Polynomial derivative;
  for (std::size_t i = 1; i < p.size(); ++i) derivative.push_back(static_cast<double>(i) * p[i]);
  std::vector<double> ends;
  zeros(derivative, from, to, ends);
  ends.insert(ends.begin(), from);
  ends.push_back(to);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    double low = ends[i], high = ends[i + 1];
    const bool rises = value(p, low) < 0;
    if (rises == (value(p, high) < 0)) continue;
    while (true) {
      const double middle = low + (high - low) / 2;
      if (!(low < middle && middle < high)) break;
      ((value(p, middle) < 0) == rises ? low : high) = middle;
    }
    out.push_back(high);
  }
}

}  // namespace oracles

#endif

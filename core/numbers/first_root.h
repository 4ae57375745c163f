// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point filter for failure times: the first sign change of a polynomial after a given
// time, certified in doubles.
//
// Bernstein bisection. The polynomial is expanded in the Bernstein basis of a node [x, x + length];
// the signs of the coefficients decide (?: not certain; the left end is positive):
//
//     + + + + +   no sign change in the node; continue with the next one
//     + + ? - -   exactly one root in the node; refine it by Newton's method and certify it
//     + - + ? -   undecided; cut the node at 31/64 and take the left part first
//
//   a                                                   b
//   |--------------------- 3 ---------------------------|      sign variations of the nodes
//   |--------- 0 --------|------------- 3 --------------|
//                        |----- 1 -----|..............      found; the right part is skipped
//
// All bounds are a-priori bounds in round-to-nearest; the rounding mode is never changed. With
// kCertify every answer other than kUnknown is a proof. Without it the same code runs with no error
// accounting: that is the `double` arithmetic.
//
// Error model. The exact polynomial is sum p_j t^j with |p_j - c_j| <= e_j; u = 2^-53, d = degree.
//   (1) Every quantity computed below is a sum of terms k c_j t^i with at most 5d + 8 roundings on
//       each term: 2d in the shift by a, 2d in the scaling, 2 in the division by a binomial, d in
//       the summation (Horner's rule: 2d in all).
//   (2) So it is off by at most
//         sum_j ((5d + 8) u (1 + 2^-20) |c_j| + e_j) T^j,   T = |a| + length >= every |t| involved.
//   (3) With gamma = (8d + 32) u and m_j = |c_j| + e_j / gamma this is at most gamma * m(T). The
//       slack (3d + 24) u covers the conversion of c_j from 128-bit integers (3u) and the roundings
//       of m(T).
//   (4) Underflow adds at most 2^-1074 per operation, times T^d 2^d: negligible, because
//       2^-300 <= m(T) <= 2^900 and T <= 2^(600/d) are checked, and d <= kMaxFilterDegree.
// Time. The polynomial is in s = t - origin. The origin is a double, and a multiple of a power of
// two that is no smaller than the units in the last place of the times involved. So t - origin is
// exact for every double t involved.
//
// Source: Bernstein bisection as in Mehlhorn and Sagraloff's surveys of real root isolation; the
// bounds are derived here.
#ifndef KINEX_CORE_NUMBERS_FIRST_ROOT_H
#define KINEX_CORE_NUMBERS_FIRST_ROOT_H

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace kinex::filter {

inline constexpr int kMaxFilterDegree = 100;  // beyond it the filter abstains
// The bound on |t| at the largest degree d, 2^(600 / d); lower degrees have larger ones.
inline constexpr double kLeastTimeLimit = 0x1p6;
static_assert(600 / kMaxFilterDegree == 6);
// Nodes visited before the filter gives up; generic certificates need 1 to 3.
inline constexpr int kMaxNodes = 96;

enum class Search { kNone, kFound, kUnknown };  // no sign change; one; the filter cannot tell

struct Enclosure {  // an interval [lo, hi]
  double lo;
  double hi;
};

// std::nextafter(x, infinity) and std::nextafter(x, -infinity), without a call.
inline double next_up(double x) {
  const auto moved = [x](int units) {
    return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + units);
  };
  if (x > 0) return x < std::numeric_limits<double>::infinity() ? moved(1) : x;
  if (x < 0) return moved(-1);
  return x == 0 ? std::numeric_limits<double>::denorm_min() : x;
}
inline double next_down(double x) { return -next_up(-x); }

constexpr double gamma(int d) { return (8 * d + 32) * 0x1p-53; }  // see the error model, (3)

// binomial(d, i)^-1 for i = 0..d.
template <int D>
struct InverseBinomials {
  std::array<double, D + 1> value{};
  constexpr InverseBinomials() {
    double b = 1;
    for (int i = 0; i <= D; ++i) {
      value[static_cast<std::size_t>(i)] = 1 / b;
      b = b * (D - i) / (i + 1);
    }
  }
};

// D >= 0: the degree, known at compile time; D < 0: the degree is given at run time.
template <int D, bool kCertify>
class FirstRoot {
 public:
  static constexpr int kRoom = D >= 0 ? D + 1 : kMaxFilterDegree + 1;
  // The bound on |t| at this degree: 2^floor(600 / D).
  static constexpr double time_limit() {
    double p = 1;
    for (int i = 0; i < (D > 0 ? 600 / D : 600); ++i) p *= 2;
    return p;
  }
  static constexpr double kTimeLimit = time_limit();

  // c, m: the coefficients c_j and the magnitudes m_j of the error model, degree + 1 entries each,
  // which must outlive this; m is not read without kCertify.
  FirstRoot(const double* c, const double* m, int degree, double origin)
      : c_(c), m_(m), degree_(degree), origin_(origin) {}

  // The first time in (a, b] at which the polynomial changes sign. a, b are times s = t - origin;
  // out is in t.
  //   kFound    exactly one root lies in out, the polynomial is positive at out.lo and negative at
  //             out.hi, and no sign change lies in (a, out.lo)
  //   kNone     it is positive on (a, b]
  //   kUnknown  not decided
  // Requires a polynomial that is positive right after a, and b - a finite. A root slightly beyond
  // b may be found as well.
  Search operator()(double a, double b, Enclosure& out) const {
    const double end = first_end(a, b);
    std::array<double, kRoom> bernstein;
    const double error = expand(a, length_of(a, end), bernstein);
    return from_first_node(a, end, bernstein, error, out);
  }

  // The first node is [a, first_end(a, b)]. length_of(x, y): the length of a node, rounded up.
  static double first_end(double a, double b) {
    // Slightly beyond b, so that a root exactly at b is not at the end of the interval.
    return a + (b - a) * (1 + 0x1p-7);
  }
  static double length_of(double x, double y) { return next_up(y - x); }

  // The same search, continued from the first node: `bernstein` has its coefficients (and is
  // overwritten), `error` bounds their errors (negative: no bound is known).
  [[gnu::always_inline]] Search from_first_node(double a, double end,
                                                std::array<double, kRoom>& bernstein, double error,
                                                Enclosure& out) const {
    // Most searches of degree 2 end here, at signs + ? -. The loop finds the same, later.
    if constexpr (D == 2 && kCertify) {
      if (error >= 0 && bernstein[2] < -error) {
        if (solve(a, last_of(a, length_of(a, end)), out) == Search::kFound) return Search::kFound;
      }
    }
    return from_node(a, end, bernstein, error, out);
  }

  // Bernstein coefficients on [x, x + length]; returns a bound on their errors, negative if none.
  double expand(double x, double length, std::array<double, kRoom>& b) const {
    const int n = d();
    for (int i = 0; i <= n; ++i) b[static_cast<std::size_t>(i)] = c_[i];
    if (x != 0) {
      for (int i = 0; i < n; ++i) {
        for (int j = n - 1; j >= i; --j) {
          b[static_cast<std::size_t>(j)] += x * b[static_cast<std::size_t>(j + 1)];
        }
      }
    }
    double power = 1;
    if constexpr (D >= 0) {
      constexpr InverseBinomials<(D >= 0 ? D : 0)> inverse;
      for (int i = 1; i <= n; ++i) {
        power *= length;
        b[static_cast<std::size_t>(i)] *= power * inverse.value[static_cast<std::size_t>(i)];
      }
    } else {
      double binomial = 1;
      for (int i = 1; i <= n; ++i) {
        power *= length;
        binomial = binomial * (n - i + 1) / i;
        b[static_cast<std::size_t>(i)] *= power / binomial;
      }
    }
    for (int k = 1; k <= n; ++k) {
      for (int i = n; i >= k; --i) {
        b[static_cast<std::size_t>(i)] += b[static_cast<std::size_t>(i - 1)];
      }
    }
    return error_at(std::fabs(x) + length);
  }

  double value(double t) const {
    double v = c_[d()];
    for (int i = d() - 1; i >= 0; --i) v = v * t + c_[i];
    return v;
  }

  // A bound on the error of value(t) for |t| <= bound; negative if out of the filter's range.
  double error_at(double bound) const {
    if constexpr (!kCertify) return 0;
    double v = m_[d()];
    for (int i = d() - 1; i >= 0; --i) v = v * bound + m_[i];
    return in_range(v, bound) ? gamma(d()) * v : -1;
  }

 private:
  Search from_node(double a, double end, std::array<double, kRoom>& bernstein, double error,
                   Enclosure& out) const {
    std::array<double, kMaxNodes + 1> pending;  // right ends of nodes still to be visited
    int top = 0;
    double x = a;
    double y = end;
    double length = length_of(x, y);
    for (int nodes = 0;;) {
      if (!(error >= 0)) return kCertify ? Search::kUnknown : Search::kNone;
      int plus = 0, minus = 0;
      const int variations = classify(bernstein, error, plus, minus);
      if (variations == 0) {
        if (top == 0) return Search::kNone;
        x = y;
        y = pending[static_cast<std::size_t>(--top)];
      } else if (variations == 1) {
        const double bp = bernstein[static_cast<std::size_t>(plus)];
        const double bm = bernstein[static_cast<std::size_t>(minus)];
        const double fraction = (plus + (minus - plus) * (bp / (bp - bm))) / d();
        const double last = last_of(x, length);
        if constexpr (D == 2 && kCertify) {
          if (solve(x, last, out) == Search::kFound) return Search::kFound;
        }
        return refine(x, last, x + length * fraction, out);
      } else {
        // Not at the middle, where the roots of simple inputs lie.
        const double middle = x + (y - x) * (31.0 / 64);
        if (!(middle > x && middle < y) || y - x < 0x1p-48 * std::fabs(x)) break;
        pending[static_cast<std::size_t>(top++)] = y;
        y = middle;
      }
      if (++nodes == kMaxNodes) break;
      length = length_of(x, y);
      error = expand(x, length, bernstein);
    }
    return kCertify ? Search::kUnknown : Search::kNone;
  }

  int d() const { return D >= 0 ? D : degree_; }

  // x + length may have been rounded up by half a unit: stay strictly inside the node.
  static double last_of(double x, double length) {
    return x + length > x ? next_down(x + length) : x + length;
  }

  // Most bounds are below the limit of the largest degree, which needs no power.
  bool is_near(double bound) const {
    if constexpr (D >= 0) return bound <= kTimeLimit;
    return bound <= kLeastTimeLimit || bound <= std::exp2(600.0 / d());
  }

  bool in_range(double magnitude, double bound) const {
    return magnitude >= 0x1p-300 && magnitude <= 0x1p900 && is_near(bound);
  }

  // 0: certainly positive on the whole node; 1: certainly exactly one root, from + to -; 2: neither
  // is certain. plus, minus: indices of the last + and the first - (for 1). The left end is
  // positive.
  int classify(const std::array<double, kRoom>& b, double error, int& plus, int& minus) const {
    const int n = d();
    int i = 1;
    while (i <= n && b[static_cast<std::size_t>(i)] > error) ++i;
    if (i > n) return 0;
    plus = i - 1;
    // At most one coefficient of unknown sign between the + block and the - block.
    if (!(b[static_cast<std::size_t>(i)] < -error)) ++i;
    if (i > n) return 2;
    minus = i;
    for (; i <= n; ++i) {
      if (!(b[static_cast<std::size_t>(i)] < -error)) return 2;
    }
    return 1;
  }

  // The root of a polynomial of degree 2 in [x, y], where it falls from + to -, by its formula. Where
  // rounding spoils that, the certificate is missed, and refine() has to find it.
  Search solve(double x, double y, Enclosure& out) const {
    const double root = std::sqrt(c_[1] * c_[1] - 4 * c_[2] * c_[0]);
    const double sum = c_[1] > 0 ? -0.5 * (c_[1] + root) : 0.5 * (root - c_[1]);
    const double t = c_[1] > 0 ? sum / c_[2] : c_[0] / sum;
    if (!(t > x && t < y)) return Search::kUnknown;
    return certify(x, y, t, -root, out);
  }

  Search refine(double x, double y, double t, Enclosure& out) const {
    double lo = x, hi = y, slope = 0;
    for (int i = 0; i < 60; ++i) {
      double v = c_[d()];
      slope = 0;
      for (int k = d() - 1; k >= 0; --k) {
        slope = slope * t + v;
        v = v * t + c_[k];
      }
      if (v > 0) {
        lo = t;
      } else {
        hi = t;
      }
      double next = t - v / slope;
      if (!(next > lo && next < hi)) {
        if (v == 0) break;
        // Newton leaves the bracket: either it has converged onto an end, or it must be halved.
        if (std::fabs(next - t) <= 0x1p-51 * std::fabs(t)) break;
        next = lo + 0.5 * (hi - lo);
        if (!(next > lo && next < hi)) break;
      }
      const double step = std::fabs(next - t);
      t = next;
      if (step <= 0x1p-50 * std::fabs(t)) break;
      // Quadratic convergence: a relative step of 2^-28 leaves an error far below one unit.
      if (step <= 0x1p-28 * std::fabs(t) && i > 0) break;
    }
    if constexpr (!kCertify) {
      out = {origin_ + t, origin_ + t};
      return Search::kFound;
    } else {
      return certify(x, y, t, slope, out);
    }
  }

  Search certify(double x, double y, double t, double slope, Enclosure& out) const {
    const double base = error_at(std::fabs(t));
    if (!(base >= 0)) return Search::kUnknown;
    double width = 2 * base / std::fabs(slope) + 0x1p-51 * std::fabs(origin_ + t) + 0x1p-900;
    for (int attempt = 0; attempt < 5; ++attempt, width *= 8) {
      if (!(width < y - x)) return Search::kUnknown;
      // Within 2^-20 of |t| the bound grows by less than (1 + 2^-20)^d < 1 + 2^-12.
      const double error =
          width <= 0x1p-21 * std::fabs(t) ? base * (1 + 0x1p-10) : error_at(std::fabs(t) + 2 * width);
      if (!(error >= 0)) return Search::kUnknown;
      out = {origin_ + (t - width), origin_ + (t + width)};
      const double lo = out.lo - origin_;
      const double hi = out.hi - origin_;
      // The differences must be exact. They are, unless the root is extremely far from the origin.
      if (out.lo - lo != origin_ || out.hi - hi != origin_) return Search::kUnknown;
      if (!(lo >= x && hi <= y)) return Search::kUnknown;
      if (value(lo) > error && value(hi) < -error) return Search::kFound;
    }
    return Search::kUnknown;
  }

  const double* c_;
  const double* m_;
  int degree_;
  double origin_;
};

// A bound on the absolute values of all real roots (Fujiwara): a power of two; +infinity if the
// sign of the leading coefficient is not certain. The coefficients' errors are those implied by m
// (see the error model); none if m is null.
double root_bound(const double* c, const double* m, int degree);

// FirstRoot for a degree known at run time. Requires degree >= 2; a, b are t - origin, b may be
// +infinity.
template <bool kCertify>
Search first_sign_change(const double* c, const double* m, int degree, double origin, double a,
                         double b, Enclosure& out);

extern template Search first_sign_change<true>(const double*, const double*, int, double, double,
                                               double, Enclosure&);
extern template Search first_sign_change<false>(const double*, const double*, int, double, double,
                                                double, Enclosure&);

}  // namespace kinex::filter

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials over any ring, for predicate formulas: of fixed size (the hot path) or dynamic.
#ifndef KINEX_CORE_NUMBERS_RING_POLYNOMIAL_H
#define KINEX_CORE_NUMBERS_RING_POLYNOMIAL_H

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/numbers/ball.h"
#include "core/numbers/integer.h"
#include "core/numbers/mp_float.h"
#include "core/numbers/rational.h"

namespace kinex {

// The ring of coefficient bounds: evaluates a formula on the largest absolute values, to decide
// whether machine integers can overflow anywhere in it.
struct Magnitude {
  double value = 0;
  double narrow_peak = 0;  // largest 64-bit intermediate
  double wide_peak = 0;    // largest 128-bit intermediate
  bool wide = false;

  Magnitude noted() const {
    Magnitude m = *this;
    double& peak = wide ? m.wide_peak : m.narrow_peak;
    peak = std::max(peak, value);
    return m;
  }
  static Magnitude merge(double value, const Magnitude& a, const Magnitude& b) {
    Magnitude m{value, std::max(a.narrow_peak, b.narrow_peak), std::max(a.wide_peak, b.wide_peak),
                a.wide || b.wide};
    return m.noted();
  }
  friend Magnitude operator+(const Magnitude& a, const Magnitude& b) {
    return merge(a.value + b.value, a, b);
  }
  friend Magnitude operator-(const Magnitude& a, const Magnitude& b) { return a + b; }
  friend Magnitude operator*(const Magnitude& a, const Magnitude& b) {
    return merge(a.value * b.value, a, b);
  }
  Magnitude& operator+=(const Magnitude& b) { return *this = *this + b; }
};

// The ring of rounding errors of a formula evaluated in plain doubles. Every value is a sum of
// monomials:
//   magnitude  bounds the sum of their absolute values
//   roundings  bounds the number of factors (1 + delta), |delta| <= 2^-53, of any of them
// Inputs are exact, and so are differences of two inputs (they are integers of few bits, or
// multiples of one power of two).
struct RoundingBound {
  double magnitude = 0;
  double roundings = 0;
  bool input = false;

  friend RoundingBound operator+(const RoundingBound& a, const RoundingBound& b) {
    return {a.magnitude + b.magnitude, std::max(a.roundings, b.roundings) + 1, false};
  }
  friend RoundingBound operator-(const RoundingBound& a, const RoundingBound& b) {
    if (a.input && b.input) return {a.magnitude + b.magnitude, 0, false};
    return a + b;
  }
  friend RoundingBound operator*(const RoundingBound& a, const RoundingBound& b) {
    return {a.magnitude * b.magnitude, a.roundings + b.roundings + 1, false};
  }
  RoundingBound& operator+=(const RoundingBound& b) { return *this = *this + b; }
};

// The ring of products of two R, which may be twice as wide.
template <class R>
struct WideRing {
  using Type = R;
  static Type widen(const R& a) { return a; }
  static Type product(const R& a, const R& b) { return a * b; }
};
template <>  // 64-bit integers multiply to 128 bits
struct WideRing<std::int64_t> {
  using Type = Int128;
  static Type widen(std::int64_t a) { return a; }
  static Type product(std::int64_t a, std::int64_t b) { return static_cast<Int128>(a) * b; }
};
template <>  // a magnitude notes that it is wide
struct WideRing<Magnitude> {
  using Type = Magnitude;
  static Type widen(Magnitude a) {
    a.wide = true;
    return a.noted();
  }
  static Type product(const Magnitude& a, const Magnitude& b) { return widen(a) * widen(b); }
};

// A polynomial with D + 1 coefficients, low degree first; leading ones may be zero.
template <class R, int D>
struct FixedPolynomial {
  using Ring = R;
  R c[D + 1];
};

template <class R, int A, int B>  // the sum
constexpr auto operator+(const FixedPolynomial<R, A>& a, const FixedPolynomial<R, B>& b) {
  FixedPolynomial<R, (A > B ? A : B)> r;
  for (int i = 0; i <= (A > B ? A : B); ++i) {
    if (i <= A && i <= B) {
      r.c[i] = a.c[i] + b.c[i];
    } else if (i <= A) {
      r.c[i] = a.c[i];
    } else {
      r.c[i] = b.c[i];
    }
  }
  return r;
}

// Only between polynomials of one size, so that no negation of single coefficients is needed.
template <class R, int D>
constexpr auto operator-(const FixedPolynomial<R, D>& a, const FixedPolynomial<R, D>& b) {
  FixedPolynomial<R, D> r;
  for (int i = 0; i <= D; ++i) r.c[i] = a.c[i] - b.c[i];
  return r;
}

// Forced inline: a call would cost more than the work, and GCC does not inline it unprompted.
template <class R, int A, int B>
[[gnu::always_inline]] constexpr auto operator*(const FixedPolynomial<R, A>& a,
                                                const FixedPolynomial<R, B>& b) {
  FixedPolynomial<R, A + B> r;
  for (int k = 0; k <= A + B; ++k) {
    const int first = k > B ? k - B : 0;
    const int last = k < A ? k : A;
    R sum = a.c[first] * b.c[k - first];
    for (int i = first + 1; i <= last; ++i) sum += a.c[i] * b.c[k - i];
    r.c[k] = sum;
  }
  return r;
}

// The product in the wide ring (128 bits for machine integers, the same ring for all others).
template <class R, int A, int B>
constexpr auto wide_product(const FixedPolynomial<R, A>& a, const FixedPolynomial<R, B>& b) {
  using W = WideRing<R>;
  FixedPolynomial<typename W::Type, A + B> r;
  for (int k = 0; k <= A + B; ++k) {
    const int first = k > B ? k - B : 0;
    const int last = k < A ? k : A;
    typename W::Type sum = W::product(a.c[first], b.c[k - first]);
    for (int i = first + 1; i <= last; ++i) sum += W::product(a.c[i], b.c[k - i]);
    r.c[k] = sum;
  }
  return r;
}

template <class R, int D>  // the same, in the wide ring
constexpr auto widen(const FixedPolynomial<R, D>& a) {
  FixedPolynomial<typename WideRing<R>::Type, D> r;
  for (int i = 0; i <= D; ++i) r.c[i] = WideRing<R>::widen(a.c[i]);
  return r;
}

// A polynomial of any size; never empty.
template <class R>
struct DynamicPolynomial {
  using Ring = R;
  std::vector<R> c;
};

template <class R>  // the sum
DynamicPolynomial<R> operator+(DynamicPolynomial<R> a, const DynamicPolynomial<R>& b) {
  const std::size_t common = std::min(a.c.size(), b.c.size());
  for (std::size_t i = 0; i < common; ++i) a.c[i] += b.c[i];
  for (std::size_t i = common; i < b.c.size(); ++i) a.c.push_back(b.c[i]);
  return a;
}

// Requires equal sizes.
template <class R>
DynamicPolynomial<R> operator-(DynamicPolynomial<R> a, const DynamicPolynomial<R>& b) {
  for (std::size_t i = 0; i < b.c.size(); ++i) a.c[i] -= b.c[i];
  return a;
}

template <class R>  // the product
DynamicPolynomial<R> operator*(const DynamicPolynomial<R>& a, const DynamicPolynomial<R>& b) {
  DynamicPolynomial<R> r;
  r.c.reserve(a.c.size() + b.c.size() - 1);
  for (std::size_t k = 0; k + 1 < a.c.size() + b.c.size(); ++k) {
    const std::size_t first = k >= b.c.size() ? k - b.c.size() + 1 : 0;
    const std::size_t last = std::min(k, a.c.size() - 1);
    R sum = a.c[first] * b.c[k - first];
    for (std::size_t i = first + 1; i <= last; ++i) sum += a.c[i] * b.c[k - i];
    r.c.push_back(std::move(sum));
  }
  return r;
}

template <class R>  // the product, in the wide ring, which is R
DynamicPolynomial<R> wide_product(const DynamicPolynomial<R>& a, const DynamicPolynomial<R>& b) {
  return a * b;
}
template <class R>  // the same, in the wide ring, which is R
DynamicPolynomial<R> widen(DynamicPolynomial<R> a) {
  return a;
}

// An integer constant of a formula, ready for every ring.
class FormulaConstant {
 public:
  explicit FormulaConstant(Integer value)
      : exact_(std::move(value)),
        machine_(exact_.fits_int64() ? exact_.to_int64() : 0),
        fits_(exact_.fits_int64()),
        approximate_(exact_.to_double()) {}

  std::int64_t in(const std::int64_t&) const { return machine_; }
  double in(const double&) const { return approximate_; }
  Ball in(const Ball&) const {
    // to_double truncates: off by less than one unit in the last place of 53 bits.
    return {approximate_,
            exact_.bit_length() <= 53
                ? 0.0
                : 2 * Ball::kUnit * (approximate_ < 0 ? -approximate_ : approximate_)};
  }
  Magnitude in(const Magnitude&) const {
    const double bound =
        fits_ ? (approximate_ < 0 ? -approximate_ : approximate_) * (1 + 0x1p-40) : 0x1p200;
    return Magnitude{bound, 0, 0, false}.noted();
  }
  RoundingBound in(const RoundingBound&) const {
    const double bound = approximate_ < 0 ? -approximate_ : approximate_;
    return {bound * (1 + 0x1p-50), exact_.bit_length() <= 53 ? 0.0 : 2.0, false};
  }
  const Integer& exact() const { return exact_; }
  Integer in(const Integer&) const { return exact_; }
  Rational in(const Rational&) const { return Rational(exact_); }
  MpFloat in(const MpFloat& like) const { return MpFloat(like.precision(), Rational(exact_)); }

 private:
  Integer exact_;
  std::int64_t machine_;
  bool fits_;
  double approximate_;
};

template <class R, int D>  // times a constant
constexpr auto scaled(FixedPolynomial<R, D> a, const FormulaConstant& k) {
  for (int i = 0; i <= D; ++i) a.c[i] = a.c[i] * k.in(a.c[i]);
  return a;
}
template <class R>  // times a constant
DynamicPolynomial<R> scaled(DynamicPolynomial<R> a, const FormulaConstant& k) {
  for (R& c : a.c) c = c * k.in(c);
  return a;
}

}  // namespace kinex

#endif

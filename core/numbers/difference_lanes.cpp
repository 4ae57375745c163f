// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds of errors are those of exact_arithmetic_difference.cpp, exact_arithmetic.cpp (degree 1) and
// first_root.h: every operation here is one of theirs, in four lanes.
#include "core/numbers/difference_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kinex::filter {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

typedef double Two __attribute__((vector_size(16)));

[[gnu::always_inline]] inline Two two_at(const double* p) {
  Two two;
  __builtin_memcpy(&two, p, sizeof(two));
  return two;
}
[[gnu::always_inline]] inline Lanes four_at(const double* p) {
  Lanes four;
  __builtin_memcpy(&four.v, p, sizeof(four.v));
  return four;
}
// Pairs (a, b) of four lanes become the lanes of a and of b.
[[gnu::always_inline]] inline void unzip(const Two* pairs, Lanes& a, Lanes& b) {
  const Lanes::Vector low = __builtin_shufflevector(pairs[0], pairs[2], 0, 1, 2, 3);
  const Lanes::Vector high = __builtin_shufflevector(pairs[1], pairs[3], 0, 1, 2, 3);
  const Lanes::Vector even = __builtin_shufflevector(low, high, 0, 4, 2, 6);
  const Lanes::Vector odd = __builtin_shufflevector(low, high, 1, 5, 3, 7);
  a = Lanes(__builtin_shufflevector(even, even, 0, 1, 2, 3));
  b = Lanes(__builtin_shufflevector(odd, odd, 0, 1, 2, 3));
}

template <int D>
[[gnu::always_inline]] inline void shift(Lanes* c, double x) {
  for (int i = 0; i < D; ++i) {
    for (int j = D - 1; j >= i; --j) c[j] += x * c[j + 1];
  }
}

// ---- the shifted differences and their magnitudes; the lanes that are usable

template <int D>
[[gnu::always_inline]] inline void subtract(const DifferenceRows<double>& rows, Lanes* v) {
  if constexpr (D == 3) {
    Lanes::Vector four[kLanes];
    for (std::size_t j = 0; j < kLanes; ++j) {
      four[j] = four_at(rows.to[j]).v - four_at(rows.from[j]).v;
    }
    transpose(four, v);
  } else {
    Two two[kLanes];
    for (std::size_t j = 0; j < kLanes; ++j) two[j] = two_at(rows.to[j]) - two_at(rows.from[j]);
    unzip(two, v[0], v[1]);
    if constexpr (D == 2) {
      v[2] = Lanes(rows.to[0][2] - rows.from[0][2], rows.to[1][2] - rows.from[1][2],
                   rows.to[2][2] - rows.from[2][2], rows.to[3][2] - rows.from[3][2]);
    }
  }
}

// Values are subtracted and errors added; both lie side by side in a row.
template <int D>
[[gnu::always_inline]] inline void subtract(const DifferenceRows<Ball>& rows, Lanes* v, Lanes* e) {
  static_assert(sizeof(Ball) == 2 * sizeof(double));
  for (int k = 0; k < D; k += 2) {
    Lanes::Vector four[kLanes];
    for (std::size_t j = 0; j < kLanes; ++j) {
      const Lanes::Vector to = four_at(&rows.to[j][k].value).v;
      const Lanes::Vector from = four_at(&rows.from[j][k].value).v;
      four[j] = __builtin_shufflevector(to - from, to + from, 0, 5, 2, 7);
    }
    Lanes out[kLanes];
    transpose(four, out);
    v[k] = out[0];
    e[k] = out[1];
    v[k + 1] = out[2];
    e[k + 1] = out[3];
  }
  if constexpr (D == 2) {
    Two two[kLanes];
    for (std::size_t j = 0; j < kLanes; ++j) {
      const Two to = two_at(&rows.to[j][2].value), from = two_at(&rows.from[j][2].value);
      two[j] = __builtin_shufflevector(to - from, to + from, 0, 3);
    }
    unzip(two, v[2], e[2]);
  }
}

template <int D>
[[gnu::always_inline]] inline LaneMask differences(const DifferenceRows<double>& rows, double x,
                                                   Lanes* c, Lanes* m) {
  subtract<D>(rows, c);
  const LaneMask usable = magnitude_of(c[D]) > Lanes(0.0);
  if (D > 1) shift<D>(c, x);
  for (int k = 0; k <= D; ++k) m[k] = magnitude_of(c[k]);
  return usable;
}

template <int D>
[[gnu::always_inline]] inline LaneMask differences(const DifferenceRows<Ball>& rows, double x,
                                                   Lanes* c, Lanes* m) {
  Lanes w[D + 1];
  subtract<D>(rows, c, w);
  for (int k = 0; k <= D; ++k) w[k] = w[k] + (2 * D + 1) * Ball::kUnit * magnitude_of(c[k]);
  const LaneMask lead = (magnitude_of(c[D]) > Lanes(0.0)) | (w[D] > Lanes(0.0));
  if (x != 0) {
    shift<D>(c, x);
    shift<D>(w, std::fabs(x));
  }
  const double inverse_gamma = (1 + 0x1p-40) / gamma(D);
  Lanes sum = 0.0;
  for (int k = 0; k <= D; ++k) {
    m[k] = magnitude_of(c[k]) + (w[k] * (1 + 0x1p-40) + Ball::kTiny) * inverse_gamma;
    sum += m[k];
  }
  return lead & (sum < Lanes(kInfinity));
}

// The entries of a span, in lanes.
[[gnu::always_inline]] inline Lanes of_lanes(bool alike, const std::array<double, kLanes>& of) {
  // Never by one load of all: they have just been stored one by one, and would have to arrive first.
  if (alike) return Lanes(of[0]);
  return Lanes(of[0], of[1], of[2], of[3]);
}

[[gnu::always_inline]] inline void keep_found(const LaneMask& found, const Lanes& lo,
                                              const Lanes& hi, double nothing,
                                              DifferenceLanes& out) {
  out.found = bits_of(found);
  const Lanes from = choose(found, lo, nothing), to = choose(found, hi, nothing);
  __builtin_memcpy(out.lo.data(), &from, sizeof(from));
  __builtin_memcpy(out.hi.data(), &to, sizeof(to));
}

// ---- degree 1: the root in closed form

// -c0 / c1 of exact numbers is off by half a unit in its last place.
[[gnu::always_inline]] inline LaneMask linear_root(const DifferenceRows<double>&, const Lanes* c,
                                                   const Lanes*, const DifferenceSpan&, Lanes& lo,
                                                   Lanes& hi) {
  const Lanes r = -c[0] / c[1];
  const Lanes error = magnitude_of(r) * 0x1.8p-52;
  lo = r - error;
  hi = r + error;
  return magnitude_of(c[1]) > Lanes(0.0);
}

// |r - root| <= (e0 + |r| e1) / (|c1| - e1) + u |r|.
[[gnu::always_inline]] inline LaneMask linear_root(const DifferenceRows<Ball>&, const Lanes* c,
                                                   const Lanes* m, const DifferenceSpan& span,
                                                   Lanes& lo, Lanes& hi) {
  const Lanes lead_error = m[1] * gamma(1);
  const Lanes r = -c[0] / c[1];
  const Lanes t = span.origin + r;
  const Lanes error = (m[0] + magnitude_of(r) * m[1]) * gamma(1) /
                          (magnitude_of(c[1]) - lead_error) * (1 + 0x1p-20) +
                      magnitude_of(r) * 0x1p-52 + magnitude_of(t) * 0x1p-51 + 0x1p-1000;
  lo = t - error;
  hi = t + error;
  return (magnitude_of(c[1]) > lead_error) & (m[0] <= Lanes(0x1p900)) & (m[1] <= Lanes(0x1p900)) &
         (m[1] >= Lanes(0x1p-300));
}

template <class Number>
[[gnu::always_inline]] inline void linear(const DifferenceRows<Number>& rows,
                                          const DifferenceSpan& span, DifferenceLanes& out) {
  Lanes c[2], m[2];
  const LaneMask usable = differences<1>(rows, span.shift, c, m);
  Lanes lo, hi;
  const LaneMask rooted = linear_root(rows, c, m, span, lo, hi) & usable;
  const LaneMask falls = rooted & (c[1] < Lanes(0.0)) & (lo > Lanes(span.now_hi));
  const LaneMask rises = rooted & (c[1] > Lanes(0.0)) & (hi < Lanes(span.now_lo));
  // Without another root, if now is one.
  const LaneMask late = lo > of_lanes(span.alike, span.horizon);
  const LaneMask clear = (usable & mask_of(span.root)) | rises | (falls & late);
  out.clear = bits_of(clear);
  keep_found(falls & ~clear, lo, hi, span.nothing, out);
  out.known = out.clear | out.found;
}

// ---- degrees 2 and 3: the first node

// FirstRoot::error_at; a lane is in range, or its bound is invalid.
template <int D>
[[gnu::always_inline]] inline Lanes error_at(const Lanes* m, const Lanes& bound, LaneMask& in_range) {
  Lanes v = m[D];
  for (int i = D - 1; i >= 0; --i) v = v * bound + m[i];
  in_range = (v >= Lanes(0x1p-300)) & (v <= Lanes(0x1p900)) &
             (bound <= Lanes(FirstRoot<D, true>::kTimeLimit));
  return gamma(D) * v;
}

[[gnu::always_inline]] inline Lanes value_at(const Lanes* c, const Lanes& t) {
  return (c[2] * t + c[1]) * t + c[0];
}

// FirstRoot::solve and the first attempt of its certify, which nearly always succeeds: the lanes in
// which they find the root, in [x, y].
[[gnu::always_inline]] inline LaneMask quadratic_root(const Lanes* c, const Lanes* m, double x,
                                                      const Lanes& y, double origin, Lanes& lo,
                                                      Lanes& hi) {
  const Lanes root = square_root_of(c[1] * c[1] - 4 * c[2] * c[0]);
  const LaneMask rises = c[1] > Lanes(0.0);
  const Lanes sum = choose(rises, -0.5 * (c[1] + root), 0.5 * (root - c[1]));
  const Lanes t = choose(rises, sum, c[0]) / choose(rises, c[2], sum);
  const Lanes size = magnitude_of(t);
  LaneMask in_range;
  const Lanes base = error_at<2>(m, size, in_range);
  const Lanes width = 2 * base / root + 0x1p-51 * magnitude_of(origin + t) + 0x1p-900;
  const Lanes error = base * (1 + 0x1p-10);
  lo = origin + (t - width);
  hi = origin + (t + width);
  const Lanes from = lo - origin, to = hi - origin;
  return in_range & (t > Lanes(x)) & (t < y) & (width < y - x) & (width <= 0x1p-21 * size) &
         (lo - from == Lanes(origin)) & (hi - to == Lanes(origin)) & (from >= Lanes(x)) & (to <= y) &
         (value_at(c, from) > error) & (value_at(c, to) < -error);
}

template <int D, class Number>
[[gnu::always_inline]] inline void nodes(const DifferenceRows<Number>& rows,
                                         const DifferenceSpan& span, DifferenceLanes& out) {
  Lanes c[D + 1], m[D + 1], b[D + 1];
  const LaneMask usable = differences<D>(rows, span.shift, c, m);
  const double x = span.now_hi - span.origin;
  for (int i = 0; i <= D; ++i) b[i] = c[i];
  if (x != 0) shift<D>(b, x);
  constexpr InverseBinomials<D> inverse;
  Lanes power = 1;
  const Lanes node = of_lanes(span.alike, span.length);
  for (int i = 1; i <= D; ++i) {
    power *= node;
    b[i] *= power * inverse.value[static_cast<std::size_t>(i)];
  }
  for (int k = 1; k <= D; ++k) {
    for (int i = D; i >= k; --i) b[i] += b[i - 1];
  }
  LaneMask in_range;
  const Lanes farthest = std::fabs(x) + node;
  const Lanes error = error_at<D>(m, farthest, in_range);
  // Between now.lo and now.hi the value moves by slope * width at most.
  const Lanes reach = larger(Lanes(std::fabs(span.now_lo - span.origin)), farthest);
  Lanes slope = D * m[D];
  for (int i = D - 1; i > 0; --i) slope = slope * reach + i * m[i];
  const Lanes moved = slope * (span.now_hi - span.now_lo) * (1 + 0x1p-20);
  const LaneMask known = usable & in_range & (mask_of(span.root) | (b[0] > error + moved));
  LaneMask clear = known;
  for (int i = 1; i <= D; ++i) clear = clear & (b[i] > error);
  out.known = bits_of(known);
  out.clear = bits_of(clear);
  if constexpr (D == 2) {
    // x + length may have been rounded up by half a unit: below it, by next_down of a positive number.
    const Lanes end = x + node;
    const LaneMask::Vector before = (LaneMask::Vector)end.v - 1;
    const LaneMask one = known & (b[2] < -error) & (end > Lanes(x)) & (end > Lanes(0.0));
    Lanes lo, hi;
    const LaneMask found =
        one & quadratic_root(c, m, x, Lanes((Lanes::Vector)before), span.origin, lo, hi);
    keep_found(found, lo, hi, span.nothing, out);
  } else {
    out.found = 0;
    out.lo.fill(span.nothing);
    out.hi.fill(span.nothing);
  }
  out.error = error;
  for (int i = 0; i <= D; ++i) {
    out.c[i] = c[i];
    out.m[i] = m[i];
    out.bernstein[i] = b[i];
  }
}

template <class Number>
[[gnu::always_inline]] inline void any(const DifferenceRows<Number>& rows, int degree,
                                       const DifferenceSpan& span, DifferenceLanes& out) {
  if (degree == 1) return linear(rows, span, out);
  if (degree == 2) return nodes<2>(rows, span, out);
  nodes<3>(rows, span, out);
}

template <class Number>
KINEX_FOR_AVX2 void avx2(const DifferenceRows<Number>& rows, int degree, const DifferenceSpan& span,
                         DifferenceLanes& out) {
  any(rows, degree, span, out);
}

template <int D>
Search continued(const DifferenceLanes& lanes, std::size_t lane, const DifferenceSpan& span,
                 Enclosure& out) {
  double c[D + 1], m[D + 1];
  std::array<double, D + 1> bernstein;
  for (std::size_t i = 0; i <= D; ++i) {
    c[i] = lanes.c[i][lane];
    m[i] = lanes.m[i][lane];
    bernstein[i] = lanes.bernstein[i][lane];
  }
  const FirstRoot<D, true> search(c, m, D, span.origin);
  return search.from_first_node(span.now_hi - span.origin, span.end[span.alike ? 0 : lane], bernstein,
                                lanes.error[lane], out);
}

}  // namespace

template <class Number>
void difference_lanes(const DifferenceRows<Number>& rows, int degree, const DifferenceSpan& span,
                      Vectors vectors, DifferenceLanes& out) {
  if (vectors == Vectors::kAvx2) return avx2(rows, degree, span, out);
  any(rows, degree, span, out);
}

template void difference_lanes(const DifferenceRows<double>&, int, const DifferenceSpan&, Vectors,
                               DifferenceLanes&);
template void difference_lanes(const DifferenceRows<Ball>&, int, const DifferenceSpan&, Vectors,
                               DifferenceLanes&);

Search from_first_node(const DifferenceLanes& lanes, std::size_t lane, int degree,
                       const DifferenceSpan& span, Enclosure& out) {
  return degree == 2 ? continued<2>(lanes, lane, span, out) : continued<3>(lanes, lane, span, out);
}

}  // namespace kinex::filter

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/first_root_lanes.h"

#include <algorithm>
#include <cmath>

namespace kinex::filter {
namespace {

// The steps of FirstRoot::expand, error_at and classify, and of ExactArithmetic::sign_over_now.
template <int D>
[[gnu::always_inline]] inline void nodes(const Lanes* c, const Lanes* m, const LaneSpan& span,
                                         LaneNodes& out) {
  const double x = span.hi;
  Lanes b[D + 1];
  for (int i = 0; i <= D; ++i) b[i] = c[i];
  if (x != 0) {
    for (int i = 0; i < D; ++i) {
      for (int j = D - 1; j >= i; --j) b[j] += x * b[j + 1];
    }
  }
  const Lanes value = b[0];  // at hi: the shift is Horner's scheme
  constexpr InverseBinomials<D> inverse;
  Lanes power = 1;
  for (int i = 1; i <= D; ++i) {
    power *= span.length;
    b[i] *= power * inverse.value[static_cast<std::size_t>(i)];
  }
  for (int k = 1; k <= D; ++k) {
    for (int i = D; i >= k; --i) b[i] += b[i - 1];
  }
  const Lanes reach = std::fabs(x) + span.length;
  const double bound = std::max(std::fabs(span.lo), std::fabs(span.hi));
  Lanes far = m[D], near = m[D], slope = D * m[D];
  for (int i = D - 1; i >= 0; --i) {
    far = far * reach + m[i];
    near = near * bound + m[i];
    if (i > 0) slope = slope * bound + i * m[i];
  }
  const Lanes least = 0x1p-300, most = 0x1p900;
  const Lanes error = gamma(D) * far;
  const Lanes now_error = gamma(D) * near + slope * span.width * (1 + 0x1p-20);
  const LaneMask bounded = (far >= least) & (far <= most) &
                           (reach <= Lanes(FirstRoot<D, true>::kTimeLimit)) & (near >= least) &
                           (near <= most) & (m[D] > Lanes(0.0));
  const LaneMask positive = bounded & (value > now_error);
  LaneMask clear = positive;
  for (int i = 1; i <= D; ++i) clear = clear & (b[i] > error);
  out.positive = positive;
  out.clear = clear;
  out.error = error;
  for (int i = 0; i <= D; ++i) out.bernstein[i] = b[i];
}

[[gnu::always_inline]] inline void any_nodes(const Lanes* c, const Lanes* m, int degree,
                                             const LaneSpan& span, LaneNodes& out) {
  if (degree == 4) return nodes<4>(c, m, span, out);
  if (degree == 8) return nodes<8>(c, m, span, out);
  nodes<12>(c, m, span, out);
}

KINEX_FOR_AVX2 void avx2_nodes(const Lanes* c, const Lanes* m, int degree, const LaneSpan& span,
                               LaneNodes& out) {
  any_nodes(c, m, degree, span, out);
}

template <int D>
Search continued(const LaneNodes& nodes, std::size_t lane, const Lanes* c, const Lanes* m,
                 double origin, double a, double end, Enclosure& out) {
  double one_c[D + 1], one_m[D + 1];
  std::array<double, D + 1> bernstein;
  for (std::size_t i = 0; i <= D; ++i) {
    one_c[i] = c[i][lane];
    one_m[i] = m[i][lane];
    bernstein[i] = nodes.bernstein[i][lane];
  }
  const FirstRoot<D, true> search(one_c, one_m, D, origin);
  return search.from_first_node(a, end, bernstein, nodes.error[lane], out);
}

}  // namespace

Search from_first_node(const LaneNodes& nodes, std::size_t lane, const Lanes* c, const Lanes* m,
                       int degree, double origin, double a, double end, Enclosure& out) {
  switch (degree) {
    case 4: return continued<4>(nodes, lane, c, m, origin, a, end, out);
    case 8: return continued<8>(nodes, lane, c, m, origin, a, end, out);
    default: return continued<12>(nodes, lane, c, m, origin, a, end, out);
  }
}

void first_nodes(const Lanes* c, const Lanes* m, int degree, const LaneSpan& span, Vectors vectors,
                 LaneNodes& out) {
  if (vectors == Vectors::kAvx2) return avx2_nodes(c, m, degree, span, out);
  any_nodes(c, m, degree, span, out);
}

}  // namespace kinex::filter

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/first_root.h"

namespace kinex::filter {

double root_bound(const double* c, const double* m, int degree) {
  const double infinity = std::numeric_limits<double>::infinity();
  // m_j = |c_j| + e_j / gamma, so e_j = gamma (m_j - |c_j|) up to rounding, covered by a factor 2.
  const double g = 2 * gamma(degree);
  const auto error = [&](int i) { return m == nullptr ? 0 : g * m[i]; };
  const double lead = std::fabs(c[degree]) - error(degree);
  if (!(lead > 0 && lead < infinity)) return infinity;
  int exponent = -1100;
  const int lead_exponent = std::ilogb(lead);
  for (int i = 0; i < degree; ++i) {
    const double magnitude = std::fabs(c[i]) + error(i);
    if (!(magnitude < infinity)) return infinity;
    if (magnitude == 0) continue;
    const int e = std::ilogb(magnitude) + 1 - lead_exponent;  // |c_i / c_d| < 2^e
    const int n = degree - i;
    exponent = std::max(exponent, e >= 0 ? (e + n - 1) / n : -((-e) / n));
  }
  if (exponent > 1000) return infinity;
  return std::ldexp(1.0, std::max(exponent + 1, -1000));
}

template <bool kCertify>
Search first_sign_change(const double* c, const double* m, int degree, double origin, double a,
                         double b, Enclosure& out) {
  constexpr Search give_up = kCertify ? Search::kUnknown : Search::kNone;
  if (!(b < std::numeric_limits<double>::infinity())) {
    b = root_bound(c, m, degree);
    if (!(b < std::numeric_limits<double>::infinity())) return give_up;
  }
  if (!(a < b)) return Search::kNone;
  switch (degree) {
    case 2: return FirstRoot<2, kCertify>(c, m, 2, origin)(a, b, out);
    case 3: return FirstRoot<3, kCertify>(c, m, 3, origin)(a, b, out);
    case 4: return FirstRoot<4, kCertify>(c, m, 4, origin)(a, b, out);
    case 5: return FirstRoot<5, kCertify>(c, m, 5, origin)(a, b, out);
    case 6: return FirstRoot<6, kCertify>(c, m, 6, origin)(a, b, out);
    case 8: return FirstRoot<8, kCertify>(c, m, 8, origin)(a, b, out);
    case 12: return FirstRoot<12, kCertify>(c, m, 12, origin)(a, b, out);
    default: break;
  }
  if (degree > kMaxFilterDegree) return give_up;
  return FirstRoot<-1, kCertify>(c, m, degree, origin)(a, b, out);
}

template Search first_sign_change<true>(const double*, const double*, int, double, double,
                                        double, Enclosure&);
template Search first_sign_change<false>(const double*, const double*, int, double, double,
                                         double, Enclosure&);

}  // namespace kinex::filter

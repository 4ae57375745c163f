// SPDX-License-Identifier: GPL-3.0-or-later
// strip_order_2(a, b, c, d, e, f) = N' D - N D', with N = ((b - a) x (c - a))^2, D = |b - a|^2 of
// the strip of a, b, c, and N', D' those of d, e, f.
// Degree 6 in the coordinates, 6d in t. Identities: predicates/points/edge_predicates.h.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/edge_predicates.h"

namespace kinex {
namespace {

struct StripOrder2 {
  static constexpr int kArity = 6;
  static constexpr int kDegree = 6;
  static constexpr int kAlternating = 0;
  static constexpr bool kAlternatesInHalves = true;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr std::array<ArgumentRole, 6> kRoles{{{"narrower strip, from"},
                                                       {"narrower strip, to"},
                                                       {"narrower strip, opposite"},
                                                       {"wider strip, from"},
                                                       {"wider strip, to"},
                                                       {"wider strip, opposite"}}};

  std::string_view name() const { return "order_strip"; }
  int dimension() const { return 2; }
  ClaimForm form() const {
    return {ClaimFigure::kNone,
            1,
            kRoles,
            "{2} is no farther from the line through {0} and {1} than {5} is from that through "
            "{3} and {4}",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return numerator(p, 3) * denominator(p, 0) - numerator(p, 0) * denominator(p, 3);
  }

 private:
  template <class Points>
  static auto numerator(const Points& p, int a) {
    const auto height = wide_product(p(a + 1, 0) - p(a, 0), p(a + 2, 1) - p(a, 1)) -
                        wide_product(p(a + 1, 1) - p(a, 1), p(a + 2, 0) - p(a, 0));
    return height * height;
  }
  template <class Points>
  static auto denominator(const Points& p, int a) {
    const auto x = p(a + 1, 0) - p(a, 0);
    const auto y = p(a + 1, 1) - p(a, 1);
    return wide_product(x, x) + wide_product(y, y);
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_strip_order_2() {
  return std::make_shared<FormulaPredicate<StripOrder2>>();
}

}  // namespace kinex

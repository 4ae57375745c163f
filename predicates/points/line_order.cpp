// SPDX-License-Identifier: GPL-3.0-or-later
// line_order(l, m, p) = (a_m - a_l) x_p + b_m - b_l.
// Degree 2 in the coordinates, 2d in t. Identities: predicates/points/line_predicates.h.
#include <array>
#include <string_view>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/line_predicates.h"

namespace kinex {
namespace {

struct LineOrder {
  static constexpr int kArity = 3;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 2;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr bool kHasUnit = true;
  static constexpr std::array<ArgumentRole, 3> kRoles{{{"lower"}, {"higher"}, {"point"}}};

  std::string_view name() const { return "line_order"; }
  int dimension() const { return 2; }
  int first_by_value() const { return 0; }
  ClaimForm form() const {
    return {ClaimFigure::kNone, 1, kRoles, "{1} is not below {0} at the x of {2}", {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return wide_product(p(1, 0) - p(0, 0), p(2, 0)) +
           wide_product(p(1, 1) - p(0, 1), p.unit());
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_line_order() {
  return std::make_shared<FormulaPredicate<LineOrder>>();
}

}  // namespace kinex

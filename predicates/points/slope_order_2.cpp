// SPDX-License-Identifier: GPL-3.0-or-later
// slope_order_2(a, b, c, d) = (b - a) x (d - c): the cross product of two directions.
// Degree 2 in the coordinates, 2d in t. Identities: predicates/predicates.h.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

struct SlopeOrder2 {
  static constexpr int kArity = 4;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 2;
  static constexpr bool kAlternatesInHalves = true;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"first, from"}, {"first, to"}, {"second, from"}, {"second, to"}}};

  std::string_view name() const { return "slope_order_2"; }
  int dimension() const { return 2; }
  ClaimForm form() const {
    return {ClaimFigure::kDirections,
            1,
            kRoles,
            "the direction from {2} to {3} does not turn right of that from {0} to {1}",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return wide_product(p(1, 0) - p(0, 0), p(3, 1) - p(2, 1)) -
           wide_product(p(1, 1) - p(0, 1), p(3, 0) - p(2, 0));
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_slope_order_2() {
  return std::make_shared<FormulaPredicate<SlopeOrder2>>();
}

}  // namespace kinex

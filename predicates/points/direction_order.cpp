// SPDX-License-Identifier: GPL-3.0-or-later
// direction_order(a, b) = v.(b - a) for a constant vector v, taken as the primitive integer vector
// of the same direction (a positive factor changes no sign and no root).
// Degree 1 in the coordinates, d in t. Identities: predicates/predicates.h.
#include <array>
#include <stdexcept>
#include <utility>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

struct DirectionOrder {
  static constexpr int kArity = 2;
  static constexpr int kDegree = 1;
  static constexpr int kAlternating = 2;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 2> kRoles{{{"before"}, {"after"}}};

  std::vector<FormulaConstant> direction;

  std::string_view name() const { return "order_direction"; }
  int dimension() const { return static_cast<int>(direction.size()); }
  ClaimForm form() const {
    ClaimForm form{ClaimFigure::kOrder, 1, kRoles, "{0} is not beyond {1} along the direction", {}};
    for (const FormulaConstant& v : direction) form.direction.push_back(v.in(Integer()));
    return form;
  }

  template <class Points>
  auto value(const Points& p) const {
    auto sum = scaled(p(1, 0) - p(0, 0), direction[0]);
    for (int axis = 1; axis < dimension(); ++axis) {
      sum = sum + scaled(p(1, axis) - p(0, axis), direction[static_cast<std::size_t>(axis)]);
    }
    return widen(sum);
  }
};

}  // namespace

std::vector<Integer> primitive_direction(const std::vector<Rational>& direction) {
  Integer denominator(1);
  bool zero = true;
  for (const Rational& v : direction) {
    denominator = lcm(denominator, v.denominator());
    zero = zero && v.is_zero();
  }
  if (zero) throw std::invalid_argument("the direction of an order must not be the zero vector");
  Integer common(0);
  std::vector<Integer> entries;
  for (const Rational& v : direction) {
    entries.push_back((v * Rational(denominator)).numerator());
    common = gcd(common, entries.back());
  }
  for (Integer& v : entries) v.divide_exactly(common);
  return entries;
}

std::shared_ptr<const Predicate> make_direction_order(const std::vector<Rational>& direction) {
  DirectionOrder formula;
  for (Integer& v : primitive_direction(direction)) formula.direction.emplace_back(std::move(v));
  return std::make_shared<FormulaPredicate<DirectionOrder>>(std::move(formula));
}

}  // namespace kinex

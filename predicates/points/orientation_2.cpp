// SPDX-License-Identifier: GPL-3.0-or-later
// orientation_2(a, b, c) = (b - a) x (c - a): twice the signed area of the triangle.
// Degree 2 in the coordinates, 2d in t. Identities: predicates/predicates.h.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "core/arithmetic/touch.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

struct Orientation2 {
  static constexpr int kArity = 3;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 3;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 3> kRoles{{{"from"}, {"to"}, {"left of it"}}};

  std::string_view name() const { return "orientation_2"; }
  int dimension() const { return 2; }
  ClaimForm form() const {
    return {
        ClaimFigure::kTurn, 1, kRoles, "{2} is not to the right of the line from {0} to {1}", {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto ax = p(0, 0);
    const auto ay = p(0, 1);
    return wide_product(p(1, 0) - ax, p(2, 1) - ay) - wide_product(p(1, 1) - ay, p(2, 0) - ax);
  }
};

class TouchingOrientation2 final : public FormulaPredicate<Orientation2>, public FailsAtTouch {};

}  // namespace

std::shared_ptr<const Predicate> make_orientation_2() {
  return std::make_shared<FormulaPredicate<Orientation2>>();
}

std::shared_ptr<const Predicate> make_orientation_2_touch() {
  return std::make_shared<TouchingOrientation2>();
}

}  // namespace kinex

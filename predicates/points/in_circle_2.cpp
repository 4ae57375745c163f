// SPDX-License-Identifier: GPL-3.0-or-later
// in_circle_2(a, b, c, d): the determinant with rows (x, y, x^2 + y^2) of a - d, b - d, c - d:
// positive iff d lies strictly inside the circle through a, b, c taken counter-clockwise.
// Degree 4 in the coordinates, 4d in t. Identities: predicates/predicates.h.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

struct InCircle2 {
  static constexpr int kArity = 4;
  static constexpr int kDegree = 4;
  static constexpr int kAlternating = 4;
  static constexpr int kReference = 3;
  static constexpr bool kOnlyToReference = true;
  static constexpr bool kInGroups = true;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"circle, first"}, {"circle, second"}, {"circle, third"}, {"not inside"}}};

  std::string_view name() const { return "in_circle_2"; }
  int dimension() const { return 2; }
  ClaimForm form() const {
    return {ClaimFigure::kCircle,
            1,
            kRoles,
            "{3} is not inside the circle through {0}, {1} and {2}, which are clockwise",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto dx = p(3, 0);
    const auto dy = p(3, 1);
    const auto ax = p(0, 0) - dx;
    const auto ay = p(0, 1) - dy;
    const auto bx = p(1, 0) - dx;
    const auto by = p(1, 1) - dy;
    const auto cx = p(2, 0) - dx;
    const auto cy = p(2, 1) - dy;
    return wide_product(ax * ax + ay * ay, bx * cy - by * cx) +
           wide_product(bx * bx + by * by, cx * ay - cy * ax) +
           wide_product(cx * cx + cy * cy, ax * by - ay * bx);
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_in_circle_2() {
  return std::make_shared<FormulaPredicate<InCircle2>>();
}

}  // namespace kinex

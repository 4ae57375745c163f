// SPDX-License-Identifier: GPL-3.0-or-later
// in_circle_lifted(a, b, c, e): projected_determinant (lifted_determinant.h) with the squares of lengths for
// heights. Degree 4 in the coordinates, 4d in t. Identities: space_predicates.h.
#include <array>
#include <stdexcept>

#include "core/arithmetic/predicate_formula.h"
#include "core/arithmetic/touch.h"
#include "predicates/points/lifted_determinant.h"
#include "predicates/points/space_predicates.h"

namespace kinex {
namespace {

struct InCircleLifted {
  static constexpr int kArity = 4;
  static constexpr int kDegree = 4;
  static constexpr int kAlternating = 4;
  static constexpr int kReference = 3;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"circle, first"}, {"circle, second"}, {"circle, third"}, {"not inside"}}};

  int u = 0, v = 1;  // the axes

  std::string_view name() const {
    return v == 1 ? "in_circle_xy" : u == 0 ? "in_circle_xz" : "in_circle_yz";
  }
  int dimension() const { return 3; }
  // No figure of the plane shows it.
  ClaimForm form() const {
    return {ClaimFigure::kNone,
            1,
            kRoles,
            "{3} is not inside the circle through {0}, {1} and {2} of its plane, which are clockwise in "
            "projection on two axes",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return projected_determinant(p, u, v, [](const auto& squares, int) { return squares; });
  }
};

class TouchingInCircleLifted final : public FormulaPredicate<InCircleLifted>, public FailsAtTouch {
 public:
  using FormulaPredicate<InCircleLifted>::FormulaPredicate;
};

InCircleLifted circle_on_axes(int first, int second) {
  if (first < 0 || second <= first || second > 2) {
    throw std::invalid_argument("a projection needs two axes of space");
  }
  return {first, second};
}

}  // namespace

std::shared_ptr<const Predicate> make_in_circle_lifted(int first, int second) {
  return std::make_shared<FormulaPredicate<InCircleLifted>>(circle_on_axes(first, second));
}

std::shared_ptr<const Predicate> make_in_circle_lifted_touch(int first, int second) {
  return std::make_shared<TouchingInCircleLifted>(circle_on_axes(first, second));
}

}  // namespace kinex

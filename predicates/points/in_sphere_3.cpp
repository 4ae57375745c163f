// SPDX-License-Identifier: GPL-3.0-or-later
// in_sphere_3(a, b, c, d, e): the negated determinant with rows (x, y, z, x^2 + y^2 + z^2) of a - e,
// b - e, c - e, d - e: positive iff e lies strictly inside the sphere through a, b, c, d, taken with
// orientation_3 > 0. Degree 5 in the coordinates, 5d in t. Identities: space_predicates.h.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "core/arithmetic/touch.h"
#include "predicates/points/lifted_determinant.h"
#include "predicates/points/space_predicates.h"

namespace kinex {
namespace {

struct InSphere3 {
  static constexpr int kArity = 5;
  static constexpr int kDegree = 5;
  static constexpr int kAlternating = 5;
  static constexpr int kReference = 4;
  static constexpr bool kOnlyToReference = true;
  static constexpr bool kInGroups = true;
  static constexpr std::array<ArgumentRole, 5> kRoles{{{"sphere, first"},
                                                       {"sphere, second"},
                                                       {"sphere, third"},
                                                       {"sphere, fourth"},
                                                       {"not inside"}}};

  std::string_view name() const { return "in_sphere_3"; }
  int dimension() const { return 3; }
  ClaimForm form() const {
    return {
        ClaimFigure::kCircle,
        1,
        kRoles,
        "{4} is not inside the sphere through {0}, {1}, {2} and {3}, whose orientation is negative",
        {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return lifted_determinant_3(p, [](const auto& x, const auto& y, const auto& z, int) {
      return x * x + y * y + z * z;
    });
  }
};

class TouchingInSphere3 final : public FormulaPredicate<InSphere3>, public FailsAtTouch {};

}  // namespace

std::shared_ptr<const Predicate> make_in_sphere_3() {
  return std::make_shared<FormulaPredicate<InSphere3>>();
}

std::shared_ptr<const Predicate> make_in_sphere_3_touch() {
  return std::make_shared<TouchingInSphere3>();
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// obtuse_angle_3(a, b, c) = (a - b) . (b - c). Degree 2 in the coordinates, 2d in t. Identities:
// space_predicates.h.
#include <array>
#include <cstdint>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/space_predicates.h"

namespace kinex {
namespace {

struct ObtuseAngle3 {
  static constexpr int kArity = 3;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 1;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 3> kRoles{{{"one side"}, {"corner"}, {"other side"}}};
  static constexpr std::array<std::uint8_t, 4> kPlaces{1, 0, 1, 2};

  std::string_view name() const { return "obtuse_angle_3"; }
  int dimension() const { return 3; }
  ClaimForm form() const {
    return {ClaimFigure::kAngle, -1,      kRoles, "the angle at {1} between {0} and {2} is not acute",
            {},                  kPlaces};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto bx = p(1, 0), by = p(1, 1), bz = p(1, 2);
    return wide_product(p(0, 0) - bx, bx - p(2, 0)) + wide_product(p(0, 1) - by, by - p(2, 1)) +
           wide_product(p(0, 2) - bz, bz - p(2, 2));
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_obtuse_angle_3() {
  return std::make_shared<FormulaPredicate<ObtuseAngle3>>();
}

}  // namespace kinex

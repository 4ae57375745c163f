// SPDX-License-Identifier: GPL-3.0-or-later
// orientation_3(a, b, c, d) = det(b - a, c - a, d - a): six times the signed volume of the
// tetrahedron. Degree 3 in the coordinates, 3d in t. Identities: space_predicates.h.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "core/arithmetic/touch.h"
#include "predicates/points/space_predicates.h"

namespace kinex {
namespace {

struct Orientation3 {
  static constexpr int kArity = 4;
  static constexpr int kDegree = 3;
  static constexpr int kAlternating = 4;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"plane, first"}, {"plane, second"}, {"plane, third"}, {"on its side"}}};

  std::string_view name() const { return "orientation_3"; }
  int dimension() const { return 3; }
  ClaimForm form() const {
    return {ClaimFigure::kTurn,
            1,
            kRoles,
            "{3} is not on the side of the plane through {0}, {1} and {2} from which they are "
            "counter-clockwise",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto ax = p(0, 0), ay = p(0, 1), az = p(0, 2);
    const auto bx = p(1, 0) - ax, by = p(1, 1) - ay, bz = p(1, 2) - az;
    const auto cx = p(2, 0) - ax, cy = p(2, 1) - ay, cz = p(2, 2) - az;
    const auto dx = p(3, 0) - ax, dy = p(3, 1) - ay, dz = p(3, 2) - az;
    return wide_product(bx * cy - by * cx, dz) + wide_product(cx * dy - cy * dx, bz) +
           wide_product(dx * by - dy * bx, cz);
  }
};

class TouchingOrientation3 final : public FormulaPredicate<Orientation3>, public FailsAtTouch {};

}  // namespace

std::shared_ptr<const Predicate> make_orientation_3() {
  return std::make_shared<FormulaPredicate<Orientation3>>();
}

std::shared_ptr<const Predicate> make_orientation_3_touch() {
  return std::make_shared<TouchingOrientation3>();
}

}  // namespace kinex

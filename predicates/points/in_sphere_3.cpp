// SPDX-License-Identifier: GPL-3.0-or-later
// in_sphere_3(a, b, c, d, e): the negated determinant with rows (x, y, z, x^2 + y^2 + z^2) of a - e,
// b - e, c - e, d - e: positive iff e lies strictly inside the sphere through a, b, c, d, taken with
// orientation_3 > 0. Degree 5 in the coordinates, 5d in t. Identities: space_predicates.h.
//
// By Laplace's expansion along the columns (x, y) and (z, square): six products of a minor of two
// rows with the complementary minor of the other two. A minor is narrow, a product is wide.
#include <array>

#include "core/arithmetic/predicate_formula.h"
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
    const auto ex = p(4, 0), ey = p(4, 1), ez = p(4, 2);
    const auto ax = p(0, 0) - ex, ay = p(0, 1) - ey, az = p(0, 2) - ez;
    const auto bx = p(1, 0) - ex, by = p(1, 1) - ey, bz = p(1, 2) - ez;
    const auto cx = p(2, 0) - ex, cy = p(2, 1) - ey, cz = p(2, 2) - ez;
    const auto dx = p(3, 0) - ex, dy = p(3, 1) - ey, dz = p(3, 2) - ez;
    const auto as = ax * ax + ay * ay + az * az, bs = bx * bx + by * by + bz * bz;
    const auto cs = cx * cx + cy * cy + cz * cz, ds = dx * dx + dy * dy + dz * dz;
    return wide_product(ax * by - ay * bx, cs * dz - ds * cz) +
           wide_product(bx * cy - by * cx, as * dz - ds * az) +
           wide_product(cx * dy - cy * dx, as * bz - bs * az) +
           wide_product(dx * ay - dy * ax, cs * bz - bs * cz) +
           wide_product(ax * cy - ay * cx, ds * bz - bs * dz) +
           wide_product(bx * dy - by * dx, cs * az - as * cz);
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_in_sphere_3() {
  return std::make_shared<FormulaPredicate<InSphere3>>();
}

}  // namespace kinex

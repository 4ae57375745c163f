// SPDX-License-Identifier: GPL-3.0-or-later
// unfolded_3(p, u, v, q) = ((v - u) x (p - u)) . ((v - u) x (u - q)): positive iff the half-planes of p and
// of q at the line u v make an obtuse angle. Degree 4 in the coordinates, 4d in t. Identities:
// space_predicates.h.
//
// With e = v - u, P = p - u and Q = q - u by Lagrange's identity: (e.P)(e.Q) - (e.e)(P.Q).
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/space_predicates.h"

namespace kinex {
namespace {

struct Unfolded3 {
  static constexpr int kArity = 4;
  static constexpr int kDegree = 4;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 1;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"one side"}, {"edge, from"}, {"edge, to"}, {"other side"}}};

  std::string_view name() const { return "unfolded_3"; }
  int dimension() const { return 3; }
  ClaimForm form() const {
    return {ClaimFigure::kTurn,
            1,
            kRoles,
            "the angle at the line through {1} and {2} between {0} and {3} is not acute",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto ux = p(1, 0), uy = p(1, 1), uz = p(1, 2);
    const auto ex = p(2, 0) - ux, ey = p(2, 1) - uy, ez = p(2, 2) - uz;
    const auto px = p(0, 0) - ux, py = p(0, 1) - uy, pz = p(0, 2) - uz;
    const auto qx = p(3, 0) - ux, qy = p(3, 1) - uy, qz = p(3, 2) - uz;
    return wide_product(ex * px + ey * py + ez * pz, ex * qx + ey * qy + ez * qz) -
           wide_product(ex * ex + ey * ey + ez * ez, px * qx + py * qy + pz * qz);
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_unfolded_3() {
  return std::make_shared<FormulaPredicate<Unfolded3>>();
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// in_circle_lifted(a, b, c, e): the determinant with rows (u, v, 2 u^2 + 2 v^2 + 2 w^2 - s w) of a - e, b - e,
// c - e, for two axes u, v of space and the third one w; s is the sum of w over the three rows. Of points of
// one plane w is a linear combination of u and v, and s w changes nothing. Of others it makes the determinant
// alternate in e, too, as it does when e is not taken away: there s is the sum over all four points. Degree 4
// in the coordinates, 4d in t. Identities: space_predicates.h.
#include <array>
#include <stdexcept>

#include "core/arithmetic/predicate_formula.h"
#include "core/arithmetic/touch.h"
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
    const int w = 3 - u - v;
    const auto eu = p(3, u), ev = p(3, v), ew = p(3, w);
    const auto au = p(0, u) - eu, av = p(0, v) - ev, aw = p(0, w) - ew;
    const auto bu = p(1, u) - eu, bv = p(1, v) - ev, bw = p(1, w) - ew;
    const auto cu = p(2, u) - eu, cv = p(2, v) - ev, cw = p(2, w) - ew;
    const auto as = aw - bw - cw, bs = bw - cw - aw, cs = cw - aw - bw;  // 2 w - s
    return wide_product(au * au + av * av + au * au + av * av + aw * as, bu * cv - bv * cu) +
           wide_product(bu * bu + bv * bv + bu * bu + bv * bv + bw * bs, cu * av - cv * au) +
           wide_product(cu * cu + cv * cv + cu * cu + cv * cv + cw * cs, au * bv - av * bu);
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

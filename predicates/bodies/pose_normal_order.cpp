// SPDX-License-Identifier: GPL-3.0-or-later
// normal_order(pose, (m, .) of A, (g, .) of B') = (W g) x m = c (g x m) - s (g.m).
// Degree 1 in the pose and in each line. Identities: predicates/bodies/pose_2.h.
#include "predicates/bodies/pose_form.h"

namespace kinex {
namespace {

struct NormalOrder {
  static constexpr int kArity = 3;
  static constexpr std::array<int, 2> kAxes{5, 6};
  static constexpr std::array<ArgumentRole, 3> kRoles{
      {{"pose", ArgumentRole::Kind::kPose},
       {"line of the first", ArgumentRole::Kind::kFrameLine, 0},
       {"line of the second", ArgumentRole::Kind::kFrameLine, 1}}};
  bool reversed;

  std::string_view name() const { return reversed ? "normal_order_reversed" : "normal_order"; }
  ClaimForm form() const {
    return {ClaimFigure::kNormals,
            reversed ? -1 : 1,
            kRoles,
            reversed ? "the normal of {1} is not counter-clockwise of that of {2}"
                     : "the normal of {1} is not clockwise of that of {2}",
            {}};
  }
  std::string_view opposite() const { return reversed ? "normal_order" : "normal_order_reversed"; }

  template <class R>
  std::array<R, 2> factors(const Constant<R>* constants) const {
    const Constant<R>& m = constants[0];
    const Constant<R>& g = constants[1];
    const R cross = g[0] * m[1] - g[1] * m[0];
    const R dot = g[0] * m[0] + g[1] * m[1];
    if (!reversed) return {cross, minus(dot)};
    return {minus(cross), dot};
  }
};

struct OrderTouch : NormalOrder {
  static constexpr bool kFailsAtTouch = true;
  std::string_view opposite() const = delete;
};

}  // namespace

std::shared_ptr<const Predicate> make_pose_order_touch(bool reversed) {
  return make_pose_form(OrderTouch{{reversed}});
}

std::shared_ptr<const Predicate> make_pose_normal_order(bool reversed) {
  return make_pose_form(NormalOrder{reversed});
}

}  // namespace kinex

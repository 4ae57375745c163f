// SPDX-License-Identifier: GPL-3.0-or-later
// left_of_ray(pose, a0, b0, a, b) = N (v - c) x (t - c), c = a0 + R b0, v = a + R b, times the
// weights of all four points. With u = a - a0 and w = b - b0 this is N times
//   u x t + w x R^T t - a x a0 - b x b0 - u x R b0 - R w x a0,
// as turning both factors of a product by R changes nothing.
// Degree 1 in the pose and in each point. Identities: predicates/bodies/pose_2.h.
#include "predicates/bodies/pose_form.h"

namespace kinex {
namespace {

struct Ray {
  static constexpr int kArity = 5;
  static constexpr std::array<int, 7> kAxes{0, 1, 2, 3, 4, 5, 6};
  static constexpr std::array<ArgumentRole, 5> kRoles{
      {{"pose", ArgumentRole::Kind::kPose},
       {"origin, of the first", ArgumentRole::Kind::kFramePoint, 0},
       {"origin, of the second", ArgumentRole::Kind::kFramePoint, 1},
       {"through, of the first", ArgumentRole::Kind::kFramePoint, 0},
       {"through, of the second", ArgumentRole::Kind::kFramePoint, 1}}};
  bool right;

  std::string_view name() const { return right ? "right_of_ray" : "left_of_ray"; }
  ClaimForm form() const {
    return {ClaimFigure::kRay,
            right ? -1 : 1,
            kRoles,
            right ? "the second body, seen from the first, is not to the left of the ray from {1} "
                    "+ {2} through {3} + {4}"
                  : "the second body, seen from the first, is not to the right of the ray from {1} "
                    "+ {2} through {3} + {4}",
            {}};
  }
  std::string_view opposite() const { return right ? "left_of_ray" : "right_of_ray"; }

  template <class R>
  std::array<R, 7> factors(const Constant<R>* constants) const {
    const Constant<R>&a0 = constants[0], &b0 = constants[1], &a = constants[2], &b = constants[3];
    // u and w, times the weights of their points
    const R ux = a0[2] * a[0] - a[2] * a0[0], uy = a0[2] * a[1] - a[2] * a0[1];
    const R wx = b0[2] * b[0] - b[2] * b0[0], wy = b0[2] * b[1] - b[2] * b0[1];
    const R of_a = a0[2] * a[2], of_b = b0[2] * b[2];
    std::array<R, 7> all{
        minus(of_b * uy),
        of_b * ux,
        minus(of_a * wy),
        of_a * wx,
        minus(of_b * (a[0] * a0[1] - a[1] * a0[0]) + of_a * (b[0] * b0[1] - b[1] * b0[0])),
        minus(b[2] * (ux * b0[1] - uy * b0[0]) + a[2] * (wx * a0[1] - wy * a0[0])),
        a[2] * (wx * a0[0] + wy * a0[1]) - b[2] * (ux * b0[0] + uy * b0[1])};
    if (right) {
      for (R& factor : all) factor = minus(factor);
    }
    return all;
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_pose_ray(bool right) { return make_pose_form(Ray{right}); }

}  // namespace kinex

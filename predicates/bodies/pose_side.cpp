// SPDX-License-Identifier: GPL-3.0-or-later
// side_a(pose, (m, h) of A, b of B') = N m.(t - R b) - N h, times the weight of b.
// side_b(pose, (g, h) of B', a of A) = N (R g).(t - a) - N h, times the weight of a.
// Degree 1 in the pose and in each constant. Identities: predicates/bodies/pose_2.h.
#include "predicates/bodies/pose_form.h"

namespace kinex {
namespace {

constexpr std::array<ArgumentRole, 3> kLineOfFirst{
    {{"pose", ArgumentRole::Kind::kPose},
     {"line of the first", ArgumentRole::Kind::kFrameLine, 0},
     {"point of the second", ArgumentRole::Kind::kFramePoint, 1}}};
constexpr std::array<ArgumentRole, 3> kLineOfSecond{
    {{"pose", ArgumentRole::Kind::kPose},
     {"line of the second", ArgumentRole::Kind::kFrameLine, 1},
     {"point of the first", ArgumentRole::Kind::kFramePoint, 0}}};

ClaimForm half_plane(std::span<const ArgumentRole> roles, bool inward) {
  return {ClaimFigure::kHalfPlane,
          inward ? -1 : 1,
          roles,
          inward ? "the second body, seen from the first, is not beyond the line {1} moved by {2}"
                 : "the second body, seen from the first, is not within the line {1} moved by {2}",
          {}};
}

struct SideA {
  static constexpr int kArity = 3;
  static constexpr std::array<int, 5> kAxes{0, 1, 4, 5, 6};
  bool inward;

  std::string_view name() const { return inward ? "inside_a" : "side_a"; }
  ClaimForm form() const { return half_plane(kLineOfFirst, inward); }
  std::string_view opposite() const { return inward ? "side_a" : "inside_a"; }

  // N t.m - N h - (c (m.b) + s (b x m))
  template <class R>
  std::array<R, 5> factors(const Constant<R>* constants) const {
    const Constant<R>& m = constants[0];
    const Constant<R>& b = constants[1];
    const R dot = m[0] * b[0] + m[1] * b[1];
    const R cross = b[0] * m[1] - b[1] * m[0];
    if (!inward) return {b[2] * m[0], b[2] * m[1], minus(b[2] * m[2]), minus(dot), minus(cross)};
    return {minus(b[2] * m[0]), minus(b[2] * m[1]), b[2] * m[2], dot, cross};
  }
};

struct SideB {
  static constexpr int kArity = 3;
  static constexpr std::array<int, 5> kAxes{2, 3, 4, 5, 6};
  bool inward;

  std::string_view name() const { return inward ? "inside_b" : "side_b"; }
  ClaimForm form() const { return half_plane(kLineOfSecond, inward); }
  std::string_view opposite() const { return inward ? "side_b" : "inside_b"; }

  // N R^T t.g - N h - (c (g.a) + s (g x a))
  template <class R>
  std::array<R, 5> factors(const Constant<R>* constants) const {
    const Constant<R>& g = constants[0];
    const Constant<R>& a = constants[1];
    const R dot = g[0] * a[0] + g[1] * a[1];
    const R cross = g[0] * a[1] - g[1] * a[0];
    if (!inward) return {a[2] * g[0], a[2] * g[1], minus(a[2] * g[2]), minus(dot), minus(cross)};
    return {minus(a[2] * g[0]), minus(a[2] * g[1]), a[2] * g[2], dot, cross};
  }
};

struct TouchA : SideA {
  static constexpr bool kFailsAtTouch = true;
  std::string_view opposite() const = delete;
};
struct TouchB : SideB {
  static constexpr bool kFailsAtTouch = true;
  std::string_view opposite() const = delete;
};

}  // namespace

std::shared_ptr<const Predicate> make_pose_touch(Frame frame, bool inward) {
  if (frame == Frame::kA) return make_pose_form(TouchA{{inward}});
  return make_pose_form(TouchB{{inward}});
}

std::shared_ptr<const Predicate> make_pose_side(Frame frame, bool inward) {
  if (frame == Frame::kA) return make_pose_form(SideA{inward});
  return make_pose_form(SideB{inward});
}

}  // namespace kinex

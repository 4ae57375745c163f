// SPDX-License-Identifier: GPL-3.0-or-later
// along_a(pose, (m, h) of A, a, b)  = N e.(t - a - R b),     e = m turned by +90 degrees,
// along_b(pose, (g, h) of B', a, b) = N (R e).(t - a - R b), e = g turned by +90 degrees,
// both times the weights of a and b.
// Degree 1 in the pose and in each constant. Identities: predicates/bodies/pose_2.h.
#include "predicates/bodies/pose_form.h"

namespace kinex {
namespace {

constexpr std::array<ArgumentRole, 4> kLineOfFirst{
    {{"pose", ArgumentRole::Kind::kPose},
     {"line of the first", ArgumentRole::Kind::kFrameLine, 0},
     {"point of the first", ArgumentRole::Kind::kFramePoint, 0},
     {"point of the second", ArgumentRole::Kind::kFramePoint, 1}}};
constexpr std::array<ArgumentRole, 4> kLineOfSecond{
    {{"pose", ArgumentRole::Kind::kPose},
     {"line of the second", ArgumentRole::Kind::kFrameLine, 1},
     {"point of the first", ArgumentRole::Kind::kFramePoint, 0},
     {"point of the second", ArgumentRole::Kind::kFramePoint, 1}}};

ClaimForm along_line(bool of_first, bool reversed) {
  return {
      ClaimFigure::kAlong,
      reversed ? -1 : 1,
      of_first ? kLineOfFirst : kLineOfSecond,
      reversed
          ? "the second body, seen from the first, is not beyond {2} + {3} along the line {1}"
          : "the second body, seen from the first, is not short of {2} + {3} along the line {1}",
      {}};
}

struct AlongA {
  static constexpr bool kOfA = true;
  static constexpr int kArity = 4;
  static constexpr std::array<int, 5> kAxes{0, 1, 4, 5, 6};

  std::string_view name() const { return "along_a"; }
  ClaimForm form() const { return along_line(true, false); }

  template <class R>
  std::array<R, 5> factors(const Constant<R>* constants) const {
    const Constant<R>& m = constants[0];
    const Constant<R>& a = constants[1];
    const Constant<R>& b = constants[2];
    const R ex = minus(m[1]);
    const R& ey = m[0];
    const R weight = a[2] * b[2];
    return {weight * ex, weight * ey, minus(b[2] * (ex * a[0] + ey * a[1])),
            minus(a[2] * (ex * b[0] + ey * b[1])), minus(a[2] * (b[0] * ey - b[1] * ex))};
  }
};

struct AlongB {
  static constexpr bool kOfA = false;
  static constexpr int kArity = 4;
  static constexpr std::array<int, 5> kAxes{2, 3, 4, 5, 6};

  std::string_view name() const { return "along_b"; }
  ClaimForm form() const { return along_line(false, false); }

  template <class R>
  std::array<R, 5> factors(const Constant<R>* constants) const {
    const Constant<R>& g = constants[0];
    const Constant<R>& a = constants[1];
    const Constant<R>& b = constants[2];
    const R ex = minus(g[1]);
    const R& ey = g[0];
    const R weight = a[2] * b[2];
    return {weight * ex, weight * ey, minus(a[2] * (ex * b[0] + ey * b[1])),
            minus(b[2] * (ex * a[0] + ey * a[1])), minus(b[2] * (ex * a[1] - ey * a[0]))};
  }
};

template <class Along>
struct AlongTouch : Along {
  static constexpr bool kFailsAtTouch = true;
  bool reversed;

  explicit AlongTouch(bool is_reversed) : reversed(is_reversed) {}
  std::string_view name() const {
    if (!reversed) return Along::name();
    return Along::kOfA ? "against_a" : "against_b";
  }
  ClaimForm form() const { return along_line(Along::kOfA, reversed); }

  template <class R>
  std::array<R, 5> factors(const Constant<R>* constants) const {
    std::array<R, 5> all = Along::factors(constants);
    if (reversed) {
      for (R& factor : all) factor = minus(factor);
    }
    return all;
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_pose_along_touch(Frame frame, bool reversed) {
  if (frame == Frame::kA) return make_pose_form(AlongTouch<AlongA>(reversed));
  return make_pose_form(AlongTouch<AlongB>(reversed));
}

std::shared_ptr<const Predicate> make_pose_along(Frame frame) {
  if (frame == Frame::kA) return make_pose_form(AlongA{});
  return make_pose_form(AlongB{});
}

}  // namespace kinex

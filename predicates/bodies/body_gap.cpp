// SPDX-License-Identifier: GPL-3.0-or-later
// discs_apart(a, b, reach) = (x_b - x_a)^2 + (y_b - y_a)^2 - reach^2  homogeneous of degree 2
// x_gap(a, b, reach)       = x_b - x_a - reach                        homogeneous of degree 1
// x_beyond(a, line)        = x_a - line                               homogeneous of degree 1
// Identities: predicates/bodies/body_gap.h.
#include "predicates/bodies/body_gap.h"

#include <algorithm>
#include <array>
#include <vector>

#include "predicates/bodies/wide_predicate.h"

namespace kinex {
namespace {

template <class R>
const R* axis_of(const MotionView<R>* points, int i, int axis, std::size_t powers) {
  return points[i] + static_cast<std::size_t>(axis) * powers;
}

constexpr std::array<ArgumentRole, 3> kTwoBodies{{{"first", ArgumentRole::Kind::kBody},
                                                  {"second", ArgumentRole::Kind::kBody},
                                                  {"reach", ArgumentRole::Kind::kNumber}}};
constexpr std::array<ArgumentRole, 2> kBodyAndMark{
    {{"body", ArgumentRole::Kind::kBody}, {"coordinate", ArgumentRole::Kind::kNumber}}};

std::vector<Integer> unit(int axis) {
  std::vector<Integer> direction(static_cast<std::size_t>(axis) + 1);
  direction.back() = Integer(1);
  return direction;
}

struct DiscsApart {
  static constexpr int kArity = 3;
  static constexpr int kHomogeneity = 2;
  static constexpr int kDimension = 2;
  bool negated;

  std::string_view name() const { return negated ? "discs_overlap" : "discs_apart"; }
  std::string_view opposite() const { return negated ? "discs_apart" : "discs_overlap"; }
  ClaimForm form() const {
    return {ClaimFigure::kDiscs,
            negated ? -1 : 1,
            kTwoBodies,
            negated ? "the origins of {0} and {1} are at most {2} apart"
                    : "the origins of {0} and {1} are at least {2} apart",
            {}};
  }
  int degree(int motion_degree) const { return 2 * motion_degree; }

  template <class R>
  void value(int d, const MotionView<R>* points, R* out, const R& zero) const {
    const std::size_t powers = static_cast<std::size_t>(d) + 1;
    for (std::size_t k = 0; k < 2 * powers - 1; ++k) out[k] = zero;
    std::vector<R> difference(powers, zero);
    for (int axis = 0; axis < 2; ++axis) {
      const R* a = axis_of<R>(points, 0, axis, powers);
      const R* b = axis_of<R>(points, 1, axis, powers);
      for (R& coefficient : difference) coefficient = zero;
      std::size_t used = 0;
      for (std::size_t k = 0; k < powers; ++k) {
        if (is_exactly_zero(a[k]) && is_exactly_zero(b[k])) continue;
        difference[k] = negated ? a[k] - b[k] : b[k] - a[k];
        used = k + 1;
      }
      for (std::size_t i = 0; i < used; ++i) {
        for (std::size_t j = 0; j < used; ++j) {
          const R product = difference[i] * difference[j];
          if (negated) {
            out[i + j] -= product;
          } else {
            out[i + j] += product;
          }
        }
      }
      std::fill_n(difference.begin(), used, zero);
    }
    const R& reach = points[2][0];
    if (negated) {
      out[0] += reach * reach;
    } else {
      out[0] -= reach * reach;
    }
  }
};

struct AxisGap {
  static constexpr int kArity = 3;
  static constexpr int kHomogeneity = 1;
  static constexpr int kDimension = 2;
  int axis;

  std::string_view name() const { return axis == 0 ? "x_gap" : "y_gap"; }
  ClaimForm form() const {
    return {ClaimFigure::kGap, 1, kTwoBodies,
            "on the axis the origin of {1} is beyond that of {0} by at least {2}", unit(axis)};
  }
  int degree(int motion_degree) const { return motion_degree; }

  template <class R>
  void value(int d, const MotionView<R>* points, R* out, const R& zero) const {
    const std::size_t powers = static_cast<std::size_t>(d) + 1;
    const R* a = axis_of<R>(points, 0, axis, powers);
    const R* b = axis_of<R>(points, 1, axis, powers);
    for (std::size_t k = 0; k < powers; ++k) {
      out[k] = is_exactly_zero(a[k]) && is_exactly_zero(b[k]) ? zero : b[k] - a[k];
    }
    out[0] -= points[2][0];
  }
};

struct BeyondLine {
  static constexpr int kArity = 2;
  static constexpr int kHomogeneity = 1;
  static constexpr int kDimension = 2;
  int axis;
  bool negated;

  std::string_view name() const {
    if (negated) return axis == 0 ? "x_short_of" : "y_short_of";
    return axis == 0 ? "x_beyond" : "y_beyond";
  }
  std::string_view opposite() const { return BeyondLine{axis, !negated}.name(); }
  ClaimForm form() const {
    return {ClaimFigure::kBeyond, negated ? -1 : 1, kBodyAndMark,
            negated ? "on the axis the origin of {0} is not beyond {1}"
                    : "on the axis the origin of {0} is not short of {1}",
            unit(axis)};
  }
  int degree(int motion_degree) const { return motion_degree; }

  template <class R>
  void value(int d, const MotionView<R>* points, R* out, const R& zero) const {
    const std::size_t powers = static_cast<std::size_t>(d) + 1;
    const R* a = axis_of<R>(points, 0, axis, powers);
    for (std::size_t k = 0; k < powers; ++k) {
      out[k] = negated && !is_exactly_zero(a[k]) ? zero - a[k] : a[k];
    }
    if (negated) {
      out[0] += points[1][0];
    } else {
      out[0] -= points[1][0];
    }
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_beyond_line(int axis, bool negated) {
  return std::make_shared<WidePredicate<BeyondLine>>(BeyondLine{axis, negated});
}

std::shared_ptr<const Predicate> make_discs_apart(bool negated) {
  return std::make_shared<WidePredicate<DiscsApart>>(DiscsApart{negated});
}

std::shared_ptr<const Predicate> make_axis_gap(int axis) {
  return std::make_shared<WidePredicate<AxisGap>>(AxisGap{axis});
}

}  // namespace kinex

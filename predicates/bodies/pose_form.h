// SPDX-License-Identifier: GPL-3.0-or-later
// PoseFormula: a linear form in the axes of a pose (predicates/bodies/pose_2.h), for WidePredicate.
//
// A Form is a class with
//   static constexpr int kArity;                the pose first, then constants
//   static constexpr std::array<int, n> kAxes;  the axes of the pose that it uses
//   name(), and opposite() where there is an opposite predicate;
//   template <class R> std::array<R, n> factors(const Constant<R>*) const;
// where factors() are the coefficients of those axes, homogeneous in each constant.
#ifndef KINEX_PREDICATES_BODIES_POSE_FORM_H
#define KINEX_PREDICATES_BODIES_POSE_FORM_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/arithmetic/linear_form.h"
#include "predicates/bodies/pose_2.h"
#include "predicates/bodies/wide_predicate.h"

namespace kinex {

// The coordinates of a constant: its i-th axis.
template <class R>
struct Constant {
  MotionView<R> first;
  std::size_t powers;
  const R& operator[](std::size_t axis) const { return first[axis * powers]; }
};

inline Ball minus(const Ball& b) { return {-b.value, b.error}; }  // -b
template <class R>  // -r
R minus(const R& r) {
  return -r;
}

template <class Form>  // a form as a formula of WidePredicate
struct PoseFormula : Form {
  explicit PoseFormula(Form form) : Form(form) {}

  // In all arguments together; it is homogeneous in each by itself.
  static constexpr int kHomogeneity = Form::kArity;
  static constexpr int kDimension = kPoseAxes;
  int degree(int motion_degree) const { return motion_degree; }

  template <class R>
  void value(int d, const MotionView<R>* points, R* out, const R& zero) const {
    const std::size_t powers = static_cast<std::size_t>(d) + 1;
    std::array<Constant<R>, kMaxArity> constants{};
    for (std::size_t i = 1; i < Form::kArity; ++i) constants[i - 1] = {points[i], powers};
    const auto factors = this->factors(constants.data());
    for (std::size_t k = 0; k < powers; ++k) out[k] = zero;
    for (std::size_t i = 0; i < Form::kAxes.size(); ++i) {
      if (is_exactly_zero(factors[i])) continue;
      const R* axis = points[0] + static_cast<std::size_t>(Form::kAxes[i]) * powers;
      for (std::size_t k = 0; k < powers; ++k) {
        if (!is_exactly_zero(axis[k])) out[k] += factors[i] * axis[k];
      }
    }
  }
};

template <class Form>  // a form as a predicate, which is linear in the pose
class PosePredicate final : public WidePredicate<PoseFormula<Form>>, public LinearForm {
 public:
  explicit PosePredicate(Form form)
      : WidePredicate<PoseFormula<Form>>(PoseFormula<Form>(form)), form_(form) {}

  std::uint32_t axes() const override {
    std::uint32_t bits = 0;
    for (const int axis : Form::kAxes) bits |= 1u << axis;
    return bits;
  }
  Ball value(int d, const MotionView<Ball>* points, const Ball* axes) const override {
    const std::size_t powers = static_cast<std::size_t>(d) + 1;
    std::array<Constant<Ball>, kMaxArity> constants{};
    for (std::size_t i = 1; i < Form::kArity; ++i) constants[i - 1] = {points[i], powers};
    const auto factors = form_.factors(constants.data());
    Ball sum;
    for (std::size_t i = 0; i < Form::kAxes.size(); ++i) {
      sum += factors[i] * axes[static_cast<std::size_t>(Form::kAxes[i])];
    }
    return sum;
  }

 private:
  Form form_;
};

template <class Form>  // the predicate of a form
std::shared_ptr<const Predicate> make_pose_form(Form form) {
  return std::make_shared<PosePredicate<Form>>(form);
}

}  // namespace kinex

#endif

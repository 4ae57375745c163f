// SPDX-License-Identifier: GPL-3.0-or-later
// PoseForm: adapts a linear form in the axes of a pose (predicates/pose_2.h) to the Predicate
// interface.
//
// A Form is a class with
//   static constexpr int kArity;             the pose first, then constants
//   static constexpr std::array<int, n> kAxes;  the axes of the pose that it uses
//   name();
//   template <class R> std::array<R, n> factors(const Constant<R>*) const;
// where factors() are the factors of those axes, homogeneous in each constant.
#ifndef KINEX_PREDICATES_POSE_FORM_H
#define KINEX_PREDICATES_POSE_FORM_H

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/predicate.h"
#include "predicates/pose_2.h"

namespace kinex {

// The coordinates of a constant: its i-th axis.
template <class R>
struct Constant {
  MotionView<R> first;
  std::size_t powers;
  const R& operator[](std::size_t axis) const { return first[axis * powers]; }
};

inline bool is_exactly_zero(const Ball& b) { return b.value == 0 && b.error == 0; }
inline bool is_exactly_zero(double d) { return d == 0; }
inline bool is_exactly_zero(const Integer& i) { return i.is_zero(); }
inline bool is_exactly_zero(const Rational& q) { return q.is_zero(); }
inline bool is_exactly_zero(const MpFloat& f) { return f.sign() == 0 && f.is_finite(); }

inline Ball minus(const Ball& b) { return {-b.value, b.error}; }
template <class R>
R minus(const R& r) {
  return -r;
}

template <class Form>
class PoseForm final : public Predicate {
 public:
  explicit PoseForm(Form form) : form_(std::move(form)) {}

  std::string_view name() const override { return form_.name(); }
  int arity() const override { return Form::kArity; }
  int dimension() const override { return kPoseAxes; }
  int degree(int motion_degree) const override { return motion_degree; }
  int alternating() const override { return 0; }
  std::string_view opposite() const override {
    if constexpr (requires { form_.opposite(); }) {
      return form_.opposite();
    } else {
      return {};
    }
  }
  // In all its arguments together; each is homogeneous by itself.
  int homogeneity() const override { return Form::kArity; }

  // The numbers of bodies are never narrow.
  bool narrow_fits(int, const double*) const override { return false; }
  void narrow(int, const MotionView<std::int64_t>*, Int128*) const override { refuse(); }
  void plain_with_reach(int, const MotionView<double>*, double, double*, double*) const override {
    refuse();
  }
  double reach_error(int) const override { return std::numeric_limits<double>::infinity(); }

  bool shifts(int) const override { return true; }
  void ball(int d, const MotionView<Ball>* points, double shift, Ball* out) const override {
    value(d, points, out, Ball{});
    taylor_shift(d, Ball{shift, 0}, out);
  }
  void plain(int d, const MotionView<double>* points, double shift, double* out) const override {
    value(d, points, out, 0.0);
    taylor_shift(d, shift, out);
  }
  void multiprecision(int d, const MotionView<MpFloat>* points, MpFloat* out) const override {
    value(d, points, out, MpFloat(points[0][0].precision()));
  }
  Polynomial exact(int d, const MotionView<Integer>* points) const override {
    std::vector<Integer> out(static_cast<std::size_t>(d) + 1);
    value(d, points, out.data(), Integer());
    return Polynomial(std::move(out));
  }
  std::vector<Rational> rational(int d, const MotionView<Rational>* points) const override {
    std::vector<Rational> out(static_cast<std::size_t>(d) + 1);
    value(d, points, out.data(), Rational());
    return out;
  }

 private:
  [[noreturn]] static void refuse() {
    throw std::logic_error("a predicate on poses was asked for machine integers");
  }

  template <class R>
  void value(int d, const MotionView<R>* points, R* out, const R& zero) const {
    const std::size_t powers = static_cast<std::size_t>(d) + 1;
    std::array<Constant<R>, kMaxArity> constants{};
    for (std::size_t i = 1; i < Form::kArity; ++i) constants[i - 1] = {points[i], powers};
    const auto factors = form_.factors(constants.data());
    for (std::size_t k = 0; k < powers; ++k) out[k] = zero;
    for (std::size_t i = 0; i < Form::kAxes.size(); ++i) {
      if (is_exactly_zero(factors[i])) continue;
      const R* axis = points[0] + static_cast<std::size_t>(Form::kAxes[i]) * powers;
      for (std::size_t k = 0; k < powers; ++k) {
        if (!is_exactly_zero(axis[k])) out[k] += factors[i] * axis[k];
      }
    }
  }

  template <class R>
  static void taylor_shift(int d, const R& shift, R* out) {
    if (is_exactly_zero(shift)) return;
    while (d > 0 && is_exactly_zero(out[d])) --d;
    for (int k = 0; k < d; ++k) {
      for (int j = d - 1; j >= k; --j) out[j] += shift * out[j + 1];
    }
  }

  Form form_;
};

}  // namespace kinex

#endif

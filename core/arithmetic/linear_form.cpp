// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/linear_form.h"

#include <bit>

namespace kinex {

void LinearSigns::begin(const MotionStore& motions, ObjectId object, double lo, double hi) {
  object_ = object;
  lo_ = lo;
  hi_ = hi;
  known_ = 0;
  const Ball now{lo + 0.5 * (hi - lo), (hi - lo) * (1 + 0x1p-40)};
  std::optional<double> anchor;
  if (motions.model().anchored) anchor = motions.shared_anchor(&object, 1);
  anchored_ = anchor.has_value();
  time_ = anchored_ ? now - Ball{*anchor, 0} : now;
}

// Horner's rule; leading coefficients that are zero are skipped.
void LinearSigns::evaluate(const MotionStore& motions, std::uint32_t axes) {
  const MotionView<Ball> motion = anchored_ ? motions.anchored(object_) : motions.ball(object_);
  const auto degree = static_cast<std::size_t>(motions.degree());
  known_ |= axes;
  for (; axes != 0; axes &= axes - 1) {
    const auto axis = static_cast<std::size_t>(std::countr_zero(axes));
    const Ball* c = motion + axis * (degree + 1);
    std::size_t k = degree;
    while (k > 0 && c[k].value == 0 && c[k].error == 0) --k;
    Ball value = c[k];
    while (k-- > 0) value = value * time_ + c[k];
    value_[axis] = value;
  }
}

std::optional<Sign> LinearSigns::over(const LinearForm& form, const MotionStore& motions,
                                      const Query& query, double lo, double hi) {
  const ObjectId object = query.ids[0];
  if (object != object_ || lo != lo_ || hi != hi_) begin(motions, object, lo, hi);
  const std::uint32_t missing = form.axes() & ~known_;
  if (missing != 0) evaluate(motions, missing);
  std::array<MotionView<Ball>, kMaxViews> points;
  points[0] = nullptr;
  for (std::size_t i = 1; i < query.arity; ++i) points[i] = motions.ball(query.ids[i]);
  const Ball value = form.value(motions.degree(), points.data(), value_.data());
  if (value.value > value.error) return Sign::kPositive;
  if (value.value < -value.error) return Sign::kNegative;
  return std::nullopt;
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// MotionStore: the motions in force, in the number types that a scene requires.
#ifndef KINEX_CORE_ARITHMETIC_MOTION_STORE_H
#define KINEX_CORE_ARITHMETIC_MOTION_STORE_H

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/arithmetic/number_needs.h"
#include "core/arithmetic/predicate.h"
#include "core/motion/scene.h"
#include "core/numbers/ball.h"
#include "core/numbers/big_array.h"

namespace kinex {

// The number types that a scene's coefficients allow, decided once per scene.
struct NumberModel {
  int degree = 1;  // motion degree that polynomials are sized for (>= 1)
  int axes = 1;
  bool narrow = false;            // all coefficients, times `scale`, are integers of at most 2^52
  Integer scale = Integer(1);     // common denominator of all coefficients
  std::vector<double> magnitude;  // largest |coefficient| * scale per power of t, rounded up
  bool anchored = false;  // every motion is also kept as doubles in t - anchor (MotionStore::set)
};
NumberModel choose_number_model(const Scene& scene, const NumberNeeds& needs);

// An object's numbers are its coefficients: that of t^k on axis a is at [a * (degree + 1) + k].
// A motion that the model does not cover (one given at run time) is kept as big integers, unless it
// is zero. Balls are kept in rows; all zero motions share the first row.
class MotionStore {
 public:
  MotionStore(const NumberModel& model, std::size_t objects);

  // The object may be a new one. Keeps the first axes, as many as the model has. `anchor`: a time near which the motion will be evaluated.
  void set(ObjectId object, const Trajectory& trajectory, double anchor = 0);
  // From the first call on, motions are also kept as doubles with error bounds (ball(), anchored()).
  void need_balls();

  int degree() const { return model_.degree; }
  const NumberModel& model() const { return model_; }
  bool is_narrow(ObjectId object) const { return narrow_object_[object] == kNarrow; }
  // Every object that has a motion is narrow.
  bool all_narrow() const { return wide_ == 0 && model_.narrow; }
  // Coefficients times the model's scale, integers of at most 2^52: doubles hold them and the
  // differences of any two of them exactly. Requires is_narrow(object).
  MotionView<double> narrow(ObjectId object) const { return &narrow_[object * stride_]; }
  void prefetch(ObjectId object) const { __builtin_prefetch(&narrow_[object * stride_]); }
  // The unit of predicates (Predicate::has_unit): the model's scale, as a double and as a ball. It
  // is narrow, an integer of at most 2^52, if doubles hold it and its differences to coordinates
  // exactly.
  bool unit_is_narrow() const { return unit_ <= 0x1p52; }
  const double& unit() const { return unit_; }
  const Ball& unit_ball() const { return unit_ball_; }
  // The number of coefficients of one object.
  std::size_t stride() const { return stride_; }
  MotionView<Ball> ball(ObjectId object) const { return &balls_[row_[object] * stride_]; }
  // The same in t - anchor, shifted exactly before rounding: far from t = 0 the coefficients in t
  // cancel, these do not. Requires model().anchored.
  MotionView<Ball> anchored(ObjectId object) const { return &anchored_[row_[object] * stride_]; }
  // The anchor shared by all moving objects among these; nullopt if none is shared.
  std::optional<double> shared_anchor(const ObjectId* ids, std::size_t count) const {
    return anchors_differ_ ? anchor_of(ids, count) : first_anchor_;
  }
  // That is the same for any objects.
  bool has_one_anchor() const { return !anchors_differ_; }
  // The exact polynomial of `predicate` over these objects, times a positive constant.
  Polynomial exact(const Predicate& predicate, const ObjectId* ids) const;
  std::size_t bytes() const;

 private:
  struct BigMotion {
    Integer denominator;
    std::vector<Integer> coefficients;  // times denominator; empty: the motion is narrow or zero
    bool whole = true;                  // the denominator is 1
  };
  bool is_big(ObjectId object) const {
    return object < big_.size() && !big_[object].coefficients.empty();
  }
  std::optional<double> anchor_of(const ObjectId* ids, std::size_t count) const;
  std::optional<double> scaled_integer(const Rational& value) const;
  void grow(std::size_t objects);
  void grow_degree(int degree);
  void set_big(ObjectId object, std::span<const std::vector<Rational>> axes);
  void make_row(ObjectId object);
  void set_ball(ObjectId object);
  void set_anchored(ObjectId object);
  // Splits an anchor a / 2^e.
  void split_anchor(double anchor);

  NumberModel model_;
  std::size_t objects_;
  std::size_t stride_;
  BigArray<double> narrow_;  // integers
  enum : std::uint8_t { kUnset, kNarrow, kWide };
  std::vector<std::uint8_t> narrow_object_;  // per object, one of these
  std::size_t wide_ = 0;                     // objects that are kWide
  BigArray<std::uint32_t> row_;  // per object, of balls_ and anchored_; 0: all are zero
  std::uint32_t rows_ = 1;
  BigArray<Ball> balls_;
  BigArray<Ball> anchored_;
  BigArray<double> anchors_;  // per object; infinity: it does not move
  std::optional<double> first_anchor_;  // of the first motion
  bool anchors_differ_ = false;         // some motion was given another one
  std::vector<BigMotion> big_;   // per object; empty before the first one
  double unit_ = 1;  // rounded, if it is not narrow
  Ball unit_ball_{1, 0};
  bool balls_needed_ = false;
  struct {
    double value = 0;
    Integer a;
    unsigned long e = 0;
  } anchor_;                   // the one that was split last
  std::vector<Integer> axis_;  // being shifted
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// LinearForm: a predicate that is linear in the axes of its first argument and whose other
// arguments are constants, such as a form in a pose (predicates/bodies/pose_form.h). A structure
// needs the signs of many forms in one pose at one instant: LinearSigns evaluates the axes of the
// pose once for all of them.
#ifndef KINEX_CORE_ARITHMETIC_LINEAR_FORM_H
#define KINEX_CORE_ARITHMETIC_LINEAR_FORM_H

#include <array>
#include <cstdint>
#include <optional>

#include "core/arithmetic/motion_store.h"
#include "core/arithmetic/query.h"
#include "core/numbers/sign.h"

namespace kinex {

// A second base class of those predicates.
class LinearForm {
 public:
  virtual ~LinearForm() = default;
  // The axes of the first argument that the form reads: bit a for axis a.
  virtual std::uint32_t axes() const = 0;
  // The value of the form. axes[a] is the value of axis a of the first argument; those of axes()
  // are read. points[i] is constant i >= 1 (points[0] is not read).
  virtual Ball value(int motion_degree, const MotionView<Ball>* points, const Ball* axes) const = 0;
};

// Signs of linear forms over a short time interval, in doubles with error bounds. The axes of the
// last first argument are cached. Cost: O(motion degree) per axis when the first argument or the
// interval changes, then O(1) per sign.
class LinearSigns {
 public:
  // The form's sign on all of [lo, hi]: positive or negative; nullopt if neither is certain.
  // `query`: the form's arguments. Requires motions as balls (MotionStore::need_balls).
  std::optional<Sign> over(const LinearForm& form, const MotionStore& motions, const Query& query,
                           double lo, double hi);
  // Call when the motion of this object changes.
  void forget(ObjectId object) {
    if (object == object_) object_ = kNoObject;
  }

 private:
  void begin(const MotionStore& motions, ObjectId object, double lo, double hi);
  void evaluate(const MotionStore& motions, std::uint32_t axes);

  ObjectId object_ = kNoObject;
  double lo_ = 0, hi_ = 0;
  bool anchored_ = false;
  Ball time_;                // holds [lo, hi], from the object's anchor if it has one
  std::uint32_t known_ = 0;  // bits
  std::array<Ball, kMostAxes> value_;
};

}  // namespace kinex

#endif

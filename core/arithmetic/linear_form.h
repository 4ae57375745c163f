// SPDX-License-Identifier: GPL-3.0-or-later
// LinearForm: a predicate that is linear in the axes of its first argument and whose other
// arguments are constants, such as a form in a pose (predicates/bodies/pose_form.h). A structure
// needs many of their signs in one pose at one instant; the axes of the pose are evaluated once.
#ifndef KINEX_CORE_ARITHMETIC_LINEAR_FORM_H
#define KINEX_CORE_ARITHMETIC_LINEAR_FORM_H

#include <array>
#include <cstdint>
#include <optional>

#include "core/arithmetic/motion_store.h"
#include "core/arithmetic/query.h"
#include "core/numbers/sign.h"

namespace kinex {

// A base of a Predicate.
class LinearForm {
 public:
  virtual ~LinearForm() = default;
  // The axes of the first argument that it reads: bit a for axis a.
  virtual std::uint32_t axes() const = 0;
  // The value where the first argument's axes have these values.
  virtual Ball value(int motion_degree, const MotionView<Ball>* points, const Ball* axes) const = 0;
};

// Signs of linear forms over a short time interval, in doubles with error bounds. The values of the
// last object are cached. O(degree) for each of its axes, then O(1) a sign.
class LinearSigns {
 public:
  // The form's sign on all of [lo, hi]; nullopt if it is not certainly constant. The motions are
  // not machine integers.
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

// SPDX-License-Identifier: GPL-3.0-or-later
// CoarseTime: a time near the present instant, rounded to a double, for choices that any time near it
// would serve.
//
// A structure may hand it on to what computes with numbers below it, and cannot compute with it.
#ifndef KINEX_CORE_NUMBERS_COARSE_TIME_H
#define KINEX_CORE_NUMBERS_COARSE_TIME_H

namespace kinex {

class CoarseTime {
 public:
  explicit CoarseTime(double value) : value_(value) {}
  // Not for structures.
  double value() const { return value_; }

 private:
  double value_;
};

}  // namespace kinex

#endif

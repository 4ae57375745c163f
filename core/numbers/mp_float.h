// SPDX-License-Identifier: GPL-3.0-or-later
// MpFloat: an MPFR number of a precision chosen at run time, rounded to nearest. Wraps mpfr_t.
#ifndef KINEX_CORE_NUMBERS_MP_FLOAT_H
#define KINEX_CORE_NUMBERS_MP_FLOAT_H

#include <mpfr.h>

#include "core/numbers/rational.h"

namespace kinex {

// Results of + - * / have the larger precision of the operands.
class MpFloat {
 public:
  MpFloat() : MpFloat(2L) {}
  explicit MpFloat(long precision_bits) {
    mpfr_init2(x_, precision_bits);
    mpfr_set_zero(x_, 1);
  }
  MpFloat(long precision_bits, const Rational& value) {
    mpfr_init2(x_, precision_bits);
    mpfr_set_q(x_, value.raw(), MPFR_RNDN);
  }
  MpFloat(long precision_bits, double value) {
    mpfr_init2(x_, precision_bits);
    mpfr_set_d(x_, value, MPFR_RNDN);
  }
  MpFloat(const MpFloat& other) {
    mpfr_init2(x_, mpfr_get_prec(other.x_));
    mpfr_set(x_, other.x_, MPFR_RNDN);
  }
  MpFloat(MpFloat&& other) noexcept {
    mpfr_init2(x_, 2);
    mpfr_swap(x_, other.x_);
  }
  MpFloat& operator=(const MpFloat& other) {
    if (this != &other) {
      mpfr_set_prec(x_, mpfr_get_prec(other.x_));
      mpfr_set(x_, other.x_, MPFR_RNDN);
    }
    return *this;
  }
  MpFloat& operator=(MpFloat&& other) noexcept {
    mpfr_swap(x_, other.x_);
    return *this;
  }
  ~MpFloat() { mpfr_clear(x_); }

  long precision() const { return mpfr_get_prec(x_); }
  int sign() const { return mpfr_nan_p(x_) ? 0 : mpfr_sgn(x_); }
  bool is_finite() const { return mpfr_number_p(x_) != 0; }
  double lower_double() const { return mpfr_get_d(x_, MPFR_RNDD); }
  double upper_double() const { return mpfr_get_d(x_, MPFR_RNDU); }
  double to_double() const { return mpfr_get_d(x_, MPFR_RNDN); }
  // -1, 0, +1; NaN compares equal to everything.
  friend int compare(const MpFloat& a, const MpFloat& b) {
    return mpfr_unordered_p(a.x_, b.x_) ? 0 : mpfr_cmp(a.x_, b.x_);
  }
  friend int compare(const MpFloat& a, const Rational& b) {
    return mpfr_nan_p(a.x_) ? 0 : mpfr_cmp_q(a.x_, b.raw());
  }

  friend MpFloat operator+(const MpFloat& a, const MpFloat& b) { return apply(mpfr_add, a, b); }
  friend MpFloat operator-(const MpFloat& a, const MpFloat& b) { return apply(mpfr_sub, a, b); }
  friend MpFloat operator*(const MpFloat& a, const MpFloat& b) { return apply(mpfr_mul, a, b); }
  friend MpFloat operator/(const MpFloat& a, const MpFloat& b) { return apply(mpfr_div, a, b); }
  friend MpFloat operator-(const MpFloat& a) {
    MpFloat r(a.precision());
    mpfr_neg(r.x_, a.x_, MPFR_RNDN);
    return r;
  }
  MpFloat& operator+=(const MpFloat& b) { return *this = *this + b; }
  MpFloat& operator-=(const MpFloat& b) { return *this = *this - b; }

  mpfr_srcptr raw() const { return x_; }
  mpfr_ptr raw() { return x_; }

 private:
  template <class Operation>
  static MpFloat apply(Operation operation, const MpFloat& a, const MpFloat& b) {
    MpFloat r(a.precision() > b.precision() ? a.precision() : b.precision());
    operation(r.x_, a.x_, b.x_, MPFR_RNDN);
    return r;
  }
  mpfr_t x_;
};

int compare(const MpFloat& a, const MpFloat& b);  // -1, 0, +1; exact
int compare(const MpFloat& a, const Rational& b);  // -1, 0, +1; exact

}  // namespace kinex

#endif

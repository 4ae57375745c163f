// SPDX-License-Identifier: GPL-3.0-or-later
// RootNamer: the exact name (RootName in core/numbers/real_root.h) of a root that is already
// enclosed in doubles, without isolating it again.
//
// A filtered Sturm sequence proves that the polynomial is square-free, counts the roots below this
// one, and finds the coarsest cell (see RootName) that isolates it. The polynomial is irrational at
// the root if it has no root modulo some small prime; otherwise exact arithmetic decides. If the
// filter fails, no name is given; name_root() (core/numbers/real_root.h) never fails and gives the
// same names, more slowly.
// Cost: about one microsecond at degree 4, two at degree 8.
#ifndef KINEX_CORE_ARITHMETIC_ROOT_NAMER_H
#define KINEX_CORE_ARITHMETIC_ROOT_NAMER_H

#include <vector>

#include "core/numbers/filtered_sturm.h"
#include "core/numbers/instant_name.h"

namespace kinex {

class RootNamer {
 public:
  // Fills in polynomial, root, lower and upper of `name` for the root of p in [lo, hi]. Requires
  // that it is the only root there and that p changes sign at it. Consumes p. Returns false if
  // there is no name; the four members are then undefined.
  bool name(std::vector<Integer>& p, double lo, double hi, InstantName& name);

 private:
  // The variable x of the sequence: x = (t - origin) / 2^scale.
  struct Frame {
    double origin = 0;
    int scale = 0;
  };
  bool count(const Frame& frame, double lo, double hi, InstantName& name) const;
  bool make_near(const std::vector<Integer>& p, double lo, Frame& frame);

  FilteredSturm sturm_;
  std::vector<Integer> shifted_;
};

// Divides p by its content and makes its leading coefficient positive. Requires p.back() != 0.
void make_canonical(std::vector<Integer>& p);

// Sets the name of a rational number: the polynomial -num + den t, its root 1, [value, value].
void set_rational_name(const Rational& value, InstantName& name);

}  // namespace kinex

#endif

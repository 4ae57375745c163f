// SPDX-License-Identifier: GPL-3.0-or-later
// RootNamer: the exact name (RootName in core/numbers/real_root.h) of a root that is already
// enclosed in doubles, without isolating it again.
//
// A filtered Sturm sequence proves that the polynomial is square-free, counts the roots below, and
// finds the coarsest cell that isolates the root. Roots modulo small primes prove that it is
// irrational. If a proof fails no name is given; name_root() then gives the same name exactly.
// Cost: about one microsecond at degree 4, two at degree 8.
#ifndef KINEX_CORE_ARITHMETIC_ROOT_NAMER_H
#define KINEX_CORE_ARITHMETIC_ROOT_NAMER_H

#include <vector>

#include "core/numbers/filtered_sturm.h"
#include "core/numbers/instant_name.h"

namespace kinex {

class RootNamer {
 public:
  // Fills in polynomial, root, lower and upper: the name of the root of p in [lo, hi]. Requires: it
  // is the only one there, and p changes sign at it. Consumes p. False: no name; the four are
  // undefined.
  bool name(std::vector<Integer>& p, double lo, double hi, InstantName& name);

 private:
  // The sequence as one of t: x = (t - origin) / 2^scale.
  struct Frame {
    double origin = 0;
    int scale = 0;
  };
  bool count(const Frame& frame, double lo, double hi, InstantName& name) const;
  bool make_near(const std::vector<Integer>& p, double lo, Frame& frame);

  FilteredSturm sturm_;
  std::vector<Integer> shifted_;
};

// p / +-content(p): primitive, positive leading coefficient. Requires p.back() != 0.
void make_canonical(std::vector<Integer>& p);

// The minimal name of a rational number: -num + den t, root 1, [value, value].
void set_rational_name(const Rational& value, InstantName& name);

}  // namespace kinex

#endif

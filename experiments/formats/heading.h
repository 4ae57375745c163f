// SPDX-License-Identifier: GPL-3.0-or-later
// Headings in degrees as rotors of bodies.
//
// A rotor p + iq turns a body by twice its angle, so a heading h needs the direction of
// (cos(h/2), sin(h/2)). Multiples of 90 degrees are exact, and headings that differ by a multiple
// of 360 give the same rotor. Otherwise p and q are multiples of 2^-40 nearest to the cosine and
// the sine, up to 2^-59: the error of the rotor's angle is below 2^-40, that of the heading below
// 2^-39, or 1.1e-10 degrees. No floating point: the same rotors on every machine.
#ifndef KINEX_EXPERIMENTS_FORMATS_HEADING_H
#define KINEX_EXPERIMENTS_FORMATS_HEADING_H

#include <array>
#include <vector>

#include "core/numbers/rational.h"

namespace kinex::formats {

// The heading in [0, 360) that differs from `degrees` by a multiple of 360.
Rational reduced_heading(const Rational& degrees);
// The reduced heading, counter-clockwise from the x axis (east), of a bearing, clockwise from the y
// axis (north).
Rational heading_of_bearing(const Rational& degrees);

// Requires 0 <= heading < 360. The part q is not negative, and p > 0 where q is 0.
struct Rotor {
  Rational p, q;
};
Rotor rotor_of_heading(const Rational& heading);

// Coefficient lists of p and q in t.
using RotorMotion = std::array<std::vector<Rational>, 2>;
// A constant rotor; (1, 0) for 0, (1, 1) for 90, (0, 1) for 180, (-1, 1) for 270 degrees.
RotorMotion fixed_rotor(const Rational& heading);
// Linear in t, from the heading `from` at t0 to `to` at t1 the short way round; counter-clockwise
// if both ways are 180 degrees. The body turns fastest in the middle of the time, when it is half
// way. A constant rotor if the headings are equal. Requires 0 <= from, to < 360 and t0 < t1.
RotorMotion turning_rotor(const Rational& from, const Rational& t0, const Rational& to,
                          const Rational& t1);

}  // namespace kinex::formats

#endif

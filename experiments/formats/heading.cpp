// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/heading.h"

#include <cstdint>
#include <utility>

#include "core/numbers/integer.h"
#include "experiments/formats/angles.h"

namespace kinex::formats {

namespace {

constexpr unsigned long kRotorBits = 40;

// 0 <= degrees <= 45, so that the angle has an error below 2^-60.
CosSin rounded_cos_sin(const Rational& degrees) {
  CosSin turn = approximate_cos_sin(approximate_pi() * degrees / Rational(180));
  turn = {rounded(turn.cos, kRotorBits), rounded(turn.sin, kRotorBits)};
  if (degrees == Rational(45)) turn.sin = turn.cos;
  return turn;
}

// The line through two values of a coordinate: its value at 0 and its slope.
std::vector<Rational> line(const Rational& a, const Rational& t0, const Rational& b,
                           const Rational& t1) {
  const Rational slope = (b - a) / (t1 - t0);
  std::vector<Rational> coefficients{a - slope * t0};
  if (!slope.is_zero()) coefficients.push_back(slope);
  return coefficients;
}

}  // namespace

Rational reduced_heading(const Rational& degrees) {
  const Rational turns = degrees / Rational(360);
  return degrees - Rational(360) * Rational(floor_divide(turns.numerator(), turns.denominator()));
}

Rational heading_of_bearing(const Rational& degrees) {
  return reduced_heading(Rational(90) - degrees);
}

// Half of the heading is a number of right angles and a remainder, which is at most 45 degrees from
// one of its two ends.
Rotor rotor_of_heading(const Rational& heading) {
  const bool second_quadrant = heading >= Rational(180);
  const Rational rest = (second_quadrant ? heading - Rational(180) : heading) / Rational(2);
  CosSin turn;
  if (rest <= Rational(45)) {
    turn = rounded_cos_sin(rest);
  } else {
    turn = rounded_cos_sin(Rational(90) - rest);
    std::swap(turn.cos, turn.sin);
  }
  if (second_quadrant) return {-turn.sin, turn.cos};
  return {turn.cos, turn.sin};
}

RotorMotion fixed_rotor(const Rational& heading) {
  const Rotor rotor = rotor_of_heading(heading);
  if (rotor.p == rotor.q) return {{{1}, {1}}};
  if (rotor.p == -rotor.q) return {{{-1}, {1}}};
  return {{{rotor.p}, {rotor.q}}};
}

RotorMotion turning_rotor(const Rational& from, const Rational& t0, const Rational& to,
                          const Rational& t1) {
  if (from == to) return fixed_rotor(from);
  const Rotor a = rotor_of_heading(from);
  Rotor b = rotor_of_heading(to);
  // The rotors of [0, 360) fill half a circle. The short way leaves it where the headings are more
  // than 180 degrees apart; so does the way counter-clockwise from h + 180 to h.
  const Rational gap = to - from;
  if (gap > Rational(180) || gap <= Rational(-180)) b = {-b.p, -b.q};
  return {line(a.p, t0, b.p, t1), line(a.q, t0, b.q, t1)};
}

}  // namespace kinex::formats

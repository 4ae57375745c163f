// SPDX-License-Identifier: GPL-3.0-or-later
// Motion: the position of an object, piecewise polynomial in t with rational coefficients.
#ifndef KINEX_CORE_MOTION_MOTION_H
#define KINEX_CORE_MOTION_MOTION_H

#include <optional>
#include <vector>

#include "core/numbers/rational.h"

namespace kinex {

// A rigid body in the plane has four coordinates: x, y of its frame's origin and a rotor p, q that
// turns the frame by twice the angle of p + iq (p and q never vanish together).
inline constexpr int kBodyAxes = 4;

// coordinates[axis][power]: coefficient of t^power (absolute t), low degree first. Every axis has
// at least one coefficient; trailing zeros are stripped by normalise().
struct Trajectory {
  std::vector<std::vector<Rational>> coordinates;

  int dimension() const { return static_cast<int>(coordinates.size()); }
  // Largest power with a non-zero coefficient on any axis; 0 for a static object.
  int degree() const;
  // The same for the axes in [first, last) alone.
  int degree_of_axes(int first, int last) const;
  void normalise();
  // Requires axis < dimension().
  Rational position(int axis, const Rational& t) const;
  // True if both are at the same place at t, with the same extents or weight. Of bodies: also in the same
  // orientation, which means rotors that are equal up to a factor. Requires that `other` has at
  // least as many axes.
  bool meets(const Trajectory& other, const Rational& t, bool bodies = false) const;
  friend bool operator==(const Trajectory&, const Trajectory&) = default;
};

// A flight plan in force on [from, to); a missing end is unbounded.
struct MotionPiece {
  std::optional<Rational> from;  // nullopt: from the scene's start (or before)
  std::optional<Rational> to;    // nullopt: to the scene's end (or beyond)
  Trajectory trajectory;
};

// Pieces in ascending order of time, contiguous (piece[i].to == piece[i+1].from).
struct Motion {
  std::vector<MotionPiece> pieces;

  int degree() const;  // largest over the pieces
  // The piece in force on (t, t + eps), or nullptr when the object does not exist there.
  const MotionPiece* piece_after(const Rational& t) const;
};

}  // namespace kinex

#endif

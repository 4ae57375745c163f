// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/motion.h"

#include <algorithm>

namespace kinex {

int Trajectory::degree() const { return degree_of_axes(0, dimension()); }

int Trajectory::degree_of_axes(int first, int last) const {
  int degree = 0;
  for (int a = first; a < std::min(last, dimension()); ++a) {
    const std::vector<Rational>& axis = coordinates[static_cast<std::size_t>(a)];
    for (std::size_t k = axis.size(); k-- > 1;) {
      if (axis[k].is_zero()) continue;
      degree = std::max(degree, static_cast<int>(k));
      break;
    }
  }
  return degree;
}

void Trajectory::normalise() {
  for (std::vector<Rational>& axis : coordinates) {
    while (axis.size() > 1 && axis.back().is_zero()) axis.pop_back();
    if (axis.empty()) axis.emplace_back();
  }
}

Rational Trajectory::position(int axis, const Rational& t) const {
  const std::vector<Rational>& c = coordinates[static_cast<std::size_t>(axis)];
  Rational value;
  for (std::size_t k = c.size(); k-- > 0;) {
    value *= t;
    value += c[k];
  }
  return value;
}

bool Trajectory::meets(const Trajectory& other, const Rational& t) const {
  const bool body = dimension() == kBodyAxes;
  if (body && position(2, t) * other.position(3, t) != position(3, t) * other.position(2, t)) {
    return false;
  }
  for (int axis = 0; axis < (body ? 2 : dimension()); ++axis) {
    if (position(axis, t) != other.position(axis, t)) return false;
  }
  return true;
}

int Motion::degree() const {
  int degree = 0;
  for (const MotionPiece& piece : pieces) degree = std::max(degree, piece.trajectory.degree());
  return degree;
}

const MotionPiece* Motion::piece_after(const Rational& t) const {
  for (const MotionPiece& piece : pieces) {
    if ((!piece.from || *piece.from <= t) && (!piece.to || t < *piece.to)) return &piece;
  }
  return nullptr;
}

}  // namespace kinex

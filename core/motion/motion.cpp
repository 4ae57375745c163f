// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/motion.h"

#include <algorithm>

#include "core/numbers/short_rational.h"

namespace kinex {

namespace {

// Whether a(t) = b(t); nullopt unless both are linear and all numbers are short.
std::optional<bool> meet_in_words(const std::vector<Rational>& a, const std::vector<Rational>& b,
                                  const ShortRational& t) {
  if (a.size() > 2 || b.size() > 2) return std::nullopt;
  const auto coefficient = [](const std::vector<Rational>& axis, std::size_t k) {
    return k < axis.size() ? shortened(axis[k]) : ShortRational{};
  };
  const auto a0 = coefficient(a, 0), a1 = coefficient(a, 1);
  const auto b0 = coefficient(b, 0), b1 = coefficient(b, 1);
  if (!a0 || !a1 || !b0 || !b1) return std::nullopt;
  return equal_lines(*a0, *a1, *b0, *b1, t);
}

}  // namespace

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

bool Trajectory::meets(const Trajectory& other, const Rational& t, bool bodies) const {
  if (bodies && position(2, t) * other.position(3, t) != position(3, t) * other.position(2, t)) {
    return false;
  }
  const std::optional<ShortRational> words = shortened(t);
  for (int axis = 0; axis < (bodies ? 2 : dimension()); ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const auto meet =
        words ? meet_in_words(coordinates[a], other.coordinates[a], *words) : std::nullopt;
    if (meet && !*meet) return false;
    if (meet) continue;
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

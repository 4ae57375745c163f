// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/turning.h"

#include <algorithm>
#include <vector>

namespace kinex {

namespace {

using Coefficients = std::vector<Rational>;

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients result(a.size() + b.size() - 1, Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

// a + factor * b
Coefficients sum(Coefficients a, const Coefficients& b, const Rational& factor) {
  if (a.size() < b.size()) a.resize(b.size(), Rational(0));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
  return a;
}

// The rotor of one as seen from the other, conj(w) w', has one direction at all times (or its
// opposite, which is the same turn): its two parts are multiples of one polynomial.
bool keep_their_angle(const Trajectory& a, const Trajectory& b) {
  const auto &p = a.coordinates[2], &q = a.coordinates[3];
  const auto &r = b.coordinates[2], &s = b.coordinates[3];
  Coefficients u = sum(product(p, r), product(q, s), Rational(1));
  Coefficients v = sum(product(p, s), product(q, r), Rational(-1));
  const std::size_t size = std::max(u.size(), v.size());
  u.resize(size, Rational(0));
  v.resize(size, Rational(0));
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i + 1; j < size; ++j) {
      if (u[i] * v[j] != u[j] * v[i]) return false;
    }
  }
  return true;
}

// Both are in force in some time of the scene.
bool overlap(const MotionPiece& a, const MotionPiece& b, const Scene& scene) {
  Rational from = scene.start;
  std::optional<Rational> to = scene.end;
  for (const MotionPiece* piece : {&a, &b}) {
    if (piece->from && from < *piece->from) from = *piece->from;
    if (piece->to && (!to || *piece->to < *to)) to = piece->to;
  }
  return !to || from < *to;
}

bool turn_against_each_other(const Motion& a, const Motion& b, const Scene& scene) {
  for (const MotionPiece& own : a.pieces) {
    for (const MotionPiece& other : b.pieces) {
      if (overlap(own, other, scene) && !keep_their_angle(own.trajectory, other.trajectory)) {
        return true;
      }
    }
  }
  return false;
}

// At one angle at all times of its motion.
bool never_turns(const Motion& motion) {
  const Trajectory at_rest{{{Rational(0)}, {Rational(0)}, {Rational(1)}, {Rational(0)}}};
  return std::all_of(motion.pieces.begin(), motion.pieces.end(), [&](const MotionPiece& piece) {
    return keep_their_angle(at_rest, piece.trajectory);
  });
}

struct Way {
  ObjectId body;  // the first that turns so
  bool turns;
};

// Existing at the same times, and not turning, or by the same rotors.
bool are_alike(const Motion& a, const Motion& b, bool turn) {
  if (!turn) {
    return a.pieces.front().from == b.pieces.front().from &&
           a.pieces.back().to == b.pieces.back().to;
  }
  return std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(),
                    [](const MotionPiece& one, const MotionPiece& other) {
                      return one.from == other.from && one.to == other.to &&
                             one.trajectory.coordinates[2] == other.trajectory.coordinates[2] &&
                             one.trajectory.coordinates[3] == other.trajectory.coordinates[3];
                    });
}

}  // namespace

std::optional<std::pair<ObjectId, ObjectId>> find_turning_pair(const Scene& scene) {
  std::vector<Way> ways;
  for (ObjectId b = 0; b < scene.objects.size(); ++b) {
    const Motion& motion = scene.objects[b].motion;
    if (motion.pieces.empty()) continue;
    const bool turns = !never_turns(motion);
    const bool known = std::any_of(ways.begin(), ways.end(), [&](const Way& way) {
      return way.turns == turns && are_alike(scene.objects[way.body].motion, motion, turns);
    });
    if (known) continue;
    for (const Way& way : ways) {
      if ((turns || way.turns) &&
          turn_against_each_other(scene.objects[way.body].motion, motion, scene)) {
        return {{way.body, b}};
      }
    }
    ways.push_back({b, turns});
  }
  return std::nullopt;
}

}  // namespace kinex

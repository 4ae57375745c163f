// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/drawn_motions.h"

#include <algorithm>
#include <utility>

#include "experiments/trade/binary_scale.h"

namespace kinex {

namespace {

// c(t) as a polynomial in u, for t = start + span u.
std::vector<Rational> in_u(const std::vector<Rational>& c, const Rational& start,
                           const Rational& span) {
  std::vector<Rational> result;
  for (auto k = c.rbegin(); k != c.rend(); ++k) {  // Horner: result * (start + span u) + c_k
    result.emplace_back(0);
    for (std::size_t i = result.size() - 1; i > 0; --i) {
      result[i] = result[i] * start + result[i - 1] * span;
    }
    result[0] = result[0] * start + *k;
  }
  return result;
}

struct ExactPiece {
  DrawnPiece drawn;
  std::vector<std::vector<Rational>> coordinates;
};

}  // namespace

DrawnMotions drawn_motions(const Scene& scene, const Rational& start, const Rational& span) {
  const Rational end = start + span;
  std::vector<std::vector<ExactPiece>> exact;
  Rational largest;
  for (const SceneObject& object : scene.objects) {
    std::vector<ExactPiece>& pieces = exact.emplace_back();
    for (const MotionPiece& piece : object.motion.pieces) {
      if ((piece.to && *piece.to < start) || (piece.from && *piece.from > end)) continue;
      ExactPiece& own = pieces.emplace_back();
      if (piece.from) own.drawn.from = ((*piece.from - start) / span).to_double();
      if (piece.to) own.drawn.to = ((*piece.to - start) / span).to_double();
      for (const std::vector<Rational>& c : piece.trajectory.coordinates) {
        own.coordinates.push_back(in_u(c, start, span));
        for (const Rational& x : own.coordinates.back()) largest = std::max(largest, absolute(x));
      }
    }
  }
  const Rational scale = largest.is_zero() ? Rational(1) : power_of_two(ceil_log2(largest));
  DrawnMotions result;
  result.scale = scale.to_double();
  for (std::vector<ExactPiece>& pieces : exact) {
    std::vector<DrawnPiece>& drawn = result.objects.emplace_back();
    for (ExactPiece& piece : pieces) {
      for (const std::vector<Rational>& c : piece.coordinates) {
        std::vector<double>& out = piece.drawn.coordinates.emplace_back();
        for (const Rational& x : c) out.push_back((x / scale).to_double());
      }
      drawn.push_back(std::move(piece.drawn));
    }
  }
  return result;
}

}  // namespace kinex

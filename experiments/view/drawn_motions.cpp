// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/drawn_motions.h"

#include <algorithm>
#include <utility>

#include "experiments/lab/binary_scale.h"

namespace kinex::view {

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

// The largest absolute value of a coefficient on these axes and those after it.
Rational largest_of(const ExactPiece& piece, std::size_t axis) {
  Rational largest;
  for (; axis < piece.coordinates.size(); ++axis) {
    for (const Rational& x : piece.coordinates[axis]) largest = std::max(largest, lab::absolute(x));
  }
  return largest.is_zero() ? Rational(1) : largest;
}

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
        if (scene.has_bodies() && own.coordinates.size() > 2) continue;  // the rotor
        for (const Rational& x : own.coordinates.back()) largest = std::max(largest, lab::absolute(x));
      }
    }
    for (const Vertex2& vertex : object.polygon) {
      for (const Rational& x : vertex) largest = std::max(largest, lab::absolute(x));
    }
  }
  const Rational scale = largest.is_zero() ? Rational(1) : lab::power_of_two(lab::ceil_log2(largest));
  DrawnMotions result;
  result.scale = scale.to_double();
  result.exact_scale = scale;
  for (const SceneObject& object : scene.objects) {
    auto& polygon = result.polygons.emplace_back();
    for (const Vertex2& vertex : object.polygon) {
      polygon.push_back({(vertex[0] / scale).to_double(), (vertex[1] / scale).to_double()});
    }
  }
  for (std::vector<ExactPiece>& pieces : exact) {
    const bool line = scene.objects[result.objects.size()].line;
    std::vector<DrawnPiece>& drawn = result.objects.emplace_back();
    for (ExactPiece& piece : pieces) {
      const Rational turn = scene.has_bodies() ? largest_of(piece, 2) : scale;
      for (const std::vector<Rational>& c : piece.coordinates) {
        std::vector<double>& out = piece.drawn.coordinates.emplace_back();
        const bool slope = line && piece.drawn.coordinates.size() == 1;
        const Rational by = piece.drawn.coordinates.size() > 2 ? turn : slope ? Rational(1) : scale;
        for (const Rational& x : c) out.push_back((x / by).to_double());
      }
      drawn.push_back(std::move(piece.drawn));
    }
  }
  return result;
}

}  // namespace kinex::view

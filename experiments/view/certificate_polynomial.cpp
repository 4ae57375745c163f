// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/certificate_polynomial.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace kinex {

MotionsInForce::MotionsInForce(const Scene& scene)
    : scene_(scene), trajectories_(scene.objects.size(), nullptr) {
  for (ObjectId object = 0; object < trajectories_.size(); ++object) changed(object, scene.start);
}

void MotionsInForce::changed(ObjectId object, const Rational& t) {
  const MotionPiece* piece = scene_.objects[object].motion.piece_after(t);
  if (piece != nullptr) trajectories_[object] = &piece->trajectory;
}

Polynomial certificate_polynomial(const Predicate& predicate, const Query& query,
                                  const MotionsInForce& motions) {
  int degree = 1;
  std::size_t axes = static_cast<std::size_t>(predicate.dimension());
  for (std::size_t i = 0; i < query.arity; ++i) {
    const Trajectory* trajectory = motions.of(query.ids[i]);
    if (trajectory == nullptr) return {};
    degree = std::max(degree, trajectory->degree());
    axes = std::max(axes, trajectory->coordinates.size());
  }
  const std::size_t powers = static_cast<std::size_t>(degree) + 1;
  std::vector<Rational> numbers(query.arity * axes * powers);
  std::array<MotionView<Rational>, kMaxArity> points{};
  for (std::size_t i = 0; i < query.arity; ++i) {
    Rational* point = &numbers[i * axes * powers];
    points[i] = point;
    const auto& coordinates = motions.of(query.ids[i])->coordinates;
    for (std::size_t a = 0; a < coordinates.size(); ++a) {
      for (std::size_t k = 0; k < std::min(powers, coordinates[a].size()); ++k) {
        point[a * powers + k] = coordinates[a][k];
      }
    }
  }
  return Polynomial::from_rationals(predicate.rational(degree, points.data()));
}

}  // namespace kinex

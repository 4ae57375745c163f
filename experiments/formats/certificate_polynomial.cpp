// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/certificate_polynomial.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace kinex::formats {

MotionsInForce::MotionsInForce(const Scene& scene)
    : scene_(scene), trajectories_(scene.objects.size(), nullptr) {
  for (ObjectId object = 0; object < trajectories_.size(); ++object) changed(object, scene.start);
}

void MotionsInForce::changed(ObjectId object, const Rational& t) {
  const MotionPiece* piece = scene_.objects[object].motion.piece_after(t);
  if (piece != nullptr) trajectories_[object] = &piece->trajectory;
}

Polynomial certificate_polynomial(const Predicate& predicate,
                                  std::span<const Trajectory* const> motions) {
  int degree = 1;
  std::size_t axes = static_cast<std::size_t>(predicate.dimension());
  for (const Trajectory* trajectory : motions) {
    if (trajectory == nullptr) return {};
    degree = std::max(degree, trajectory->degree());
    axes = std::max(axes, trajectory->coordinates.size());
  }
  const std::size_t powers = static_cast<std::size_t>(degree) + 1;
  std::vector<Rational> numbers(motions.size() * axes * powers);
  const Rational one(1);
  std::array<MotionView<Rational>, kMaxViews> points{};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    Rational* point = &numbers[i * axes * powers];
    points[i] = point;
    const auto& coordinates = motions[i]->coordinates;
    for (std::size_t a = 0; a < coordinates.size(); ++a) {
      for (std::size_t k = 0; k < std::min(powers, coordinates[a].size()); ++k) {
        point[a * powers + k] = coordinates[a][k];
      }
    }
  }
  points[motions.size()] = &one;
  return Polynomial::from_rationals(predicate.rational(degree, points.data()));
}

Polynomial certificate_polynomial(const Predicate& predicate, const Query& query,
                                  const DerivedObjects& motions) {
  std::array<const Trajectory*, kMaxArity> of{};
  for (std::size_t i = 0; i < query.arity; ++i) of[i] = &motions.trajectory(query.ids[i]);
  return certificate_polynomial(predicate, std::span(of.data(), query.arity));
}

}  // namespace kinex::formats

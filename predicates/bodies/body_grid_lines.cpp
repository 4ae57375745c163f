// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/body_grid_lines.h"

#include <algorithm>
#include <utility>

namespace kinex {

std::optional<BodyGridLines> BodyGridLines::over(Kernel& kernel, const Scene& scene,
                                                 const Rational& largest_radius) {
  if (!scene.end) return std::nullopt;
  Rational farthest;
  for (const SceneObject& object : scene.objects) {
    for (const MotionPiece& piece : object.motion.pieces) {
      const Rational from = piece.from ? std::max(*piece.from, scene.start) : scene.start;
      const Rational to = piece.to ? std::min(*piece.to, *scene.end) : *scene.end;
      if (to < from) continue;
      for (int axis = 0; axis < 2; ++axis) {
        for (const Rational& t : {from, to}) {
          const Rational x = piece.trajectory.position(axis, t);
          farthest = std::max(farthest, x.sign() < 0 ? -x : x);
        }
      }
    }
  }
  const Rational cells(static_cast<int>(64 + scene.objects.size()));
  Rational width = Rational(2) * largest_radius;
  // Doubled, so that short numbers stay short.
  while (width * cells < farthest) width *= Rational(2);
  return BodyGridLines(kernel, std::move(width));
}

ObjectId BodyGridLines::line(std::int64_t k) {
  const auto [place, is_new] = lines_.try_emplace(k, kNoObject);
  if (is_new) {
    const Rational at = Rational(k) * width_;
    place->second = kernel_->constant(at.to_string(), {at});
  }
  return place->second;
}

std::size_t BodyGridLines::bytes() const {
  constexpr std::size_t kNode = 48;
  return lines_.size() * (sizeof(std::int64_t) + sizeof(ObjectId) + kNode);
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that appear, or jump, after the scene's start must not overlap others.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "core/numbers/time_text.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/placed_body.h"
#include "experiments/formats/scene_parts.h"

namespace kinex::formats {

namespace {

// False if the object certainly does not exist right after t. O(1).
bool may_exist(const Motion& motion, const Rational& t) {
  if (motion.pieces.empty()) return false;
  const MotionPiece& first = motion.pieces.front();
  const MotionPiece& last = motion.pieces.back();
  return (!first.from || *first.from <= t) && (!last.to || t < *last.to);
}

double radius_of(const Polygon2& polygon) {
  double most = 0;
  for (const Vertex2& v : polygon) {
    most = std::max(most, std::hypot(v[0].to_double(), v[1].to_double()));
  }
  return most;
}

// A place in doubles, and an upper bound on its rounding error.
struct RoughPlace {
  RoughPlace(const Trajectory& trajectory, double t) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double power = 1;
      for (const Rational& c : trajectory.coordinates[axis]) {
        const double term = c.to_double() * power;
        at[axis] += term;
        error += std::abs(term) * 1e-9;
        power *= t;
      }
    }
  }
  double at[2] = {0, 0};
  double error = 0;
};

}  // namespace

void check_appearances(const JsonNode& objects, const Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& body = scene.objects[i];
    const MotionPiece* before = nullptr;
    for (const MotionPiece& piece : body.motion.pieces) {
      const MotionPiece* last = before;
      before = &piece;
      if (!piece.from || *piece.from <= scene.start || (scene.end && *piece.from >= *scene.end)) {
        continue;
      }
      const Rational& t = *piece.from;
      const bool jumps = last != nullptr;
      if (jumps && last->trajectory.meets(piece.trajectory, t, true)) continue;
      const RoughPlace here(piece.trajectory, t.to_double());
      const double radius = radius_of(body.polygon);
      std::optional<Polygon2> placed;
      for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        const SceneObject& other = scene.objects[k];
        objects.poll();
        if (k == i || !may_exist(other.motion, t)) continue;
        const MotionPiece* there = other.motion.piece_after(t);
        if (there == nullptr) continue;
        const RoughPlace place(there->trajectory, t.to_double());
        const double reach =
            (radius + radius_of(other.polygon)) * (1 + 1e-9) + here.error + place.error;
        if (std::hypot(here.at[0] - place.at[0], here.at[1] - place.at[1]) > reach) continue;
        if (!placed) placed = placed_polygon(body.polygon, piece.trajectory, t);
        if (contact_of(*placed, placed_polygon(other.polygon, there->trajectory, t)) !=
            Contact::kOverlapping) {
          continue;
        }
        objects.at(i).fail("the body " + show_text(body.id) + (jumps ? " jumps" : " appears") +
                               " at " + time_text(t) + " into " + show_text(other.id),
                           std::string("let it come, or jump, to where it is apart from all "
                                       "others") +
                               kOverlappingStartsRemedy);
      }
    }
  }
}

}  // namespace kinex::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/weights.h"

#include <string>
#include <utility>

#include "core/numbers/time_text.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/scene_reader.h"

namespace kinex::formats {

namespace {

constexpr const char* kWeight = "weight";

std::vector<Rational>& last_axis(MotionPiece& piece) {
  return piece.trajectory.coordinates.back();
}

void append(MotionPiece& piece, std::vector<Rational> weight) {
  piece.trajectory.coordinates.push_back(std::move(weight));
  piece.trajectory.normalise();
}

void refuse_others(const JsonNode& node, const Scene& scene, bool body) {
  if (body) node.fail("a weight of a body", "remove it: points alone have weights");
  if (scene.objects.back().line) {
    node.fail("\"weight\" of a line", "remove it, or \"line\": true");
  }
  if (scene.extents == Extents::kRadius || scene.extents == Extents::kHalfExtents) {
    const bool disc = scene.extents == Extents::kRadius;
    node.fail(std::string("a weight of a ") + (disc ? "disc" : "box"),
              std::string("remove it, or the \"") + (disc ? "radius" : "half_extents") + "\"");
  }
}

void check_seam(MotionPiece& before, MotionPiece& after, const JsonNode& node, const Scene& scene) {
  if (scene.jumps || !before.to || before.to != after.from) return;
  if (last_axis(before) == last_axis(after)) return;
  const int axis = after.trajectory.dimension() - 1;
  const Rational there = before.trajectory.position(axis, *after.from);
  const Rational here = after.trajectory.position(axis, *after.from);
  if (there == here) return;
  node.fail("the weight jumps at " + time_text(*after.from) + " from " + time_text(there) + " to " +
                time_text(here),
            "make the pieces meet, or say \"jumps\": true in the scene");
}

}  // namespace

std::vector<Rational> read_weight(const JsonNode& node) {
  if (!node.is(JsonValue::Kind::kArray)) return {node.rational()};
  return read_coefficients(node, kMaxExtentDegree, kWeight);
}

bool add_weights(const JsonNode& object, const Scene& scene, Motion& motion) {
  const bool body = object.find("polygon").has_value();
  const auto beside = object.find(kWeight);
  if (beside) refuse_others(*beside, scene, body);
  const JsonNode pieces = object.member("motion");
  const bool in_pieces = pieces.at(0).is(JsonValue::Kind::kObject);
  std::size_t found = 0;
  for (std::size_t i = 0; in_pieces && i < pieces.size(); ++i) {
    const JsonNode entry = pieces.at(i);  // nodes refer to those above them
    const auto node = entry.find(kWeight);
    if (!node) continue;
    ++found;
    refuse_others(*node, scene, body);
    if (beside) {
      node->fail("a weight of a flight plan whose object has one", "remove one of the two");
    }
  }
  if (beside) append_weight(motion, read_weight(*beside));
  if (found == 0) return beside.has_value();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const JsonNode entry = pieces.at(i);
    const auto node = entry.find(kWeight);
    if (!node) {
      entry.fail("\"weight\" is missing",
                 "give every flight plan of the object a weight, or write one beside its motion");
    }
    append(motion.pieces[i], read_weight(*node));
    if (i > 0) check_seam(motion.pieces[i - 1], motion.pieces[i], *node, scene);
  }
  return true;
}

void append_weight(Motion& motion, const std::vector<Rational>& weight) {
  for (MotionPiece& piece : motion.pieces) append(piece, weight);
}

void complete_weights(Scene& scene) {
  scene.extents = Extents::kWeight;
  for (SceneObject& object : scene.objects) {
    const bool has = object.motion.pieces.front().trajectory.dimension() > scene.dimension;
    if (!has) append_weight(object.motion, {Rational()});
  }
}

std::optional<std::vector<Rational>> common_weight(const SceneObject& object, const Scene& scene) {
  const auto axis = static_cast<std::size_t>(scene.dimension);
  const std::vector<MotionPiece>& pieces = object.motion.pieces;
  const std::vector<Rational>& first = pieces.front().trajectory.coordinates[axis];
  for (const MotionPiece& piece : pieces) {
    if (piece.trajectory.coordinates[axis] != first) return std::nullopt;
  }
  return first;
}

}  // namespace kinex::formats

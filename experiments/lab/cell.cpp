// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/cell.h"

namespace kinex::lab {

namespace {

void negate_coordinates(Scene& scene) {
  for (SceneObject& object : scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      for (std::vector<Rational>& axis : piece.trajectory.coordinates) {
        for (Rational& coefficient : axis) coefficient = -coefficient;
      }
    }
  }
}

}  // namespace

std::string Cell::workload_text() const {
  std::string text = workload;
  if (parameters.m != 0 && parameters.m != parameters.n) {
    text += " m=" + std::to_string(parameters.m);
  }
  if (parameters.dimension != 0) text += " " + std::to_string(parameters.dimension) + "d";
  if (parameters.degree != 1) text += " degree " + std::to_string(parameters.degree);
  if (parameters.separation) text += " s=" + parameters.separation->to_string();
  if (parameters.turns != -1) text += " turns=" + std::to_string(parameters.turns);
  if (const std::string changes = changes_text(); !changes.empty()) text += " " + changes;
  return text;
}

std::string Cell::changes_text() const {
  std::string text = mirrored ? "mirrored" : "";
  if (change != nullptr) text += (text.empty() ? "" : " ") + std::string(change->name);
  return text;
}

Scene scene_of(const Cell& cell, int k) {
  WorkloadParameters parameters = cell.parameters;
  parameters.seed += static_cast<std::uint64_t>(k);
  Scene scene = generate_scene(cell.workload, parameters, cell.structure);
  if (cell.mirrored) {
    negate_coordinates(scene);
    scene.name += " mirrored";
  }
  if (cell.change != nullptr) {
    cell.change->apply(scene, k);
    scene.name += " " + std::string(cell.change->name) + " " + std::to_string(k);
  }
  return scene;
}

}  // namespace kinex::lab

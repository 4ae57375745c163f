// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/cell.h"

#include <stdexcept>

namespace kinex {

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
  if (mirrored) text += " mirrored";
  return text;
}

Scene scene_of(const Cell& cell, int k) {
  const Workload* workload = find_workload(cell.workload);
  if (workload == nullptr) throw std::invalid_argument("no workload " + cell.workload);
  WorkloadParameters parameters = cell.parameters;
  parameters.seed += static_cast<std::uint64_t>(k);
  Scene scene = generate_scene(*workload, parameters);
  if (cell.mirrored) {
    negate_coordinates(scene);
    scene.name += " mirrored";
  }
  Request request;
  request.structure = cell.structure;
  request.label = cell.structure;
  scene.maintain = {request};
  return scene;
}

}  // namespace kinex

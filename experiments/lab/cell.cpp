// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/cell.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/lab/turned_scene.h"

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
  if (mirrored) text += " mirrored";
  if (turned) text += " turned";
  return text;
}

double variable_of(const Cell& cell, Variable variable) {
  const WorkloadParameters& p = cell.parameters;
  const Workload* workload = find_workload(cell.workload);
  const auto separation = [&] {
    const std::optional<Rational>& known = p.separation ? p.separation : workload->separation;
    if (!known) throw std::invalid_argument("no separation in " + cell.workload);
    return known->to_double();
  };
  const auto mu = [&] {
    const int m = p.m == 0 ? (workload->default_m == 0 ? p.n : workload->default_m) : p.m;
    return std::min<double>(p.n + m, std::sqrt(2 / separation()));
  };
  switch (variable) {
    case Variable::kMu:
      return mu();
    case Variable::kLogMu:
      return std::log2(mu());
    case Variable::kHalvings:
      return std::log2(4 / separation());
    case Variable::kObjects:
    case Variable::kVertices:
      break;
  }
  return p.n;
}

std::string variable_name(Variable variable) {
  switch (variable) {
    case Variable::kObjects:
      return "objects n";
    case Variable::kVertices:
      return "vertices n";
    case Variable::kMu:
      return "mu";
    case Variable::kLogMu:
      return "log2 mu";
    case Variable::kHalvings:
      return "halvings of the distance";
  }
  return "";
}

Scene scene_of(const Cell& cell, int k) {
  WorkloadParameters parameters = cell.parameters;
  parameters.seed += static_cast<std::uint64_t>(k);
  Scene scene = generate_scene(cell.workload, parameters, cell.structure);
  if (cell.mirrored) {
    negate_coordinates(scene);
    scene.name += " mirrored";
  }
  if (cell.turned) {
    turn_scene(scene, k);
    scene.name += " turned " + std::to_string(k);
  }
  return scene;
}

}  // namespace kinex::lab

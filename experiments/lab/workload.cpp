// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/workload.h"

#include <stdexcept>
#include <utility>

#include "core/numbers/show_number.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/lab/colours.h"
#include "experiments/lab/family.h"
#include "experiments/lab/workload_parts.h"
#include "structures/registry.h"

namespace kinex::lab {

namespace {

[[noreturn]] void refuse(const Workload& workload, const char* option, const std::string& problem,
                         const std::string& remedy) {
  throw formats::InputError(std::string(workload.name), option, problem, remedy);
}

void check_body_parameters(const Workload& workload, const WorkloadParameters& parameters) {
  if (parameters.separation && !workload.separation) {
    refuse(workload, "--separation", "this workload takes none", "leave --separation out");
  }
  if (parameters.separation && parameters.separation->sign() <= 0) {
    refuse(workload, "--separation", show_number(*parameters.separation) + " is no distance",
           "write a number greater than 0");
  }
  if (parameters.separation && workload.min_separation &&
      *parameters.separation < *workload.min_separation) {
    refuse(workload, "--separation", show_number(*parameters.separation) + " is too near",
           "write " + workload.min_separation->to_string() + " or more");
  }
  if (parameters.separation && workload.max_separation &&
      *workload.max_separation < *parameters.separation) {
    refuse(workload, "--separation", show_number(*parameters.separation) + " is too far",
           "write " + workload.max_separation->to_string() + " or less");
  }
  if (parameters.turns != -1 && !workload.takes_turns) {
    refuse(workload, "--turns", "this workload takes none", "leave --turns out");
  }
  if (!workload.takes_turns) return;
  if (parameters.turns < workload.min_turns || parameters.turns > kMaxWorkloadTurns) {
    refuse(workload, "--turns",
           formats::counted(static_cast<std::uint64_t>(parameters.turns), "turn", "turns"),
           formats::write_between(workload.min_turns, kMaxWorkloadTurns));
  }
}

void check_parameters(const Workload& workload, const WorkloadParameters& parameters) {
  if (parameters.n < workload.min_n || parameters.n > kMaxWorkloadSize) {
    refuse(workload, "--n", std::to_string(parameters.n) + " " + std::string(workload.n_counts),
           formats::write_between(workload.min_n, kMaxWorkloadSize));
  }
  if (parameters.m != 0 && !workload.takes_m) {
    refuse(workload, "--m", "this workload has one size only", "leave --m out");
  }
  const int min_m = workload.takes_m ? workload.min_m : 0;
  if (parameters.m < min_m || parameters.m > kMaxWorkloadSize) {
    refuse(workload, "--m", std::to_string(parameters.m) + " " + std::string(workload.m_counts),
           formats::write_between(workload.min_m, kMaxWorkloadSize));
  }
  if (parameters.degree != 1 && !workload.takes_degree) {
    refuse(workload, "--degree", "this workload has a degree of its own", "leave --degree out");
  }
  if (parameters.degree < 1 || parameters.degree > kMaxWorkloadDegree) {
    refuse(workload, "--degree", "degree " + std::to_string(parameters.degree),
           formats::write_between(1, kMaxWorkloadDegree));
  }
  if (parameters.dimension < workload.min_dimension ||
      parameters.dimension > workload.max_dimension) {
    refuse(workload, "--dimension", "dimension " + std::to_string(parameters.dimension),
           formats::write_between(workload.min_dimension, workload.max_dimension));
  }
  check_body_parameters(workload, parameters);
}

std::string describe(const Workload& workload, const WorkloadParameters& parameters) {
  std::string name(workload.name);
  name += " n=" + std::to_string(parameters.n);
  if (workload.takes_m) name += " m=" + std::to_string(parameters.m);
  if (workload.takes_degree && parameters.degree != 1) {
    name += " degree=" + std::to_string(parameters.degree);
  }
  if (parameters.dimension != workload.default_dimension) {
    name += " dimension=" + std::to_string(parameters.dimension);
  }
  if (workload.separation) name += " separation=" + parameters.separation->to_string();
  if (workload.takes_turns) name += " turns=" + std::to_string(parameters.turns);
  if (workload.random) name += " seed=" + std::to_string(parameters.seed);
  return name;
}

}  // namespace

void set_kind(std::vector<Workload>& all, SceneKind kind,
              const std::vector<std::string_view>& names) {
  for (Workload& workload : all) {
    for (const std::string_view name : names) {
      if (workload.name == name) workload.scenes = kind;
    }
  }
}

void set_sizes(std::vector<Workload>& all, const std::vector<SizeWords>& words) {
  for (Workload& workload : all) {
    for (const SizeWords& one : words) {
      if (workload.name != one.name) continue;
      workload.n_counts = one.n;
      workload.m_counts = one.m;
    }
  }
}

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> kWorkloads = [] {
    std::vector<Workload> all;
    for (const FamilyExperiments& family : experiment_families()) {
      all.insert(all.end(), family.workloads.begin(), family.workloads.end());
    }
    return all;
  }();
  return kWorkloads;
}

const Workload* find_workload(std::string_view name) {
  for (const Workload& workload : workloads()) {
    if (workload.name == name) return &workload;
  }
  return nullptr;
}

WorkloadParameters resolved(const Workload& workload, WorkloadParameters parameters) {
  if (parameters.dimension == 0) parameters.dimension = workload.default_dimension;
  if (parameters.m == 0 && workload.takes_m) {
    parameters.m = workload.default_m == 0 ? parameters.n : workload.default_m;
  }
  if (!parameters.separation) parameters.separation = workload.separation;
  if (workload.takes_turns && parameters.turns == -1) parameters.turns = 1;
  check_parameters(workload, parameters);
  return parameters;
}

Scene generate_scene(const Workload& workload, WorkloadParameters parameters) {
  parameters = resolved(workload, std::move(parameters));
  Scene scene;
  scene.name = describe(workload, parameters);
  scene.dimension = parameters.dimension;
  workload.generate(parameters, scene);
  Request request;
  request.structure = workload.maintain.empty()
                          ? usual_structure(workload.bodies, parameters.dimension)
                          : kinex::usual_structure(Reading{workload.maintain}, parameters.dimension);
  request.label = request.structure;
  if (!request.structure.empty()) scene.maintain.push_back(std::move(request));
  name_colours(scene);
  return scene;
}

void join_vertices(Scene& scene) {
  if (scene.dimension != 1 || scene.has_bodies()) return;
  int u = 0, v = 1;
  for (SceneObject& object : scene.objects) {
    if (!object.ends.empty()) return;
    object.ends = {"v" + std::to_string(u), "v" + std::to_string(v)};
    if (++u == v) {
      u = 0;
      ++v;
    }
  }
}

void give_extents(Scene& scene, Extents extents) {
  if (scene.has_bodies() || scene.extents != Extents::kNone || extents == Extents::kNone) return;
  Rational spread(1);
  for (int axis = 0; axis < scene.dimension; ++axis) {
    std::optional<Rational> low, high;
    for (const SceneObject& object : scene.objects) {
      const MotionPiece& first = object.motion.pieces.front();
      const Rational x = first.trajectory.position(axis, first.from.value_or(scene.start));
      if (!low || x < *low) low = x;
      if (!high || *high < x) high = x;
    }
    if (low && *high - *low > spread) spread = *high - *low;
  }
  std::int64_t root = 1;  // at least the square root of n
  while (static_cast<std::size_t>(root * root) < scene.objects.size()) root *= 2;
  const int axes = extents == Extents::kHalfExtents ? scene.dimension : 1;
  std::int64_t k = 0;
  for (SceneObject& object : scene.objects) {
    for (int axis = 0; axis < axes; ++axis) {
      k = (5 * k + 3) % 16;
      const Rational half = spread * fraction(4 + k % 13, 48 * root);
      const Rational value = extents == Extents::kWeight ? half * half : half;
      for (MotionPiece& piece : object.motion.pieces) piece.trajectory.coordinates.push_back({value});
    }
  }
  scene.extents = extents;
}

void make_lines(Scene& scene, LineUse lines) {
  if (lines == LineUse::kNone || scene.dimension != 2 || scene.has_bodies()) return;
  if (scene.extents != Extents::kNone || scene.has_lines()) return;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    scene.objects[i].line = lines == LineUse::kAlone || i % 2 == 0;
  }
}

Scene generate_scene(std::string_view workload, const WorkloadParameters& parameters,
                     std::string_view structure) {
  const Workload* known = find_workload(workload);
  if (known == nullptr) throw std::invalid_argument("no workload " + std::string(workload));
  Scene scene = generate_scene(*known, parameters);
  Request request;
  request.structure = request.label = structure;
  scene.maintain = {std::move(request)};
  const StructureInfo* const info = find_structure_info(structure);
  if (info != nullptr && info->graph) join_vertices(scene);
  if (info != nullptr) give_extents(scene, info->usual_extents());
  if (info != nullptr) make_lines(scene, info->lines);
  name_colours(scene);
  return scene;
}

}  // namespace kinex::lab

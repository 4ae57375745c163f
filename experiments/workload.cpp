// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workload.h"

#include "experiments/input_error.h"
#include "experiments/workloads/families.h"
#include "experiments/workloads/polygons.h"
#include "structures/registry.h"

namespace kinex {

namespace {

[[noreturn]] void refuse(const Workload& workload, const char* option, const std::string& problem,
                         const std::string& remedy) {
  throw InputError(std::string(workload.name), option, problem, remedy);
}

std::string range(int low, int high) {
  if (low == high) return "write " + std::to_string(low);
  return "write a number from " + std::to_string(low) + " to " + std::to_string(high);
}

void check_body_parameters(const Workload& workload, const WorkloadParameters& parameters) {
  if (parameters.separation && !workload.separation) {
    refuse(workload, "--separation", "this family takes none", "leave --separation out");
  }
  if (parameters.separation && parameters.separation->sign() <= 0) {
    refuse(workload, "--separation", parameters.separation->to_string() + " is no distance",
           "write a number greater than 0");
  }
  if (parameters.separation && workload.min_separation &&
      *parameters.separation < *workload.min_separation) {
    refuse(workload, "--separation", parameters.separation->to_string() + " is too near",
           "write " + workload.min_separation->to_string() + " or more");
  }
  if (parameters.separation && workload.max_separation &&
      *workload.max_separation < *parameters.separation) {
    refuse(workload, "--separation", parameters.separation->to_string() + " is too far",
           "write " + workload.max_separation->to_string() + " or less");
  }
  if (parameters.turns != -1 && !workload.takes_turns) {
    refuse(workload, "--turns", "this family takes none", "leave --turns out");
  }
  if (!workload.takes_turns) return;
  if (parameters.turns < workload.min_turns || parameters.turns > kMaxWorkloadTurns) {
    refuse(workload, "--turns", std::to_string(parameters.turns) + " turns",
           range(workload.min_turns, kMaxWorkloadTurns));
  }
}

void check_parameters(const Workload& workload, const WorkloadParameters& parameters) {
  if (parameters.n < workload.min_n || parameters.n > kMaxWorkloadSize) {
    refuse(workload, "--n",
           std::to_string(parameters.n) + (workload.min_n > 1 ? " vertices" : " objects"),
           range(workload.min_n, kMaxWorkloadSize));
  }
  if (parameters.m != 0 && !workload.takes_m) {
    refuse(workload, "--m", "this family has one size only", "leave --m out");
  }
  const int min_m = workload.takes_m ? workload.min_m : 0;
  if (parameters.m < min_m || parameters.m > kMaxWorkloadSize) {
    refuse(workload, "--m",
           std::to_string(parameters.m) + (workload.min_m > 1 ? " vertices" : " objects"),
           range(workload.min_m, kMaxWorkloadSize));
  }
  if (parameters.degree != 1 && !workload.takes_degree) {
    refuse(workload, "--degree", "this family has a degree of its own", "leave --degree out");
  }
  if (parameters.degree < 1 || parameters.degree > kMaxWorkloadDegree) {
    refuse(workload, "--degree", "degree " + std::to_string(parameters.degree),
           range(1, kMaxWorkloadDegree));
  }
  if (parameters.dimension < workload.min_dimension ||
      parameters.dimension > workload.max_dimension) {
    refuse(workload, "--dimension", "dimension " + std::to_string(parameters.dimension),
           range(workload.min_dimension, workload.max_dimension));
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

// Empty if there is none for the family.
std::string_view default_structure(const Workload& workload, int dimension) {
  if (!workload.maintain.empty()) return workload.maintain;
  if (!workload.bodies) return dimension == 2 ? "delaunay_2" : "sorted_list";
  for (const StructureInfo& info : structure_infos()) {
    if (info.follows_bodies()) return info.name;
  }
  return "";
}

std::vector<Workload> point_workloads() {
  return {
      {"uniform-square", "origin and destination uniform in the unit square (interval, cube)", 2, 1,
       3, true, true, false, "", generate_uniform_square},
      {"uniform-disk", "origin and destination uniform in the unit disk (interval, ball)", 2, 1, 3,
       true, true, false, "", generate_uniform_disk},
      {"gaussian", "origin and destination normally distributed", 2, 1, 3, true, true, false, "",
       generate_gaussian},
      {"grid", "an integer grid with integer velocities: full of ties", 2, 1, 3, true, false, false,
       "", generate_grid},
      {"lattice", "random starts; all on an integer lattice at t = 1", 2, 1, 3, true, false, false,
       "", generate_lattice},
      {"sort-worst", "every pair swaps --degree times", 1, 1, 1, false, true, false, "sorted_list",
       generate_sort_worst},
      {"tournament-worst", "n log2(n) - n + 1 failures of a kinetic tournament; n a power of two",
       1, 1, 1, false, false, false, "maximum_tournament", generate_tournament_worst},
      {"heap-worst", "as many failures of a kinetic heap as the sum of its depths", 1, 1, 1, false,
       false, false, "maximum_heap", generate_heap_worst},
      {"hull-worst", "a convex hull of --m slow and --n moving points that changes 2nm - 1 times",
       2, 2, 2, false, false, true, "delaunay_2", generate_hull_worst},
      {"meet", "objects meet in pairs at t = 1/2", 2, 1, 3, true, false, false, "", generate_meet},
      {"through-one-point", "all objects pass through one point at t = 1/2", 2, 1, 3, true, false,
       false, "", generate_through_one_point},
      {"near-one-point", "all objects pass within 2^-60 of one point at t = 1/2", 2, 1, 3, true,
       false, false, "", generate_near_one_point},
      {"collinear-instant", "all objects are on one line at t = 1/2", 2, 2, 2, true, false, false,
       "", generate_collinear_instant},
      {"counter-rotating-rings", "two concentric rings turn against each other", 2, 2, 2, false,
       false, false, "", generate_counter_rotating_rings},
      {"expanding-circle", "cocircular for ever, moving outwards", 2, 2, 2, false, false, false, "",
       generate_expanding_circle},
      {"rotating-circle", "cocircular for ever, turning", 2, 2, 2, false, false, false, "",
       generate_rotating_circle},
      {"static-one-mover", "one object crosses n - 1 objects at rest", 2, 1, 3, true, false, false,
       "", generate_static_one_mover},
      {"new-plans", "random motion; --m times an object heads for another destination", 2, 1, 3,
       true, false, true, "", generate_new_plans},
      {"come-and-go", "random motion; half of the objects appear, and half disappear, on the way",
       2, 1, 3, true, false, false, "", generate_come_and_go},
  };
}

}  // namespace

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> kWorkloads = [] {
    std::vector<Workload> all = point_workloads();
    all.insert(all.end(), polygon_workloads().begin(), polygon_workloads().end());
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

Scene generate_scene(const Workload& workload, WorkloadParameters parameters) {
  if (parameters.dimension == 0) parameters.dimension = workload.default_dimension;
  if (parameters.m == 0 && workload.takes_m) {
    parameters.m = workload.default_m == 0 ? parameters.n : workload.default_m;
  }
  if (!parameters.separation) parameters.separation = workload.separation;
  if (workload.takes_turns && parameters.turns == -1) parameters.turns = 1;
  check_parameters(workload, parameters);
  Scene scene;
  scene.name = describe(workload, parameters);
  scene.dimension = parameters.dimension;
  workload.generate(parameters, scene);
  Request request;
  request.structure = default_structure(workload, parameters.dimension);
  request.label = request.structure;
  if (!request.structure.empty()) scene.maintain.push_back(std::move(request));
  return scene;
}

}  // namespace kinex

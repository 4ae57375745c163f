// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/workloads.h"

namespace kinex::families {

std::vector<lab::Workload> point_workloads() {
  std::vector<lab::Workload> all = {
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
      {"meet", "objects meet in pairs at t = 1/2", 2, 1, 3, true, false, false, "", generate_meet},
      {"through-one-point", "all objects pass through one point at t = 1/2", 2, 1, 3, true, false,
       false, "", generate_through_one_point},
      {"near-one-point", "all objects pass within 2^-60 of one point at t = 1/2", 2, 1, 3, true,
       false, false, "", generate_near_one_point},
      {"collinear-instant", "all objects are on one line at t = 1/2", 2, 2, 2, true, false, false,
       "", generate_collinear_instant},
      {"counter-rotating-rings", "two concentric rings turn against each other", 2, 2, 2, false,
       false, false, "", generate_counter_rotating_rings},
      {"expanding-circle", "always cocircular, moving outwards", 2, 2, 2, false, false, false, "",
       generate_expanding_circle},
      {"rotating-circle", "always cocircular, turning", 2, 2, 2, false, false, false, "",
       generate_rotating_circle},
      {"static-one-mover", "one object crosses n - 1 objects at rest", 2, 1, 3, true, false, false,
       "", generate_static_one_mover},
      {"new-plans", "random motion; --m times an object heads for another destination", 2, 1, 3,
       true, false, true, "", generate_new_plans},
      {"come-and-go", "random motion; half of the objects appear, and half disappear, on the way",
       2, 1, 3, true, false, false, "", generate_come_and_go},
      {"walks", "random walks, as recorded ten times a second; --m flight plans an object", 2, 1, 3,
       true, false, true, "", generate_walks, 1, 1, 20},
  };
  using lab::SceneKind;
  lab::set_kind(all, SceneKind::kRandom, {"uniform-square", "uniform-disk", "gaussian"});
  lab::set_kind(
      all, SceneKind::kTies,
      {"grid", "lattice", "meet", "through-one-point", "near-one-point", "collinear-instant",
       "counter-rotating-rings", "expanding-circle", "rotating-circle"});
  lab::set_kind(all, SceneKind::kNewPlans, {"new-plans", "come-and-go", "walks"});
  lab::set_sizes(all, {{"new-plans", "objects", "new destinations"},
                       {"walks", "objects", "flight plans of each object"}});
  return all;
}

}  // namespace kinex::families

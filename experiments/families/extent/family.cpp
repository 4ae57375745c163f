// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/extent/family.h"

#include "experiments/families/extent/experiments.h"

namespace kinex::families {

lab::FamilyExperiments extent_experiments() {
  lab::FamilyExperiments family;
  family.name = "extent";
  family.workloads = {{"box-worst", "a bounding box that changes --n times in every axis", 2, 1, 3,
                       false, false, false, "bounding_box", generate_box_worst, 3}};
  family.add_cells = add_extent_cells;
  family.trade = {{"bounding_box",
                   2,
                   {32, 128},
                   "box-worst",
                   {16, 48},
                   {36, 100},
                   {16, 48},
                   {{16, 64, 256}, {16, 64, 256, 1024}}}};
  return family;
}

}  // namespace kinex::families

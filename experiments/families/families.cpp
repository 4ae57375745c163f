// SPDX-License-Identifier: GPL-3.0-or-later
// All families of experiments: the one place where a family is listed.
#include "experiments/families/arrangement/family.h"
#include "experiments/families/collision/family.h"
#include "experiments/families/extent/family.h"
#include "experiments/families/hull/family.h"
#include "experiments/families/maximum/family.h"
#include "experiments/families/order/family.h"
#include "experiments/families/points/family.h"
#include "experiments/families/proximity/family.h"
#include "experiments/families/range/family.h"
#include "experiments/families/triangulation/family.h"

// Declared in experiments/lab/family.h: the laboratory walks over the list and does not know it.
namespace kinex::lab {

const std::vector<lab::FamilyExperiments>& experiment_families() {
  static const std::vector<lab::FamilyExperiments> kFamilies{
      families::point_experiments(),     families::order_experiments(),
      families::maximum_experiments(),   families::triangulation_experiments(),
      families::hull_experiments(),      families::collision_experiments(),
      families::extent_experiments(),    families::proximity_experiments(),
      families::range_experiments(),     families::arrangement_experiments()};
  return kFamilies;
}

}  // namespace kinex::lab

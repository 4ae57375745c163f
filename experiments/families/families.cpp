// SPDX-License-Identifier: GPL-3.0-or-later
// All families of experiments: the one place where a family is listed.
#include "experiments/families/collision/family.h"
#include "experiments/families/extent/family.h"
#include "experiments/families/hull/family.h"
#include "experiments/families/maximum/family.h"
#include "experiments/families/order/family.h"
#include "experiments/families/points/family.h"
#include "experiments/families/proximity/family.h"
#include "experiments/families/triangulation/family.h"

namespace kinex {

const std::vector<FamilyExperiments>& experiment_families() {
  static const std::vector<FamilyExperiments> kFamilies{
      point_experiments(),         order_experiments(), maximum_experiments(),
      triangulation_experiments(), hull_experiments(),  collision_experiments(),
      extent_experiments(),        proximity_experiments()};
  return kFamilies;
}

}  // namespace kinex

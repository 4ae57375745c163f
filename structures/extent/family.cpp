// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/family.h"

#include <utility>

#include "structures/extent/bounding_box.h"
#include "structures/extent/calipers_family.h"
#include "structures/extent/circle_family.h"
#include "structures/extent/direction_structures.h"

namespace kinex {

StructureFamily extent_family() {
  StructureInfo box{.name = "bounding_box",
                    .summary = "the extreme points of every axis, by tournament trees"};
  box.any_dimension = true;
  box.shape = Attribute::Shape::kSequence;
  box.kinds = {
      {"replace", Effect::kSometimes, "another point wins a match for a side"},
      {"tie", Effect::kNever, "another point wins a match: the coordinates are identically equal"}};
  box.certificates = "n - 1 for each side of the box, one for each match of its tournament";
  box.ties = "of points with identically equal coordinates the smallest id is on the side";
  box.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), sections 5 and 6.7";
  box.role = "box";
  box.make = make_plain<BoundingBox>;
  StructureFamily family{"extent", {box}};
  for (StructureInfo& info : caliper_structures()) family.structures.push_back(std::move(info));
  for (StructureInfo& info : circle_structures()) family.structures.push_back(std::move(info));
  for (StructureInfo& info : direction_structures()) family.structures.push_back(std::move(info));
  return family;
}

}  // namespace kinex

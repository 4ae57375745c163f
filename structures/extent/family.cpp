// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/family.h"

#include "structures/extent/bounding_box.h"

namespace kinex {

StructureFamily extent_family() {
  StructureInfo box{.name = "bounding_box",
                    .summary = "the extreme points of every axis, by tournament trees"};
  box.any_dimension = true;
  box.shape = Attribute::Shape::kSequence;
  box.kinds = {{"replace", Effect::kSometimes}, {"tie", Effect::kNever}};
  box.make = make_plain<BoundingBox>;
  return {"extent", {box}};
}

}  // namespace kinex

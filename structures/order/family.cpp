// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/order/family.h"

#include "structures/order/sorted_list.h"

namespace kinex {

StructureFamily order_family() {
  StructureInfo list{
      .name = "sorted_list",
      .summary = "objects in the order of a key, by certificates between neighbours"};
  list.any_dimension = true;
  list.uses_key = true;
  list.shape = Attribute::Shape::kSequence;
  list.kinds = {{"swap", Effect::kAlways, "two neighbours in the order change places"},
                {"tie", Effect::kAlways,
                 "two neighbours change places: their keys have become identically equal"}};
  list.certificates = "n - 1, one for each pair of neighbours";
  list.ties = "objects with identically equal keys are in the order of their ids";
  list.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 5";
  list.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<SortedList>(in.kernel, in.id, in.request.key, in.scene);
  };
  return {"order", {list}};
}

}  // namespace kinex

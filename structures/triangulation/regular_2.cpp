// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/regular_2.h"

namespace kinex {

Regular2::Regular2(Kernel& kernel, StructureId id, const Scene& scene)
    : PlaneRegular(kernel, id, scene, "edges",
                   RegularTriangulation::Kinds{kShow, kHide, kWitness, kRetile, kBlocked, kTouch}) {
}

std::vector<std::string_view> Regular2::event_kinds() const {
  return common_event_kinds(
      {"flip", "enter", "leave", "show", "hide", "witness", "retile", "blocked", "touch"});
}

void Regular2::flipped(ObjectId u, ObjectId v, ObjectId p, ObjectId q) {
  if (v == store_.infinity()) {
    kernel_->report(id_, kLeave, {u, p, q}, true);
  } else if (q == store_.infinity()) {
    kernel_->report(id_, kEnter, {p, u, v}, true);
  } else {
    kernel_->report(id_, kFlip, {u, v, p, q}, true);
  }
}

}  // namespace kinex

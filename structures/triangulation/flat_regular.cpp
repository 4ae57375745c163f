// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/flat_regular.h"

namespace kinex {

FlatRegular::FlatRegular(Kernel& kernel, StructureId id, std::size_t objects, Extents extents,
                         const FlatKinds& kinds)
    : InPlane(
          kernel, id, objects, extents,
          PlaneKinds{kinds.flip, kinds.enter, kinds.leave, kinds.retile},
          PartNames{"edges", "hidden"},
          Kinds{kinds.show, kinds.hide, kinds.witness, kinds.retile, kinds.blocked, kinds.touch}) {}

void FlatRegular::build(std::span<const ObjectId> objects) {
  empty_ = objects.empty();
  PlaneRegular::build(objects);
}

// On the first axes on which the points are not identically on one line.
void FlatRegular::construct() {
  change_.reset();
  for (std::size_t pair = 0; pair < kAxisPairs.size() && !corrupt_; ++pair) {
    take_axes(pair);
    PlaneRegular::construct();
    if (!flat_ || empty_) break;
  }
}

void FlatRegular::let_go() {
  change_.reset();
  drop_all_certificates();
  drop_all_witnesses();
}

void FlatRegular::certificate_failed(CertificateId failed) {
  change_.reset();
  if (corrupt_) return;
  if (stands_upright()) {
    count_failure(failed);
    return rebuild_because("in projection all points of the plane are on one line");
  }
  PlaneRegular::certificate_failed(failed);
}

// A point that shows or hides changes several edges.
void FlatRegular::report_change(std::uint8_t kind, const Points& points) {
  report_points(kind, points, false);
  kernel_->report_changed_within(id_);
}

std::size_t FlatRegular::wanted() const {
  return flat_ ? 0 : 3 * store_.vertices() - 3 + kClaims * hidden().size();
}

}  // namespace kinex

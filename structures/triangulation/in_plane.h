// SPDX-License-Identifier: GPL-3.0-or-later
// InPlane: what the triangulations of points of space that are all identically in one plane, which may turn, have
// in common: FlatTriangulation of delaunay_3, FlatRegular of regular_3. A part of a structure, whose cells it has
// none of: all of its events are internal, and it tells readers of edges that the structure has changed within.
//
// It works in projection on two axes: the first of xy, xz, yz on which the plane is not identically vertical.
//
// The plane is vertical over its two axes at an instant: all orientations and circles are zero then. If they
// change their signs, the projections of all triangles turn over, and the triangulation stays. It is built
// anew right after the instant, which is a rebuild with a reason, and needs no other axes. Likewise where all
// points meet on a line.
//
//      y          y           y
//      | 0  1     | 0,1       | 1  0      in projection, before, at and after the instant: the plane turns
//      | 2  3     | 2,3       | 3  2      about an axis that is parallel to y
//      '----- x   '----- x    '----- x
#ifndef KINEX_STRUCTURES_TRIANGULATION_IN_PLANE_H
#define KINEX_STRUCTURES_TRIANGULATION_IN_PLANE_H

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "structures/triangulation/plane_flips.h"
#include "structures/triangulation/regular_geometry.h"

namespace kinex {

// A change of one or two edges, smaller id first, or of none.
struct EdgeChange {
  std::optional<std::array<ObjectId, 2>> gone, came;
};

// Base: a PlaneFlips of a SewnTriangulation of the PlaneComplex.
template <class Base>
class InPlane : public Base {
 public:
  std::vector<std::string_view> event_kinds() const override { return {}; }
  // No points.
  void clear() { this->build({}); }
  bool corrupt() const { return this->corrupt_; }
  // What it has changed in its last call, if that was one flip.
  const std::optional<EdgeChange>& change() const { return change_; }
  void forget_change() { change_.reset(); }
  // True if all triangles are upright at that time, in projection, and the hull turns once.
  bool holds_at(const Snapshot& snapshot) const override;

 protected:
  using Geometry = RegularGeometry<PlaneComplex>;
  using Cell = PlaneComplex::Cell;
  // The ranks of its kinds of events.
  struct PlaneKinds {
    std::uint8_t flip, enter, leave, retile;
  };

  // `extents`: as of the geometry. `base`: what Base takes behind the geometry.
  template <class... Some>
  InPlane(Kernel& kernel, StructureId id, std::size_t objects, Extents extents, PlaneKinds kinds,
          Some&&... base)
      : Base(kernel, id, objects,
             Geometry(kernel, kAxisPairs[0], extents, static_cast<ObjectId>(objects)),
             std::forward<Some>(base)...),
        extents_(extents),
        plane_kinds_(kinds) {
    geometries_[0] = this->geometry_;
  }

  const Geometry& on_axes(std::size_t pair);
  // From now on it works on this pair of axes.
  void take_axes(std::size_t pair) {
    pair_ = pair;
    this->geometry_ = on_axes(pair);
  }
  // At now itself no triangle has an area in projection: looked at once at an instant.
  virtual bool stands_upright();
  const AxisPair& axes() const { return kAxisPairs[pair_]; }

  void flipped(ObjectId u, ObjectId v, ObjectId p, ObjectId q) override;
  void tell_sewn(const AttributeDifference& change) override;
  void tell_rebuilt(const std::string& reason, const AttributeDifference&) override {
    this->kernel_->count_rebuild(this->id_, reason);
  }

  std::optional<EdgeChange> change_;
  std::uint64_t flips_ = 0;

 private:
  Extents extents_;
  PlaneKinds plane_kinds_;
  std::array<std::optional<Geometry>, 3> geometries_;  // that were needed so far
  std::size_t pair_ = 0;                               // the axes in use, of kAxisPairs
  // The number of the last instant at which it could have been vertical.
  std::uint64_t looked_at_ = 0;
};

template <class Base>
const RegularGeometry<PlaneComplex>& InPlane<Base>::on_axes(std::size_t pair) {
  std::optional<Geometry>& geometry = geometries_[pair];
  if (!geometry) {
    geometry.emplace(*this->kernel_, kAxisPairs[pair], extents_, this->store_.infinity());
  }
  return *geometry;
}

// Two triangles of the hull fail or touch zero then, so that the instant is shared.
template <class Base>
bool InPlane<Base>::stands_upright() {
  if (!this->kernel_->tells_sign_now() || !this->kernel_->instant_is_shared(this->id_)) {
    return false;
  }
  if (looked_at_ == this->kernel_->instant_number()) return false;
  looked_at_ = this->kernel_->instant_number();
  const Triangulation2& store = this->store_;
  for (Cell t = 0; t < store.triangle_capacity(); ++t) {
    if (!store.live(t) || store.ghost(t)) continue;
    const Query orientation = this->geometry_.orientation_claim(store.corners(t));
    if (this->kernel_->sign(orientation, When::kNow) != Sign::kZero) return false;
  }
  return true;
}

// ---- what is reported

template <class Base>
void InPlane<Base>::flipped(ObjectId u, ObjectId v, ObjectId p, ObjectId q) {
  const ObjectId infinity = this->store_.infinity();
  ++flips_;
  EdgeChange change;
  if (v != infinity) change.gone = {u, v};
  if (q != infinity) change.came = {p, q};
  if (v == infinity) {
    this->kernel_->report(this->id_, plane_kinds_.leave, {u, p, q}, false);
  } else if (q == infinity) {
    this->kernel_->report(this->id_, plane_kinds_.enter, {p, u, v}, false);
  } else {
    this->kernel_->report(this->id_, plane_kinds_.flip, {u, v, p, q}, false);
  }
  change_ = change;
  this->kernel_->report_changed_within(this->id_);
}

template <class Base>
void InPlane<Base>::tell_sewn(const AttributeDifference& change) {
  change_.reset();
  this->kernel_->report(this->id_, plane_kinds_.retile, {}, false);
  if (!change.gone.empty() || !change.came.empty()) {
    this->kernel_->report_changed_within(this->id_);
  }
}

}  // namespace kinex

#endif

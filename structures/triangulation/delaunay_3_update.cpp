// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3: construction, insertion, erasure and new motions.
#include <algorithm>

#include "structures/triangulation/delaunay_3.h"
#include "structures/triangulation/edge_winding.h"

namespace kinex {

void Delaunay3::build(std::span<const ObjectId> objects) {
  points_.set_present(objects);
  construct();
}

void Delaunay3::construct() {
  drop_all_certificates();
  points_.reset();
  forget_instant();
  hint_ = kNone;
  const std::vector<ObjectId> objects = points_.members();
  for (const ObjectId id : objects) points_.show(id);
  std::vector<std::pair<ObjectId, ObjectId>> hidden;
  const StaticResult built = build_static(geometry_, objects, true, store_, hidden);
  if (built == StaticResult::kFailed)
    return give_up("the static construction found no place for a point");
  for (const auto& [v, behind] : hidden) points_.hide(v, behind);
  flat_ = built == StaticResult::kFlat;
  certify_everything();
  construct_plane();
}

// The triangulation of all points in one plane, if they are. Three points need none: their pairs are all that
// it could have for edges.
void Delaunay3::construct_plane() {
  std::vector<ObjectId> vertices;
  for (ObjectId v = 0; v < objects() && flat_; ++v) {
    if (points_.is_vertex(v)) vertices.push_back(v);
  }
  if (vertices.size() < 4) vertices.clear();
  if (plane_ == nullptr) {
    if (vertices.empty()) return;
    plane_ = std::make_unique<FlatTriangulation>(
        *kernel_, id_, objects(),
        FlatTriangulation::FlatKinds{kPlaneFlip, kPlaneEnter, kPlaneLeave, kPlaneRetile,
                                     kPlaneBlocked, kPlaneTouch, kLinePass});
  }
  plane_->build(vertices);
  corrupt_ = plane_->corrupt();
}

StaticResult Delaunay3::build_patch(std::span<const ObjectId> vertices) {
  hidden_in_patch_.clear();
  return build_static(geometry_, vertices, false, patch_, hidden_in_patch_);
}

void Delaunay3::sewn() {
  for (const auto& [v, behind] : hidden_in_patch_) points_.hide(v, behind);
}

void Delaunay3::add_windings(const std::vector<Cell>& near, std::vector<Cell>& wrong) {
  kinex::add_windings(geometry_, store_, near, wrong);
}

void Delaunay3::insert(ObjectId object) {
  if (corrupt_) return;
  comes_or_goes_ = true;
  points_.set_present(object, true);
  if (flat_) {
    construct();
  } else {
    put_in(object);
  }
  comes_or_goes_ = false;
  untold_.clear();
}

void Delaunay3::erase(ObjectId object) {
  if (corrupt_) return;
  if (plane_ != nullptr) plane_->forget_change();
  comes_or_goes_ = true;
  points_.set_present(object, false);
  if (!points_.is_vertex(object)) {
    points_.reveal(object);
  } else if (flat_) {
    construct();
  } else {
    take_out(object);
  }
  points_.forget(object);
  comes_or_goes_ = false;
  untold_.clear();
}

void Delaunay3::motions_changed(std::span<const ObjectId> objects) {
  moved_.insert(moved_.end(), objects.begin(), objects.end());
  if (corrupt_) return;
  if (flat_) {
    if (plane_ != nullptr) plane_->let_go();
    return;
  }
  for (const ObjectId v : objects) renew_about(v);
}

void Delaunay3::instant_settled() {
  if (corrupt_) return;
  if (plane_ != nullptr) plane_->forget_change();
  if (!flat_ || !moved_.empty()) return SewnTriangulation::instant_settled();
  if (plane_ != nullptr) plane_->instant_settled();
}

// New motions while all points are in one plane.
void Delaunay3::sort_out_flat() {
  SewnTriangulation::sort_out_flat();
  if (corrupt_ || !flat_) return;
  if (planar()) {
    kernel_->count_rebuild(id_, "new motions in a common plane");
  } else {
    kernel_->report_changed_within(id_);  // equal points may have parted
  }
}

// The point becomes a vertex, or is hidden behind an equal one; the smaller id is the vertex.
void Delaunay3::put_in(ObjectId object) {
  const PointPlace<SpaceComplex> place = locate<SpaceComplex>(geometry_, store_, object, hint());
  const ObjectId vertex = place.equal;
  if (vertex != kNoObject && vertex < object) return points_.hide(object, vertex);
  points_.show(object);
  if (vertex != kNoObject) {
    std::vector<Cell> cells;
    store_.star(vertex, cells);
    if (!sew(cells, {{vertex}, {object}}))
      return rebuild_because("insertion in place of an equal point");
    return points_.hide(vertex, object);
  }
  if (place.cell != kNone) {
    find_conflicts<SpaceComplex>(geometry_, store_, object, place.cell, conflicts_);
    if (fill(conflicts_.cells, conflicts_.star)) return;
  }
  rebuild_because("insertion at a degenerate instant");
}

// Removes the vertex; the smallest of the points hidden behind it comes forward.
void Delaunay3::take_out(ObjectId vertex) {
  Guests guests{{vertex}, {}};
  const std::vector<ObjectId> behind = points_.reveal_behind(vertex);
  if (!behind.empty()) {
    guests.came = {behind.front()};
    points_.show(behind.front());
    for (std::size_t i = 1; i < behind.size(); ++i) points_.hide(behind[i], behind.front());
  }
  std::vector<Cell> cells;
  store_.star(vertex, cells);
  if (!sew(cells, guests)) rebuild_because("erasure of a point whose cells are everywhere");
}

// Hidden points that no longer coincide with their vertex become vertices.
void Delaunay3::settle_hidden() {
  const std::vector<ObjectId> parted = points_.reveal_parted(
      moved_, [this](ObjectId a, ObjectId b) { return geometry_.equal(a, b, When::kRightAfter); });
  for (const ObjectId v : parted) {
    if (corrupt_ || flat_ || points_.vertex_of(v) != kNoObject) continue;  // rebuilt with them
    put_in(v);
  }
}

}  // namespace kinex

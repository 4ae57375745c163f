// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: construction, insertion, erasure and new motions.
#include <algorithm>

#include "structures/triangulation/regular_2.h"

namespace kinex {

void Regular2::build(std::span<const ObjectId> objects) {
  std::fill(present_.begin(), present_.end(), false);
  for (const ObjectId id : objects) present_[id] = true;
  construct();
}

void Regular2::rebuild() {
  if (corrupt_) return;
  construct();
  untold_.clear();
}

void Regular2::rebuild_because(const std::string& reason) {
  if (corrupt_) return;
  AttributeDifference change;
  if (comes_or_goes_) {
    construct();
  } else {
    const Attribute before = told();
    construct();
    if (!corrupt_) change = difference_between(before, attribute());
  }
  untold_.clear();
  kernel_->count_rebuild(id_, reason, change.gone, change.came);
}

void Regular2::retract_all() {
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (store_.live(Triangulation2::triangle(h))) drop_certificate(h);
  }
  for (ObjectId h = 0; h < witness_.size(); ++h) drop_witness(h);
}

void Regular2::construct() {
  retract_all();
  waiting_.clear();
  witness_ties_.clear();
  suspects_.clear();
  has_last_change_ = false;
  hint_ = kNone;
  std::vector<ObjectId> objects;
  for (ObjectId id = 0; id < present_.size(); ++id) {
    if (present_[id]) objects.push_back(id);
  }
  const StaticResult built = build_static(geometry_, objects, true, store_);
  if (built == StaticResult::kFailed) {
    return give_up("the static construction found no place for a point");
  }
  flat_ = built == StaticResult::kFlat;
  for (HalfEdge h = 0; h < store_.half_edge_capacity() && !corrupt_; ++h) {
    if (store_.live(Triangulation2::triangle(h)) && h < store_.twin(h)) set_certificate(h);
  }
  if (flat_) return;
  for (const ObjectId id : objects) {
    if (corrupt_ || store_.has(id)) continue;
    const Triangle t = locate(geometry_, store_, id, hint());
    if (t == kNone || geometry_.conflict(store_, t, id)) {
      return give_up("the static construction hides a point that shows");
    }
    hint_ = t;
    set_witness(id, t);
  }
}

void Regular2::insert(ObjectId object) {
  if (corrupt_) return;
  comes_or_goes_ = true;
  present_[object] = true;
  if (flat_) {
    construct();
  } else {
    put_in(object);
    settle_hidden();
  }
  comes_or_goes_ = false;
  untold_.clear();
}

void Regular2::erase(ObjectId object) {
  if (corrupt_) return;
  comes_or_goes_ = true;
  present_[object] = false;
  for (ObjectId h = 0; h < witness_.size(); ++h) {
    if (witness_[h].names(object)) wait(h);
  }
  drop_witness(object);
  if (flat_) {
    construct();
  } else if (store_.has(object)) {
    std::vector<Triangle> cells;
    star_of(object, cells);
    if (!sew(cells, {{object}, {}})) {
      rebuild_because("erasure of a point whose triangles are everywhere");
    }
  }
  if (!flat_) settle_hidden();
  comes_or_goes_ = false;
  untold_.clear();
}

void Regular2::motions_changed(std::span<const ObjectId> objects) {
  moved_.insert(moved_.end(), objects.begin(), objects.end());
  if (corrupt_) return;
  witness_ties_.note_of(witnesses_, objects);
  for (const ObjectId v : objects) renew_about(v);
}

// A point that is neither a vertex nor has a witness becomes the one or gets the other.
void Regular2::put_in(ObjectId object) {
  const Triangle t = locate_hidden(object);
  if (t == kNone) return rebuild_because("a point was not found");
  if (!geometry_.conflict(store_, t, object)) return set_witness(object, t);
  find_conflicts(geometry_, store_, object, t, conflicts_);
  const bool everywhere = conflicts_.cells.size() >= store_.triangles();
  if (!everywhere && fill(conflicts_.cells, conflicts_.star)) return;
  if (everywhere || !sew(conflicts_.cells, {{}, {object}})) {
    rebuild_because("a point shows at a degenerate instant");
  }
}

// New motions while all points are on one line.
void Regular2::sort_out_line() {
  construct();
  if (corrupt_ || flat_) return;
  kernel_->count_rebuild(id_, "points leave their common line", {}, attribute().ids);
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3: construction, insertion, erasure and new motions.
#include <algorithm>

#include "structures/triangulation/delaunay_3.h"

namespace kinex {

void Delaunay3::build(std::span<const ObjectId> objects) {
  std::fill(present_.begin(), present_.end(), false);
  for (const ObjectId id : objects) present_[id] = true;
  construct();
}

void Delaunay3::rebuild() {
  if (corrupt_) return;
  construct();
  untold_.clear();
}

void Delaunay3::rebuild_because(const std::string& reason) {
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

void Delaunay3::retract_all() {
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c)) continue;
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) drop_certificate(f);
  }
}

void Delaunay3::construct() {
  retract_all();
  hidden_.clear();
  suspects_.clear();
  has_last_flip_ = false;
  hint_ = kNone;
  std::vector<ObjectId> objects;
  for (ObjectId id = 0; id < present_.size(); ++id) {
    representative_[id] = present_[id] ? id : kNoObject;
    if (present_[id]) objects.push_back(id);
  }
  std::vector<std::pair<ObjectId, ObjectId>> hidden;
  const StaticResult built = build_static(geometry_, objects, true, store_, hidden);
  if (built == StaticResult::kFailed)
    return give_up("the static construction found no place for a point");
  for (const auto& [v, behind] : hidden) hide(v, behind);
  flat_ = built == StaticResult::kFlat;
  for (Cell c = 0; c < store_.cell_capacity() && !corrupt_; ++c) {
    if (!store_.live(c)) continue;
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      if (f < store_.mate(f)) set_certificate(f);
    }
  }
}

void Delaunay3::hide(ObjectId object, ObjectId behind) {
  std::vector<ObjectId>& list = hidden_[behind];
  const auto put = [&](ObjectId v) {
    representative_[v] = behind;
    list.insert(std::lower_bound(list.begin(), list.end(), v), v);
  };
  put(object);
  const auto own = hidden_.find(object);
  if (own == hidden_.end()) return;
  for (const ObjectId v : own->second) put(v);
  hidden_.erase(own);
}

// `object` is no longer hidden.
void Delaunay3::reveal(ObjectId object) {
  const auto it = hidden_.find(representative_[object]);
  std::vector<ObjectId>& list = it->second;
  list.erase(std::lower_bound(list.begin(), list.end(), object));
  if (list.empty()) hidden_.erase(it);
  representative_[object] = kNoObject;
}

void Delaunay3::insert(ObjectId object) {
  if (corrupt_) return;
  comes_or_goes_ = true;
  present_[object] = true;
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
  comes_or_goes_ = true;
  present_[object] = false;
  if (representative_[object] != object) {
    reveal(object);
  } else if (flat_) {
    construct();
  } else {
    take_out(object);
  }
  representative_[object] = kNoObject;
  comes_or_goes_ = false;
  untold_.clear();
}

void Delaunay3::motions_changed(std::span<const ObjectId> objects) {
  moved_.insert(moved_.end(), objects.begin(), objects.end());
}

// The point becomes a vertex, or is hidden behind an equal one; the smaller id is the vertex.
void Delaunay3::put_in(ObjectId object) {
  const Cell hint = hint_ != kNone && hint_ < store_.cell_capacity() && store_.live(hint_)
                        ? hint_
                        : store_.cell_of(store_.infinity());
  const PlaceInSpace place = locate(geometry_, store_, object, hint);
  const ObjectId vertex = place.equal;
  if (vertex != kNoObject && vertex < object) return hide(object, vertex);
  representative_[object] = object;
  if (vertex != kNoObject) {
    std::vector<Cell> cells;
    store_.star(vertex, cells);
    if (!sew(cells, {{vertex}, {object}}))
      return rebuild_because("insertion in place of an equal point");
    return hide(vertex, object);
  }
  if (place.cell != kNone) {
    find_conflicts(geometry_, store_, object, place.cell, conflicts_);
    if (fill(conflicts_.cells, conflicts_.star)) return;
  }
  rebuild_because("insertion at a degenerate instant");
}

// Removes the vertex; the smallest of the points hidden behind it comes forward.
void Delaunay3::take_out(ObjectId vertex) {
  Guests guests{{vertex}, {}};
  if (const auto it = hidden_.find(vertex); it != hidden_.end()) {
    const std::vector<ObjectId> behind = it->second;
    hidden_.erase(it);
    guests.came = {behind.front()};
    representative_[behind.front()] = behind.front();
    for (std::size_t i = 1; i < behind.size(); ++i) hide(behind[i], behind.front());
  }
  std::vector<Cell> cells;
  store_.star(vertex, cells);
  if (!sew(cells, guests)) rebuild_because("erasure of a point whose cells are everywhere");
}

// Hidden points that no longer coincide with their vertex become vertices.
void Delaunay3::part_hidden() {
  std::vector<ObjectId> parted;
  const auto look_at = [&](ObjectId v, ObjectId vertex) {
    if (!geometry_.identical(v, vertex)) parted.push_back(v);
  };
  for (const ObjectId v : moved_) {
    if (!present_[v]) continue;
    if (representative_[v] != v) {
      look_at(v, representative_[v]);
    } else if (const auto it = hidden_.find(v); it != hidden_.end()) {
      for (const ObjectId other : it->second) look_at(other, v);
    }
  }
  std::sort(parted.begin(), parted.end());
  parted.erase(std::unique(parted.begin(), parted.end()), parted.end());
  for (const ObjectId v : parted) reveal(v);
  for (const ObjectId v : parted) {
    if (corrupt_ || flat_ || representative_[v] != kNoObject) continue;  // rebuilt with all of them
    put_in(v);
  }
}

// New motions while all points are in one plane.
void Delaunay3::sort_out_plane() {
  construct();
  if (corrupt_ || flat_) return;
  kernel_->count_rebuild(id_, "points leave their common plane", {}, attribute().ids);
}

}  // namespace kinex

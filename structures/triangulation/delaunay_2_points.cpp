// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2: insertion (Bowyer 1981, Watson 1981) and deletion (by ears: Devillers 1999) of one
// point, right after now.
#include <algorithm>

#include "structures/triangulation/delaunay_2.h"

namespace kinex {

bool Delaunay2::identical(ObjectId a, ObjectId b) const {
  return kernel_->sign_after(order_[0], {a, b}) == Sign::kZero &&
         kernel_->sign_after(order_[1], {a, b}) == Sign::kZero;
}

// Requires d on the line through a and b.
bool Delaunay2::strictly_between(ObjectId d, ObjectId a, ObjectId b) const {
  Sign along = kernel_->sign_after(order_[0], {a, b});
  const PredicateId order = along != Sign::kZero ? order_[0] : order_[1];
  if (along == Sign::kZero) along = kernel_->sign_after(order, {a, b});
  return along != Sign::kZero && kernel_->sign_after(order, {a, d}) == along &&
         kernel_->sign_after(order, {d, b}) == along;
}

// True if d (finite) is inside the circle of the triangle; for a ghost, if d is beyond its hull
// edge or on the edge itself.
bool Delaunay2::conflict(ObjectId a, ObjectId b, ObjectId c, ObjectId d) const {
  const ObjectId infinity = store_.infinity();
  if (a != infinity && b != infinity && c != infinity) {
    return kernel_->sign_after(in_circle_, {a, b, c, d}) == Sign::kPositive;
  }
  const ObjectId x = a == infinity ? b : b == infinity ? c : a;
  const ObjectId y = a == infinity ? c : b == infinity ? a : b;
  const Sign side = turn(x, y, d);
  return side == Sign::kPositive || (side == Sign::kZero && strictly_between(d, x, y));
}

bool Delaunay2::conflict(Triangle t, ObjectId d) const {
  return conflict(store_.origin(3 * t), store_.origin(3 * t + 1), store_.origin(3 * t + 2), d);
}

// Walks from the triangle of `hint` towards d, across edges that have d on their other side. The
// walk ends in a valid Delaunay triangulation (Devillers, Pion, Teillaud 2002); if it does not,
// nothing is found.
Delaunay2::Place Delaunay2::locate(ObjectId d, HalfEdge hint) const {
  const ObjectId infinity = store_.infinity();
  Place place;
  Triangle t = Triangulation2::triangle(hint);
  for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
    if (store_.origin(h) == infinity) {
      t = Triangulation2::triangle(store_.twin(Triangulation2::next(h)));
      break;
    }
  }
  HalfEdge entered = kNone;
  for (std::size_t steps = store_.triangles() + 1; steps != 0; --steps) {
    HalfEdge onwards = kNone;
    HalfEdge on[3];
    int zeros = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const HalfEdge h = 3 * t + (static_cast<unsigned>(steps) + k) % 3;
      if (h == entered) continue;
      const Sign side = turn(store_.origin(h), store_.target(h), d);
      if (side == Sign::kNegative) {
        onwards = store_.twin(h);
        break;
      }
      if (side == Sign::kZero) on[zeros++] = h;
    }
    if (onwards != kNone) {
      t = Triangulation2::triangle(onwards);
      entered = onwards;
      if (store_.apex(onwards) != infinity) continue;
      place.triangle = t;
      return place;
    }
    if (zeros == 3) return place;  // a flat triangle
    if (zeros == 2) {
      place.equal = store_.origin(Triangulation2::next(on[0]) == on[1] ? on[1] : on[0]);
    } else {
      place.triangle = t;
    }
    return place;
  }
  return place;
}

Delaunay2::Insertion Delaunay2::add_point(ObjectId d, HalfEdge hint, bool careful) {
  const Place place = locate(d, hint);
  if (place.equal != kNoObject) {
    if (careful && !identical(d, place.equal)) return Insertion::kFailed;
    points_.hide(d, place.equal);
    return Insertion::kHidden;
  }
  if (place.triangle == kNone || !conflict(place.triangle, d)) return Insertion::kFailed;
  mark_.resize(store_.triangle_capacity(), 0);
  const std::uint32_t inside = ++epoch_, outside = ++epoch_;
  cavity_.assign(1, place.triangle);
  mark_[place.triangle] = inside;
  for (std::size_t i = 0; i < cavity_.size(); ++i) {
    for (HalfEdge h = 3 * cavity_[i]; h < 3 * cavity_[i] + 3; ++h) {
      const Triangle s = Triangulation2::triangle(store_.twin(h));
      if (mark_[s] == inside || mark_[s] == outside) continue;
      mark_[s] = conflict(s, d) ? inside : outside;
      if (mark_[s] == inside) cavity_.push_back(s);
    }
  }
  if (certify_) {
    for (const Triangle t : cavity_) {
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        if (mark_[Triangulation2::triangle(store_.twin(h))] == inside) {
          drop_certificate(h);
        } else if (careful && !upright(store_.origin(h), store_.target(h), d)) {
          return Insertion::kFailed;
        }
      }
    }
  }
  const std::size_t told = untold_.size();
  if (certify_) note_edges(cavity_, inside);
  if (!store_.star(d, cavity_, rim_)) {
    untold_.cut(told);
    return Insertion::kFailed;
  }
  points_.show(d);
  hint_ = store_.out(d);
  if (certify_) {
    for (const HalfEdge h : rim_) {
      if (store_.origin(h) != store_.infinity()) untold_.came({d, store_.origin(h)});
    }
    for (const HalfEdge h : rim_) {
      set_certificate(h);
      set_certificate(Triangulation2::next(h));
    }
  }
  return Insertion::kVertex;
}

// Notes the edges inside the cavity, which disappear.
void Delaunay2::note_edges(const std::vector<Triangle>& cavity, std::uint32_t inside) {
  for (const Triangle t : cavity) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const ObjectId a = store_.origin(h), b = store_.target(h);
      if (a < b && b != store_.infinity() &&
          mark_[Triangulation2::triangle(store_.twin(h))] == inside) {
        untold_.gone({a, b});
      }
    }
  }
}

// ---- deletion

// True if the corner `at` of the remaining polygon corners_ can be cut off: the triangle is
// positively oriented and no other corner is in conflict with it. witness_ remembers a corner in
// conflict.
bool Delaunay2::is_ear(std::uint32_t at) {
  const std::uint32_t before = corner_previous_[at], after = corner_next_[at];
  const ObjectId a = corners_[before], b = corners_[at], c = corners_[after];
  if (!upright(a, b, c)) return false;
  for (std::uint32_t i = corner_next_[after]; i != before; i = corner_next_[i]) {
    if (corners_[i] == store_.infinity() || !conflict(a, b, c, corners_[i])) continue;
    witness_[at] = i;
    return false;
  }
  return true;
}

// Cuts the polygon corners_ into Delaunay triangles, ears_. False if that is impossible.
bool Delaunay2::plan_ears() {
  const auto k = static_cast<std::uint32_t>(corners_.size());
  corner_next_.resize(k);
  corner_previous_.resize(k);
  witness_.assign(k, kNone);
  for (std::uint32_t i = 0; i < k; ++i) {
    corner_next_[i] = i + 1 == k ? 0 : i + 1;
    corner_previous_[i] = i == 0 ? k - 1 : i - 1;
  }
  // A corner that was cut off has itself as its successor.
  ears_.clear();
  std::uint32_t at = 0, tries = 0;
  std::uint32_t left = k;
  while (left > 3) {
    if (tries++ > left) return false;
    const std::uint32_t before = corner_previous_[at], after = corner_next_[at];
    const std::uint32_t w = witness_[at];
    const bool blocked = w != kNone && corner_next_[w] != w && w != before && w != after;
    if (blocked || !is_ear(at)) {
      at = after;
      continue;
    }
    ears_.push_back({before, at, after});
    corner_next_[before] = after;
    corner_previous_[after] = before;
    corner_next_[at] = at;
    witness_[before] = witness_[after] = kNone;
    --left;
    tries = 0;
    at = before;
  }
  const std::uint32_t before = corner_previous_[at], after = corner_next_[at];
  ears_.push_back({before, at, after});
  return upright(corners_[before], corners_[at], corners_[after]);
}

// True if the planned ears and their surroundings make a triangulation: no edge twice, and no two
// triangles on the same three corners, ghosts included. In a valid triangulation this fails only if all
// other points are on one line; at a degenerate instant what surrounds the hole may be folded over it.
bool Delaunay2::ears_fit() {
  beyond_.clear();  // the vertex opposite to the side from corner i to the next one, on its other side
  for (const HalfEdge h : link_) beyond_.push_back(store_.apex(store_.twin(h)));
  for (std::size_t i = 0; i < ears_.size(); ++i) {
    const auto [before, at, after] = ears_[i];
    const ObjectId a = corners_[before], b = corners_[at], c = corners_[after];
    const bool last = i + 1 == ears_.size();
    if (beyond_[before] == c || beyond_[at] == a || (last && beyond_[after] == b)) return false;
    if (!last && store_.adjacent(std::min(a, c), std::max(a, c))) return false;
    beyond_[before] = b;
  }
  return true;
}

// False, with nothing changed, if the hole cannot be filled or all others are on one line.
bool Delaunay2::remove_vertex(ObjectId v) {
  store_.link(v, link_);
  corners_.clear();
  for (const HalfEdge h : link_) corners_.push_back(store_.origin(h));
  std::vector<ObjectId> sorted = corners_;
  std::sort(sorted.begin(), sorted.end());
  if (sorted.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end() ||
      std::binary_search(sorted.begin(), sorted.end(), v) || !plan_ears() || !ears_fit()) {
    return false;
  }
  const ObjectId infinity = store_.infinity();
  for (const ObjectId corner : corners_) {
    if (corner != infinity) untold_.gone({v, corner});
  }
  for (std::size_t i = 0; i + 1 < ears_.size(); ++i) {
    const ObjectId a = corners_[ears_[i][0]], b = corners_[ears_[i][2]];
    if (a != infinity && b != infinity) untold_.came({a, b});
  }
  for (const HalfEdge h : link_) drop_certificate(Triangulation2::next(h));
  store_.fill(v, ears_, filled_);
  points_.forget(v);
  hint_ = 3 * filled_[0];
  mark_.resize(store_.triangle_capacity(), 0);
  const std::uint32_t fresh = ++epoch_;
  for (const Triangle t : filled_) mark_[t] = fresh;
  for (const Triangle t : filled_) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdge g = store_.twin(h);
      if (h < g || mark_[Triangulation2::triangle(g)] != fresh) set_certificate(h);
    }
  }
  return true;
}

}  // namespace kinex

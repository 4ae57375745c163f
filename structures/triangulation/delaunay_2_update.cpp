// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2: insertion, erasure, new motions, and the repair of degenerate instants.
#include <algorithm>
#include <utility>

#include "structures/parts/sort_unique.h"
#include "structures/triangulation/delaunay_2.h"

namespace kinex {

void Delaunay2::insert(ObjectId object) {
  if (corrupt_) return;
  const std::size_t told = untold_.size();
  comes_or_goes_ = true;
  points_.set_present(object, true);
  put_in_anywhere(object);
  comes_or_goes_ = false;
  untold_.cut(told);
}

void Delaunay2::put_in_anywhere(ObjectId object) {
  if (on_line_) return remake_line("insertion while all points are on one line");
  if (!put_in(object)) rebuild_because("insertion at a degenerate instant");
  settle_ties(false);
}

void Delaunay2::erase(ObjectId object) {
  if (corrupt_) return;
  const std::size_t told = untold_.size();
  comes_or_goes_ = true;
  points_.set_present(object, false);
  take_out_anywhere(object);
  comes_or_goes_ = false;
  untold_.cut(told);
}

void Delaunay2::take_out_anywhere(ObjectId object) {
  if (!points_.is_vertex(object)) return points_.reveal(object);
  if (on_line_) return remake_line("erasure while all points are on one line");
  if (!take_out(object)) return remake_line("erasure leaves all points on one line");
  settle_ties(false);
}

// With at most three points the static algorithm is the update, in constant time. More points on
// one line are built anew, which is counted.
void Delaunay2::remake_line(const std::string& reason) {
  const std::size_t before = on_line_ ? line_.size() : store_.vertices();
  if (before > 3 || !points_.hidden().empty()) return rebuild_because(reason);
  const Attribute edges = attribute();
  construct();
  if (!corrupt_) untold_.add(difference_between(edges, attribute()));
}

void Delaunay2::motions_changed(std::span<const ObjectId> objects) {
  moved_.insert(moved_.end(), objects.begin(), objects.end());
}

// The point becomes a vertex, or is hidden behind an equal one; the smaller id is the vertex.
bool Delaunay2::put_in(ObjectId object) {
  mended_ = true;
  const Insertion done = add_point(object, hint_, true);
  if (done != Insertion::kHidden) return done == Insertion::kVertex;
  const ObjectId vertex = points_.vertex_of(object);
  if (vertex < object) return true;
  points_.reveal(object);
  const std::vector<ObjectId> behind = points_.reveal_behind(vertex);
  if (!remove_vertex(vertex) || add_point(object, hint_, true) != Insertion::kVertex) return false;
  points_.hide(vertex, object);
  for (const ObjectId other : behind) points_.hide(other, object);
  return true;
}

// Removes the vertex; points hidden behind it come forward.
bool Delaunay2::take_out(ObjectId vertex) {
  mended_ = true;
  const std::vector<ObjectId> behind = points_.reveal_behind(vertex);
  if (!remove_vertex(vertex)) return false;
  for (const ObjectId other : behind) {
    if (!put_in(other)) return false;
  }
  return true;
}

// Hidden points that no longer coincide with their vertex become vertices.
bool Delaunay2::reexamine_hidden() {
  const std::vector<ObjectId> parted =
      points_.reveal_parted(moved_, [this](ObjectId a, ObjectId b) { return identical(a, b); });
  for (const ObjectId v : parted) {
    if (!put_in(v)) return false;
    kernel_->report(id_, kReinsert, {v}, false);
  }
  return true;
}

void Delaunay2::instant_settled() {
  if (corrupt_) return;
  sort_unique(moved_);
  if (on_line_) {
    if (!moved_.empty()) {
      const bool apart = points_.hidden().empty();
      remake_line("motion change while all points are on one line");
      for (const auto& [vertex, behind] : points_.hidden()) {
        for (const ObjectId v : behind) {
          if (apart) kernel_->report(id_, kReinsert, {v}, false);
        }
      }
    }
    moved_.clear();
    return;
  }
  suspects_.insert(suspects_.end(), moved_.begin(), moved_.end());
  if (mend() && !reexamine_hidden()) rebuild_because("points part at a degenerate instant");
  // Ties that new motions have made, and those that could not be settled in the midst of the instant.
  for (const ObjectId v : suspects_) {
    if (corrupt_ || on_line_ || !store_.has(v)) continue;
    store_.link(v, link_);
    for (const HalfEdge h : link_) {
      for (const HalfEdge edge : {h, Triangulation2::next(h)}) {
        ties_.note(edge);
        follow_turn(edge);
      }
    }
  }
  if (!corrupt_) settle_ties(true);
  // A point came or went before other certificates had failed: checks the hull that these led to.
  if (mended_ && !suspects_.empty() && !corrupt_ && !on_line_ && !hull_turns_once()) {
    rebuild_because("the hull winds around twice");
  }
  mended_ = mended_ && !suspects_.empty();
  moved_.clear();
  suspects_.clear();
  has_last_quad_ = false;
}

void Delaunay2::instant_over() {
  if (corrupt_ || untold_.size() == 0) return;
  const AttributeDifference change = untold_.take();
  kernel_->report_settled(id_, change.gone, change.came);
  if (change.gone.empty() && change.came.empty()) kernel_->report_changed_within(id_);
}

// Collects finite triangles around the suspects that are not positively oriented right after now.
// True if a suspect is on the hull.
bool Delaunay2::collect_turned(std::vector<Triangle>& turned) {
  turned.clear();
  bool hull = false;
  mark_.resize(store_.triangle_capacity(), 0);
  const std::uint32_t seen = ++epoch_;
  for (const ObjectId v : suspects_) {
    if (!store_.has(v)) continue;
    store_.link(v, link_);
    for (const HalfEdge h : link_) {
      const Triangle t = Triangulation2::triangle(h);
      if (mark_[t] == seen) continue;
      mark_[t] = seen;
      hull = hull || store_.ghost(t);
      if (!upright(t)) turned.push_back(t);
    }
  }
  return hull;
}

// Takes out the points whose triangles have turned over and puts them in again. False if everything
// was rebuilt instead.
bool Delaunay2::mend() {
  sort_unique(suspects_);
  std::vector<Triangle> turned;
  const bool hull = collect_turned(turned);
  if (turned.empty()) {
    // Upright triangles and left turns along the hull make a triangulation unless the hull winds
    // around more than once (the angles at all vertices would then add up to too much).
    const bool winds = hull && !hull_turns_once();
    if (!winds && (!blocked_ || retries_ < kMostRetries)) {
      if (blocked_) {
        ++retries_;
        blocked_ = false;
        restore_certificates();
      }
      return true;
    }
    rebuild_because(winds ? "the hull winds around twice" : "points pass through each other");
    return false;
  }
  std::string reason = store_.vertices() == 3 ? "the only three points pass through one line"
                       : !moved_.empty()      ? "a motion change turns triangles over"
                       : blocked_             ? "points pass through each other"
                                              : "triangles turn over";
  bool good = true;
  blocked_ = false;
  if (turned.size() > std::max<std::size_t>(16, store_.vertices() / 8)) {
    good = false;
    reason += ", in many places";
  }
  std::vector<ObjectId> taken;
  while (good && !turned.empty()) {
    // The vertex of most of them that can be taken out; among several the largest id.
    std::map<ObjectId, int> count;
    for (const Triangle t : turned) {
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) ++count[store_.origin(h)];
    }
    std::vector<std::pair<int, ObjectId>> candidates;
    for (const auto& [v, times] : count) candidates.emplace_back(times, v);
    std::sort(candidates.rbegin(), candidates.rend());
    std::vector<Triangle> left;
    good = false;
    for (const auto& [times, v] : candidates) {
      left.clear();
      for (const Triangle t : turned) {
        if (store_.origin(3 * t) != v && store_.origin(3 * t + 1) != v &&
            store_.origin(3 * t + 2) != v) {
          left.push_back(t);
        }
      }
      good = remove_vertex(v);
      if (!good) continue;
      taken.push_back(v);
      const std::vector<ObjectId> behind = points_.reveal_behind(v);
      taken.insert(taken.end(), behind.begin(), behind.end());
      break;
    }
    turned = left;
  }
  good = good && hull_turns_once();
  std::sort(taken.begin(), taken.end());
  for (std::size_t i = 0; i < taken.size() && good; ++i) {
    good = put_in(taken[i]);
  }
  if (!good) {
    rebuild_because(reason);
    return false;
  }
  if (!exact_ && ++repairs_ > kMostRepairs) {
    give_up("no end of repairs");
    return false;
  }
  reinsertions_ += taken.size();
  for (const ObjectId v : taken) kernel_->report(id_, kReinsert, {v}, false);
  restore_certificates();
  return true;
}

// Around the suspects: edges that lost their certificate because their flip was impossible.
void Delaunay2::restore_certificates() {
  for (const ObjectId v : suspects_) {
    if (!store_.has(v)) continue;
    store_.link(v, link_);
    for (const HalfEdge h : link_) {
      if (store_.label(h) == kNoCertificate) set_certificate(h);
      const HalfEdge spoke = Triangulation2::next(h);
      if (store_.label(spoke) == kNoCertificate) set_certificate(spoke);
    }
  }
}

// Along the hull the direction turns from left to right once: with left turns everywhere the hull
// is then a simple convex polygon.
bool Delaunay2::hull_turns_once() const {
  const std::vector<ObjectId> corners = hull();
  std::vector<bool> forward;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ObjectId a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
    Sign s = kernel_->sign_after(order_[0], {a, b});
    if (s == Sign::kZero) s = kernel_->sign_after(order_[1], {a, b});
    forward.push_back(s == Sign::kPositive);
  }
  int starts = 0;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    if (forward[i] && !forward[i == 0 ? forward.size() - 1 : i - 1]) ++starts;
  }
  return starts == 1;
}

}  // namespace kinex

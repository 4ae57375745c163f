// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/regular_2.h"

#include <algorithm>
#include <array>
#include <utility>

namespace kinex {

Regular2::Regular2(Kernel& kernel, StructureId id, const Scene& scene)
    : RegularTriangulation(kernel, id, scene, "edges",
                           {kShow, kHide, kWitness, kRetile, kBlocked, kTouch}) {}

std::vector<std::string_view> Regular2::event_kinds() const {
  return common_event_kinds(
      {"flip", "enter", "leave", "show", "hide", "witness", "retile", "blocked", "touch"});
}

// A vertex of degree 3 is at an end of the edge.
bool Regular2::repair(Facet h) {
  if (flippable(h)) {
    flip(h);
    return true;
  }
  const ObjectId u = store_.origin(h), v = store_.target(h);
  return hide(std::min(u, v)) || hide(std::max(u, v));
}

// The edge between the apices is not there yet, and both new triangles are upright right after now.
bool Regular2::flippable(HalfEdge h) const {
  const ObjectId u = store_.origin(h), v = store_.target(h);
  const ObjectId p = store_.apex(h), q = store_.apex(store_.twin(h));
  if (p == q || store_.adjacent(std::min(p, q), std::max(p, q))) return false;
  return geometry_.upright({p, u, q}) && geometry_.upright({q, v, p});
}

void Regular2::flip(HalfEdge h) {
  ObjectId u = store_.origin(h), v = store_.target(h);
  ObjectId p = store_.apex(h), q = store_.apex(store_.twin(h));
  const HalfEdge d = store_.flip(h), e = store_.twin(d);
  set_certificate(d);  // first: the arithmetic reuses the polynomial of the failure
  const std::uint64_t zeros = kernel_->possible_zeros();
  const std::array<Facet, 4> rim{Triangulation2::next(d), Triangulation2::previous(d),
                                 Triangulation2::next(e), Triangulation2::previous(e)};
  for (const Facet side : rim) set_certificate(side);
  after_change(rim, zeros);
  if (corrupt_) return;
  if (u > v) std::swap(u, v);
  if (p > q) std::swap(p, q);
  if (v == store_.infinity()) {
    kernel_->report(id_, kLeave, {u, p, q}, true);
  } else if (q == store_.infinity()) {
    kernel_->report(id_, kEnter, {p, u, v}, true);
  } else {
    kernel_->report(id_, kFlip, {u, v, p, q}, true);
  }
}

// Stars of vertices wind around twice only if the hull does.
void Regular2::add_windings(const std::vector<Cell>& near, std::vector<Cell>&) {
  near_hull_ = std::any_of(near.begin(), near.end(), [this](Cell t) { return store_.ghost(t); });
}

void Regular2::settle_hull() {
  if (near_hull_ && !hull_turns_once()) rebuild_because("the hull winds around twice");
}

// Along the hull the direction turns from left to right once: with left turns everywhere the hull is
// then a simple convex polygon.
bool Regular2::hull_turns_once() const {
  if (!store_.has(store_.infinity())) return false;
  std::vector<ObjectId> corners;
  const HalfEdge first = store_.out(store_.infinity());
  HalfEdge at = first;
  do {
    corners.push_back(store_.target(at));
    at = store_.around(at);
  } while (at != first);
  std::vector<bool> forward;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ObjectId a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
    Sign s = kernel_->sign_after(geometry_.order(0), {a, b});
    if (s == Sign::kZero) s = kernel_->sign_after(geometry_.order(1), {a, b});
    forward.push_back(s == Sign::kPositive);
  }
  int starts = 0;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    if (forward[i] && !forward[i == 0 ? forward.size() - 1 : i - 1]) ++starts;
  }
  return starts == 1;
}

}  // namespace kinex

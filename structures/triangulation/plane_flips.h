// SPDX-License-Identifier: GPL-3.0-or-later
// PlaneFlips: the flips of edges of regular_2, and of points in space that are all in one plane, those
// of the hull included; and whether the hull turns once. The picture is in regular_2.h.
#ifndef KINEX_STRUCTURES_TRIANGULATION_PLANE_FLIPS_H
#define KINEX_STRUCTURES_TRIANGULATION_PLANE_FLIPS_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/engine/kernel.h"
#include "structures/triangulation/plane_complex.h"

namespace kinex {

// Base: a SewnTriangulation of the PlaneComplex.
template <class Base>
class PlaneFlips : public Base {
 protected:
  using Base::Base;
  using Cell = PlaneComplex::Cell;
  using HalfEdge = Triangulation2::HalfEdge;

  // The edge u v has given way to p q; u < v, p < q. Infinity is the largest.
  virtual void flipped(ObjectId u, ObjectId v, ObjectId p, ObjectId q) = 0;

  // The edge between the apices is not there yet, and both new triangles are upright right after now.
  bool flippable(HalfEdge h) const {
    const Triangulation2& store = this->store_;
    const ObjectId u = store.origin(h), v = store.target(h);
    const ObjectId p = store.apex(h), q = store.apex(store.twin(h));
    if (p == q || store.adjacent(std::min(p, q), std::max(p, q))) return false;
    return this->geometry_.upright({p, u, q}) && this->geometry_.upright({q, v, p});
  }
  void flip(HalfEdge h);

  // Stars of vertices wind around twice only if the hull does.
  void add_windings(const std::vector<Cell>& near, std::vector<Cell>&) override {
    near_hull_ =
        std::any_of(near.begin(), near.end(), [this](Cell t) { return this->store_.ghost(t); });
  }
  void settle_hull() override {
    if (near_hull_ && !hull_turns_once()) this->rebuild_because("the hull winds around twice");
  }

 private:
  bool hull_turns_once() const;

  bool near_hull_ = false;  // what is settled touches the hull
};

template <class Base>
void PlaneFlips<Base>::flip(HalfEdge h) {
  Triangulation2& store = this->store_;
  ObjectId u = store.origin(h), v = store.target(h);
  ObjectId p = store.apex(h), q = store.apex(store.twin(h));
  const HalfEdge d = store.flip(h), e = store.twin(d);
  this->set_certificate(d);  // first: the arithmetic reuses the polynomial of the failure
  const std::uint64_t zeros = this->kernel_->possible_zeros();
  const std::array<HalfEdge, 4> rim{Triangulation2::next(d), Triangulation2::previous(d),
                                    Triangulation2::next(e), Triangulation2::previous(e)};
  for (const HalfEdge side : rim) this->set_certificate(side);
  this->after_change(rim, zeros);
  if (this->corrupt_) return;
  if (u > v) std::swap(u, v);
  if (p > q) std::swap(p, q);
  flipped(u, v, p, q);
}

// Along the hull the direction turns from left to right once: with left turns everywhere the hull is
// then a simple convex polygon.
template <class Base>
bool PlaneFlips<Base>::hull_turns_once() const {
  const Triangulation2& store = this->store_;
  if (!store.has(store.infinity())) return false;
  std::vector<ObjectId> corners;
  const HalfEdge first = store.out(store.infinity());
  HalfEdge at = first;
  do {
    corners.push_back(store.target(at));
    at = store.around(at);
  } while (at != first);
  std::vector<bool> forward;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ObjectId a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
    Sign s = this->kernel_->sign_after(this->geometry_.order(0), {a, b});
    if (s == Sign::kZero) s = this->kernel_->sign_after(this->geometry_.order(1), {a, b});
    forward.push_back(s == Sign::kPositive);
  }
  int starts = 0;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    if (forward[i] && !forward[i == 0 ? forward.size() - 1 : i - 1]) ++starts;
  }
  return starts == 1;
}

}  // namespace kinex

#endif

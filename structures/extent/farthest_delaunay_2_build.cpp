// SPDX-License-Identifier: GPL-3.0-or-later
// FarthestDelaunay2: changes of the cycle of vertices, and the static construction.
#include <algorithm>
#include <cstdint>

#include "structures/extent/farthest_delaunay_2.h"

namespace kinex {
namespace {

// A fixed permutation of 64-bit numbers (SplitMix64): an order of ids that no scene foresees.
std::uint64_t scattered(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

// ---- the cycle

// The vertices counter-clockwise from the smallest id.
std::vector<ObjectId> FarthestDelaunay2::cycle() const {
  if (store_.vertices() == 0) return few_;
  std::vector<ObjectId> result;
  const HalfEdge first = store_.out(store_.infinity());
  HalfEdge h = first;
  do {  // counter-clockwise around infinity is clockwise around the hull
    result.push_back(store_.target(h));
    h = store_.around(h);
  } while (h != first);
  std::reverse(result.begin(), result.end());
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

// The half-edge between two vertices that has the triangulation on its left and nothing on its
// right; kNone: there is none.
FarthestDelaunay2::HalfEdge FarthestDelaunay2::hull_edge(ObjectId from, ObjectId to) const {
  const HalfEdge first = store_.out(from);
  HalfEdge h = first;
  do {
    if (store_.target(h) == to && store_.apex(store_.twin(h)) == store_.infinity()) return h;
    h = store_.around(h);
  } while (h != first);
  return kNone;
}

bool FarthestDelaunay2::can_enter(ObjectId p, ObjectId a, ObjectId b) const {
  return store_.vertices() >= 3 && !store_.has(p) && store_.has(a) && store_.has(b) &&
         hull_edge(a, b) != kNone;
}

bool FarthestDelaunay2::can_leave(ObjectId p) const {
  return store_.vertices() >= 4 && store_.has(p);
}

// The ear a p b.
void FarthestDelaunay2::enter(ObjectId p, ObjectId a, ObjectId b) {
  const HalfEdge h = hull_edge(a, b);
  if (!store_.star(p, {Triangulation2::triangle(store_.twin(h))}, rim_)) {
    return give_up("a vertex has no place");
  }
  untold_.came({a, p});
  untold_.came({p, b});
  set_certificate(h);
}

// Its diagonals are flipped away: p is an ear then.
void FarthestDelaunay2::leave(ObjectId p) {
  for (;;) {
    const HalfEdge first = store_.out(p);
    HalfEdge h = first;
    while (!is_diagonal(h) && store_.around(h) != first) h = store_.around(h);
    if (!is_diagonal(h)) break;
    flip(h);
  }
  HalfEdge h = store_.out(p);  // from p to its successor, with the ear on the left
  while (to_infinity(h) || store_.apex(h) == store_.infinity()) h = store_.around(h);
  const ObjectId b = store_.target(h), a = store_.apex(h);
  drop_certificate(Triangulation2::next(h));
  store_.fill(p, {{0, 1, 2}}, filled_);
  untold_.gone({a, p});
  untold_.gone({p, b});
}

// Makes the change that an event of the hull states; false if it is not that of one vertex, or
// contradicts what is there.
bool FarthestDelaunay2::follow(const Event& event) {
  const ObjectId p = event.ids[0];
  if (event.has_difference()) return false;
  if (event.kind == HullEvents::kEnter && event.count == 3) {
    if (!can_enter(p, event.ids[1], event.ids[2])) return false;
    enter(p, event.ids[1], event.ids[2]);
    return true;
  }
  if (event.kind != HullEvents::kLeave || !can_leave(p)) return false;
  leave(p);
  return true;
}

// One vertex has come, or gone, and nothing else has changed: makes that change.
bool FarthestDelaunay2::change_one(const std::vector<ObjectId>& before,
                                   const std::vector<ObjectId>& after) {
  const bool comes = after.size() == before.size() + 1;
  if (!comes && before.size() != after.size() + 1) return false;
  const std::vector<ObjectId>& more = comes ? after : before;
  const std::vector<ObjectId>& fewer = comes ? before : after;
  for (std::size_t i = 0; i < more.size(); ++i) {
    std::vector<ObjectId> rest = more;
    const ObjectId p = more[i];
    if (std::find(fewer.begin(), fewer.end(), p) != fewer.end()) continue;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    if (rest.empty()) return false;
    std::rotate(rest.begin(), std::min_element(rest.begin(), rest.end()), rest.end());
    if (rest != fewer) return false;
    const ObjectId a = more[i == 0 ? more.size() - 1 : i - 1];
    const ObjectId b = more[i + 1 == more.size() ? 0 : i + 1];
    if (comes ? !can_enter(p, a, b) : !can_leave(p)) return false;
    if (comes) {
      enter(p, a, b);
    } else {
      leave(p);
    }
    return true;
  }
  return false;
}

// Makes the cycle that of the hull.
void FarthestDelaunay2::synchronise() {
  const HullRing& ring = hull_->ring();
  const std::vector<ObjectId> after = ring.size() == 0 ? std::vector<ObjectId>{} : ring.cycle();
  const std::vector<ObjectId> before = cycle();
  if (before != after && !change_one(before, after)) construct(after, true);
}

void FarthestDelaunay2::begin() {
  repeats_.clear();
  synchronise();
  finish();
  untold_.clear();
}

void FarthestDelaunay2::rebuild() {
  failing_.clear();
  const HullRing& ring = hull_->ring();
  construct(ring.size() == 0 ? std::vector<ObjectId>{} : ring.cycle(), false);
  settle_ties();
  failing_.clear();  // they fail next: the hull may still change at this instant
  untold_.clear();
}

// ---- the static construction

// `keep`: certificates that stay the same are kept.
void FarthestDelaunay2::construct(const std::vector<ObjectId>& cycle, bool keep) {
  struct Kept {
    ObjectId a, b;
    CertificateId certificate;
    bool operator<(const Kept& k) const { return a != k.a ? a < k.a : b < k.b; }
  };
  const Attribute before = attribute();
  std::vector<Kept> kept;
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h)) || to_infinity(h) || named(h) != h) continue;
    if (!keep) drop_certificate(h);
    if (store_.label(h) == kNoCertificate) continue;
    kept.push_back({store_.origin(h), store_.target(h), store_.label(h)});
  }
  std::sort(kept.begin(), kept.end());
  store_.clear();
  few_.clear();
  ties_.clear();
  failing_.clear();
  if (cycle.size() < 3) {
    few_ = cycle;
  } else {
    triangulate(cycle);
  }
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h)) || !is_diagonal(h) || named(h) != h) continue;
    const Kept wanted{store_.origin(h), store_.target(h), kNoCertificate};
    const auto there = std::lower_bound(kept.begin(), kept.end(), wanted);
    if (there != kept.end() && !(wanted < *there) && there->certificate != kNoCertificate) {
      store_.set_label(h, there->certificate);
      there->certificate = kNoCertificate;
      if (kernel_->claims(store_.label(h), query_of(h))) {
        kernel_->set_tag(store_.label(h), h);
        note_outlook(h, kernel_->outlook(store_.label(h)));
        continue;
      }
    }
    set_certificate(h);
  }
  for (Kept& k : kept) slots_.drop(k.certificate);
  untold_.add(difference_between(before, attribute()));
}

// Vertices are taken out in a scattered order until three are left, and put back in the reverse
// order between the neighbours that they had, each as an ear.
void FarthestDelaunay2::triangulate(const std::vector<ObjectId>& cycle) {
  const std::size_t size = cycle.size();
  std::vector<std::size_t> next(size), previous(size), order(size);
  for (std::size_t i = 0; i < size; ++i) {
    next[i] = i + 1 == size ? 0 : i + 1;
    previous[i] = i == 0 ? size - 1 : i - 1;
    order[i] = i;
  }
  std::sort(order.begin(), order.end(), [&cycle](std::size_t i, std::size_t j) {
    return scattered(cycle[i]) < scattered(cycle[j]);
  });
  for (std::size_t k = 0; k + 3 < size; ++k) {
    next[previous[order[k]]] = next[order[k]];
    previous[next[order[k]]] = previous[order[k]];
  }
  const std::size_t first = order[size - 1], second = next[first];
  store_.start(cycle[first], cycle[second], cycle[next[second]]);
  for (std::size_t k = size - 3; k-- > 0;) {
    const std::size_t i = order[k];
    const HalfEdge h = hull_edge(cycle[previous[i]], cycle[next[i]]);
    if (!store_.star(cycle[i], {Triangulation2::triangle(store_.twin(h))}, rim_)) {
      return give_up("a vertex has no place");
    }
    legalise(store_.twin(h));
  }
}

// The triangle of `opposite` is a new ear at its apex: flips until the new vertex's triangles hold.
// Each flip raises the degree of the new vertex, so this ends in every arithmetic.
void FarthestDelaunay2::legalise(HalfEdge opposite) {
  stack_ = {opposite};
  while (!stack_.empty()) {
    const HalfEdge h = stack_.back();
    stack_.pop_back();
    if (!is_diagonal(h) || kernel_->sign_after(query_of(named(h))) != Sign::kNegative) continue;
    const HalfEdge d = store_.flip(h);
    stack_.push_back(Triangulation2::next(d));
    stack_.push_back(Triangulation2::previous(store_.twin(d)));
  }
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/triangulation_2.h"

#include <algorithm>

namespace kinex {

Triangulation2::Triangulation2(std::size_t objects)
    : infinity_(static_cast<ObjectId>(objects)),
      out_(objects + 1, kNone),
      vertex_mark_(objects + 1, 0),
      vertex_triangle_(objects + 1, kNone) {}

void Triangulation2::clear() {
  half_edges_.clear();
  free_.clear();
  triangle_mark_.clear();
  out_.assign(out_.size(), kNone);
  vertices_ = 0;
  journal_.forget();
}

Triangulation2::Triangle Triangulation2::allocate() {
  if (!free_.empty()) {
    const Triangle t = free_.back();
    free_.pop_back();
    return t;
  }
  const Triangle t = triangle_capacity();
  half_edges_.resize(half_edges_.size() + 3, Record{kNone, kNone, kNone});
  triangle_mark_.push_back(0);
  return t;
}

void Triangulation2::release(Triangle t) {
  for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) half_edges_[h] = {kNone, kNone, kNone};
  free_.push_back(t);
}

void Triangulation2::start(ObjectId a, ObjectId b, ObjectId c) {
  const ObjectId corner[3] = {a, b, c};
  const HalfEdge inner = 3 * allocate();
  HalfEdge ghost[3];  // ghost[i] lies beyond the side from corner i to corner i + 1
  for (HalfEdge& g : ghost) g = 3 * allocate();
  for (unsigned i = 0; i < 3; ++i) {
    half_edges_[inner + i] = {corner[i], ghost[i], kNone};
    half_edges_[ghost[i]] = {corner[(i + 1) % 3], inner + i, kNone};
    // from corner i out to infinity, and back to corner i + 1
    half_edges_[ghost[i] + 1] = {corner[i], ghost[(i + 2) % 3] + 2, kNone};
    half_edges_[ghost[i] + 2] = {infinity_, ghost[(i + 1) % 3] + 1, kNone};
    out_[corner[i]] = inner + i;
  }
  out_[infinity_] = ghost[0] + 2;
  vertices_ = 3;
  for (unsigned i = 0; i < 3; ++i) touch(corner[i], corner[(i + 1) % 3]);
}

bool Triangulation2::adjacent(ObjectId a, ObjectId b) const {
  const HalfEdge first = out_[a];
  HalfEdge h = first;
  do {
    if (target(h) == b) return true;
    h = around(h);
  } while (h != first);
  return false;
}

Triangulation2::HalfEdge Triangulation2::flip(HalfEdge h) {
  const HalfEdge h1 = next(h), h2 = previous(h);
  const HalfEdge g = half_edges_[h].twin;
  const HalfEdge g1 = next(g), g2 = previous(g);
  const ObjectId u = half_edges_[h].origin, v = half_edges_[g].origin;
  const ObjectId p = half_edges_[h2].origin, q = half_edges_[g2].origin;
  const std::uint32_t label = half_edges_[h].label;
  const Record outer_h = half_edges_[g2];  // q -> v moves to the slot of h
  const Record outer_g = half_edges_[h2];  // p -> u moves to the slot of g
  half_edges_[h] = {q, outer_h.twin, outer_h.label};
  half_edges_[outer_h.twin].twin = h;
  half_edges_[g] = {p, outer_g.twin, outer_g.label};
  half_edges_[outer_g.twin].twin = g;
  half_edges_[h2] = {p, g2, label};
  half_edges_[g2] = {q, h2, label};
  out_[u] = g1;
  out_[v] = h1;
  out_[p] = h2;
  out_[q] = g2;
  touch(u, v);
  touch(p, q);
  return h2;
}

bool Triangulation2::star(ObjectId v, const std::vector<Triangle>& cavity,
                          std::vector<HalfEdge>& rim) {
  ++epoch_;
  sides_.clear();
  for (const Triangle t : cavity) triangle_mark_[t] = epoch_;
  for (const Triangle t : cavity) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const Record& side = half_edges_[h];
      if (triangle_mark_[triangle(side.twin)] == epoch_) {
        if (h < side.twin) touch(side.origin, target(h));
        continue;
      }
      if (vertex_mark_[side.origin] == epoch_) return false;  // the rim meets a vertex twice
      vertex_mark_[side.origin] = epoch_;
      sides_.push_back({side.origin, target(h), side.twin, side.label});
    }
  }
  if (sides_.size() != cavity.size() + 2) return false;  // a vertex inside, or no disc
  for (const Side& s : sides_) {
    if (vertex_mark_[s.to] != epoch_) return false;
  }
  slots_ = cavity;
  slots_.push_back(allocate());
  slots_.push_back(allocate());
  rim.clear();
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Side& s = sides_[i];
    const HalfEdge h = 3 * slots_[i];
    put(h, s.from, s.outer, s.label);
    half_edges_[h + 1] = {s.to, kNone, kNone};
    half_edges_[h + 2] = {v, kNone, kNone};
    vertex_triangle_[s.from] = slots_[i];
    touch(v, s.from);
    rim.push_back(h);
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const HalfEdge a = 3 * slots_[i] + 1, b = 3 * vertex_triangle_[sides_[i].to] + 2;
    half_edges_[a].twin = b;
    half_edges_[b].twin = a;
  }
  out_[v] = 3 * slots_[0] + 2;
  ++vertices_;
  return true;
}

void Triangulation2::link(ObjectId v, std::vector<HalfEdge>& out) const {
  out.clear();
  const HalfEdge first = out_[v];
  HalfEdge h = first;
  do {
    out.push_back(next(h));
    h = around(h);
  } while (h != first);
}

void Triangulation2::fill(ObjectId v, const std::vector<Ear>& ears, std::vector<Triangle>& filled) {
  link(v, link_);
  sides_.clear();
  slots_.clear();
  for (const HalfEdge h : link_) {
    sides_.push_back({origin(h), target(h), twin(h), label(h)});
    slots_.push_back(triangle(h));
    touch(v, origin(h));
  }
  for (const Triangle t : slots_) release(t);
  out_[v] = kNone;
  --vertices_;
  filled.clear();
  // sides_[i] is the polygon's side from corner i to the next remaining corner.
  for (std::size_t i = 0; i < ears.size(); ++i) {
    const auto [before, at, after] = ears[i];
    const HalfEdge h = 3 * allocate();
    filled.push_back(triangle(h));
    put(h, sides_[before].from, sides_[before].outer, sides_[before].label);
    put(h + 1, sides_[at].from, sides_[at].outer, sides_[at].label);
    if (i + 1 == ears.size()) {
      put(h + 2, sides_[after].from, sides_[after].outer, sides_[after].label);
    } else {
      half_edges_[h + 2] = {sides_[after].from, kNone, kNone};
      out_[sides_[after].from] = h + 2;
      touch(sides_[before].from, sides_[after].from);
      sides_[before].outer = h + 2;
      sides_[before].label = kNone;
    }
  }
}

Triangulation2::HalfEdge Triangulation2::between(ObjectId a, ObjectId b) const {
  const HalfEdge first = out_[a];
  if (first == kNone) return kNone;
  HalfEdge h = first;
  do {
    if (target(h) == b) return h;
    h = around(h);
  } while (h != first);
  return kNone;
}

bool Triangulation2::replace(std::span<const Triangle> cells,
                             std::span<const Corners> fresh_corners,
                             std::vector<Triangle>& fresh) {
  // The sides of the new triangles, and what each is joined to: a half-edge outside, or a side.
  struct Inner {
    ObjectId from, to;
    std::uint32_t place;
    HalfEdge outer;
    std::uint32_t label;
  };
  std::vector<Inner> inner;
  for (std::uint32_t i = 0; i < fresh_corners.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      inner.push_back({fresh_corners[i][k], fresh_corners[i][(k + 1) % 3], 3 * i + k, kNone, kNone});
    }
  }
  const auto before = [](const Inner& a, const Inner& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  };
  std::sort(inner.begin(), inner.end(), before);
  const auto find = [&](ObjectId from, ObjectId to) -> Inner* {
    const auto at =
        std::lower_bound(inner.begin(), inner.end(), Inner{from, to, 0, kNone, kNone}, before);
    return at != inner.end() && at->from == from && at->to == to ? &*at : nullptr;
  };
  const bool has_ghost = std::any_of(inner.begin(), inner.end(),
                                     [this](const Inner& side) { return side.from == infinity_; });
  if (!has_ghost &&
      std::any_of(cells.begin(), cells.end(), [this](Triangle t) { return ghost(t); })) {
    return false;
  }
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i].from == inner[i].to) return false;
    if (i > 0 && !before(inner[i - 1], inner[i])) return false;  // a side twice
  }
  ++epoch_;
  for (const Triangle t : cells) triangle_mark_[t] = epoch_;
  std::vector<ObjectId> old;
  for (const Triangle t : cells) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      old.push_back(origin(h));
      if (triangle_mark_[triangle(twin(h))] == epoch_) {
        if (h < twin(h)) touch(origin(h), target(h));
        continue;
      }
      Inner* const side = find(origin(h), target(h));
      if (side == nullptr) return false;
      side->outer = twin(h);
      side->label = label(h);
    }
  }
  std::sort(old.begin(), old.end());
  old.erase(std::unique(old.begin(), old.end()), old.end());
  for (const Inner& side : inner) {
    if (!std::binary_search(old.begin(), old.end(), side.from) && has(side.from)) return false;
    if (side.outer != kNone) continue;
    const Inner* const mate = find(side.to, side.from);
    if (mate == nullptr || mate->outer != kNone) return false;
  }
  for (const ObjectId v : old) {
    if (v != infinity_) --vertices_;
    out_[v] = kNone;
  }
  for (const Triangle t : cells) release(t);
  fresh.clear();
  for (std::size_t i = 0; i < fresh_corners.size(); ++i) fresh.push_back(allocate());
  const auto half_edge = [&fresh](std::uint32_t place) { return 3 * fresh[place / 3] + place % 3; };
  for (const Inner& side : inner) {
    const HalfEdge h = half_edge(side.place);
    if (out_[side.from] == kNone && side.from != infinity_) ++vertices_;
    if (side.outer != kNone) {
      put(h, side.from, side.outer, side.label);
    } else {
      half_edges_[h] = {side.from, half_edge(find(side.to, side.from)->place), kNone};
      if (side.from < side.to) touch(side.from, side.to);
      out_[side.from] = h;
    }
  }
  return true;
}

std::string Triangulation2::defect() const {
  std::size_t count = 0;
  std::vector<std::uint32_t> degree(out_.size(), 0);
  for (HalfEdge h = 0; h < half_edges_.size(); ++h) {
    if (!live(triangle(h))) continue;
    ++count;
    const HalfEdge g = twin(h);
    if (g >= half_edges_.size() || twin(g) != h)
      return "half-edge " + std::to_string(h) + " has no twin";
    if (origin(h) > infinity_) return "half-edge " + std::to_string(h) + " starts nowhere";
    if (origin(h) != target(g) || origin(g) != target(h) || origin(h) == origin(g)) {
      return "half-edge " + std::to_string(h) + " and its twin have different ends";
    }
    if (label(h) != label(g)) return "half-edge " + std::to_string(h) + " has two labels";
    if (!has(origin(h)) || origin(out(origin(h))) != origin(h)) {
      return "vertex " + std::to_string(origin(h)) + " does not know its edges";
    }
    ++degree[origin(h)];
  }
  std::size_t finite = 0;
  for (ObjectId v = 0; v <= infinity_; ++v) {
    if (degree[v] == 0) {
      if (has(v)) return "vertex " + std::to_string(v) + " has no edges";
      continue;
    }
    if (v != infinity_) ++finite;
    std::uint32_t turns = 0;
    HalfEdge h = out(v);
    do {
      ++turns;
      h = around(h);
    } while (h != out(v) && turns <= degree[v]);
    if (turns != degree[v]) return "vertex " + std::to_string(v) + " has two stars";
    if (turns < 3) return "vertex " + std::to_string(v) + " has fewer than three neighbours";
  }
  if (finite != vertices_) return "the number of vertices is wrong";
  if (count != 3 * triangles()) return "the number of triangles is wrong";
  if (count != 0 && triangles() != 2 * (finite + 1) - 4) return "Euler's formula does not hold";
  return {};
}

std::size_t Triangulation2::bytes() const {
  return half_edges_.capacity() * sizeof(Record) + sides_.capacity() * sizeof(Side) +
         journal_.bytes() +
         (out_.capacity() + free_.capacity() + triangle_mark_.capacity() + vertex_mark_.capacity() +
          vertex_triangle_.capacity() + slots_.capacity() + link_.capacity()) *
             sizeof(std::uint32_t);
}

}  // namespace kinex

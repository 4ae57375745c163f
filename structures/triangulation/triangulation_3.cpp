// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/triangulation_3.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace kinex {

void Triangulation3::clear() {
  for (const Place& place : places_) {
    if (place.vertex != kNone) cell_of_[place.vertex] = kNone;
  }
  places_.clear();
  free_.clear();
  vertices_ = 0;
  journal_.forget();
}

void Triangulation3::touch_changed(std::span<const Cell> cells, std::span<const Quad> quads) {
  std::vector<EdgeJournal::Edge> old, fresh, changed;
  const auto add = [](std::vector<EdgeJournal::Edge>& edges, const Quad& quad) {
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = i + 1; j < 4; ++j) {
        edges.push_back({std::min(quad[i], quad[j]), std::max(quad[i], quad[j])});
      }
    }
  };
  for (const Cell c : cells) add(old, quad(c));
  for (const Quad& q : quads) add(fresh, q);
  sort_unique(old);
  sort_unique(fresh);
  std::set_symmetric_difference(old.begin(), old.end(), fresh.begin(), fresh.end(),
                                std::back_inserter(changed));
  for (const auto& [a, b] : changed) touch(a, b);
}

void Triangulation3::start(const Quad& cell) {
  std::vector<Quad> quads{cell};
  for (unsigned i = 0; i < 4; ++i) {
    Quad ghost = cell;
    ghost[i] = infinity_;
    std::swap(ghost[(i + 1) % 4], ghost[(i + 2) % 4]);
    quads.push_back(ghost);
  }
  std::vector<Cell> fresh;
  replace({}, quads, fresh);
}

Triangulation3::Triple Triangulation3::triple(Facet f) const {
  const Cell c = cell(f);
  Triple result{};
  std::size_t count = 0;
  for (Facet g = 4 * c; g < 4 * c + 4; ++g) {
    if (g != f) result[count++] = places_[g].vertex;
  }
  std::sort(result.begin(), result.end());
  return result;
}

int Triangulation3::side(const Quad& quad, unsigned i) {
  int parity = i % 2 == 0 ? 1 : -1;
  for (unsigned j = 0; j < 4; ++j) {
    for (unsigned k = j + 1; k < 4; ++k) {
      if (j != i && k != i && quad[j] > quad[k]) parity = -parity;
    }
  }
  return parity;
}

std::uint32_t Triangulation3::next_epoch() const {
  if (mark_.size() < places_.size() / 4) mark_.resize(places_.size() / 4, 0);
  if (++epoch_ == 0) {
    std::fill(mark_.begin(), mark_.end(), 0u);
    epoch_ = 1;
  }
  return epoch_;
}

void Triangulation3::star(ObjectId v, std::vector<Cell>& out) const {
  out.clear();
  if (cell_of_[v] == kNone) return;
  const std::uint32_t seen = next_epoch();
  out.push_back(cell_of_[v]);
  mark_[cell_of_[v]] = seen;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Cell c = out[i];
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      if (places_[f].vertex == v) continue;
      const Cell other = cell(places_[f].mate);
      if (mark_[other] == seen) continue;
      mark_[other] = seen;
      out.push_back(other);
    }
  }
}

bool Triangulation3::adjacent(ObjectId a, ObjectId b) const {
  star(a, open_);
  return std::any_of(open_.begin(), open_.end(), [&](Cell c) { return place_of(c, b) != kNone; });
}

bool Triangulation3::has_facet(ObjectId a, ObjectId b, ObjectId c) const {
  star(a, open_);
  return std::any_of(open_.begin(), open_.end(), [&](Cell cell) {
    return place_of(cell, b) != kNone && place_of(cell, c) != kNone;
  });
}

Triangulation3::Around Triangulation3::around(Facet f) const {
  Around result;
  const ObjectId q = apex(mate(f));
  for (Facet g = 4 * cell(f); g < 4 * cell(f) + 4; ++g) {
    if (g == f || apex(mate(g)) != q) continue;
    ++result.cells;
    result.edge = g;
  }
  return result;
}

Triangulation3::Cell Triangulation3::allocate() {
  if (!free_.empty()) {
    const Cell c = free_.back();
    free_.pop_back();
    return c;
  }
  places_.resize(places_.size() + 4);
  return static_cast<Cell>(places_.size() / 4 - 1);
}

// Cell k of the new ones is that of f with its k-th vertex of the facet replaced by the other apex.
void Triangulation3::flip_2_3(Facet f, std::array<Facet, 9>& fresh) {
  const Cell c = cell(f), d = cell(mate(f));
  const ObjectId p = apex(f), q = apex(mate(f));
  const std::uint32_t label = places_[f].label;
  const Quad old = quad(c);
  const unsigned i = f % 4;
  struct Rim {
    Facet at_p, at_q;  // the facets outside, seen from there
    std::uint32_t label_p, label_q;
  };
  std::array<Rim, 4> rims{};
  for (unsigned k = 0; k < 4; ++k) {
    if (k == i) continue;
    const Facet at_d = place_of(d, old[k]);
    rims[k] = {places_[4 * c + k].mate, places_[at_d].mate, places_[4 * c + k].label,
               places_[at_d].label};
  }
  std::array<Cell, 4> made{};
  std::size_t count = 0;
  for (unsigned k = 0; k < 4; ++k) {
    if (k == i) continue;
    made[k] = count == 0 ? c : count == 1 ? d : allocate();
    ++count;
  }
  std::size_t outside = 3, inside = 0;
  for (unsigned k = 0; k < 4; ++k) {
    if (k == i) continue;
    const Cell n = made[k];
    for (unsigned j = 0; j < 4; ++j) places_[4 * n + j].vertex = j == k ? q : old[j];
    join(4 * n + k, rims[k].at_p, rims[k].label_p);
    join(4 * n + i, rims[k].at_q, rims[k].label_q);
    fresh[outside++] = 4 * n + k;
    fresh[outside++] = 4 * n + i;
  }
  for (unsigned k = 0; k < 4; ++k) {
    for (unsigned l = k + 1; l < 4; ++l) {
      if (k == i || l == i) continue;
      join(4 * made[k] + l, 4 * made[l] + k, inside == 0 ? label : kNone);
      fresh[inside++] = 4 * made[k] + l;
    }
  }
  for (unsigned k = 0; k < 4; ++k) {
    if (k == i) continue;
    cell_of_[old[k]] = made[k == (i + 1) % 4 ? (i + 2) % 4 : (i + 1) % 4];
  }
  cell_of_[p] = cell_of_[q] = c;
  touch(p, q);
}

// Of the cell c of f, with the edge u v and the vertices x, y: the new cells are c with v, and with
// u, replaced by the third vertex z around the edge. p = apex(f) is one of x and y.
void Triangulation3::flip_3_2(Facet f, Facet out, std::array<Facet, 7>& fresh,
                              std::array<std::uint32_t, 2>& gone) {
  const Cell c = cell(f);
  const Facet k = f, l = out;  // places of x = p and of y
  const Cell c1 = cell(places_[k].mate), c2 = cell(places_[l].mate);
  const ObjectId z = apex(places_[k].mate);
  const ObjectId x = places_[k].vertex, y = places_[l].vertex;
  Facet i = kNone, j = kNone;  // places of u and v
  for (Facet g = 4 * c; g < 4 * c + 4; ++g) {
    if (g == k || g == l) continue;
    (i == kNone ? i : j) = g;
  }
  const ObjectId u = places_[i].vertex, v = places_[j].vertex;
  const std::uint32_t label = places_[f].label;
  gone[0] = places_[l].label;
  gone[1] = places_[place_of(c1, y)].label;  // between c1 and c2
  const auto rim = [this](Facet g) {
    return std::pair<Facet, std::uint32_t>(places_[g].mate, places_[g].label);
  };
  const auto below_xy = rim(j), above_xy = rim(i);
  const auto below_zy = rim(place_of(c1, v)), above_zy = rim(place_of(c1, u));
  const auto below_xz = rim(place_of(c2, v)), above_xz = rim(place_of(c2, u));
  const Quad old = quad(c);
  const Cell a = c, b = c1;  // with u; with v
  for (unsigned n = 0; n < 4; ++n) {
    places_[4 * a + n].vertex = n == j % 4 ? z : old[n];
    places_[4 * b + n].vertex = n == i % 4 ? z : old[n];
  }
  for (unsigned n = 0; n < 4; ++n) places_[4 * c2 + n] = {};
  free_.push_back(c2);
  join(4 * a + i % 4, 4 * b + j % 4, label);
  join(4 * a + j % 4, below_xy.first, below_xy.second);
  join(4 * a + k % 4, below_zy.first, below_zy.second);
  join(4 * a + l % 4, below_xz.first, below_xz.second);
  join(4 * b + i % 4, above_xy.first, above_xy.second);
  join(4 * b + k % 4, above_zy.first, above_zy.second);
  join(4 * b + l % 4, above_xz.first, above_xz.second);
  fresh = {4 * a + i % 4, 4 * a + j % 4, 4 * a + k % 4, 4 * a + l % 4,
           4 * b + i % 4, 4 * b + k % 4, 4 * b + l % 4};
  cell_of_[u] = cell_of_[x] = cell_of_[y] = cell_of_[z] = a;
  cell_of_[v] = b;
  touch(u, v);
}

bool Triangulation3::replace(std::span<const Cell> cells, std::span<const Quad> quads,
                             std::vector<Cell>& fresh) {
  fresh.clear();
  const auto is_ghost = [this](const Quad& q) {
    return std::find(q.begin(), q.end(), infinity_) != q.end();
  };
  const bool has_ghost = std::any_of(quads.begin(), quads.end(), is_ghost);
  if (!has_ghost && std::any_of(cells.begin(), cells.end(), [&](Cell c) { return ghost(c); })) {
    return false;
  }
  entries_.clear();
  const std::uint32_t inside = next_epoch();
  for (const Cell c : cells) mark_[c] = inside;
  for (const Cell c : cells) {
    const Quad old = quad(c);
    for (unsigned i = 0; i < 4; ++i) {
      const Facet outside = places_[4 * c + i].mate;
      if (mark_[cell(outside)] == inside) continue;
      entries_.push_back({triple(4 * c + i), -side(old, i), outside, kNone, kNone});
    }
  }
  for (std::uint32_t n = 0; n < quads.size(); ++n) {
    for (unsigned i = 0; i < 4; ++i) {
      const Quad& q = quads[n];
      Triple three{q[(i + 1) % 4], q[(i + 2) % 4], q[(i + 3) % 4]};
      std::sort(three.begin(), three.end());
      if (three[0] == three[1] || three[1] == three[2]) return false;
      entries_.push_back({three, side(q, i), kNone, n, i});
    }
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    if (a.triple != b.triple) return a.triple < b.triple;
    return a.side < b.side;
  });
  if (entries_.size() % 2 != 0) return false;
  for (std::size_t e = 0; e < entries_.size(); e += 2) {
    const Entry &a = entries_[e], &b = entries_[e + 1];
    if (a.triple != b.triple || a.side == b.side) return false;
    if (e + 2 < entries_.size() && entries_[e + 2].triple == a.triple) return false;
    if (a.outside != kNone && b.outside != kNone) return false;  // nothing is in between
    const ObjectId p = a.outside != kNone ? apex(a.outside) : quads[a.quad][a.place];
    const ObjectId q = b.outside != kNone ? apex(b.outside) : quads[b.quad][b.place];
    if (p == q) return false;
  }
  // Vertices that stay have a cell outside or a new one.
  for (const Cell c : cells) {
    for (const ObjectId v : quad(c)) {
      if (cell_of_[v] == kNone || mark_[cell_of_[v]] != inside) continue;
      cell_of_[v] = kNone;
      if (v != infinity_) --vertices_;
    }
  }
  const auto give = [this](ObjectId v, Cell c) {
    if (cell_of_[v] == kNone && v != infinity_) ++vertices_;
    cell_of_[v] = c;
  };
  for (const Entry& entry : entries_) {
    if (entry.outside == kNone) continue;
    for (const ObjectId v : entry.triple) give(v, cell(entry.outside));
  }
  touch_changed(cells, quads);
  for (const Cell c : cells) {
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) places_[f] = {};
    free_.push_back(c);
  }
  for (const Quad& q : quads) {
    const Cell c = allocate();
    fresh.push_back(c);
    for (unsigned i = 0; i < 4; ++i) {
      places_[4 * c + i] = {q[i], kNone, kNone};
      give(q[i], c);
    }
  }
  for (std::size_t e = 0; e < entries_.size(); e += 2) {
    const auto facet = [&](const Entry& entry) {
      return entry.outside != kNone ? entry.outside : 4 * fresh[entry.quad] + entry.place;
    };
    const Entry &a = entries_[e], &b = entries_[e + 1];
    const Facet rim = a.outside != kNone ? a.outside : b.outside;
    join(facet(a), facet(b), rim == kNone ? kNone : places_[rim].label);
  }
  return true;
}

std::string Triangulation3::defect() const {
  const auto at = [](Cell c) { return "cell " + std::to_string(c); };
  std::set<std::pair<ObjectId, ObjectId>> edges;
  std::set<ObjectId> seen;
  std::size_t cells_there = 0;
  for (Cell c = 0; c < cell_capacity(); ++c) {
    if (!live(c)) continue;
    ++cells_there;
    const Quad q = quad(c);
    for (unsigned i = 0; i < 4; ++i) {
      seen.insert(q[i]);
      for (unsigned j = i + 1; j < 4; ++j) {
        if (q[i] == q[j]) return at(c) + " has a vertex twice";
        edges.insert(std::minmax(q[i], q[j]));
      }
      const Facet f = 4 * c + i, g = places_[f].mate;
      if (g >= places_.size() || !live(cell(g)) || places_[g].mate != f)
        return at(c) + " has no neighbour";
      if (triple(f) != triple(g)) return at(c) + " has a neighbour on another facet";
      if (side(q, i) == side(quad(cell(g)), g % 4))
        return at(c) + " is turned against its neighbour";
      if (places_[f].label != places_[g].label) return at(c) + " has a facet with two labels";
      if (apex(f) == apex(g)) return at(c) + " is there twice";
    }
  }
  if (cells_there != cells()) return "the number of cells is wrong";
  for (ObjectId v = 0; v < cell_of_.size(); ++v) {
    if (has(v) != (seen.count(v) != 0)) return "vertex " + std::to_string(v) + " is there or not";
    if (has(v) && place_of(cell_of_[v], v) == kNone)
      return "vertex " + std::to_string(v) + " has another cell";
  }
  if (cells_there == 0) return vertices_ == 0 ? "" : "vertices without cells";
  if (vertices_ + 1 != seen.size()) return "the number of vertices is wrong";
  // V - E + F - C = 0 on the 3-sphere, with F = 2C.
  if (seen.size() + cells_there != edges.size()) return "Euler's formula does not hold";
  return "";
}

std::size_t Triangulation3::bytes() const {
  return places_.capacity() * sizeof(Place) + entries_.capacity() * sizeof(Entry) +
         journal_.bytes() +
         (cell_of_.capacity() + free_.capacity() + mark_.capacity() + open_.capacity()) *
             sizeof(std::uint32_t);
}

}  // namespace kinex

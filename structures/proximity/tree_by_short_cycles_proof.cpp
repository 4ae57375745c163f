// SPDX-License-Identifier: GPL-3.0-or-later
// TreeByShortCycles: how the cycle of an edge outside the tree is found, and how its records become those
// of another cycle.
#include <algorithm>

#include "structures/proximity/tree_by_short_cycles.h"

namespace kinex {

// The first triangle, by its third vertex, whose other edges are shorter right after now. Triangles
// with `longer`, which is longer or leaves the graph, are passed over.
bool TreeByShortCycles::find_triangle(Item outside, Item longer) {
  const auto [u, v] = edges_->ends(outside);
  const std::span<const EdgeAt> at_u = adjacent_->at(u), at_v = adjacent_->at(v);
  for (auto a = at_u.begin(), b = at_v.begin(); a != at_u.end() && b != at_v.end();) {
    if (a->vertex < b->vertex) {
      ++a;
    } else if (b->vertex < a->vertex) {
      ++b;
    } else {
      const Item x = a++->edge, y = b++->edge;
      if (!has(x) || !has(y) || x == longer || y == longer) continue;
      if (!is_shorter(x, outside) || !is_shorter(y, outside)) continue;
      cycle_.assign({x, y});
      return true;
    }
  }
  return false;
}

// The edge between two vertices, kNoItem if there is none.
Item TreeByShortCycles::edge_between(std::uint32_t u, std::uint32_t v) const {
  for (const EdgeAt& one : adjacent_->at(u)) {
    if (one.vertex == v) return has(one.edge) ? one.edge : kNoItem;
  }
  return kNoItem;
}

// While all other edges are shorter: a cycle of few edges, by a search from both ends until it meets
// itself; the path in the tree if that is far.
void TreeByShortCycles::find_short(Item outside) {
  const auto ends = edges_->ends(outside);
  reached_.resize(vertices_);
  passed_.assign(ends.begin(), ends.end());
  for (const std::uint32_t end : ends) reached_[end] = {outside, end};
  cycle_.clear();
  for (std::size_t i = 0; i < passed_.size() && cycle_.empty() && passed_.size() < kFar; ++i) {
    const std::uint32_t from = passed_[i];
    for (const EdgeAt& one : adjacent_->at(from)) {
      Reached& to = reached_[one.vertex];
      if (!has(one.edge) || one.edge == outside) continue;
      if (to.by == kNoItem) {
        to = {one.edge, reached_[from].root};
        passed_.push_back(one.vertex);
      } else if (to.root != reached_[from].root) {
        cycle_.push_back(one.edge);
        for (const std::uint32_t end : {from, one.vertex}) walk_back(end, outside);
        break;
      }
    }
  }
  for (const std::uint32_t at : passed_) reached_[at] = {};
  if (cycle_.empty()) find_path(outside);
}

// Adds the edges by which find_short came to a vertex.
void TreeByShortCycles::walk_back(std::uint32_t vertex, Item outside) {
  while (reached_[vertex].by != outside) {
    const Item edge = reached_[vertex].by;
    cycle_.push_back(edge);
    const auto ends = edges_->ends(edge);
    vertex = ends[0] == vertex ? ends[1] : ends[0];
  }
}

// The cycle of `outside` without `gone`, which is outside the tree, and with the other edges of its
// cycle. False if that is long, or not all are shorter than `outside`. `is_sure`: they are.
bool TreeByShortCycles::join_cycles(Item outside, Item gone, bool is_sure) {
  cycle_.clear();
  bool fits = true;
  for (const Item owner : {outside, gone}) {
    for (const Place place : records_.cycle(owner)) {
      const Item inside = records_[place].inside;
      if (inside == gone) continue;
      if (inside == outside) fits = false;
      std::uint8_t& mark = marks_[inside];
      if (mark == 0) cycle_.push_back(inside);
      // An edge of both is in neither.
      mark = mark == 1 ? 3 : owner == outside ? 1 : 2;
    }
  }
  std::size_t left = 0;
  for (const Item item : cycle_) {
    if (fits && marks_[item] != 3) {
      fits = left < kLongest && (marks_[item] == 1 || is_sure || is_shorter(item, outside));
      cycle_[left++] = item;
    }
    marks_[item] = 0;
  }
  cycle_.resize(left);
  if (!fits) return false;
  make_simple(outside);
  if (cycle_.size() > 2) make_shorter(outside, gone);
  return true;
}

// An edge of cycle_ at a vertex that is marked: not passed yet.
Item TreeByShortCycles::next_of_walk(std::uint32_t vertex) const {
  if (cycle_.size() > kFew) {
    auto place = std::lower_bound(at_.begin(), at_.end(), vertex,
                                  [](const EdgeAt& one, std::uint32_t v) { return one.vertex < v; });
    while (marks_[place->edge] == 0) ++place;
    return place->edge;
  }
  return *std::find_if(cycle_.begin(), cycle_.end(), [&](Item item) {
    const auto ends = edges_->ends(item);
    return marks_[item] != 0 && (ends[0] == vertex || ends[1] == vertex);
  });
}

// Of edges that meet every vertex an even number of times, `outside` counted: those of one cycle, from
// end to end. The walk from one end to the other drops its loops. passed_: its vertices.
void TreeByShortCycles::make_simple(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  walk_.clear();
  passed_.assign(1, u);
  if (cycle_.size() > kFew) {
    at_.clear();
    for (const Item item : cycle_) {
      for (const std::uint32_t end : edges_->ends(item)) at_.push_back({end, item});
    }
    std::sort(at_.begin(), at_.end(), [](const EdgeAt& one, const EdgeAt& other) {
      return one.vertex != other.vertex ? one.vertex < other.vertex : one.edge < other.edge;
    });
  }
  for (const Item item : cycle_) marks_[item] = 1;
  while (passed_.back() != v) {
    const std::uint32_t at = passed_.back();
    const Item next = next_of_walk(at);
    marks_[next] = 0;
    const auto ends = edges_->ends(next);
    const std::uint32_t to = ends[0] == at ? ends[1] : ends[0];
    walk_.push_back(next);
    passed_.erase(std::find(passed_.begin(), passed_.end(), to), passed_.end());
    passed_.push_back(to);
    walk_.resize(passed_.size() - 1);
  }
  for (const Item item : cycle_) marks_[item] = 0;
  cycle_.swap(walk_);
}

// Two edges of the walk that follow each other give way to the third one of a triangle, if it is shorter
// than `outside`.
void TreeByShortCycles::make_shorter(Item outside, Item gone) {
  std::size_t size = 0;  // edges kept; their vertices are one more
  for (std::size_t i = 0; i < cycle_.size(); ++i) {
    Item edge = cycle_[i];
    const std::uint32_t to = passed_[i + 1];
    while (size > 0) {
      const Item chord = edge_between(passed_[size - 1], to);
      if (chord == kNoItem || chord == outside || chord == gone) break;
      if (!is_shorter(chord, outside)) break;
      edge = chord;
      --size;
    }
    cycle_[size++] = edge;
    passed_[size] = to;
  }
  cycle_.resize(size);
}

void TreeByShortCycles::find_path(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  cycle_ = forest().path(u, v);
  std::sort(cycle_.begin(), cycle_.end());
}

// cycle_ becomes the cycle of `outside`. Its records stay, but for `stale`, where the edges of both
// sides do; the others say that an edge is at most as long as the owner. The old cycle may have been
// exchanged for one that contains `outside`.
void TreeByShortCycles::prove(Item outside, Place stale) {
  enum : std::uint8_t { kNone, kWanted, kProved };
  const std::span<const Place> old = records_.cycle(outside);
  own_.assign(old.begin(), old.end());
  for (const Item item : cycle_) marks_[item] = kWanted;
  marks_[outside] = kProved;
  const auto sort_out = [this](const auto& stays) {
    std::size_t others = 0;
    for (const Place place : own_) {
      if (!stays(place)) own_[others++] = place;
    }
    own_.resize(others);
  };
  sort_out([&](Place place) {
    const Record& record = records_[place];
    const bool stays =
        place != stale && marks_[record.inside] == kWanted && marks_[record.outside] != kNone;
    if (stays) marks_[record.inside] = kProved;
    return stays;
  });
  sort_out([&](Place place) {
    const Item inside = records_[place].inside;
    if (marks_[inside] != kWanted) return false;
    marks_[inside] = kProved;
    records_.change(place, inside, outside);
    return true;
  });
  for (const Item item : cycle_) {
    if (marks_[item] == kWanted) {
      if (own_.empty()) {
        records_.add(item, outside, outside);
      } else {
        records_.change(own_.back(), item, outside);
        own_.pop_back();
      }
    }
    marks_[item] = kNone;
  }
  marks_[outside] = kNone;
  for (const Place place : own_) records_.drop(place);
}

// Makes cycle_ a cycle of an edge in whose cycle `gone` is longer than it is, or leaves the graph.
void TreeByShortCycles::find_cycle_without(Item outside, Item gone, bool is_sure) {
  if (find_triangle(outside, gone)) return;
  if (in_tree(gone) || !join_cycles(outside, gone, is_sure)) find_path(outside);
}

}  // namespace kinex

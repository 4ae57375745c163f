// SPDX-License-Identifier: GPL-3.0-or-later
// TreeByShortCycles: how the cycle of an edge outside the tree is found, and how its records become those
// of another cycle.
#include <algorithm>

#include "structures/proximity/tree_by_short_cycles.h"

namespace kinex {

// Calls visit(x, y) for each vertex from which edges x and y of the graph lead to the ends of `edge`, by
// vertex in ascending order, until it returns true.
template <class Visit>
bool TreeByShortCycles::any_triangle(Item edge, const Visit& visit) const {
  const auto [u, v] = edges_->ends(edge);
  const std::span<const EdgeAt> at_u = adjacent_->at(u), at_v = adjacent_->at(v);
  for (auto a = at_u.begin(), b = at_v.begin(); a != at_u.end() && b != at_v.end();) {
    if (a->vertex < b->vertex) {
      ++a;
    } else if (b->vertex < a->vertex) {
      ++b;
    } else {
      const EdgeAt x = *a++, y = *b++;
      if (has(x.edge) && has(y.edge) && visit(x.edge, y.edge)) return true;
    }
  }
  return false;
}

// The first triangle, by its third vertex, whose other edges are shorter right after now. Triangles
// with `longer`, which is longer or leaves the graph, are passed over.
bool TreeByShortCycles::find_triangle(Item outside, Item longer) {
  return any_triangle(outside, [&](Item x, Item y) {
    if (x == longer || y == longer || !is_shorter(x, outside) || !is_shorter(y, outside))
      return false;
    cycle_.assign({x, y});
    return true;
  });
}

// rest_ becomes two edges that join the ends of `gone` and are shorter than `outside` right after now.
bool TreeByShortCycles::find_detour(Item outside, Item gone) {
  return any_triangle(gone, [&](Item x, Item y) {
    if (x == outside || y == outside || !is_shorter(x, outside) || !is_shorter(y, outside))
      return false;
    rest_.assign({x, y});
    return true;
  });
}

// The edge between two vertices, kNoItem if there is none.
Item TreeByShortCycles::edge_between(std::uint32_t u, std::uint32_t v) const {
  for (const EdgeAt& one : adjacent_->at(u)) {
    if (one.vertex == v) return has(one.edge) ? one.edge : kNoItem;
  }
  return kNoItem;
}

// cycle_ becomes a path between the ends of `outside`, by a search from both in turn until it meets
// itself; empty if there is none, or more than `most` vertices are nearer. `at(vertex)`: the edges there;
// `leads(edge)`: it is in the graph that is searched.
template <class At, class Leads>
void TreeByShortCycles::search(Item outside, std::size_t most, const At& at, const Leads& leads) {
  const auto ends = edges_->ends(outside);
  reached_.resize(vertices_);
  passed_.assign(ends.begin(), ends.end());
  for (const std::uint32_t end : ends) reached_[end] = {outside, end};
  cycle_.clear();
  for (std::size_t i = 0; i < passed_.size() && cycle_.empty() && passed_.size() <= most; ++i) {
    const std::uint32_t from = passed_[i];
    const Reached here = reached_[from];
    for (const EdgeAt& one : at(from)) {
      if (one.edge == here.by || one.edge == outside || !leads(one.edge)) continue;
      Reached& to = reached_[one.vertex];
      if (to.by == kNoItem) {
        to = {one.edge, here.root};
        passed_.push_back(one.vertex);
      } else if (to.root != here.root) {
        cycle_.push_back(one.edge);
        for (const std::uint32_t end : {from, one.vertex}) walk_back(end, outside);
        break;
      }
    }
  }
  for (const std::uint32_t vertex : passed_) reached_[vertex] = {};
}

// Adds the edges by which a search came to a vertex.
void TreeByShortCycles::walk_back(std::uint32_t vertex, Item outside) {
  while (reached_[vertex].by != outside) {
    const Item edge = reached_[vertex].by;
    cycle_.push_back(edge);
    const auto ends = edges_->ends(edge);
    vertex = ends[0] == vertex ? ends[1] : ends[0];
  }
}

// While all other edges are shorter: a cycle of few edges; the path in the tree if there is none near.
void TreeByShortCycles::find_short(Item outside) {
  search(
      outside, kNear, [this](std::uint32_t vertex) { return adjacent_->at(vertex); },
      [this](Item edge) { return has(edge); });
  if (cycle_.empty()) find_path(outside);
}

// cycle_ becomes the path in the tree between the ends of `outside`; empty if there is none. False: the
// search went too far.
bool TreeByShortCycles::search_tree(Item outside) {
  search(
      outside, kFar,
      [this](std::uint32_t vertex) { return std::span<const EdgeAt>(tree_at_[vertex]); },
      [](Item) { return true; });
  return passed_.size() <= kFar;
}

// The same for ends that are connected, however far.
void TreeByShortCycles::find_path(Item outside) {
  if (search_tree(outside)) return;
  const auto [u, v] = edges_->ends(outside);
  cycle_ = forest().path(u, v);
}

// `item`, an edge of the tree, is on that path.
bool TreeByShortCycles::is_on_path(Item item, Item outside) {
  if (search_tree(outside)) return std::find(cycle_.begin(), cycle_.end(), item) != cycle_.end();
  const auto [u, v] = edges_->ends(outside);
  return forest().on_path(item, u, v);
}

// The cycle of `outside` with rest_, which joins the ends of `gone`, in place of that. False if it is long,
// or not all edges are shorter than `outside`. `is_sure`: they are.
bool TreeByShortCycles::join_cycles(Item outside, Item gone, bool is_sure) {
  cycle_.clear();
  bool fits = true;
  const auto add = [&](Item inside, std::uint8_t own) {
    if (inside == outside) fits = false;
    std::uint8_t& mark = marks_[inside];
    if (mark == 0) cycle_.push_back(inside);
    // An edge of both is in neither.
    mark = mark == 1 ? 3 : own;
  };
  for (const Place place : records_.cycle(outside)) {
    if (records_[place].inside != gone) add(records_[place].inside, 1);
  }
  for (const Item inside : rest_) {
    if (inside != gone) add(inside, 2);
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

// An edge of cycle_ at a vertex: not passed yet.
Item TreeByShortCycles::next_of_walk(std::uint32_t vertex) {
  std::uint32_t& first = crossings_[vertex].first;
  while (marks_[waiting_[first].edge] == 0) first = waiting_[first].next;
  return waiting_[first].edge;
}

// Of edges that meet every vertex an even number of times, `outside` counted: those of one cycle, from
// end to end. The walk from one end to the other drops its loops. passed_: its vertices. Time O(size).
void TreeByShortCycles::make_simple(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  walk_.clear();
  passed_.assign(1, u);
  if (crossings_.size() < vertices_) crossings_.resize(vertices_);
  waiting_.clear();
  for (auto item = cycle_.rbegin(); item != cycle_.rend(); ++item) {
    for (const std::uint32_t end : edges_->ends(*item)) {
      waiting_.push_back({*item, crossings_[end].first});
      crossings_[end].first = static_cast<std::uint32_t>(waiting_.size() - 1);
    }
    marks_[*item] = 1;
  }
  crossings_[u].passed = 0;
  while (passed_.back() != v) {
    const std::uint32_t at = passed_.back();
    const Item next = next_of_walk(at);
    marks_[next] = 0;
    const auto ends = edges_->ends(next);
    const std::uint32_t to = ends[0] == at ? ends[1] : ends[0];
    if (crossings_[to].passed == kNoPlace) {
      crossings_[to].passed = static_cast<std::uint32_t>(passed_.size());
      passed_.push_back(to);
      walk_.push_back(next);
    } else {
      while (passed_.back() != to) {
        crossings_[passed_.back()].passed = kNoPlace;
        passed_.pop_back();
      }
      walk_.resize(passed_.size() - 1);
    }
  }
  for (const Item item : cycle_) {
    marks_[item] = 0;
    for (const std::uint32_t end : edges_->ends(item)) crossings_[end] = {};
  }
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
  if (has(gone) && !in_tree(gone)) {
    rest_.clear();
    for (const Place place : records_.cycle(gone)) rest_.push_back(records_[place].inside);
    if (join_cycles(outside, gone, is_sure)) return;
  }
  if (!in_tree(gone) && find_detour(outside, gone) && join_cycles(outside, gone, is_sure)) return;
  find_path(outside);
}

}  // namespace kinex

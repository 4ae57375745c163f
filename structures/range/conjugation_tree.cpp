// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/conjugation_tree.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/parts/merge_sort.h"
#include "structures/range/halving_line.h"

namespace kinex {

ConjugationTree::ConjugationTree(const DualPoints& points, std::vector<ObjectId> objects)
    : axis_(points.axis()), order_(std::move(objects)) {
  merge_sort(order_, [&](ObjectId a, ObjectId b) { return points.precedes(a, b); });
  ObjectId most = 0;
  for (const ObjectId object : order_) most = std::max(most, object);
  std::vector<std::uint32_t> rank(order_.empty() ? 0 : most + std::size_t{1});
  for (std::size_t i = 0; i < order_.size(); ++i) rank[order_[i]] = static_cast<std::uint32_t>(i);
  nodes_.push_back({0, static_cast<std::uint32_t>(order_.size()), 0, 0, 0, kRoot});
  // The first line separates small slopes from large ones.
  if (order_.size() > kLeaf) halve(kRoot, points);
  for (Ref at = 0; at < nodes_.size(); ++at) {
    if (!is_leaf(at)) make_chains(at, points, rank);
  }
}

// The objects of the node are in two halves. Makes nodes of these, halves both by a common line, and
// goes on below.
void ConjugationTree::halve(Ref node, const DualPoints& points) {
  const Node whole = nodes_[node];
  const auto half = static_cast<std::uint32_t>(first_half(whole.end - whole.first));
  const std::uint32_t middle = whole.first + half;
  const auto fresh = static_cast<Ref>(nodes_.size());
  nodes_[node].below = fresh;
  nodes_.push_back({whole.first, middle, 0, 0, 0, kRoot});
  nodes_.push_back({middle, whole.end, 0, 0, 0, kRoot});
  if (half <= kLeaf) return;
  const std::span<ObjectId> objects(order_);
  halve_both(points, objects.subspan(whole.first, half),
             objects.subspan(middle, whole.end - middle));
  halve(fresh, points);
  halve(fresh + 1, points);
}

// The lower and the upper chain of the convex hull, strict vertices only.
void ConjugationTree::make_chains(Ref node, const DualPoints& points,
                                  const std::vector<std::uint32_t>& rank) {
  std::vector<Vertex> by_slope;
  for (std::uint32_t place = nodes_[node].first; place < nodes_[node].end; ++place) {
    by_slope.push_back({order_[place], place});
  }
  std::sort(by_slope.begin(), by_slope.end(),
            [&](const Vertex& a, const Vertex& b) { return rank[a.object] < rank[b.object]; });
  const auto add = [&](bool is_upper) {
    const std::size_t begin = chains_.size();
    for (const Vertex& next : by_slope) {
      while (chains_.size() >= begin + 2) {
        const Sign turn =
            points.turn(chains_[chains_.size() - 2].object, chains_.back().object, next.object);
        if (turn == (is_upper ? Sign::kNegative : Sign::kPositive)) break;
        chains_.pop_back();
      }
      chains_.push_back(next);
    }
    return static_cast<std::uint32_t>(begin);
  };
  nodes_[node].lower = add(false);
  nodes_[node].upper = add(true);
  nodes_[node].stop = static_cast<std::uint32_t>(chains_.size());
}

// Along the lower chain coordinates fall, then rise.
ConjugationTree::Vertex ConjugationTree::least(Ref node, BoxAt& box) const {
  std::uint32_t from = nodes_[node].lower, to = nodes_[node].upper - 1;
  while (from < to) {
    const std::uint32_t middle = (from + to) / 2;
    if (box.precedes(axis_, chains_[middle + 1].object, chains_[middle].object)) {
      from = middle + 1;
    } else {
      to = middle;
    }
  }
  return chains_[from];
}

ConjugationTree::Vertex ConjugationTree::largest(Ref node, BoxAt& box) const {
  std::uint32_t from = nodes_[node].upper, to = nodes_[node].stop - 1;
  while (from < to) {
    const std::uint32_t middle = (from + to) / 2;
    if (box.precedes(axis_, chains_[middle].object, chains_[middle + 1].object)) {
      from = middle + 1;
    } else {
      to = middle;
    }
  }
  return chains_[from];
}

NodePlace ConjugationTree::place(Ref node, BoxAt& box, Seen& seen) const {
  const Node& there = nodes_[node];
  const auto is_here = [&there](const Vertex& v) {
    return there.first <= v.place && v.place < there.end;
  };
  // Those of the node above: the one is before a low side that is crossed and not beyond a high one,
  // the other is beyond a high side that is crossed and not before a low one.
  const bool knows_least = is_here(seen.least), knows_largest = is_here(seen.largest);
  bool has_least = knows_least, has_largest = knows_largest;
  const auto least = [&] {
    if (!has_least) seen.least = this->least(node, box);
    has_least = true;
    return seen.least.object;
  };
  const auto largest = [&] {
    if (!has_largest) seen.largest = this->largest(node, box);
    has_largest = true;
    return seen.largest.object;
  };
  if (seen.low) {
    seen.low = knows_least || box.is_below(axis_, least());
    if (seen.low && !knows_largest && box.is_below(axis_, largest())) return NodePlace::kOutside;
  }
  if (seen.high) {
    seen.high = knows_largest || box.is_beyond(axis_, largest());
    if (seen.high && !knows_least && box.is_beyond(axis_, least())) return NodePlace::kOutside;
  }
  return seen.decided() ? NodePlace::kInside : NodePlace::kCrossed;
}

std::uint64_t ConjugationTree::search(BoxAt& box, std::vector<ObjectId>& out,
                                      QueryTrace* trace) const {
  std::uint64_t looked_at = 0;
  std::vector<std::pair<Ref, Seen>> open{{kRoot, {}}};
  while (!open.empty()) {
    auto [at, seen] = open.back();
    open.pop_back();
    ++looked_at;
    if (is_leaf(at)) {
      add_to(trace, at, NodePlace::kCrossed);
      for (const ObjectId object : objects(at)) {
        ++looked_at;
        if (seen.holds(box, axis_, object)) out.push_back(object);
      }
      continue;
    }
    const NodePlace there = place(at, box, seen);
    add_to(trace, at, there);
    if (there == NodePlace::kInside) out.insert(out.end(), objects(at).begin(), objects(at).end());
    if (there != NodePlace::kCrossed) continue;
    open.emplace_back(below(at, 1), seen);
    open.emplace_back(below(at, 0), seen);
  }
  return looked_at;
}

// What one line makes a search look at below a node of m points that it crosses. Of the four nodes
// two levels below it misses one, which is looked at but not searched.
std::uint64_t ConjugationTree::most_looked_at(std::uint64_t n) {
  if (n <= kLeaf) return 1 + n;
  const std::vector<std::uint64_t> sizes = sizes_below(n);
  std::uint64_t below = 0, whole = 0, half = 0;  // of the present size, and of its half
  for (std::size_t i = sizes.size() - 1; i-- > 0;) {
    whole = i + 2 == sizes.size()   ? 2 + sizes[i]
            : i + 3 == sizes.size() ? 2 + 2 * below
                                    : 2 + below + 2 + half;
    half = std::exchange(below, whole);
  }
  return 1 + 2 * below;
}

std::vector<std::uint64_t> ConjugationTree::sizes_below(std::uint64_t n) {
  std::vector<std::uint64_t> sizes{n};
  while (sizes.back() > kLeaf) sizes.push_back(first_half(sizes.back()));
  return sizes;
}

void ConjugationTree::check(const Snapshot& now, AuditReport& report) const {
  for (Ref at = 0; at < nodes_.size(); ++at) {
    if (is_leaf(at)) continue;
    const std::size_t half = objects(below(at, 0)).size();
    report.check(half == first_half(objects(at).size()) &&
                     half + objects(below(at, 1)).size() == objects(at).size(),
                 [] { return "halves of a node are not halves"; });
    const auto smaller = [&](ObjectId a, ObjectId b) {
      return now.position(a, axis_) < now.position(b, axis_);
    };
    const auto [least, largest] =
        std::minmax_element(objects(at).begin(), objects(at).end(), smaller);
    const auto begin = chains_.begin();
    const Node& node = nodes_[at];
    const auto is_before = [&](const Vertex& a, const Vertex& b) {
      return smaller(a.object, b.object);
    };
    const auto low = std::min_element(begin + node.lower, begin + node.upper, is_before);
    const auto high = std::max_element(begin + node.upper, begin + node.stop, is_before);
    report.check(!smaller(*least, low->object) && !smaller(high->object, *largest),
                 [&] { return "the hull of node " + std::to_string(at) + " is too small"; });
  }
}

}  // namespace kinex

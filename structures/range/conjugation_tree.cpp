// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/conjugation_tree.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/parts/merge_sort.h"
#include "structures/range/halving_line.h"

namespace kinex {

ConjugationTrees::Ref ConjugationTrees::add(std::span<const ObjectId> objects) {
  std::vector<ObjectId> sorted(objects.begin(), objects.end());
  merge_sort(sorted, [&](ObjectId a, ObjectId b) { return points_->precedes(a, b); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (rank_.size() <= sorted[i]) rank_.resize(sorted[i] + std::size_t{1});
    rank_[sorted[i]] = static_cast<std::uint32_t>(i);
  }
  const auto first = static_cast<std::uint32_t>(order_.size());
  order_.insert(order_.end(), sorted.begin(), sorted.end());
  const Ref root = nodes();
  nodes_.push_back({first, static_cast<std::uint32_t>(order_.size()), 0, 0, 0, kNone});
  // The first line separates small slopes from large ones.
  if (sorted.size() > kLeaf) halve(root);
  for (Ref at = root; at < nodes(); ++at) {
    if (!is_leaf(at)) make_chains(at);
  }
  return root;
}

void ConjugationTrees::finish() {
  rank_ = {};
  points_->fill(order_, in_order_);
  points_->fill(chains_, in_chains_);
}

// The objects of the node are in two halves. Makes nodes of these, halves both by a common line, and
// goes on below.
void ConjugationTrees::halve(Ref node) {
  const Node whole = nodes_[node];
  const auto half = static_cast<std::uint32_t>(first_half(whole.end - whole.first));
  const std::uint32_t middle = whole.first + half;
  const Ref fresh = nodes();
  nodes_[node].below = fresh;
  nodes_.push_back({whole.first, middle, 0, 0, 0, kNone});
  nodes_.push_back({middle, whole.end, 0, 0, 0, kNone});
  if (half <= kLeaf) return;
  const std::span<ObjectId> objects(order_);
  halve_both(*points_, objects.subspan(whole.first, half),
             objects.subspan(middle, whole.end - middle));
  halve(fresh);
  halve(fresh + 1);
}

// The lower and the upper chain of the convex hull, strict vertices only.
void ConjugationTrees::make_chains(Ref node) {
  std::vector<ObjectId> by_slope(objects(node).begin(), objects(node).end());
  std::sort(by_slope.begin(), by_slope.end(),
            [&](ObjectId a, ObjectId b) { return rank_[a] < rank_[b]; });
  const auto add = [&](bool is_upper) {
    const std::size_t begin = chains_.size();
    for (const ObjectId next : by_slope) {
      while (chains_.size() >= begin + 2) {
        const Sign turn = points_->turn(chains_[chains_.size() - 2], chains_.back(), next);
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

// The place of the vertex with the least coordinate of the lower chain, or with the largest of the
// upper one. Along the lower chain coordinates fall, then rise; along the upper one they rise, then
// fall.
std::uint32_t ConjugationTrees::extreme(BoxAt& box, bool is_upper, std::uint32_t from,
                                        std::uint32_t end) const {
  const std::uint32_t low = is_upper ? 0 : 1;
  std::uint32_t to = end - 1;
  while (from < to) {
    const std::uint32_t middle = (from + to) / 2;
    if (box.precedes(axis(), chains_[middle + low], chains_[middle + 1 - low])) {
      from = middle + 1;
    } else {
      to = middle;
    }
  }
  return from;
}

// By the extreme vertices alone.
ConjugationTrees::Out ConjugationTrees::out_of_long(const Node& node, BoxAt& box) const {
  const std::uint32_t least = extreme(box, false, node.lower, node.upper);
  const std::uint32_t largest = extreme(box, true, node.upper, node.stop);
  const auto out = [&](std::uint32_t place) {
    return box.out(axis(), in_chains_, place, {chains_.data() + place, 1});
  };
  const OutOfInterval low = out(least), high = out(largest);
  return {low.before != 0, high.after != 0, high.before != 0, low.after != 0};
}

ConjugationTrees::Out ConjugationTrees::out_of(const Node& node, BoxAt& box) const {
  const std::size_t size = node.stop - node.lower;
  if (size > OutOfInterval::kMost) return out_of_long(node, box);
  const OutOfInterval out =
      box.out(axis(), in_chains_, node.lower, {chains_.data() + node.lower, size});
  const std::uint64_t lower = OutOfInterval::all(node.upper - node.lower);
  const std::uint64_t upper = OutOfInterval::all(size) & ~lower;
  return {(out.before & lower) != 0, (out.after & upper) != 0, (~out.before & upper) == 0,
          (~out.after & lower) == 0};
}

NodePlace ConjugationTrees::place(Ref node, BoxAt& box, Seen& seen) const {
  const Out out = out_of(nodes_[node], box);
  seen.low = seen.low && out.low;
  seen.high = seen.high && out.high;
  if (out.all_before || out.all_after) return NodePlace::kOutside;
  return seen.decided() ? NodePlace::kInside : NodePlace::kCrossed;
}

std::uint64_t ConjugationTrees::inside(Ref leaf, BoxAt& box, int axis,
                                       const CoordinateTable& table) const {
  const std::span<const ObjectId> all = objects(leaf);
  const OutOfInterval out = box.out(axis, table, first_place(leaf), all);
  return OutOfInterval::all(all.size()) & ~(out.before | out.after);
}

std::uint64_t ConjugationTrees::search(Ref root, BoxAt& box, std::vector<ObjectId>& out,
                                       QueryTrace* trace) const {
  std::uint64_t looked_at = 0;
  OpenNodes open;
  open.push(root, {});
  while (!open.empty()) {
    auto [at, seen] = open.pop();
    ++looked_at;
    if (is_leaf(at)) {
      add_to(trace, at, NodePlace::kCrossed);
      looked_at += objects(at).size();
      add_some(at, inside(at, box, axis(), in_order_), out);
      continue;
    }
    const NodePlace there = place(at, box, seen);
    add_to(trace, at, there);
    if (there == NodePlace::kInside) out.insert(out.end(), objects(at).begin(), objects(at).end());
    if (there != NodePlace::kCrossed) continue;
    for (const std::size_t half : {1, 0}) {
      prefetch(below(at, half));
      open.push(below(at, half), seen);
    }
  }
  return looked_at;
}

// What one line makes a search look at below a node of m points that it crosses. Of the four nodes
// two levels below it misses one, which is looked at but not searched.
std::uint64_t ConjugationTrees::most_looked_at(std::uint64_t n) {
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

std::vector<std::uint64_t> ConjugationTrees::sizes_below(std::uint64_t n) {
  std::vector<std::uint64_t> sizes{n};
  while (sizes.back() > kLeaf) sizes.push_back(first_half(sizes.back()));
  return sizes;
}

void ConjugationTrees::check(const Snapshot& now, AuditReport& report) const {
  for (Ref at = 1; at < nodes(); ++at) {
    if (is_leaf(at)) continue;
    const std::size_t half = objects(below(at, 0)).size();
    report.check(half == first_half(objects(at).size()) &&
                     half + objects(below(at, 1)).size() == objects(at).size(),
                 [] { return "halves of a node are not halves"; });
    const auto smaller = [&](ObjectId a, ObjectId b) {
      return now.position(a, axis()) < now.position(b, axis());
    };
    const auto [least, largest] =
        std::minmax_element(objects(at).begin(), objects(at).end(), smaller);
    const auto begin = chains_.begin();
    const Node& node = nodes_[at];
    const auto low = std::min_element(begin + node.lower, begin + node.upper, smaller);
    const auto high = std::max_element(begin + node.upper, begin + node.stop, smaller);
    report.check(!smaller(*least, *low) && !smaller(*high, *largest),
                 [&] { return "the hull of node " + std::to_string(at) + " is too small"; });
  }
}

}  // namespace kinex

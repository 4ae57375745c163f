// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/rank_kd_tree_2.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <utility>

namespace kinex {
namespace {

// The bits of a label, each followed by a zero.
std::uint64_t spread(std::uint64_t label) {
  label = (label | label << 16) & 0x0000ffff0000ffffu;
  label = (label | label << 8) & 0x00ff00ff00ff00ffu;
  label = (label | label << 4) & 0x0f0f0f0f0f0f0f0fu;
  label = (label | label << 2) & 0x3333333333333333u;
  return (label | label << 1) & 0x5555555555555555u;
}

// The bits of the labels by x, which come first, and by y.
constexpr std::array<std::uint64_t, 2> kAlong{0xaaaaaaaaaaaaaaaau, 0x5555555555555555u};

}  // namespace

RankKdTree2::Code RankKdTree2::code(ObjectId object) const {
  return spread(label(0, object)) << 1 | spread(label(1, object));
}

unsigned RankKdTree2::common_bits(Code a, Code b) const {
  return code_bits() - static_cast<unsigned>(std::bit_width(a ^ b));
}

void RankKdTree2::make_tree() {
  root_ = kNone;
  nodes_.clear();
  free_.clear();
  std::fill(above_leaf_.begin(), above_leaf_.end(), kNone);
  for (const ObjectId object : labels(0).in_order()) put_in(object);
  arrange();
}

// Puts the nodes in memory in the order in which searches meet them.
void RankKdTree2::arrange() {
  if (root_ == kNone || is_leaf(root_)) return;
  std::vector<Node> arranged;
  arranged.reserve(nodes_.size());
  std::vector<Ref> moved(nodes_.size()), open{root_};
  while (!open.empty()) {
    const Ref at = open.back();
    open.pop_back();
    moved[at - kInner] = kInner + static_cast<Ref>(arranged.size());
    arranged.push_back(node(at));
    for (const std::size_t place : {1, 0}) {
      if (!is_leaf(node(at).below[place])) open.push_back(node(at).below[place]);
    }
  }
  const auto move = [&](Ref& ref) {
    if (ref != kNone && !is_leaf(ref)) ref = moved[ref - kInner];
  };
  for (Node& node : arranged) {
    move(node.above);
    for (Ref& below : node.below) move(below);
  }
  for (Ref& above : above_leaf_) move(above);
  move(root_);
  nodes_ = std::move(arranged);
}

void RankKdTree2::replace_below(Ref above, Ref old, Ref fresh) {
  if (above == kNone) {
    root_ = fresh;
  } else {
    auto& below = node(above).below;
    below[below[0] == old ? 0 : 1] = fresh;
  }
}

void RankKdTree2::put_in(ObjectId object) {
  const Code own = code(object);
  above_leaf_[object] = kNone;
  if (root_ == kNone) {
    root_ = object;
    return;
  }
  Ref at = root_;
  ++walked_;
  while (!is_leaf(at) && common_bits(own, node(at).code) >= node(at).depth) {
    at = node(at).below[side(own, node(at).depth)];
    ++walked_;
  }
  const Code other = is_leaf(at) ? code(at) : node(at).code;
  Ref fresh;
  if (free_.empty()) {
    fresh = kInner + static_cast<Ref>(nodes_.size());
    nodes_.emplace_back();
  } else {
    fresh = free_.back();
    free_.pop_back();
  }
  Node& made = node(fresh);
  made.code = own;
  made.depth = common_bits(own, other);
  made.above = above(at);
  const std::size_t place = side(own, made.depth);
  made.below[place] = object;
  made.below[1 - place] = at;
  replace_below(made.above, at, fresh);
  above(at) = fresh;
  above_leaf_[object] = fresh;
}

void RankKdTree2::take_out(ObjectId object) {
  const Ref parent = above_leaf_[object];
  above_leaf_[object] = kNone;
  if (parent == kNone) {
    root_ = kNone;
    return;
  }
  const Ref sibling = node(parent).below[node(parent).below[0] == object ? 1 : 0];
  const Ref grandparent = node(parent).above;
  replace_below(grandparent, parent, sibling);
  above(sibling) = grandparent;
  free_.push_back(parent);
}

// True if the leaf stays where it is: it remains in its half of the cell above it.
bool RankKdTree2::stays(ObjectId object, Code fresh) const {
  const Ref parent = above_leaf_[object];
  return parent == kNone || common_bits(code(object), fresh) > node(parent).depth;
}

std::uint64_t RankKdTree2::exchange(int axis, ObjectId before, ObjectId after) {
  const Code a = code(before), b = code(after);
  const Code along = spread(0xffffffffu) << (axis == 0 ? 1 : 0);
  if (stays(before, (a & ~along) | (b & along)) && stays(after, (b & ~along) | (a & along))) {
    labels_of(axis).exchange(before, after);
    return 2;
  }
  changing(std::array{before, after});
  walked_ = 0;
  take_out(before);
  take_out(after);
  labels_of(axis).exchange(before, after);
  put_in(before);
  put_in(after);
  return walked_;
}

// Numbers with the bits of one axis only are in the order of their labels.
RankKdTree2::Sides RankKdTree2::sides_of(const Node& node, const CodeBox& box) const {
  const unsigned rest = code_bits() - node.depth;  // bits that are not fixed
  const Code free = rest == 64 ? ~Code{0} : (Code{1} << rest) - 1;
  const Code low = node.code & ~free, high = node.code | free;
  bool is_outside = false;
  Sides sides = 0;
  for (const std::size_t a : {0, 1}) {
    const Code least = low & kAlong[a], largest = high & kAlong[a];
    is_outside |= largest < box.low[a] || box.high[a] < least;
    if (box.low[a] <= least) sides |= side_bit(a, false);
    if (largest <= box.high[a]) sides |= side_bit(a, true);
  }
  return is_outside ? kOutside : sides;
}

RankKdTree2::Cost RankKdTree2::search(const LabelBox& box, std::vector<ObjectId>& out,
                                      QueryTrace* trace) const {
  const CodeBox codes{{spread(box.low[0]) << 1, spread(box.low[1])},
                      {spread(box.high[0]) << 1, spread(box.high[1])}};
  const auto part = [&](Ref ref, Sides above) -> Part {
    if (above == kAllSides) return {ref, kAllSides};
    return {ref, is_leaf(ref) ? above : sides_of(node(ref), codes)};
  };
  const auto halves = [&](const Part& above) -> std::array<Part, 2> {
    const auto& below = node(above.ref).below;
    return {part(below[0], above.sides), part(below[1], above.sides)};
  };
  const Part root = root_ == kNone ? Part{} : part(root_, 0);
  return search_parts(root, box, out, trace, halves);
}

// 50 sqrt(N) + 2k + 1, rounded up where it is not an integer.
std::uint64_t RankKdTree2::most_looked_at(std::uint64_t k) const {
  const std::uint64_t square = 2500 * static_cast<std::uint64_t>(labels(0).size());
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= square) root += bit;
  }
  return root + (root * root < square ? 1 : 0) + 2 * k + 1;
}

ObjectId RankKdTree2::leaf_before(ObjectId leaf) const {
  Ref from = leaf, at = above_leaf_[leaf];
  for (; at != kNone && node(at).below[0] == from; at = node(at).above) from = at;
  if (at == kNone) return kNoObject;
  for (at = node(at).below[0]; !is_leaf(at);) at = node(at).below[1];
  return at;
}

std::vector<ObjectId> RankKdTree2::leaves() const {
  std::vector<ObjectId> result;
  std::vector<Ref> open;
  if (root_ != kNone) open.push_back(root_);
  while (!open.empty()) {
    const Ref at = open.back();
    open.pop_back();
    if (is_leaf(at)) {
      result.push_back(at);
    } else {
      open.push_back(node(at).below[1]);
      open.push_back(node(at).below[0]);
    }
  }
  return result;
}

// The leaves are in the order of the codes, and every inner node is what they have in common.
void RankKdTree2::check_tree(AuditReport& report) const {
  std::vector<ObjectId> expected = labels(0).in_order();
  std::sort(expected.begin(), expected.end(),
            [this](ObjectId a, ObjectId b) { return code(a) < code(b); });
  report.check(leaves() == expected, [] { return "the leaves are not in the order of the cells"; });
  report.check(nodes_.size() - free_.size() + 1 == std::max<std::size_t>(expected.size(), 1),
               [] { return "another number of nodes than n - 1"; });
  std::vector<Ref> open;
  if (root_ != kNone) open.push_back(root_);
  while (!open.empty()) {
    const Ref at = open.back();
    open.pop_back();
    if (is_leaf(at)) continue;
    const Node& there = node(at);
    for (const std::size_t place : {0, 1}) {
      const Ref below = there.below[place];
      const Code c = is_leaf(below) ? code(below) : node(below).code;
      report.check((is_leaf(below) ? above_leaf_[below] : node(below).above) == at,
                   [] { return "a node has another one above"; });
      report.check(common_bits(c, there.code) >= there.depth && side(c, there.depth) == place,
                   [] { return "a node is not in its half of the cell above"; });
      report.check(is_leaf(below) || node(below).depth > there.depth,
                   [] { return "a cell is no smaller than the one above"; });
      open.push_back(below);
    }
  }
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// AxisLabels: an integer label for every object of a sorted list, increasing along the list. Trees
// over labels need no signs.
//
//   labels  0   1   2   3   4   5   6   7      size() = 8, a power of two
//           c       a   e       b              an insertion behind e gets 4, one behind a makes room
//
// Cost: an exchange of two neighbours O(1). An insertion takes a free label between its neighbours,
// else spreads the smallest dyadic interval that is sparse enough: amortised O(log^2 n) moves. The
// allowed density falls from 1 for single labels to 1/2 for all of them; then size() doubles.
// A search by rank, or for a place in the order, O(log n).
//
// Source: order maintenance in a packed array: Itai, Konheim, Rodeh, "A sparse table implementation
// of priority queues" (1981).
#ifndef KINEX_STRUCTURES_PARTS_AXIS_LABELS_H
#define KINEX_STRUCTURES_PARTS_AXIS_LABELS_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

class AxisLabels {
 public:
  using Label = std::uint32_t;
  static constexpr Label kNone = 0xffffffffu;
  struct Move {  // an object and its next label
    ObjectId object;
    Label label;
  };

  // For objects below this number.
  explicit AxisLabels(std::size_t objects) : of_(objects, kNone) { assign({}, 0); }

  unsigned bits() const { return bits_; }
  std::size_t size() const { return at_.size(); }
  std::size_t count() const { return count_; }
  // Objects have ids below this number.
  std::size_t objects() const { return of_.size(); }
  bool has(ObjectId object) const { return of_[object] != kNone; }
  // Requires has(object).
  Label of(ObjectId object) const { return of_[object]; }
  // kNoObject: nothing has this label.
  ObjectId at(Label label) const { return at_[label]; }
  // The object with the k-th smallest label, k < count(). O(log n).
  ObjectId of_rank(std::size_t k) const;
  // The number of objects with a smaller label. O(log n).
  std::size_t rank(ObjectId object) const;
  // True if `next` has the next larger label in use. O(1) without gaps, else O(log n).
  bool are_neighbours(ObjectId object, ObjectId next) const;
  // Labels that separate the objects which come first from the others.
  struct Cut {
    std::size_t count = 0;  // of the objects that come first
    std::size_t first = 0;  // all labels from here on that are below `end` are free
    std::size_t end = 0;    // the least label of the others; size(): there are none
  };
  // comes_first(object) is true for all objects up to some label, and then false. It is asked
  // log2 size() + 1 times at most. O(log n), and O(log n) more for each gap in the labels that is met.
  template <class ComesFirst>
  Cut cut(const ComesFirst& comes_first) const;
  // The objects by label. O(size()).
  std::vector<ObjectId> in_order() const;
  // The least `bits` for n objects.
  static unsigned bits_for(std::size_t n);

  // Spreads these objects evenly over 2^bits labels, in place of those that were there. Requires
  // bits >= bits_for(order.size()).
  void assign(const std::vector<ObjectId>& order, unsigned bits);
  // Two objects exchange their labels.
  void exchange(ObjectId a, ObjectId b);
  // The moves that give `object` a label between those of its neighbours in the list (kNoObject:
  // none), itself the last one; nullopt if more bits are needed. Nothing changes. Requires
  // neighbours in the order of the labels, too.
  std::optional<std::vector<Move>> room_between(ObjectId previous, ObjectId object,
                                                ObjectId next) const;
  void apply(const std::vector<Move>& moves);
  void erase(ObjectId object);
  // Labels, objects and counts agree.
  bool consistent() const;
  std::size_t bytes() const {
    return of_.capacity() * sizeof(Label) + at_.capacity() * sizeof(ObjectId) +
           sums_.capacity() * sizeof(std::uint32_t);
  }

 private:
  void put(ObjectId object, Label label);
  void take(ObjectId object);
  void add_to_sums(Label label, std::int32_t by);
  // The last label in use below `end`. Requires that this is the k-th smallest one, k > 0.
  Label last_below(std::size_t end, std::size_t k) const {
    constexpr std::size_t kNear = 4;
    for (std::size_t label = end; label > 0 && label + kNear > end; --label) {
      if (at_[label - 1] != kNoObject) return static_cast<Label>(label - 1);
    }
    return of_[of_rank(k - 1)];
  }

  unsigned bits_ = 0;
  std::size_t count_ = 0;
  std::vector<Label> of_;            // per object
  std::vector<ObjectId> at_;         // per label
  std::vector<std::uint32_t> sums_;  // a Fenwick tree over the labels in use, from 1
};

// Of a block of labels the last object decides. sums_[end + step] is the number of objects in the
// block of `step` labels from `end` on, since `end` is a multiple of `step`.
template <class ComesFirst>
AxisLabels::Cut AxisLabels::cut(const ComesFirst& comes_first) const {
  Cut cut;
  for (std::size_t step = size(); step > 0; step /= 2) {
    const std::size_t end = cut.end + step;
    if (end > size()) continue;
    const std::size_t count = cut.count + sums_[end];
    if (count > cut.count && !comes_first(at_[last_below(end, count)])) continue;
    cut.count = count;
    cut.end = end;
  }
  cut.first = cut.count == 0 ? 0 : last_below(cut.end, cut.count) + std::size_t{1};
  return cut;
}

}  // namespace kinex

#endif

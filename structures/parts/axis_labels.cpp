// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/axis_labels.h"

#include <algorithm>
#include <bit>

namespace kinex {

unsigned AxisLabels::bits_for(std::size_t n) {
  return n < 2 ? 0u : static_cast<unsigned>(std::bit_width(n - 1));
}

ObjectId AxisLabels::of_rank(std::size_t k) const {
  std::size_t place = 0;
  for (std::size_t step = size(); step > 0; step /= 2) {
    if (place + step <= size() && sums_[place + step] <= k) {
      place += step;
      k -= sums_[place];
    }
  }
  return at_[place];
}

std::size_t AxisLabels::rank(ObjectId object) const {
  std::size_t sum = 0;
  for (std::size_t place = of_[object]; place > 0; place &= place - 1) sum += sums_[place];
  return sum;
}

bool AxisLabels::are_neighbours(ObjectId object, ObjectId next) const {
  constexpr Label kNear = 4;
  const Label from = of_[object], to = of_[next];
  if (to <= from) return false;
  if (to - from > kNear) return rank(object) + 1 == rank(next);
  return std::all_of(at_.begin() + from + 1, at_.begin() + to,
                     [](ObjectId between) { return between == kNoObject; });
}

std::vector<ObjectId> AxisLabels::in_order() const {
  std::vector<ObjectId> result;
  result.reserve(count_);
  for (const ObjectId object : at_) {
    if (object != kNoObject) result.push_back(object);
  }
  return result;
}

void AxisLabels::add_to_sums(Label label, std::int32_t by) {
  for (std::size_t place = label + std::size_t{1}; place <= size(); place += place & -place) {
    sums_[place] += static_cast<std::uint32_t>(by);
  }
}

void AxisLabels::put(ObjectId object, Label label) {
  of_[object] = label;
  at_[label] = object;
  add_to_sums(label, 1);
  ++count_;
}

void AxisLabels::take(ObjectId object) {
  at_[of_[object]] = kNoObject;
  add_to_sums(of_[object], -1);
  of_[object] = kNone;
  --count_;
}

void AxisLabels::assign(const std::vector<ObjectId>& order, unsigned bits) {
  bits_ = bits;
  count_ = 0;
  std::fill(of_.begin(), of_.end(), kNone);
  at_.assign(std::size_t{1} << bits, kNoObject);
  sums_.assign(at_.size() + 1, 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    put(order[i], static_cast<Label>(i * size() / order.size()));
  }
}

void AxisLabels::exchange(ObjectId a, ObjectId b) {
  std::swap(of_[a], of_[b]);
  at_[of_[a]] = a;
  at_[of_[b]] = b;
}

std::optional<std::vector<AxisLabels::Move>> AxisLabels::room_between(ObjectId previous,
                                                                      ObjectId object,
                                                                      ObjectId next) const {
  const std::size_t begin = previous == kNoObject ? 0 : of_[previous] + std::size_t{1};
  const std::size_t end = next == kNoObject ? size() : of_[next];
  if (begin < end) return std::vector<Move>{{object, static_cast<Label>((begin + end) / 2)}};
  const std::size_t near = previous != kNoObject ? of_[previous] : of_[next];
  for (unsigned k = 1; k <= bits_; ++k) {
    const std::size_t first = near >> k << k, length = std::size_t{1} << k;
    std::vector<ObjectId> order;
    for (std::size_t label = first; label < first + length; ++label) {
      if (at_[label] != kNoObject) order.push_back(at_[label]);
    }
    // (order.size() + 1) / length <= 1 - k / (2 bits)
    if ((order.size() + 1) * 2 * bits_ > length * (2 * bits_ - k)) continue;
    const auto behind = std::find(order.begin(), order.end(), previous);
    order.insert(behind == order.end() ? order.begin() : behind + 1, object);
    std::vector<Move> moves;
    Move own{object, kNone};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto label = static_cast<Label>(first + i * length / order.size());
      if (order[i] == object) {
        own.label = label;
      } else if (of_[order[i]] != label) {
        moves.push_back({order[i], label});
      }
    }
    moves.push_back(own);
    return moves;
  }
  return std::nullopt;
}

void AxisLabels::apply(const std::vector<Move>& moves) {
  for (const Move& move : moves) {
    if (has(move.object)) take(move.object);
  }
  for (const Move& move : moves) put(move.object, move.label);
}

void AxisLabels::erase(ObjectId object) { take(object); }

bool AxisLabels::consistent() const {
  std::size_t seen = 0;
  for (std::size_t label = 0; label < size(); ++label) {
    const ObjectId object = at_[label];
    if (object == kNoObject) continue;
    if (object >= of_.size() || of_[object] != label || rank(object) != seen ||
        of_rank(seen) != object) {
      return false;
    }
    ++seen;
  }
  const auto used = std::count_if(of_.begin(), of_.end(), [](Label l) { return l != kNone; });
  return seen == count_ && static_cast<std::size_t>(used) == count_;
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/halving_line.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace kinex {
namespace {

// Brings the element of rank k to its place, smaller ones in front of it. std::nth_element may not
// end in its range if the comparison contradicts itself.
template <class Before>
void select(std::span<ObjectId> items, std::size_t k, const Before& before) {
  std::size_t first = 0, end = items.size();
  while (end - first > 1) {
    // The middle one of three: what is in place already stays there.
    std::size_t low = first, middle = k, high = end - 1;
    if (before(items[middle], items[low])) std::swap(low, middle);
    if (before(items[high], items[middle])) middle = before(items[high], items[low]) ? low : high;
    const ObjectId pivot = items[middle];
    std::swap(items[middle], items[end - 1]);
    std::size_t place = first;
    for (std::size_t i = first; i + 1 < end; ++i) {
      if (before(items[i], pivot)) std::swap(items[i], items[place++]);
    }
    std::swap(items[place], items[end - 1]);
    if (place == k) return;
    (k < place ? end : first) = k < place ? place : place + 1;
  }
}

class Halving {
 public:
  explicit Halving(const DualPoints& points) : points_(points) {}

  // Brings the point of A of rank `k` to its place, and B to the order of its line, with rank `l`.
  void run(std::span<ObjectId> a, std::size_t k, std::span<ObjectId> b, std::size_t l) const {
    std::size_t first = 0, end = a.size();
    while (true) {
      std::swap(a[pivot(a.subspan(first, end - first), k - first, b, l) + first], a[end - 1]);
      const ObjectId from = a[end - 1];
      turn_to(from, b, l);
      std::size_t place = first;
      for (std::size_t i = first; i + 1 < end; ++i) {
        if (points_.is_left(from, b[l], a[i])) std::swap(a[i], a[place++]);
      }
      std::swap(a[place], a[end - 1]);
      if (place == k) return;
      (k < place ? end : first) = k < place ? place : place + 1;
    }
  }

 private:
  // B around `from`, from the left to the right.
  void turn_to(ObjectId from, std::span<ObjectId> b, std::size_t l) const {
    select(b, l, [&](ObjectId x, ObjectId y) { return x != y && points_.is_left(from, y, x); });
  }

  // The place of a point of A whose rank is probably near k: that of a sample against a sample.
  std::size_t pivot(std::span<const ObjectId> a, std::size_t k, std::span<const ObjectId> b,
                    std::size_t l) const {
    constexpr std::size_t kFew = 24;
    if (a.size() < kFew) return k;
    const auto sampled = [](std::span<const ObjectId> from) {
      std::size_t size = 4;  // about the square root
      while ((size - 2) * (size - 2) < from.size()) ++size;
      std::vector<ObjectId> result;
      for (std::size_t i = 0; i < size; ++i)
        result.push_back(from[(2 * i + 1) * from.size() / (2 * size)]);
      return result;
    };
    std::vector<ObjectId> some = sampled(a),
                          others = b.size() < kFew ? std::vector<ObjectId>(b.begin(), b.end())
                                                   : sampled(b);
    const std::size_t rank = k * some.size() / a.size();
    run(some, rank, others, l * others.size() / b.size());
    return static_cast<std::size_t>(std::find(a.begin(), a.end(), some[rank]) - a.begin());
  }

  const DualPoints& points_;
};

}  // namespace

void halve_both(const DualPoints& points, std::span<ObjectId> a, std::span<ObjectId> b) {
  Halving(points).run(a, first_half(a.size()) - 1, b, first_half(b.size()) - 1);
}

}  // namespace kinex

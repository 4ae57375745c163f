// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/witness.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace kinex {

namespace {

struct Line {
  Rational value;  // at the start
  Rational slope;
};

std::vector<Line> lines_of(const Scene& scene, bool negated) {
  std::vector<Line> lines;
  for (const SceneObject& object : scene.objects) {
    if (object.motion.pieces.size() != 1) throw std::invalid_argument("more than one piece");
    const std::vector<Rational>& x = object.motion.pieces.front().trajectory.coordinates.at(0);
    if (x.size() > 2) throw std::invalid_argument("not linear");
    Line line;
    if (x.size() > 1) line.slope = x[1];
    line.value = (x.empty() ? Rational(0) : x[0]) + line.slope * scene.start;
    if (negated) {
      line.value = -line.value;
      line.slope = -line.slope;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

// Sorts by `less` and counts how many pairs were out of order. Merge sort.
template <class Less>
std::uint64_t sort_counting(std::vector<std::size_t>& items, std::size_t begin, std::size_t end,
                            std::vector<std::size_t>& work, const Less& less) {
  if (end - begin < 2) return 0;
  const std::size_t middle = begin + (end - begin) / 2;
  std::uint64_t count = sort_counting(items, begin, middle, work, less) +
                        sort_counting(items, middle, end, work, less);
  std::size_t a = begin, b = middle, out = begin;
  while (a < middle || b < end) {
    if (b == end || (a < middle && !less(items[b], items[a]))) {
      work[out++] = items[a++];
    } else {
      count += middle - a;
      work[out++] = items[b++];
    }
  }
  std::copy(work.begin() + static_cast<std::ptrdiff_t>(begin),
            work.begin() + static_cast<std::ptrdiff_t>(end),
            items.begin() + static_cast<std::ptrdiff_t>(begin));
  return count;
}

// The time at which b, the steeper one, has caught up with a.
Rational meeting(const Line& a, const Line& b) { return (a.value - b.value) / (b.slope - a.slope); }

Integer envelope_changes(const Scene& scene, bool lower) {
  std::vector<Line> lines = lines_of(scene, lower);
  if (lines.empty()) return 0;
  std::sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
    return a.slope != b.slope ? a.slope < b.slope : a.value < b.value;
  });
  // The upper envelope over all times, from left to right.
  std::vector<Line> envelope;
  for (const Line& line : lines) {
    if (!envelope.empty() && envelope.back().slope == line.slope) envelope.pop_back();
    while (envelope.size() >= 2 && meeting(envelope.back(), line) <=
                                       meeting(envelope[envelope.size() - 2], envelope.back())) {
      envelope.pop_back();
    }
    envelope.push_back(line);
  }
  std::int64_t changes = 0;
  for (std::size_t i = 1; i < envelope.size(); ++i) {
    const Rational t = meeting(envelope[i - 1], envelope[i]) + scene.start;
    if (t > scene.start && (!scene.end || t <= *scene.end)) ++changes;
  }
  return changes;
}

}  // namespace

Integer inversions(const Scene& scene) {
  const std::vector<Line> lines = lines_of(scene, false);
  std::vector<std::size_t> order(lines.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    if (lines[i].value != lines[j].value) return lines[i].value < lines[j].value;
    if (lines[i].slope != lines[j].slope) return lines[i].slope < lines[j].slope;
    return i < j;
  });
  std::vector<Rational> last;  // decides the order at the end
  for (const Line& line : lines) {
    last.push_back(scene.end ? line.value + line.slope * (*scene.end - scene.start) : line.slope);
  }
  const auto before_at_end = [&](std::size_t i, std::size_t j) {
    if (last[i] != last[j]) return last[i] < last[j];
    if (lines[i].slope != lines[j].slope) return lines[i].slope < lines[j].slope;
    if (lines[i].value != lines[j].value) return lines[i].value < lines[j].value;
    return i < j;
  };
  std::vector<std::size_t> work(order.size());
  return static_cast<std::int64_t>(sort_counting(order, 0, order.size(), work, before_at_end));
}

Integer upper_envelope_changes(const Scene& scene) { return envelope_changes(scene, false); }
Integer lower_envelope_changes(const Scene& scene) { return envelope_changes(scene, true); }

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/maximum/envelope_witness.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "experiments/families/points/lines.h"

namespace kinex::families {

namespace {

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

Integer upper_envelope_changes(const Scene& scene) { return envelope_changes(scene, false); }
Integer lower_envelope_changes(const Scene& scene) { return envelope_changes(scene, true); }

}  // namespace kinex::families

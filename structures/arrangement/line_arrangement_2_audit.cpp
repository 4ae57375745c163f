// SPDX-License-Identifier: GPL-3.0-or-later
// The witness: lines sorted by the coordinates of their crossings, in CGAL's exact numbers.
#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "structures/arrangement/line_arrangement_2.h"

namespace kinex {

namespace {

using Number = CGAL::Gmpq;

struct Lines {
  std::vector<Number> slope, height;

  bool parallel(ObjectId l, ObjectId m) const { return slope[l] == slope[m]; }
  // Where m crosses l.
  Number x(ObjectId l, ObjectId m) const {
    return (height[l] - height[m]) / (slope[m] - slope[l]);
  }
  // Where it does if l alone, of the three, is raised by 1; and so on.
  Number raised(ObjectId who, ObjectId l, ObjectId m) const {
    const Number rise(static_cast<int>(who == l) - static_cast<int>(who == m));
    return rise / (slope[m] - slope[l]);
  }
  bool before(ObjectId l, ObjectId m, ObjectId k) const {
    if (parallel(l, m) || parallel(l, k)) {
      return parallel(l, m) == parallel(l, k) ? m < k : parallel(l, m);
    }
    if (x(l, m) != x(l, k)) return x(l, m) < x(l, k);
    std::array<ObjectId, 3> three{l, m, k};
    std::sort(three.begin(), three.end());
    for (const ObjectId who : three) {
      const Number first = raised(who, l, m), second = raised(who, l, k);
      if (first != second) return first < second;
    }
    return m < k;
  }
};

}  // namespace

void LineArrangement2::audit(const Snapshot& snapshot, AuditReport& report) const {
  Lines lines;
  lines.slope.resize(snapshot.objects());
  lines.height.resize(snapshot.objects());
  for (const ObjectId l : crossings_.lines()) {
    report.check(snapshot.alive(l), [] { return "a line that is not there"; });
    if (!snapshot.alive(l)) return;
    lines.slope[l] = Number(snapshot.position(l, 0).raw());
    lines.height[l] = Number(snapshot.position(l, 1).raw());
  }
  std::vector<ObjectId> order = crossings_.lines();
  std::stable_sort(order.begin(), order.end(),
                   [&](ObjectId l, ObjectId m) { return lines.slope[l] < lines.slope[m]; });
  report.check(order == slopes_.items(), [] { return "another order of slopes"; });
  for (const ObjectId l : crossings_.lines()) {
    std::vector<ObjectId> others = crossings_.lines();
    others.erase(std::find(others.begin(), others.end(), l));
    std::sort(others.begin(), others.end(),
              [&](ObjectId m, ObjectId k) { return lines.before(l, m, k); });
    report.check(others == crossings_.order(l),
                 [l] { return "another order of crossings on line " + std::to_string(l); });
  }
}

}  // namespace kinex

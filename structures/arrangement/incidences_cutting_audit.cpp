// SPDX-License-Identifier: GPL-3.0-or-later
// The witness: sides of all points and lines in CGAL's exact kernel; and for each trapezoid and each line,
// whether the line is between its floor and its ceiling for some x between its walls.
#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "structures/arrangement/incidences_cutting.h"
#include "structures/arrangement/static_sides_audit.h"

namespace kinex {
namespace {

using Number = CGAL::Gmpq;

// The open set of x at which some linear functions are positive.
class Range {
 public:
  void require_positive(const Number& slope, const Number& constant) {
    if (slope == 0) {
      empty_ = empty_ || constant <= 0;
    } else if (slope > 0) {
      const Number bound = -constant / slope;
      low_ = low_ ? std::max(*low_, bound) : bound;
    } else {
      const Number bound = -constant / slope;
      high_ = high_ ? std::min(*high_, bound) : bound;
    }
  }
  bool is_empty() const { return empty_ || (low_ && high_ && *low_ >= *high_); }

 private:
  bool empty_ = false;
  std::optional<Number> low_, high_;
};

}  // namespace

void IncidencesCutting::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_points_above(snapshot, is_line_) == attribute().ids,
               [] { return "other points are above lines"; });
  const auto number = [&snapshot](ObjectId line, int axis) {
    return Number(snapshot.position(line, axis).raw());
  };
  const auto x_of = [&number](const std::array<ObjectId, 2>& crossing) {
    const auto [l, m] = crossing;
    return Number((number(l, 1) - number(m, 1)) / (number(m, 0) - number(l, 0)));
  };
  const auto all_there = [&snapshot](const CuttingCells::Trapezoid& t) {
    for (const ObjectId id : {t.floor, t.ceiling, t.left[0], t.left[1], t.right[0], t.right[1]}) {
      if (id != kNoObject && !snapshot.alive(id)) return false;
    }
    return true;
  };
  Ids lines;
  for (ObjectId l = 0; l < snapshot.objects(); ++l) {
    if (snapshot.alive(l) && is_line_[l]) lines.push_back(l);
  }
  cells_.each([&](Cell cell) {
    const CuttingCells::Trapezoid& t = cells_.trapezoid(cell);
    report.check(all_there(t), [] { return "a trapezoid of lines that are not there"; });
    if (!all_there(t)) return;
    for (const ObjectId line : lines) {
      Range range;
      if (t.left[0] != kNoObject) range.require_positive(1, -x_of(t.left));
      if (t.right[0] != kNoObject) range.require_positive(-1, x_of(t.right));
      if (t.floor != kNoObject) {
        range.require_positive(number(line, 0) - number(t.floor, 0),
                               number(line, 1) - number(t.floor, 1));
      }
      if (t.ceiling != kNoObject) {
        range.require_positive(number(t.ceiling, 0) - number(line, 0),
                               number(t.ceiling, 1) - number(line, 1));
      }
      report.check(range.is_empty() || cells_.is_crossed(cell, line), [line] {
        return "a trapezoid that line " + std::to_string(line) + " crosses unseen";
      });
    }
  });
}

}  // namespace kinex

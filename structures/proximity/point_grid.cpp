// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/point_grid.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "predicates/predicates.h"

namespace kinex {
namespace {

Rational rational(std::size_t whole) { return Rational(Integer(static_cast<std::int64_t>(whole))); }

// The coefficients of c in powers of u, t = a + (b - a) u.
std::vector<Rational> over_unit(const std::vector<Rational>& c, const Rational& a,
                                const Rational& b) {
  std::vector<Rational> result;
  for (std::size_t k = c.size(); k-- > 0;) {  // Horner
    std::vector<Rational> next(result.size() + 1);
    for (std::size_t i = 0; i < result.size(); ++i) {
      next[i] += result[i] * a;
      next[i + 1] += result[i] * (b - a);
    }
    next[0] += c[k];
    result = std::move(next);
  }
  return result;
}

// On [a, b] a polynomial is between its smallest and its largest Bernstein coefficient.
void widen(const std::vector<Rational>& coordinate, const Rational& a, const Rational& b,
           std::vector<Rational>& values) {
  const std::vector<Rational> c = over_unit(coordinate, a, b);
  const std::size_t degree = c.empty() ? 0 : c.size() - 1;
  for (std::size_t i = 0; i <= degree && !c.empty(); ++i) {
    Rational value, ratio(1);  // C(i, k) / C(degree, k)
    for (std::size_t k = 0; k <= i; ++k) {
      value += ratio * c[k];
      if (k < i) ratio = ratio * rational(i - k) / rational(degree - k);
    }
    values.push_back(value);
  }
}

// The smallest m 2^e that is not less, with m = 16 .. 31; requires length > 0. `unit`: 2^e.
Rational rounded_up(const Rational& length, Rational& unit) {
  unit = Rational(1);
  while (Rational(16) * unit < length) unit *= Rational(2);
  while (length < Rational(16) * unit) unit /= Rational(2);
  Rational result = Rational(16) * unit;
  while (result < length) result += unit;
  return result;
}

// The multiple of unit at or below a number.
Rational rounded_down(const Rational& x, const Rational& unit) {
  const Rational quotient = x / unit;
  const Integer below = floor_divide(quotient.numerator(), quotient.denominator());
  return Rational(below) * unit;
}

}  // namespace

FlightBox FlightBox::of(const Scene& scene) {
  FlightBox box;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<Rational> values;
    for (const SceneObject& object : scene.objects) {
      for (const MotionPiece& piece : object.motion.pieces) {
        const Rational from = piece.from ? std::max(*piece.from, scene.start) : scene.start;
        const Rational to = piece.to ? std::min(*piece.to, *scene.end) : *scene.end;
        if (to < from) continue;
        widen(piece.trajectory.coordinates[axis], from, to, values);
      }
    }
    if (values.empty()) continue;
    box.low[axis] = *std::min_element(values.begin(), values.end());
    box.high[axis] = *std::max_element(values.begin(), values.end());
  }
  return box;
}

PointGrid::PointGrid(Kernel& kernel, StructureId id, FlightBox box, std::size_t points)
    : slots_(kernel, id, "cells"),
      box_(std::move(box)),
      order_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1))},
      places_(points) {}

// ---- lines

ObjectId PointGrid::line(std::size_t axis, const Rational& at) {
  const auto [place, is_new] = known_[axis].try_emplace(at, kNoObject);
  if (is_new) {
    place->second = slots_.kernel().constant((axis == 0 ? "x=" : "y=") + at.to_string(), {at, at});
  }
  return place->second;
}

// Of c columns and r rows, cr <= squares, those of the smallest side. The first line is a short
// number, up to 1/16 of a side before it has to be: that much less fits into c columns.
void PointGrid::lay(std::size_t squares, std::span<const ObjectId> points) {
  for (const ObjectId point : points) {
    for (CertificateId& slot : places_[point].certificate) slots_.drop(slot);
  }
  cells_.clear();
  squares_ = squares;
  const Rational slack(Integer(1), Integer(16));
  std::array<std::size_t, 2> count{1, 1};
  Rational side;
  for (std::size_t columns = 1; columns <= squares; ++columns) {
    const std::size_t rows = squares / columns;
    const Rational needed = std::max((box_.high[0] - box_.low[0]) / (rational(columns) - slack),
                                     (box_.high[1] - box_.low[1]) / (rational(rows) - slack));
    if (columns > 1 && !(needed < side)) continue;
    side = needed;
    count = {columns, rows};
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    lines_[axis].clear();
    at_[axis].clear();
    if (side.sign() == 0) continue;  // all points are at one place
    Rational unit;
    const Rational width = rounded_up(side, unit);
    Rational at = rounded_down(box_.low[axis] + width, unit);
    for (std::size_t k = 1; k < count[axis] && at < box_.high[axis]; ++k, at += width) {
      lines_[axis].push_back(line(axis, at));
      at_[axis].push_back(at);
    }
  }
  for (const ObjectId point : points) insert(point);
}

// ---- cells

bool PointGrid::has_side(ObjectId point, std::uint32_t side) const {
  const std::int64_t k = places_[point].cell[side / 2];
  return side % 2 == 0 ? k > 0 : k < static_cast<std::int64_t>(lines_[side / 2].size());
}

Query PointGrid::query(ObjectId point, std::uint32_t side) const {
  const std::size_t axis = side / 2;
  const auto k = static_cast<std::size_t>(places_[point].cell[axis]);
  if (side % 2 == 0) return Query(order_[axis], {lines_[axis][k - 1], point});
  return Query(order_[axis], {point, lines_[axis][k]});
}

void PointGrid::certify(ObjectId point) {
  for (std::uint32_t side = 0; side < kSides; ++side) {
    CertificateId& slot = places_[point].certificate[side];
    const std::uint32_t tag = point * kSides + side;
    if (!has_side(point, side)) {
      slots_.drop(slot);
    } else if (const Query now = query(point, side); !slots_.holds(slot, now, tag)) {
      slots_.set(slot, now, tag);
    }
  }
}

void PointGrid::enter(ObjectId point) {
  std::vector<ObjectId>& cell = cells_[places_[point].cell];
  cell.insert(std::lower_bound(cell.begin(), cell.end(), point), point);
}

void PointGrid::leave(ObjectId point) {
  const auto found = cells_.find(places_[point].cell);
  std::vector<ObjectId>& cell = found->second;
  cell.erase(std::lower_bound(cell.begin(), cell.end(), point));
  if (cell.empty()) cells_.erase(found);
}

void PointGrid::insert(ObjectId point) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto beyond = [&](ObjectId line) {
      return slots_.kernel().sign_after(order_[axis], {line, point}) != Sign::kNegative;
    };
    const std::vector<ObjectId>& lines = lines_[axis];
    places_[point].cell[axis] =
        std::partition_point(lines.begin(), lines.end(), beyond) - lines.begin();
  }
  enter(point);
  certify(point);
}

void PointGrid::erase(ObjectId point) {
  for (CertificateId& slot : places_[point].certificate) slots_.drop(slot);
  leave(point);
}

void PointGrid::move_on(CertificateId failed) {
  const std::uint32_t tag = slots_.failed(failed);
  const ObjectId point = tag / kSides;
  const std::uint32_t side = tag % kSides;
  leave(point);
  places_[point].cell[side / 2] += side % 2 == 0 ? -1 : 1;
  enter(point);
  certify(point);
}

// The cells of one column are consecutive in the map.
std::vector<ObjectId> PointGrid::near(ObjectId point) const {
  std::vector<ObjectId> result;
  const Cell& own = places_[point].cell;
  for (std::int64_t x = own[0] - kReach; x <= own[0] + kReach; ++x) {
    for (auto at = cells_.lower_bound({x, own[1] - kReach});
         at != cells_.end() && at->first[0] == x && at->first[1] <= own[1] + kReach; ++at) {
      result.insert(result.end(), at->second.begin(), at->second.end());
    }
  }
  result.erase(std::remove(result.begin(), result.end(), point), result.end());
  std::sort(result.begin(), result.end());
  return result;
}

// ---- checks

void PointGrid::visit_proof(ProofVisitor& visitor) const {
  static constexpr std::array<std::string_view, kSides> kRoles{"low side on x", "high side on x",
                                                               "low side on y", "high side on y"};
  ProofGroup group;
  group.kind = "grid cell";
  for (const auto& [cell, points] : cells_) {
    group.text = "cell " + std::to_string(cell[0]) + ", " + std::to_string(cell[1]);
    for (const ObjectId point : points) {
      group.about = {point};
      visitor.group(group);
      for (std::uint32_t side = 0; side < kSides; ++side) {
        const CertificateId slot = places_[point].certificate[side];
        if (slot != kNoCertificate) visitor.certificate(slot, kRoles[side]);
      }
    }
  }
}

void PointGrid::check(AuditReport& report) const {
  for (const auto& [cell, points] : cells_) {
    for (const ObjectId point : points) {
      report.check(places_[point].cell == cell, [] { return "a point in another cell"; });
      for (std::uint32_t side = 0; side < kSides; ++side) {
        const CertificateId slot = places_[point].certificate[side];
        report.check(has_side(point, side)
                         ? slots_.holds(slot, query(point, side), point * kSides + side)
                         : slot == kNoCertificate,
                     [] { return "a wrong certificate of a cell"; });
      }
    }
  }
}

void PointGrid::audit(const Snapshot& snapshot, AuditReport& report) const {
  for (const auto& [cell, points] : cells_) {
    for (const ObjectId point : points) {
      for (const int axis : {0, 1}) {
        const std::vector<Rational>& at = at_[static_cast<std::size_t>(axis)];
        const auto k = static_cast<std::size_t>(cell[static_cast<std::size_t>(axis)]);
        const Rational& x = snapshot.position(point, axis);
        report.check((k == 0 || at[k - 1] <= x) && (k == at.size() || x <= at[k]),
                     [point] { return "outside of its cell: point " + std::to_string(point); });
      }
    }
  }
}

std::size_t PointGrid::bytes() const {
  constexpr std::size_t kNode = 48;
  std::size_t total = places_.capacity() * sizeof(Place) +
                      cells_.size() * (sizeof(Cell) + sizeof(std::vector<ObjectId>) + kNode);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    total += known_[axis].size() * (sizeof(Rational) + sizeof(ObjectId) + kNode) +
             lines_[axis].capacity() * sizeof(ObjectId) + at_[axis].capacity() * sizeof(Rational);
  }
  for (const auto& [cell, points] : cells_) total += points.capacity() * sizeof(ObjectId);
  return total;
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/point_grid.h"

#include <algorithm>
#include <cstddef>
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

// Bounds of the coordinates of all objects along one axis; none without objects.
std::vector<Rational> values_along(const Scene& scene, std::size_t axis) {
  std::vector<Rational> values;
  for (const SceneObject& object : scene.objects) {
    for (const MotionPiece& piece : object.motion.pieces) {
      const Rational from = piece.from ? std::max(*piece.from, scene.start) : scene.start;
      const Rational to = piece.to ? std::min(*piece.to, *scene.end) : *scene.end;
      if (to < from) continue;
      widen(piece.trajectory.coordinates[axis], from, to, values);
    }
  }
  return values;
}

// How many cells a grid has along each axis, and the smallest side that they need.
struct Layout {
  std::vector<std::size_t> count;
  Rational side;
};

// Of c1, .. cells with c1 c2 .. <= cells those of the smallest side. The first line is a short
// number, up to 1/16 of a side before it has to be: that much less fits into c columns.
class LayoutSearch {
 public:
  explicit LayoutSearch(const FlightBox& box) : box_(box), count_(box.low.size()) {}
  Layout best(std::size_t cells) {
    search(0, cells, Rational());
    return best_;
  }

 private:
  void search(std::size_t axis, std::size_t cells, const Rational& so_far) {
    const bool last = axis + 1 == count_.size();
    for (std::size_t c = last ? cells : 1; c <= cells; ++c) {
      const Rational slack(Integer(1), Integer(16));
      count_[axis] = c;
      const Rational needed =
          std::max(so_far, (box_.high[axis] - box_.low[axis]) / (rational(c) - slack));
      if (!last) {
        search(axis + 1, cells / c, needed);
      } else if (best_.count.empty() || needed < best_.side) {
        best_ = {count_, needed};
      }
    }
  }

  const FlightBox& box_;
  std::vector<std::size_t> count_;
  Layout best_;
};

}  // namespace

FlightBox FlightBox::of(const Scene& scene) {
  const auto axes = static_cast<std::size_t>(scene.dimension);
  FlightBox box{std::vector<Rational>(axes), std::vector<Rational>(axes), {}};
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::vector<Rational> values = values_along(scene, axis);
    if (values.empty()) continue;
    box.low[axis] = *std::min_element(values.begin(), values.end());
    box.high[axis] = *std::max_element(values.begin(), values.end());
  }
  return box;
}

FlightBox FlightBox::of_discs(const Scene& scene) {
  FlightBox box = of(scene);
  const std::vector<Rational> radii =
      values_along(scene, static_cast<std::size_t>(scene.dimension));
  if (!radii.empty()) box.diameter = Rational(2) * *std::max_element(radii.begin(), radii.end());
  return box;
}

PointGrid::PointGrid(Kernel& kernel, StructureId id, FlightBox box, std::size_t points,
                     std::int64_t reach)
    : slots_(kernel, id, "cells"), box_(std::move(box)), reach_(reach), places_(points) {
  for (std::size_t axis = 0; axis < box_.low.size(); ++axis) {
    axes_.push_back({kernel.bind(make_coordinate_order(static_cast<int>(axis))), {}, {}, {}});
  }
}

// ---- lines

std::size_t PointGrid::lines() const {
  std::size_t total = 0;
  for (const Axis& axis : axes_) total += axis.lines.size();
  return total;
}

ObjectId PointGrid::line(std::size_t axis, const Rational& at) {
  const auto [place, is_new] = axes_[axis].known.try_emplace(at, kNoObject);
  if (is_new) {
    place->second = slots_.kernel().constant(std::string{"xyz"[axis]} + "=" + at.to_string(),
                                             std::vector<Rational>(axes_.size(), at));
  }
  return place->second;
}

void PointGrid::lay(std::size_t cells, std::span<const ObjectId> points) {
  for (const ObjectId point : points) {
    for (CertificateId& slot : places_[point].certificate) slots_.drop(slot);
  }
  cells_.clear();
  cells_asked_ = cells;
  const Layout layout = LayoutSearch(box_).best(cells);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    Axis& axis = axes_[i];
    axis.lines.clear();
    axis.at.clear();
    if (layout.side.sign() == 0) continue;  // all points are at one place
    Rational unit;
    Rational width = rounded_up(std::max(layout.side, box_.diameter), unit);
    if (!(box_.diameter < width)) width += unit;
    Rational at = rounded_down(box_.low[i] + width, unit);
    for (std::size_t k = 1; k < layout.count[i] && at < box_.high[i]; ++k, at += width) {
      axis.lines.push_back(line(i, at));
      axis.at.push_back(at);
    }
  }
  for (const ObjectId point : points) insert(point);
}

// ---- cells

bool PointGrid::has_side(ObjectId point, std::uint32_t side) const {
  const std::int64_t k = places_[point].cell[side / 2];
  return side % 2 == 0 ? k > 0 : k < static_cast<std::int64_t>(axes_[side / 2].lines.size());
}

Query PointGrid::query(ObjectId point, std::uint32_t side) const {
  const Axis& axis = axes_[side / 2];
  const auto k = static_cast<std::size_t>(places_[point].cell[side / 2]);
  if (side % 2 == 0) return Query(axis.order, {axis.lines[k - 1], point});
  return Query(axis.order, {point, axis.lines[k]});
}

void PointGrid::certify(ObjectId point) {
  for (std::uint32_t side = 0; side < sides(); ++side) {
    CertificateId& slot = places_[point].certificate[side];
    const std::uint32_t tag = point * sides() + side;
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
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const Axis& axis = axes_[i];
    const auto beyond = [&](ObjectId line) {
      return slots_.kernel().sign_after(axis.order, {line, point}) != Sign::kNegative;
    };
    places_[point].cell[i] =
        std::partition_point(axis.lines.begin(), axis.lines.end(), beyond) - axis.lines.begin();
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
  const ObjectId point = tag / sides();
  const std::uint32_t side = tag % sides();
  leave(point);
  places_[point].cell[side / 2] += side % 2 == 0 ? -1 : 1;
  enter(point);
  certify(point);
}

// The cells of one column are consecutive in the map. `from` is known on the axes before this one.
void PointGrid::add_near(std::size_t axis, const Cell& own, Cell& from,
                         std::vector<ObjectId>& result) const {
  from[axis] = own[axis] - reach_;
  const std::int64_t last = own[axis] + reach_;
  if (axis + 1 < axes_.size()) {
    for (; from[axis] <= last; ++from[axis]) add_near(axis + 1, own, from, result);
    return;
  }
  const auto in_column = [&](const Cell& cell) {
    return std::equal(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(axis), from.begin());
  };
  for (auto at = cells_.lower_bound(from);
       at != cells_.end() && in_column(at->first) && at->first[axis] <= last; ++at) {
    result.insert(result.end(), at->second.begin(), at->second.end());
  }
}

std::vector<ObjectId> PointGrid::near(ObjectId point) const {
  std::vector<ObjectId> result;
  Cell from{};
  add_near(0, places_[point].cell, from, result);
  result.erase(std::remove(result.begin(), result.end(), point), result.end());
  std::sort(result.begin(), result.end());
  return result;
}

// ---- checks

void PointGrid::visit_proof(ProofVisitor& visitor) const {
  static constexpr std::array<std::string_view, kMostSides> kRoles{
      "low side on x",  "high side on x", "low side on y",
      "high side on y", "low side on z",  "high side on z"};
  ProofGroup group;
  group.kind = "grid cell";
  for (const auto& [cell, points] : cells_) {
    group.text = "cell " + std::to_string(cell[0]);
    for (std::size_t i = 1; i < axes_.size(); ++i) group.text += ", " + std::to_string(cell[i]);
    for (const ObjectId point : points) {
      group.about = {point};
      visitor.group(group);
      for (std::uint32_t side = 0; side < sides(); ++side) {
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
      for (std::uint32_t side = 0; side < sides(); ++side) {
        const CertificateId slot = places_[point].certificate[side];
        report.check(has_side(point, side)
                         ? slots_.holds(slot, query(point, side), point * sides() + side)
                         : slot == kNoCertificate,
                     [] { return "a wrong certificate of a cell"; });
      }
    }
  }
}

void PointGrid::audit(const Snapshot& snapshot, AuditReport& report) const {
  for (const auto& [cell, points] : cells_) {
    for (const ObjectId point : points) {
      for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::vector<Rational>& at = axes_[i].at;
        const auto k = static_cast<std::size_t>(cell[i]);
        const Rational& x = snapshot.position(point, static_cast<int>(i));
        report.check((k == 0 || at[k - 1] <= x) && (k == at.size() || x <= at[k]),
                     [point = point] { return "outside of its cell: point " + std::to_string(point); });
      }
    }
  }
}

std::size_t PointGrid::bytes() const {
  constexpr std::size_t kNode = 48;
  std::size_t total = places_.capacity() * sizeof(Place) +
                      cells_.size() * (sizeof(Cell) + sizeof(std::vector<ObjectId>) + kNode);
  for (const Axis& axis : axes_) {
    total += axis.known.size() * (sizeof(Rational) + sizeof(ObjectId) + kNode) +
             axis.lines.capacity() * sizeof(ObjectId) + axis.at.capacity() * sizeof(Rational);
  }
  for (const auto& [cell, points] : cells_) total += points.capacity() * sizeof(ObjectId);
  return total;
}

}  // namespace kinex

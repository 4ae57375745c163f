// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/point_grid.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "predicates/predicates.h"

namespace kinex {

PointGrid::PointGrid(Kernel& kernel, StructureId id, FlightBox box, std::size_t points,
                     std::int64_t reach)
    : slots_(kernel, id, "cells"), lines_(kernel, std::move(box)), reach_(reach), places_(points) {
  for (std::size_t axis = 0; axis < axes(); ++axis) {
    orders_.push_back(kernel.bind(make_coordinate_order(static_cast<int>(axis))));
  }
}

void PointGrid::lay(std::size_t cells, std::span<const ObjectId> points) {
  for (const ObjectId point : points) {
    for (CertificateId& slot : places_[point].certificate) slots_.drop(slot);
  }
  cells_.clear();
  cells_asked_ = cells;
  lines_.lay(cells);
  for (const ObjectId point : points) insert(point);
}

std::size_t PointGrid::lines() const {
  std::size_t total = 0;
  for (std::size_t axis = 0; axis < axes(); ++axis) total += lines_.of(axis).size();
  return total;
}

// ---- cells

bool PointGrid::has_side(ObjectId point, std::uint32_t side) const {
  const std::int64_t k = places_[point].cell[side / 2];
  return side % 2 == 0 ? k > 0 : k < static_cast<std::int64_t>(lines_.of(side / 2).size());
}

Query PointGrid::query(ObjectId point, std::uint32_t side) const {
  const std::span<const ObjectId> lines = lines_.of(side / 2);
  const auto k = static_cast<std::size_t>(places_[point].cell[side / 2]);
  if (side % 2 == 0) return Query(orders_[side / 2], {lines[k - 1], point});
  return Query(orders_[side / 2], {point, lines[k]});
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
  for (std::size_t i = 0; i < axes(); ++i) {
    const std::span<const ObjectId> lines = lines_.of(i);
    const auto beyond = [&](ObjectId line) {
      return slots_.kernel().sign_after(orders_[i], {line, point}) != Sign::kNegative;
    };
    places_[point].cell[i] =
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
  if (axis + 1 < axes()) {
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
    for (std::size_t i = 1; i < axes(); ++i) group.text += ", " + std::to_string(cell[i]);
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

std::size_t PointGrid::bytes() const {
  constexpr std::size_t kNode = 48;
  std::size_t total = lines_.bytes() + places_.capacity() * sizeof(Place) +
                      cells_.size() * (sizeof(Cell) + sizeof(std::vector<ObjectId>) + kNode);
  for (const auto& [cell, points] : cells_) total += points.capacity() * sizeof(ObjectId);
  return total;
}

}  // namespace kinex

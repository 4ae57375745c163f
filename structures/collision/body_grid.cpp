// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/body_grid.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "predicates/bodies/body_gap.h"

namespace kinex {

BodyGrid::BodyGrid(Kernel& kernel, StructureId id, BodyGridLines lines, std::size_t bodies)
    : kernel_(kernel),
      slots_(kernel, id, "cells"),
      lines_(std::move(lines)),
      beyond_{kernel.bind(make_beyond_line(0, false)), kernel.bind(make_beyond_line(1, false))},
      short_of_{kernel.bind(make_beyond_line(0, true)), kernel.bind(make_beyond_line(1, true))},
      places_(bodies) {}

bool BodyGrid::is_beyond(ObjectId body, int axis, std::int64_t k) {
  const Query query(beyond_[static_cast<std::size_t>(axis)], {body, lines_.line(k)});
  return kernel_.sign_after(query) != Sign::kNegative;
}

// The last grid line that the body is beyond: by steps that double, then halve.
std::int64_t BodyGrid::find_cell(ObjectId body, int axis) {
  constexpr std::int64_t kFarthest = std::int64_t{1} << 60;
  std::int64_t low = 0, high = 1;
  if (is_beyond(body, axis, 0)) {
    while (high < kFarthest && is_beyond(body, axis, high)) {
      low = high;
      high *= 2;
    }
  } else {
    high = 0;
    low = -1;
    while (low > -kFarthest && !is_beyond(body, axis, low)) {
      high = low;
      low *= 2;
    }
  }
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (is_beyond(body, axis, middle) ? low : high) = middle;
  }
  return low;
}

// Directions: 0 low x, 1 high x, 2 low y, 3 high y.
Query BodyGrid::side(ObjectId body, std::uint32_t direction) {
  const std::size_t axis = direction / 2;
  const std::int64_t k = places_[body].cell[axis];
  if (direction % 2 == 0) return Query(beyond_[axis], {body, lines_.line(k)});
  return Query(short_of_[axis], {body, lines_.line(k + 1)});
}

void BodyGrid::enter(ObjectId body) {
  std::vector<ObjectId>& cell = cells_[places_[body].cell];
  cell.insert(std::lower_bound(cell.begin(), cell.end(), body), body);
}

void BodyGrid::leave(ObjectId body) {
  const auto found = cells_.find(places_[body].cell);
  std::vector<ObjectId>& cell = found->second;
  cell.erase(std::lower_bound(cell.begin(), cell.end(), body));
  if (cell.empty()) cells_.erase(found);
}

void BodyGrid::insert(ObjectId body) {
  Place& place = places_[body];
  for (int axis = 0; axis < 2; ++axis) {
    place.cell[static_cast<std::size_t>(axis)] = find_cell(body, axis);
  }
  enter(body);
  for (std::uint32_t d = 0; d < 4; ++d) certify(body, d);
}

void BodyGrid::certify(ObjectId body, std::uint32_t direction) {
  slots_.set(places_[body].certificate[direction], side(body, direction), 4 * body + direction);
}

void BodyGrid::erase(ObjectId body) {
  for (CertificateId& slot : places_[body].certificate) slots_.drop(slot);
  leave(body);
}

ObjectId BodyGrid::move_on(CertificateId failed) {
  const std::uint32_t tag = slots_.failed(failed);
  const ObjectId body = tag / 4;
  const std::uint32_t direction = tag % 4, axis = direction / 2;
  leave(body);
  places_[body].cell[axis] += direction % 2 == 0 ? -1 : 1;
  enter(body);
  certify(body, 2 * axis);
  certify(body, 2 * axis + 1);
  return body;
}

// The cells of one column are consecutive in the map.
std::span<const ObjectId> BodyGrid::near(ObjectId body) {
  near_.clear();
  const Cell& own = places_[body].cell;
  for (std::int64_t x = own[0] - 1; x <= own[0] + 1; ++x) {
    for (auto at = cells_.lower_bound({x, own[1] - 1});
         at != cells_.end() && at->first[0] == x && at->first[1] <= own[1] + 1; ++at) {
      near_.insert(near_.end(), at->second.begin(), at->second.end());
    }
  }
  near_.erase(std::remove(near_.begin(), near_.end(), body), near_.end());
  std::sort(near_.begin(), near_.end());
  return near_;
}

bool BodyGrid::are_near(ObjectId a, ObjectId b) const {
  const Cell& p = places_[a].cell;
  const Cell& q = places_[b].cell;
  return std::abs(p[0] - q[0]) <= 1 && std::abs(p[1] - q[1]) <= 1;
}

void BodyGrid::visit_proof(ProofVisitor& visitor) const {
  static constexpr std::array<std::string_view, 4> kRoles{"low side on x", "high side on x",
                                                          "low side on y", "high side on y"};
  ProofGroup group;
  group.kind = "grid cell";
  for (const auto& [cell, bodies] : cells_) {
    group.text = "cell " + std::to_string(cell[0]) + ", " + std::to_string(cell[1]);
    for (const ObjectId body : bodies) {
      group.about = {body};
      visitor.group(group);
      for (std::size_t d = 0; d < 4; ++d) {
        visitor.certificate(places_[body].certificate[d], kRoles[d]);
      }
    }
  }
}

std::size_t BodyGrid::bytes() const {
  constexpr std::size_t kNode = 48;
  return places_.capacity() * sizeof(Place) + lines_.bytes() +
         cells_.size() *
             (sizeof(Cell) + sizeof(std::vector<ObjectId>) + 4 * sizeof(ObjectId) + kNode);
}

}  // namespace kinex

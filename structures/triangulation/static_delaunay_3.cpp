// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/static_delaunay_3.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "structures/triangulation/curve_order.h"

namespace kinex {
namespace {

using Cell = Triangulation3::Cell;
using Facet = Triangulation3::Facet;
using Quad = Triangulation3::Quad;

// The order along a curve. Of identically equal points the smallest id is kept.
std::vector<ObjectId> quick_order(const SpaceGeometry& geometry, std::span<const ObjectId> points,
                                  std::vector<std::pair<ObjectId, ObjectId>>& hidden) {
  std::vector<RankedPoint<3>> all = ranked<3>(
      geometry.kernel(), {geometry.order(0), geometry.order(1), geometry.order(2)}, points);
  std::size_t kept = 0;
  for (const RankedPoint<3>& point : all) {
    if (kept != 0 && all[kept - 1].rank == point.rank) {
      hidden.emplace_back(point.id, all[kept - 1].id);
    } else {
      all[kept++] = point;
    }
  }
  all.resize(kept);
  return order_along_curve<3>(all);
}

// The first four points in general position, upright; none if all are in one plane.
std::optional<Quad> first_cell(const SpaceGeometry& geometry, std::span<const ObjectId> points) {
  std::size_t i = 1;
  while (i < points.size() && geometry.identical(points[0], points[i])) ++i;
  std::size_t j = i + 1;
  while (j < points.size() && geometry.on_line(points[0], points[i], points[j])) ++j;
  for (std::size_t k = j + 1; k < points.size(); ++k) {
    Quad quad{points[0], points[i], points[j], points[k]};
    const Sign sign = geometry.orientation(quad);
    if (sign == Sign::kZero) continue;
    if (sign == Sign::kNegative) std::swap(quad[0], quad[1]);
    return quad;
  }
  return std::nullopt;
}

}  // namespace

PlaceInSpace locate(const SpaceGeometry& geometry, const Triangulation3& store, ObjectId v,
                    Cell hint) {
  PlaceInSpace place;
  Cell c = hint;
  if (const Facet beyond = store.place_of(c, store.infinity()); beyond != Triangulation3::kNone) {
    c = Triangulation3::cell(store.mate(beyond));
  }
  Facet entered = Triangulation3::kNone;
  for (std::size_t steps = 2 * store.cells() + 4; steps != 0; --steps) {
    Facet onwards = Triangulation3::kNone;
    const Quad q = store.quad(c);
    unsigned zeros = 0, corner = entered == Triangulation3::kNone ? 0 : entered % 4;
    for (unsigned n = 0; n < 4; ++n) {
      const unsigned i = (static_cast<unsigned>(steps) + n) % 4;
      if (4 * c + i == entered) continue;
      Quad with = q;
      with[i] = v;
      const Sign sign = geometry.orientation(with);
      if (sign == Sign::kNegative) {
        onwards = store.mate(4 * c + i);
        break;
      }
      if (sign == Sign::kZero) {
        ++zeros;
      } else {
        corner = i;
      }
    }
    if (onwards == Triangulation3::kNone) {
      // In the planes of three facets: at the vertex opposite the fourth.
      if (zeros == 3) {
        place.equal = q[corner];
      } else {
        place.cell = c;
      }
      return place;
    }
    c = Triangulation3::cell(onwards);
    entered = onwards;
    if (store.ghost(c)) {
      place.cell = c;
      return place;
    }
  }
  return place;
}

void find_conflicts(const SpaceGeometry& geometry, const Triangulation3& store, ObjectId v,
                    Cell first, Conflicts& out) {
  out.cells.assign(1, first);
  out.star.clear();
  if (out.mark.size() < store.cell_capacity()) out.mark.resize(store.cell_capacity(), 0);
  const std::uint32_t in = out.epoch += 2, beyond = in + 1;
  out.mark[first] = in;
  for (std::size_t i = 0; i < out.cells.size(); ++i) {
    const Cell c = out.cells[i];
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      const Cell other = Triangulation3::cell(store.mate(f));
      if (out.mark[other] >= in) continue;
      out.mark[other] = geometry.conflict(store, other, v) ? in : beyond;
      if (out.mark[other] == in) out.cells.push_back(other);
    }
  }
  for (const Cell c : out.cells) {
    for (unsigned i = 0; i < 4; ++i) {
      if (out.mark[Triangulation3::cell(store.mate(4 * c + i))] == in) continue;
      Quad quad = store.quad(c);
      quad[i] = v;
      out.star.push_back(quad);
    }
  }
}

StaticResult build_static(const SpaceGeometry& geometry, std::span<const ObjectId> points,
                          bool quick, Triangulation3& store,
                          std::vector<std::pair<ObjectId, ObjectId>>& hidden) {
  store.clear();
  std::vector<ObjectId> order(points.begin(), points.end());
  if (quick) order = quick_order(geometry, points, hidden);
  const std::optional<Quad> first = first_cell(geometry, order);
  if (!first) return StaticResult::kFlat;
  store.start(*first);
  Cell hint = store.cell_of((*first)[0]);
  Conflicts conflicts;
  std::vector<Cell> fresh;
  for (const ObjectId v : order) {
    if (store.has(v)) continue;
    const PlaceInSpace place = locate(geometry, store, v, hint);
    if (place.equal != kNoObject) {
      hidden.emplace_back(v, place.equal);
      continue;
    }
    if (place.cell == Triangulation3::kNone) return StaticResult::kFailed;
    find_conflicts(geometry, store, v, place.cell, conflicts);
    if (!store.replace(conflicts.cells, conflicts.star, fresh)) return StaticResult::kFailed;
    hint = fresh.front();
  }
  return StaticResult::kBuilt;
}

}  // namespace kinex

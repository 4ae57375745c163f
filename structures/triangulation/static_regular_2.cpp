// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/static_regular_2.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "structures/triangulation/curve_order.h"

namespace kinex {
namespace {

using PlaneCorners = Triangulation2::Corners;

// The first three points that are not on one line, upright; none if all are.
std::optional<PlaneCorners> first_triangle(const PlaneGeometry& geometry,
                                           std::span<const ObjectId> points) {
  std::size_t i = 1;
  while (i < points.size() && geometry.equal(points[0], points[i], When::kRightAfter)) ++i;
  for (std::size_t j = i + 1; j < points.size(); ++j) {
    PlaneCorners corners{points[0], points[i], points[j]};
    const Sign sign = geometry.orientation(corners);
    if (sign == Sign::kZero) continue;
    if (sign == Sign::kNegative) std::swap(corners[0], corners[1]);
    return corners;
  }
  return std::nullopt;
}

}  // namespace

Triangulation2::Triangle locate(const PlaneGeometry& geometry, const Triangulation2& store,
                                ObjectId v, Triangulation2::Triangle hint) {
  using HalfEdge = Triangulation2::HalfEdge;
  Triangulation2::Triangle t = hint;
  for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
    if (store.origin(h) != store.infinity()) continue;
    t = Triangulation2::triangle(store.twin(Triangulation2::next(h)));
    break;
  }
  HalfEdge entered = Triangulation2::kNone;
  for (std::size_t steps = 2 * store.triangles() + 4; steps != 0; --steps) {
    HalfEdge onwards = Triangulation2::kNone;
    for (unsigned k = 0; k < 3; ++k) {
      const HalfEdge h = 3 * t + (static_cast<unsigned>(steps) + k) % 3;
      const ObjectId from = store.origin(h), to = store.target(h);
      if (h == entered || from == v || to == v) continue;
      if (geometry.orientation({from, to, v}) != Sign::kNegative) continue;
      onwards = store.twin(h);
      break;
    }
    if (onwards == Triangulation2::kNone) return t;
    t = Triangulation2::triangle(onwards);
    entered = onwards;
    if (store.apex(onwards) == store.infinity()) return t;
  }
  return Triangulation2::kNone;
}

void find_conflicts(const PlaneGeometry& geometry, const Triangulation2& store, ObjectId v,
                    Triangulation2::Triangle first, PlaneConflicts& out) {
  out.cells.assign(1, first);
  out.star.clear();
  if (out.mark.size() < store.triangle_capacity()) out.mark.resize(store.triangle_capacity(), 0);
  const std::uint32_t in = out.epoch += 2, beyond = in + 1;
  out.mark[first] = in;
  for (std::size_t i = 0; i < out.cells.size(); ++i) {
    const Triangulation2::Triangle t = out.cells[i];
    for (Triangulation2::HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const Triangulation2::Triangle other = Triangulation2::triangle(store.twin(h));
      if (out.mark[other] >= in) continue;
      out.mark[other] = geometry.conflict(store, other, v) ? in : beyond;
      if (out.mark[other] == in) out.cells.push_back(other);
    }
  }
  for (const Triangulation2::Triangle t : out.cells) {
    for (Triangulation2::HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      if (out.mark[Triangulation2::triangle(store.twin(h))] == in) continue;
      out.star.push_back({store.origin(h), store.target(h), v});
    }
  }
}

StaticResult build_static(const PlaneGeometry& geometry, std::span<const ObjectId> points,
                          bool quick, Triangulation2& store) {
  store.clear();
  std::vector<ObjectId> order(points.begin(), points.end());
  if (quick) {
    order = order_along_curve<2>(
        ranked<2>(geometry.kernel(), {geometry.order(0), geometry.order(1)}, points));
  }
  const std::optional<PlaneCorners> first = first_triangle(geometry, order);
  if (!first) return StaticResult::kFlat;
  store.start((*first)[0], (*first)[1], (*first)[2]);
  Triangulation2::Triangle hint = 0;
  PlaneConflicts conflicts;
  std::vector<Triangulation2::Triangle> fresh;
  for (const ObjectId v : order) {
    if (v == (*first)[0] || v == (*first)[1] || v == (*first)[2]) continue;
    const Triangulation2::Triangle t = locate(geometry, store, v, hint);
    if (t == Triangulation2::kNone) return StaticResult::kFailed;
    hint = t;
    if (!geometry.conflict(store, t, v)) continue;
    find_conflicts(geometry, store, v, t, conflicts);
    if (conflicts.cells.size() == store.triangles()) return StaticResult::kFailed;
    if (!store.replace(conflicts.cells, conflicts.star, fresh)) return StaticResult::kFailed;
    hint = fresh.front();
  }
  return StaticResult::kBuilt;
}

}  // namespace kinex

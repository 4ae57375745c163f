// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/static_delaunay_3.h"

#include "structures/triangulation/curve_order.h"
#include "structures/triangulation/point_location.h"

namespace kinex {
namespace {

// The order along a curve. Of identically equal points the smallest id is kept.
std::vector<ObjectId> quick_order(const RegularGeometry<SpaceComplex>& geometry,
                                  std::span<const ObjectId> points,
                                  std::vector<std::pair<ObjectId, ObjectId>>& hidden) {
  std::vector<RankedPoint<3>> all = ranked<3>(geometry.kernel(), geometry.orders(), points);
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

}  // namespace

StaticResult build_static(const RegularGeometry<SpaceComplex>& geometry,
                          std::span<const ObjectId> points, bool quick, Triangulation3& store,
                          std::vector<std::pair<ObjectId, ObjectId>>& hidden) {
  store.clear();
  std::vector<ObjectId> order(points.begin(), points.end());
  if (quick) order = quick_order(geometry, points, hidden);
  Triangulation3::Quad first{};
  if (!first_simplex<SpaceComplex>(geometry, order, first)) return StaticResult::kFlat;
  store.start(first);
  Triangulation3::Cell hint = store.cell_of(first[0]);
  Conflicts<SpaceComplex> conflicts;
  std::vector<Triangulation3::Cell> fresh;
  for (const ObjectId v : order) {
    if (store.has(v)) continue;
    const auto place = locate<SpaceComplex>(geometry, store, v, hint);
    if (place.equal != kNoObject) {
      hidden.emplace_back(v, place.equal);
      continue;
    }
    if (place.cell == Triangulation3::kNone) return StaticResult::kFailed;
    find_conflicts<SpaceComplex>(geometry, store, v, place.cell, conflicts);
    if (!store.replace(conflicts.cells, conflicts.star, fresh)) return StaticResult::kFailed;
    hint = fresh.front();
  }
  return StaticResult::kBuilt;
}

}  // namespace kinex

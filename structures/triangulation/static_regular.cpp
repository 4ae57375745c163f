// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/static_regular.h"

#include <algorithm>
#include <vector>

#include "structures/triangulation/curve_order.h"
#include "structures/triangulation/point_location.h"

namespace kinex {

template <class Complex>
StaticResult build_static(const RegularGeometry<Complex>& geometry,
                          std::span<const ObjectId> points, bool quick,
                          typename Complex::Store& store) {
  store.clear();
  std::vector<ObjectId> order(points.begin(), points.end());
  if (quick) {
    order = order_along_curve<Complex::kAxes>(
        ranked<Complex::kAxes>(geometry.kernel(), geometry.orders(), points));
  }
  typename Complex::Simplex first{};
  if (!first_simplex<Complex>(geometry, order, first)) return StaticResult::kFlat;
  Complex::start(store, first);
  typename Complex::Cell hint = Complex::cell_of(store, first[0]);
  Conflicts<Complex> conflicts;
  std::vector<typename Complex::Cell> fresh;
  for (const ObjectId v : order) {
    if (std::find(first.begin(), first.end(), v) != first.end()) continue;
    const auto c = locate<Complex>(geometry, store, v, hint).cell;
    if (c == Complex::kNone) return StaticResult::kFailed;
    hint = c;
    if (!geometry.conflict(store, c, v)) continue;
    find_conflicts<Complex>(geometry, store, v, c, conflicts);
    if (!store.replace(conflicts.cells, conflicts.star, fresh)) return StaticResult::kFailed;
    hint = fresh.front();
  }
  return StaticResult::kBuilt;
}

template StaticResult build_static<PlaneComplex>(const RegularGeometry<PlaneComplex>&,
                                                 std::span<const ObjectId>, bool, Triangulation2&);
template StaticResult build_static<SpaceComplex>(const RegularGeometry<SpaceComplex>&,
                                                 std::span<const ObjectId>, bool, Triangulation3&);

}  // namespace kinex

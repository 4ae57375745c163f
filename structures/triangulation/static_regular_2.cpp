// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/static_regular_2.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <random>
#include <tuple>

#include "structures/parts/merge_sort.h"

namespace kinex {
namespace {

using PlaneCorners = Triangulation2::Corners;

// Ranks along an axis: equal iff identically equal.
std::vector<std::uint32_t> ranks_in_plane(const PlaneGeometry& geometry,
                                          std::span<const ObjectId> points, int axis) {
  const PredicateId order = geometry.order(axis);
  std::vector<std::uint32_t> sorted(points.size());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) sorted[i] = i;
  merge_sort(sorted, [&](std::uint32_t a, std::uint32_t b) {
    return geometry.kernel().sign_after(order, {points[a], points[b]}) == Sign::kPositive;
  });
  std::vector<std::uint32_t> rank(points.size(), 0);
  std::uint32_t current = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const ObjectId a = points[sorted[i - 1]], b = points[sorted[i]];
    if (geometry.kernel().sign_after(order, {a, b}) != Sign::kZero) ++current;
    rank[sorted[i]] = current;
  }
  return rank;
}

// Along a curve over ranks, in rounds of doubling size (Amenta, Choi, Rote 2003).
std::vector<ObjectId> order_along_curve(const PlaneGeometry& geometry,
                                        std::span<const ObjectId> points) {
  struct Turn {
    std::uint64_t round, place;
    ObjectId id;
  };
  const std::vector<std::uint32_t> x = ranks_in_plane(geometry, points, 0);
  const std::vector<std::uint32_t> y = ranks_in_plane(geometry, points, 1);
  std::vector<Turn> turns;
  std::mt19937_64 engine(20240607);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Turn turn{32, 0, points[i]};  // half of the points come in the last round, a quarter before, ..
    for (std::uint64_t bits = engine(); (bits & 1) != 0 && turn.round != 0; bits >>= 1) --turn.round;
    for (unsigned k = 0; k < 32; ++k) {
      turn.place |= std::uint64_t{x[i] >> k & 1} << (2 * k) | std::uint64_t{y[i] >> k & 1} << (2 * k + 1);
    }
    turns.push_back(turn);
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return std::tie(a.round, a.place, a.id) < std::tie(b.round, b.place, b.id);
  });
  std::vector<ObjectId> order;
  for (const Turn& turn : turns) order.push_back(turn.id);
  return order;
}

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
  if (quick) order = order_along_curve(geometry, points);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/static_delaunay_3.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <tuple>

#include "structures/parts/merge_sort.h"

namespace kinex {
namespace {

using Cell = Triangulation3::Cell;
using Facet = Triangulation3::Facet;
using Quad = Triangulation3::Quad;

// Ranks along an axis: equal iff identically equal.
std::vector<std::uint32_t> ranks(const SpaceGeometry& geometry, std::span<const ObjectId> points,
                                 int axis) {
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

// Bit k of x goes to bit 3k.
std::uint64_t spread(std::uint64_t x) {
  std::uint64_t result = 0;
  for (unsigned k = 0; k < 16; ++k) result |= (x >> k & 1) << (3 * k);
  return result;
}

// An order of insertion: along a curve over ranks, in rounds of doubling size (Amenta, Choi, Rote
// 2003). Only comparisons of coordinates are needed, and no order of the input is a bad one. Of
// identically equal points the smallest id is kept.
std::vector<ObjectId> quick_order(const SpaceGeometry& geometry, std::span<const ObjectId> points,
                                  std::vector<std::pair<ObjectId, ObjectId>>& hidden) {
  struct Turn {
    std::array<std::uint32_t, 3> rank;
    ObjectId id;
    std::uint64_t round = 40, place = 0;
  };
  std::vector<Turn> all(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) all[i].id = points[i];
  std::array<std::uint64_t, 3> most{1, 1, 1};
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const std::vector<std::uint32_t> rank = ranks(geometry, points, axis);
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].rank[k] = rank[i];
      most[k] = std::max<std::uint64_t>(most[k], rank[i] + std::uint64_t{1});
    }
  }
  std::sort(all.begin(), all.end(), [](const Turn& a, const Turn& b) {
    return std::tie(a.rank, a.id) < std::tie(b.rank, b.id);
  });
  std::size_t kept = 0;
  for (const Turn& turn : all) {
    if (kept != 0 && all[kept - 1].rank == turn.rank) {
      hidden.emplace_back(turn.id, all[kept - 1].id);
    } else {
      all[kept++] = turn;
    }
  }
  all.resize(kept);
  std::mt19937_64 engine(20240607);
  for (Turn& turn : all) {  // half of the points come in the last round, a quarter before, ..
    for (std::uint64_t bits = engine(); (bits & 1) != 0 && turn.round != 0; bits >>= 1)
      --turn.round;
    for (std::size_t k = 0; k < 3; ++k) {
      turn.place |= spread(turn.rank[k] * std::uint64_t{0xffff} / most[k]) << k;
    }
  }
  std::sort(all.begin(), all.end(), [](const Turn& a, const Turn& b) {
    return std::tie(a.round, a.place, a.id) < std::tie(b.round, b.place, b.id);
  });
  std::vector<ObjectId> order;
  for (const Turn& turn : all) order.push_back(turn.id);
  return order;
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

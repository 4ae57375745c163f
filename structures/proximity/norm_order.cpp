// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/norm_order.h"

#include <algorithm>
#include <utility>

#include "predicates/predicates.h"
#include "structures/proximity/turned_order.h"

namespace kinex {

NormOrder::NormOrder(Kernel& kernel, std::vector<Vector> units)
    : kernel_(&kernel), units_(std::move(units)) {}

// The plane turned by an infinitesimal angle, counter-clockwise: u.x becomes u.x + eps (u1 x - u0 y).
NormOrder::Vector NormOrder::vector(const Along& along) const {
  const auto [x, y] = units_[along.direction];
  const Vector v = along.turned ? Vector{y, -x} : Vector{x, y};
  const int sign = along.negative ? -1 : 1;
  return {sign * v[0], sign * v[1]};
}

PredicateId NormOrder::order(const Along& along) const {
  const auto [place, fresh] = orders_.try_emplace(along, PredicateId{});
  if (!fresh) return place->second;
  place->second = bind_order_along(*kernel_, vector(along));
  return place->second;
}

PredicateId NormOrder::extents(const Along& u, const Along& v,
                               const std::array<int, 4>& places) const {
  const auto [place, fresh] = extents_.try_emplace({u, v, places}, PredicateId{});
  if (fresh) {
    const Vector a = vector(u), b = vector(v);
    place->second = kernel_->bind(make_extent_order({a[0], a[1]}, {b[0], b[1]}, places));
  }
  return place->second;
}

// "b is at least as long as a", or the same after the turn. A claim and the opposite one name the
// same objects in the same order, so that an arithmetic finds the roots of one by the other.
Query NormOrder::difference(const Step& a, const Step& b, bool turned) const {
  const NormForm &short_one = a.form, &long_one = b.form;
  if (short_one.direction == long_one.direction) {
    // Along the direction; a query of the opposite order where the vector has no positive part.
    Along along{short_one.direction, turned, false};
    const Vector u = vector(along);
    along.negative = u[0] < 0 || (u[0] == 0 && u[1] < 0);
    std::array<ObjectId, 2> ends{kNoObject, kNoObject};
    if (short_one.from == long_one.from) ends = {short_one.to, long_one.to};
    if (short_one.to == long_one.to) ends = {long_one.from, short_one.from};
    if (ends[0] != kNoObject && ends[0] != ends[1]) {
      if (along.negative) std::swap(ends[0], ends[1]);
      return Query(order(along), {ends[0], ends[1]});
    }
  }
  const bool in_order =
      std::pair(long_one.pair(), b.number) < std::pair(short_one.pair(), a.number);
  const NormForm& one = in_order ? long_one : short_one;
  const NormForm& other = in_order ? short_one : long_one;
  const std::array<ObjectId, 4> ids{one.to, one.from, other.to, other.from};
  Query query;
  std::array<int, 4> places{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto begin = query.ids.begin(), end = begin + query.arity;
    const auto there = std::find(begin, end, ids[i]);
    places[i] = static_cast<int>(there - begin);
    if (there == end) query.ids[query.arity++] = ids[i];
  }
  query.predicate =
      extents({one.direction, turned, !in_order}, {other.direction, turned, !in_order}, places);
  return query;
}

Query NormOrder::claim(const Step& a, const Step& b) const {
  const Query now = difference(a, b, false);
  return kernel_->sign_after(now) != Sign::kZero ? now : difference(a, b, true);
}

// The length of the step between two ids along (2, 1).
std::int64_t NormOrder::by_ids(const NormForm& form) const {
  const auto [x, y] = units_[form.direction];
  return (std::int64_t{form.to} - std::int64_t{form.from}) * (2 * x + y);
}

bool NormOrder::goes_first(const Step& a, const Step& b) const {
  return std::tuple(by_ids(a.form), a.form.pair(), a.number) <
         std::tuple(by_ids(b.form), b.form.pair(), b.number);
}

}  // namespace kinex

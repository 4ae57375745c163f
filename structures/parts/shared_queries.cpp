// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/shared_queries.h"

#include <algorithm>
#include <utility>

#include "predicates/points/shared_arguments.h"

namespace kinex {

SharedQueries::SharedQueries(Kernel& kernel, std::shared_ptr<const Predicate> whole)
    : kernel_(&kernel), whole_(std::move(whole)), all_different_(kernel.bind(whole_)) {}

PredicateId SharedQueries::bound(const Pattern& pattern) const {
  const auto [place, fresh] = bound_.try_emplace(pattern, PredicateId{});
  if (fresh) {
    const std::span<const std::uint8_t> used(pattern.data(),
                                             static_cast<std::size_t>(whole_->arity()));
    place->second = kernel_->bind(make_shared_arguments(whole_, used));
  }
  return place->second;
}

Query SharedQueries::query(std::span<const ObjectId> ids) const {
  Query query;
  Pattern pattern{};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto end = query.ids.begin() + query.arity;
    const auto there = std::find(query.ids.begin(), end, ids[i]);
    pattern[i] = static_cast<std::uint8_t>(there - query.ids.begin());
    if (there == end) query.ids[query.arity++] = ids[i];
  }
  query.predicate = query.arity == ids.size() ? all_different_ : bound(pattern);
  return query;
}

Query SharedQueries::order(std::span<const ObjectId> front,
                           std::span<const ObjectId> back) const {
  const std::size_t half = front.size();
  const bool in_order = std::lexicographical_compare(front.begin(), front.end(), back.begin(),
                                                     back.end());
  std::array<ObjectId, kMaxArity> ids{};
  std::copy(front.begin(), front.end(), ids.begin() + (in_order ? 0 : half));
  std::copy(back.begin(), back.end(), ids.begin() + (in_order ? half : 0));
  Query result = query({ids.data(), 2 * half});
  if (in_order) return result;
  if (result.arity == 2 * half) {
    std::rotate(result.ids.begin(), result.ids.begin() + static_cast<std::ptrdiff_t>(half),
                result.ids.begin() + static_cast<std::ptrdiff_t>(2 * half));
    return result;
  }
  // The same objects; the places of the halves exchanged.
  Pattern pattern{};
  for (std::size_t i = 0; i < 2 * half; ++i) {
    const ObjectId id = ids[i < half ? i + half : i - half];
    pattern[i] = static_cast<std::uint8_t>(std::find(result.ids.begin(), result.ids.end(), id) -
                                           result.ids.begin());
  }
  result.predicate = bound(pattern);
  return result;
}

}  // namespace kinex

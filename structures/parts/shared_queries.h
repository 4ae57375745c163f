// SPDX-License-Identifier: GPL-3.0-or-later
// SharedQueries: the queries of one predicate over lists in which an object may occur twice.
//
// A query may not name an object twice. For each pattern of repetitions that occurs, a predicate of
// fewer arguments is bound (predicates/points/shared_arguments.h), when it occurs for the first
// time.
//
//   query({a, b, c, b, c, f})   order_strip/012123 of (a, b, c, f)
//
// Cost: O(arity^2) for the pattern, and a search among the patterns bound so far.
#ifndef KINEX_STRUCTURES_PARTS_SHARED_QUERIES_H
#define KINEX_STRUCTURES_PARTS_SHARED_QUERIES_H

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>

#include "core/engine/kernel.h"

namespace kinex {

class SharedQueries {
 public:
  SharedQueries(Kernel& kernel, std::shared_ptr<const Predicate> whole);

  // The claim "whole(ids) >= 0". Requires as many ids as the predicate has arguments. Queries of
  // the same ids in the same order of their first occurrences name the same objects in the same
  // order.
  Query query(std::span<const ObjectId> ids) const;
  // For a predicate that alternates in halves: "whole(front, back) >= 0". The queries of two halves
  // in either order name the same objects in the same order, so that an arithmetic finds the
  // roots of one by the other.
  Query order(std::span<const ObjectId> front, std::span<const ObjectId> back) const;
  std::size_t bytes() const { return bound_.size() * 64; }  // of a map, about

 private:
  using Pattern = std::array<std::uint8_t, kMaxArity>;
  PredicateId bound(const Pattern& pattern) const;

  Kernel* kernel_;
  std::shared_ptr<const Predicate> whole_;
  PredicateId all_different_;
  mutable std::map<Pattern, PredicateId> bound_;  // those that have occurred
};

}  // namespace kinex

#endif

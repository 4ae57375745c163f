// SPDX-License-Identifier: GPL-3.0-or-later
// Query: a predicate and its arguments. Signs and failure times are computed for queries.
#ifndef KINEX_CORE_ARITHMETIC_QUERY_H
#define KINEX_CORE_ARITHMETIC_QUERY_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>

#include "core/arithmetic/predicate.h"
#include "core/motion/scene.h"
#include "core/numbers/check.h"

namespace kinex {

// A predicate with its arguments: names one polynomial in t under the motions in force.
//
// Queries are copied at every failure, in pieces of 16 bytes. A piece that was written in smaller ones
// is read some 15 cycles late (no store can be forwarded to the load), which `of` avoids.
struct alignas(16) Query {
  PredicateId predicate = 0;
  std::uint8_t arity = 0;
  std::array<ObjectId, kMaxArity> ids{};
  std::uint32_t rest = 0;  // without it, the last piece of a copy would overlap the one before

  typedef std::uint64_t Piece __attribute__((vector_size(16)));

  Query() = default;
  // Requires at most kMaxArity ids.
  Query(PredicateId p, std::initializer_list<ObjectId> list) : predicate(p) {
    require(list.size() <= kMaxArity, "a query names too many objects");
    for (ObjectId id : list) ids[arity++] = id;
  }
  // The same for so many objects, written in pieces of 16 bytes.
  static Query of(PredicateId p, ObjectId a, ObjectId b) {
    return from_pieces(Piece{head(p, 2, a), b}, Piece{});
  }
  static Query of(PredicateId p, ObjectId a, ObjectId b, ObjectId c) {
    return from_pieces(Piece{head(p, 3, a), b | std::uint64_t{c} << 32}, Piece{});
  }
  static Query of(PredicateId p, ObjectId a, ObjectId b, ObjectId c, ObjectId d) {
    return from_pieces(Piece{head(p, 4, a), b | std::uint64_t{c} << 32}, Piece{d, 0});
  }
  // By the first 32 bytes; the ids beyond are unused.
  static Query from_pieces(Piece first, Piece second) {
    static_assert(std::endian::native == std::endian::little);
    Query query;
    auto* const to = reinterpret_cast<std::byte*>(&query);
    std::memcpy(to, &first, sizeof(Piece));
    std::memcpy(to + sizeof(Piece), &second, sizeof(Piece));
    return query;
  }
  // The first eight bytes of such a query.
  static constexpr std::uint64_t head(PredicateId p, std::uint64_t arity, ObjectId first) {
    return p | arity << 16 | std::uint64_t{first} << 32;
  }
  // Branch-free: the ids are compared in registers.
  friend bool operator==(const Query& a, const Query& b) {
    std::uint32_t differ = static_cast<std::uint32_t>(a.predicate ^ b.predicate) |
                           static_cast<std::uint32_t>(a.arity ^ b.arity);
    for (std::size_t i = 0; i < kMaxArity; ++i) differ |= a.ids[i] ^ b.ids[i];
    return differ == 0;
  }
};

static_assert(sizeof(Query) == 3 * sizeof(Query::Piece) && offsetof(Query, predicate) == 0 && offsetof(Query, arity) == 2 &&
              offsetof(Query, ids) == 4);

// The sum of the arguments, modulo 2^32. Queries with different sums are not permutations of each
// other: a quick test, in registers.
inline ObjectId sum_of_ids(const Query& q) {
  ObjectId sum = 0;
  for (const ObjectId id : q.ids) sum += id;  // unused places are zero
  return sum;
}

// True if two of the arguments are the same object. For up to five arguments the only branch is
// that on the arity; repeats_an_object_of_many is the case of more.
bool repeats_an_object_of_many(const Query& q);
inline bool repeats_an_object(const Query& q) {
  const auto equal = [&q](std::size_t i, std::size_t j) {
    return static_cast<unsigned>(q.ids[i] == q.ids[j]);
  };
  if (q.arity > 5) [[unlikely]] return repeats_an_object_of_many(q);
  unsigned same = 0;
  switch (q.arity) {
    case 5:
      same = equal(4, 0) | equal(4, 1) | equal(4, 2) | equal(4, 3);
      [[fallthrough]];
    case 4:
      same |= equal(3, 0) | equal(3, 1) | equal(3, 2);
      [[fallthrough]];
    case 3:
      same |= equal(2, 0) | equal(2, 1);
      [[fallthrough]];
    case 2:
      same |= equal(1, 0);
      [[fallthrough]];
    default:
      return same != 0;
  }
}

// The arguments in ascending order; unused places stay zero, at the end.
inline std::array<ObjectId, kMaxArity> sorted_ids(const Query& query) {
  std::array<ObjectId, kMaxArity> ids = query.ids;
  for (std::size_t i = 1; i < query.arity; ++i) {
    const ObjectId id = ids[i];
    std::size_t j = i;
    for (; j > 0 && ids[j - 1] > id; --j) ids[j] = ids[j - 1];
    ids[j] = id;
  }
  return ids;
}

// A failure time in the form of the queue. [lo, hi] contains the exact instant. `root` is a handle
// of the exact number in the arithmetic's table (root_table.h); 0: none has been made, the usual
// case. A certificate that never fails has lo = hi = +infinity.
struct FailureTime {
  double lo = 0;
  double hi = 0;
  std::uint32_t root = 0;
};

}  // namespace kinex

#endif

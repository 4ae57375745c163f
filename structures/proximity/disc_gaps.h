// SPDX-License-Identifier: GPL-3.0-or-later
// DiscGaps: claims (CasedClaims, structures/parts/match_proof.h) about pairs of discs: the pair of the
// smaller gap |ab| - r_a - r_b is in front.
//
// With A, B the squared distances of two pairs and s the difference of their sums of radii, the gap of
// the first is the smaller one iff sqrt(A) <= sqrt(B) + s, that is in one of three cases
// (predicates/points/gap_predicates.h):
//
//   I    s >= 0, gap_left >= 0
//   II   s >= 0, gap_product <= 0
//   III  s <= 0, gap_right >= 0, gap_product >= 0
//
// Case I is taken where it holds. So gaps that come to be identically equal are noticed: where they are
// and gap_product vanished before, the gaps differed in case I alone, with gap_left > 0 before and < 0
// after; else gap_product, which vanishes from then on, belongs to a new motion.
//
// Ties. Of two pairs with identically equal gaps the lexicographically smaller one is in front.
#ifndef KINEX_STRUCTURES_PROXIMITY_DISC_GAPS_H
#define KINEX_STRUCTURES_PROXIMITY_DISC_GAPS_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/engine/kernel.h"
#include "structures/parts/match_proof.h"
#include "structures/parts/shared_queries.h"

namespace kinex {

class DiscGaps {
 public:
  using Value = std::array<ObjectId, 2>;  // a pair, ids ascending
  enum Case : std::uint8_t { kFirst, kSecond, kThird };

  // Throws std::invalid_argument unless the dimension is 1, 2 or 3.
  DiscGaps(Kernel& kernel, int dimension);

  // Of different pairs, which may share a disc.
  CaseChoice choose(Kernel& kernel, const Value& front, const Value& back) const;
  Conjunction claims_of(std::uint8_t which, const Value& front, const Value& back) const;
  // Resolves ties.
  bool goes_first(const Value& a, const Value& b) const { return a < b; }
  // Two pairs, the degree of motions and radii: the most failures of certificates about them, for one
  // motion of each disc, and the most changes of their order.
  static int most_failures(int degree) { return 13 * degree; }
  static int most_orders(int degree) { return 4 * degree; }
  std::size_t bytes() const;

 private:
  enum Term : std::uint8_t { kRadii, kLeft, kRight, kProduct };
  struct Signed {
    SharedQueries plus, minus;
    Signed(Kernel& kernel, int dimension, int term);
  };
  // "term(front, back) >= 0", or "<= 0". Claims about two pairs name their discs in one order, so that
  // an arithmetic finds the roots of one by the other.
  Query query(Term term, bool negated, const Value& front, const Value& back) const;

  std::array<Signed, 4> terms_;
};

}  // namespace kinex

#endif

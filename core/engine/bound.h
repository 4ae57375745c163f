// SPDX-License-Identifier: GPL-3.0-or-later
// Hard bounds: explicit integers for the given input, from theorems with known constants.
#ifndef KINEX_CORE_ENGINE_BOUND_H
#define KINEX_CORE_ENGINE_BOUND_H

#include <cstdint>
#include <string>
#include <vector>

#include "core/engine/ledger.h"
#include "core/motion/scene.h"
#include "core/numbers/integer.h"

namespace kinex {

// What a bound may depend on.
struct BoundContext {
  // Per object that the structure is built from, in the order of their ids: how many motion pieces
  // were in force during the run (>= 1).
  std::vector<int> pieces;
  std::vector<ObjectId> members = {};  // those objects; empty: all objects of the scene
  int degree = 1;                      // largest motion degree
  bool dynamic = false;                // objects were inserted or erased, or jumped
  const StructureLedger* ledger = nullptr;

  std::size_t objects() const { return pieces.size(); }
  // The place in `pieces` of an object, which must be one that the structure is built from.
  // O(log members).
  std::size_t place(ObjectId object) const;
  // No flight-plan change, insertion or erasure: the bounds of the static theorems apply.
  bool plain() const;
};

// A count of a ledger, as an integer.
inline Integer counted(std::uint64_t k) { return Integer(static_cast<std::int64_t>(k)); }

struct BoundCheck {    // a hard bound, and the observed count
  std::string id;      // stable name, for example "sorted_list.swaps"
  std::string source;  // the reason of the bound, for reports
  Integer bound;
  Integer observed;
  bool holds = true;
};

// The check "observed <= bound"; `holds` is its result.
BoundCheck at_most(std::string id, std::string source, Integer bound, Integer observed);

// Upper bound on the Davenport-Schinzel number lambda_s(n): the largest number of pieces of the
// lower envelope of n functions of which any two cross at most s times. 0 for n <= 0.
//
//   s = 0           1
//   s = 1           n
//   s = 2           2n - 1
//   s = 3, n <= 8   1, 4, 8, 12, 17, 22, 27, 32 (known values)
//   else            the smaller of
//                     (a) s n(n-1)/2 + 1: the envelope changes only where two functions cross;
//                     (b) for s = 3, n (4 + 2 ceil(log2(n / 8)))
//
// Proof of (b): lambda_3(n) / n <= lambda_3(n-1) / (n-1) + 2 / (n-1), by removing the rarest symbol
// and one of two neighbours that become equal. So lambda_3(n) <= 4 n + 2 n (H(n-1) - H(7)), which
// is at most (b).
// Source: Sharir and Agarwal, "Davenport-Schinzel sequences and their geometric applications"
// (1995); the values for s = 3: OEIS A002004.
Integer davenport_schinzel_bound(int s, const Integer& n);

// n(n-1)/2; 0 for n <= 0.
Integer pairs(const Integer& n);

// Sum over all pairs of objects of the number of sign changes of a function of the pair during the
// run. The function is a polynomial of degree `degree` on each joint piece of the two motions, and
// continuous where pieces meet (or one of the two objects is absent). m pieces have at most
// degree * m roots and m - 1 meeting points; a and b pieces make at most a + b - 1 joint pieces. If
// every object has one piece the sum is degree * n(n-1)/2. `common`: pieces of one more motion that
// the functions of all pairs depend on. O(n).
Integer pair_sign_changes(const std::vector<int>& pieces, int degree, int common = 1);

}  // namespace kinex

#endif

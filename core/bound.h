// SPDX-License-Identifier: GPL-3.0-or-later
// Hard bounds: explicit integers for this very input, from theorems with known constants.
#ifndef KINEX_CORE_BOUND_H
#define KINEX_CORE_BOUND_H

#include <string>
#include <vector>

#include "core/integer.h"
#include "core/ledger.h"

namespace kinex {

// What a bound may depend on.
struct BoundContext {
  std::vector<int>
      pieces;            // per object, how many motion pieces were in force during the run (>= 1)
  int degree = 1;        // largest motion degree
  bool dynamic = false;  // objects were inserted or erased, or jumped
  const StructureLedger* ledger = nullptr;

  std::size_t objects() const { return pieces.size(); }
  // No flight-plan change, insertion or erasure: the bounds of the static theorems apply.
  bool plain() const;
};

struct BoundCheck {
  std::string id;      // stable name, for example "sorted_list.swaps"
  std::string source;  // where the bound comes from
  Integer bound;
  Integer observed;
  bool holds = true;
};

// observed <= bound.
BoundCheck at_most(std::string id, std::string source, Integer bound, Integer observed);

// Largest number of pieces of the lower envelope of n functions of which any two cross at most s
// times (Davenport-Schinzel numbers lambda_s(n)): 1 for s = 0, n for s = 1, 2n - 1 for s = 2, the
// known values for s = 3 and n <= 8 (1, 4, 8, 12, 17, 22, 27, 32), and else the smaller one of two proven
// upper bounds: s n(n-1)/2 + 1 (every change of the envelope is at a crossing of two functions); and
// for s = 3, from lambda_3(n) / n <= lambda_3(n-1) / (n-1) + 2 / (n-1) (take out the rarest symbol, and
// two neighbours that become equal), 4 n + 2 n (H(n-1) - H(7)) <= n (4 + 2 ceil(log2(n / 8))). 0 for
// n <= 0.
// Source: Sharir and Agarwal, "Davenport-Schinzel sequences and their geometric applications"
// (1995); the values for s = 3: OEIS A002004.
Integer davenport_schinzel_bound(int s, const Integer& n);

// n(n-1)/2; 0 for n <= 0.
Integer pairs(const Integer& n);

// Sum over all pairs of objects of how often the sign of a function of the pair can change during
// the run: its values are polynomials of degree `degree` on each joint piece of the two motions and
// continuous where pieces meet (or one of the two is absent). m pieces have at most degree * m
// roots and m - 1 meeting points, and pieces a and b make at most a + b - 1 joint pieces. A run in
// which nobody has more than one piece gives degree * n(n-1)/2. `common`: pieces of one more motion
// that the functions of all pairs depend on. O(n).
Integer pair_sign_changes(const std::vector<int>& pieces, int degree, int common = 1);

}  // namespace kinex

#endif

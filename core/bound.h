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
  std::vector<int> pieces;  // per object, how many motion pieces were in force during the run (>= 1)
  int degree = 1;           // largest motion degree
  bool dynamic = false;     // objects were inserted or erased, or jumped
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

// Largest number of pieces of the lower envelope of n functions of which any two cross at most s times
// (Davenport-Schinzel numbers lambda_s(n)): exact for s <= 2; for larger s a proven upper bound:
// s = 3 the exact values up to n = 8, else min(2n*ln-type bounds are not used) s*n(n-1)/2 + 1.
Integer davenport_schinzel_bound(int s, const Integer& n);

}  // namespace kinex

#endif

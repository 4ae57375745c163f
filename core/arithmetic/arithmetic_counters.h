// SPDX-License-Identifier: GPL-3.0-or-later
// Counts of the queries to an arithmetic, by the stage that answered them.
#ifndef KINEX_CORE_ARITHMETIC_ARITHMETIC_COUNTERS_H
#define KINEX_CORE_ARITHMETIC_ARITHMETIC_COUNTERS_H

#include <array>
#include <cstdint>
#include <vector>

namespace kinex {

// The stages that can answer a query, cheapest first.
enum class Stage : std::uint8_t { kDouble, kWide, kMultiprecision, kExact };
inline constexpr int kStages = 4;  // the number of stages
using StageCounts = std::array<std::uint64_t, kStages>;  // a count per stage

struct PredicateCounters {  // the queries of one predicate
  StageCounts signs{};
  StageCounts failures{};     // failure times computed
  StageCounts looks{};        // lazy scheduling: windows after the first one
  StageCounts comparisons{};  // of a failure time (the first of two) with overlapping enclosures
};

struct ArithmeticCounters {  // all queries of a run
  std::vector<PredicateCounters> by_predicate;  // indexed by PredicateId
  StageCounts comparisons{};                    // of overlapping enclosures
  // polynomials_solved[d]: failure times computed for polynomials of degree d (the cost in the
  // report is a weighted sum of these).
  std::vector<std::uint64_t> polynomials_solved;
  std::uint64_t roots_made_exact = 0;
  std::uint64_t refinements = 0;
  std::uint64_t gcds = 0;
  std::uint64_t max_bits = 0;  // largest coefficient bit length met in exact work
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger: the counts of a run. Plain 64-bit counters owned by the run, always on, always exact.
#ifndef KINEX_CORE_LEDGER_H
#define KINEX_CORE_LEDGER_H

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace kinex {

// The stages that can answer a query, cheapest first.
enum class Stage : std::uint8_t { kDouble, kWide, kMultiprecision, kExact };
inline constexpr int kStages = 4;
using StageCounts = std::array<std::uint64_t, kStages>;

struct PredicateCounters {
  StageCounts signs{};
  StageCounts failures{};     // failure times computed
  StageCounts looks{};        // lazy scheduling: windows after the first one
  StageCounts comparisons{};  // of a failure time (the first of two) with overlapping enclosures
};

struct ArithmeticCounters {
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

// Certificates changed per failure, for responsiveness: histogram[k] counts failures with k
// changes; the last bin collects the rest.
struct ChangeStatistics {
  static constexpr int kBins = 64;
  std::uint64_t events = 0;
  std::uint64_t total = 0;
  std::uint64_t max = 0;
  std::array<std::uint64_t, kBins> histogram{};

  void add(std::uint64_t k) {
    ++events;
    total += k;
    if (k > max) max = k;
    ++histogram[k < kBins ? k : kBins - 1];
  }
};

struct StructureLedger {
  // processed = external + internal.
  //   external  reported changes of the attribute, as many as the event log marks so: from
  //             failures, ends of instants ("settled"), rebuilds, and watched structures
  //   internal  failures that reported no such change
  // A failure that changes the attribute twice counts as two events. Updates, insertions, erasures
  // and rebuilds that change nothing are not counted.
  std::uint64_t processed = 0;
  std::uint64_t external = 0;
  std::uint64_t internal = 0;
  std::uint64_t failures = 0;  // certificate failures handled
  std::uint64_t records = 0;   // reports: events, and changes of the scene
  std::uint64_t rebuilds = 0;
  std::map<std::string, std::uint64_t> rebuild_reasons;
  std::uint64_t simultaneous_groups = 0;  // instants with two or more failures of this structure
  std::uint64_t largest_group = 0;
  std::map<std::string, std::uint64_t> by_kind;  // of events, also updates, insertions and erasures
  std::uint64_t motion_updates = 0;
  std::uint64_t insertions = 0;
  std::uint64_t erasures = 0;
  std::uint64_t certificates_created = 0;
  std::uint64_t certificates_retracted = 0;
  std::uint64_t live = 0;
  std::uint64_t max_live = 0;
  std::uint64_t max_per_object = 0;
  // Lazy scheduling: failure times found; those of certificates that were retracted before they
  // failed; proofs that a certificate holds up to a limit.
  std::uint64_t failures_found = 0;
  std::uint64_t failures_unused = 0;
  std::uint64_t windows = 0;
  ChangeStatistics created_per_event;
  ChangeStatistics retracted_per_event;
  std::uint64_t audit_checks = 0;
  std::uint64_t audit_violations = 0;
  bool corrupt = false;  // an inexact arithmetic led to an impossible state
  std::string corruption;
  double seconds = 0;  // CPU time of its work, without reports and audits

  // Events per external event; 0 if there was none.
  double efficiency() const {
    return external == 0 ? 0.0 : static_cast<double>(processed) / static_cast<double>(external);
  }
};

struct RunLedger {
  std::uint64_t max_queue = 0;
  std::uint64_t events = 0;  // certificate failures over all structures
  std::uint64_t instants = 0;
  std::uint64_t peak_bytes = 0;
};

}  // namespace kinex

#endif

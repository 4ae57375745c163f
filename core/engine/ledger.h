// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger: the counts of a run. Plain 64-bit counters owned by the run, always on, always exact.
#ifndef KINEX_CORE_ENGINE_LEDGER_H
#define KINEX_CORE_ENGINE_LEDGER_H

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>

namespace kinex {

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

// The line of one part of a structure. Unlike those of the whole structure, the largest number of
// live certificates is taken at every moment, also in the middle of a repair.
struct PartLedger {
  std::string name;
  std::uint64_t failures = 0;
  std::uint64_t created = 0;
  std::uint64_t retracted = 0;
  std::uint64_t live = 0;
  std::uint64_t max_live = 0;
};

struct StructureLedger {  // the counts of one structure
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
  // Of a structure made of parts (structures/parts/slots.h); they add up to the counts above.
  std::deque<PartLedger> parts;
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

struct RunLedger {  // the counts of all structures together
  std::uint64_t max_queue = 0;
  std::uint64_t events = 0;  // certificate failures over all structures
  std::uint64_t instants = 0;
  std::uint64_t peak_bytes = 0;
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Traces: the events of a run with their instants. Traces of one scene in different arithmetics can be
// compared event by event.
#ifndef KINEX_EXPERIMENTS_TRADE_TRACE_H
#define KINEX_EXPERIMENTS_TRADE_TRACE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/event.h"
#include "core/numbers/real_root.h"

namespace kinex::trade {

// One number for each (kind, ids), the same in all runs that share the table.
class EventNames {
 public:
  std::uint32_t number(const Event& event);
  std::size_t size() const { return numbers_.size(); }

 private:
  using Name = std::array<std::uint32_t, kMaxArity + 2>;
  std::map<Name, std::uint32_t> numbers_;
};

// The trace of a run in an exact arithmetic. Refining its instants has no observable effect.
struct ExactTrace {
  std::vector<std::uint32_t> names;     // by event
  std::vector<std::uint32_t> instants;  // by event: index into `times`; never decreases
  std::vector<RealRoot> times;          // strictly ascending

  std::size_t size() const { return names.size(); }
};

// The trace of a run in an inexact arithmetic: the numbers that it used as instants, exactly.
struct InexactTrace {
  std::vector<std::uint32_t> names;
  std::vector<std::optional<Rational>> times;  // by event; nullopt: not a finite number

  std::size_t size() const { return names.size(); }
};

// Sinks that record traces. At every event ExactRecorder stores the exact root that is now, and
// InexactRecorder the rational value of the number that the arithmetic uses for it.
class ExactRecorder final : public EventSink {
 public:
  explicit ExactRecorder(EventNames& names) : names_(names) {}
  void event(const Event& event, Arithmetic& arithmetic) override;
  ExactTrace trace;

 private:
  EventNames& names_;
  RootCounters counters_;
  std::uint64_t last_ = 0;  // the number of the instant recorded last
};

class InexactRecorder final : public EventSink {
 public:
  explicit InexactRecorder(EventNames& names) : names_(names) {}
  void event(const Event& event, Arithmetic& arithmetic) override;
  InexactTrace trace;

 private:
  EventNames& names_;
};

// True if events, order and instants are exactly the same. May refine the instants.
bool equal(ExactTrace& a, ExactTrace& b);

// A rational number with the same decimals as the instant, as many as time_decimal writes: the
// instant itself if it is rational. May refine the instant.
Rational rational_near(RealRoot& instant, RootCounters& counters);
// With 17 decimals, rounded towards zero: "0.26376261582597332".
std::string time_decimal(const Rational& time);
std::optional<std::string> time_decimal(const std::optional<Rational>& time);

}  // namespace kinex::trade

#endif

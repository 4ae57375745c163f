// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a scene and records it.
//
// The attribute is read from the structure after every call that may change it: after the repair of
// a failure, after an insertion, and so on. A change is attributed to the first event that the
// structure reported during the call; later events of the same repair (ties put in order) have no
// change. The same holds for the proofs.
#ifndef KINEX_EXPERIMENTS_VIEW_RECORDER_H
#define KINEX_EXPERIMENTS_VIEW_RECORDER_H

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/engine/simulator.h"
#include "experiments/view/proof_recorder.h"
#include "experiments/view/recorded_run.h"

namespace kinex::view {

// The value of RecordedRun::stopped if an observer ended the run.
inline constexpr std::string_view kLogEnds = "the log ends here";

// The external events of a structure do not lead to its attribute: a fault of the structure.
class MisreportedEvents : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// An event as reported to an observer.
struct SeenEvent {
  std::uint64_t number;  // from 1
  std::string_view structure, kind;
  std::span<const std::string_view> ids;         // names
  std::span<const std::string_view> gone, came;  // likewise: of the event's difference
  const Event& event;
  const InstantName& instant;
};

struct RecordOptions {
  std::string arithmetic = "exact";
  std::optional<Rational> from;                 // default: the scene's start
  std::uint64_t max_events = ~std::uint64_t{};  // recorded; the run stops soon after
  std::uint64_t most_visits = ProofRecorder::kMostVisits;
  // Called for every event, recorded or not; false: the run ends at this event.
  std::function<bool(const SeenEvent&)> observe;
  std::function<bool(const Simulator&)> progress;  // as in SimulatorOptions
  const std::atomic<bool>* interrupt = nullptr;    // likewise
};

// The scene's end, if it has one, must lie after options.from. Throws InputError for an unknown
// arithmetic. Cost: the run's, and O(size of the attribute) for each external event.
RecordedRun record_run(const Scene& scene, const RecordOptions& options);

}  // namespace kinex::view

#endif

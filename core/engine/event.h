// SPDX-License-Identifier: GPL-3.0-or-later
// Event: one change made by a run, as plain data that can be printed, hashed, stored and replayed.
#ifndef KINEX_CORE_ENGINE_EVENT_H
#define KINEX_CORE_ENGINE_EVENT_H

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/engine/certificate.h"

namespace kinex {

class Arithmetic;

struct Event {
  StructureId structure = 0;
  std::uint8_t kind = 0;  // rank in the structure's event_kinds()
  std::uint8_t count = 0;
  bool external = false;  // the attribute changed
  std::array<ObjectId, kMaxArity> ids{};
  // The certificate whose failure caused it; arity 0 for updates, insertions, erasures.
  Query certificate;
  std::string_view reason;  // of a rebuild, else empty; lives as long as the run
  // What left the attribute and what joined it, where the event's own ids do not determine it:
  //   edges            the pairs, flattened, each with the smaller id first, pairs ascending
  //   sequence, cycle  the whole attribute before and after
  //   object           that object, or nothing
  // Both are empty if the ids determine the change. Valid during the call of the sink.
  std::span<const ObjectId> gone, came;

  bool has_difference() const { return !gone.empty() || !came.empty(); }
};

// Receives every event of a run as it is processed; `arithmetic` can describe the present instant.
class EventSink {
 public:
  virtual ~EventSink() = default;
  virtual void event(const Event& event, Arithmetic& arithmetic) = 0;
  // All events of the instant have been received: they are final.
  virtual void instant_ended() {}
  // The run was stopped within an instant: the events since the last instant_ended() are withdrawn.
  virtual void instant_abandoned() {}
};

}  // namespace kinex

#endif

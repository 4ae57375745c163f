// SPDX-License-Identifier: GPL-3.0-or-later
// EventReporter: the interface through which a Kernel passes events on to the simulator.
#ifndef KINEX_CORE_ENGINE_EVENT_REPORTER_H
#define KINEX_CORE_ENGINE_EVENT_REPORTER_H

#include "core/engine/event.h"

namespace kinex {

// Receives the events that structures report, one call each, in the order of the reports.
class EventReporter {
 public:
  virtual ~EventReporter() = default;
  virtual void reported(const Event& event) = 0;
  // The common events "settled" and "rebuild" (structure.h): `event` has all but its kind.
  virtual void settled(Event) {}
  virtual void rebuilt(Event) {}
  // The structure's watchers are to be notified without an event.
  virtual void changed_within(StructureId) {}
};

}  // namespace kinex

#endif

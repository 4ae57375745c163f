// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef KINEX_CORE_ENGINE_EVENT_REPORTER_H
#define KINEX_CORE_ENGINE_EVENT_REPORTER_H

#include "core/engine/event.h"

namespace kinex {

// Receives what structures report.
class EventReporter {
 public:
  virtual ~EventReporter() = default;
  virtual void reported(const Event& event) = 0;
  // The common events: `event` has all but its kind.
  virtual void settled(Event) {}
  virtual void rebuilt(Event) {}
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// RefusedChange: a change of the scene at an instant inside the run that cannot be made.
#ifndef KINEX_CORE_ENGINE_REFUSED_CHANGE_H
#define KINEX_CORE_ENGINE_REFUSED_CHANGE_H

#include <stdexcept>
#include <string>
#include <utility>

#include "core/numbers/rational.h"

namespace kinex {

// The message names what was refused and why. Everything before `time` is correct. The run that
// threw cannot continue; a run with SimulatorOptions::stop_before ends before `time`.
class RefusedChange : public std::invalid_argument {
 public:
  RefusedChange(Rational time, const std::string& message)
      : std::invalid_argument(message), time_(std::move(time)) {}
  const Rational& time() const { return time_; }

 private:
  Rational time_;
};

}  // namespace kinex

#endif

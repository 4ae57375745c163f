// SPDX-License-Identifier: GPL-3.0-or-later
// ChangesDigest: a digest of the external events of a run, of all its structures, whatever their
// order and the arithmetic's numbers for their instants. Two runs with one digest report the same
// changes.
#ifndef KINEX_EXPERIMENTS_LAB_BENCH_CHANGES_H
#define KINEX_EXPERIMENTS_LAB_BENCH_CHANGES_H

#include <cstdint>

#include "core/engine/event.h"

namespace kinex::lab {

class ChangesDigest final : public EventSink {
 public:
  void event(const Event& event, Arithmetic& arithmetic) override;
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0;  // of the hashes of the events
};

}  // namespace kinex::lab

#endif

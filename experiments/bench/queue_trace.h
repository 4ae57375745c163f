// SPDX-License-Identifier: GPL-3.0-or-later
// The operations that a real run performs on its event queue, recorded so that other queues can
// replay them.
#ifndef KINEX_EXPERIMENTS_BENCH_QUEUE_TRACE_H
#define KINEX_EXPERIMENTS_BENCH_QUEUE_TRACE_H

#include <cstdint>
#include <vector>

#include "core/motion/scene.h"

namespace kinex::bench {

struct QueueOperation {
  enum class Kind : std::uint8_t { kPush, kReset, kRemove, kPop };
  Kind kind;
  std::uint32_t id;  // of the certificate; kPop: of the certificate that the run handled
  double lo, hi;     // kPush, kReset: the enclosure of the failure time
};

struct QueueTrace {
  std::size_t certificates = 0;  // ids are below
  std::size_t events = 0;
  std::vector<QueueOperation> operations;
};

// Runs the first structure that the scene maintains, one that reads no other, in `exact` for at most
// `events` failures, and compares the queue before and after each. O(live certificates) a failure:
// for recording only.
QueueTrace record_queue(const Scene& scene, std::uint64_t events);

}  // namespace kinex::bench

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a query of a library in a process of its own, which may crash or hang.
#ifndef KINEX_EXPERIMENTS_PEERS_WORKER_H
#define KINEX_EXPERIMENTS_PEERS_WORKER_H

#include <vector>

#include "experiments/peers/method.h"

namespace kinex::peers {

struct WorkerLimits {
  double seconds = 5;          // of wall time for one question
  double measure_seconds = 0;  // the query is repeated for this time to measure it; 0: once
};

// One answer per question. Float methods get the nearest floats. Throws std::runtime_error if
// no process can be started or the module cannot be loaded.
std::vector<PeerAnswer> ask_all(const PeerMethod& method, const std::vector<PeerCase>& questions,
                                const WorkerLimits& limits = {});

}  // namespace kinex::peers

#endif

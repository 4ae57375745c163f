// SPDX-License-Identifier: GPL-3.0-or-later
// AttemptProvenance: what made the records of an attempt, as the first line of its file.
#ifndef KINEX_EXPERIMENTS_SWEEP_ATTEMPT_PROVENANCE_H
#define KINEX_EXPERIMENTS_SWEEP_ATTEMPT_PROVENANCE_H

#include <string>
#include <string_view>

#include "experiments/lab/machine.h"
#include "experiments/sweep/plan.h"

namespace kinex::sweep {

struct AttemptProvenance {
  std::string plan_name, plan_hash;
  std::string plan;     // Plan::text
  std::string program;  // program_identity()
  lab::BuildFacts build;
  lab::MachineFacts machine;
  std::string host, command, shard;
  std::string job;      // of a batch system; empty: none
  std::string started;  // UTC
};

// Of this program on this machine, now.
AttemptProvenance provenance_of(const PlanText& plan, std::string command, std::string shard);

std::string provenance_line(const AttemptProvenance& provenance);
AttemptProvenance parse_provenance(std::string_view line, const std::string& file);

}  // namespace kinex::sweep

#endif

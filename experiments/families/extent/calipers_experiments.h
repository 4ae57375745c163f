// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on rotating calipers: diameter, width, rectangles.
#ifndef KINEX_EXPERIMENTS_FAMILIES_EXTENT_CALIPERS_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_EXTENT_CALIPERS_EXPERIMENTS_H

#include <functional>
#include <vector>

#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/trade_plan.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

// vernier.cpp
void generate_vernier(const lab::WorkloadParameters&, Scene&);
void generate_vernier_turned(const lab::WorkloadParameters&, Scene&);
void generate_comb(const lab::WorkloadParameters&, Scene&);
void generate_through_point(const lab::WorkloadParameters&, Scene&);
// calipers_cells.cpp
std::vector<lab::Workload> caliper_workloads();
std::vector<lab::TradePlan> caliper_trade();
void add_caliper_cells(lab::Catalogue& catalogue, lab::Extent extent);
// caliper_study.cpp
lab::StudyResult study_calipers(bool quick, const std::function<bool()>& go_on);

}  // namespace kinex::families

#endif

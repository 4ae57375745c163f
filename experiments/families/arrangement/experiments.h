// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on moving lines; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_ARRANGEMENT_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_ARRANGEMENT_EXPERIMENTS_H

#include <functional>
#include <string>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/part.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

// cells.cpp
void add_arrangement_cells(lab::Catalogue& catalogue, lab::Extent extent);
// cutting_study.cpp
lab::StudyResult study_cuttings(bool quick, const std::function<bool()>& go_on);
// kds_section_7.cpp
std::vector<lab::SeriesPoint> kds_section_7_arrangements_points(bool quick);
lab::PartReport kds_section_7_arrangements_report(const std::vector<lab::SeriesResult>& results,
                                                  const std::string& command);
// kds_section_7_cuttings.cpp
lab::StudyResult study_sample_lines(bool quick, const std::function<bool()>& go_on);
lab::PartReport kds_section_7_cuttings_report(const lab::StudyResult& result,
                                              const std::string& command);
// bench_rows.cpp
std::vector<lab::BenchRow> arrangement_bench_rows(int scale);
// lines_and_points.cpp
void generate_points_through_lines(const lab::WorkloadParameters&, Scene&);
void generate_small_lines_and_points(const lab::WorkloadParameters&, Scene&);
void generate_random_lines_and_points(const lab::WorkloadParameters&, Scene&);
void generate_three_bundles(const lab::WorkloadParameters&, Scene&);
void generate_turning_pencil(const lab::WorkloadParameters&, Scene&);
void generate_small_lines(const lab::WorkloadParameters&, Scene&);
void generate_random_lines(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif

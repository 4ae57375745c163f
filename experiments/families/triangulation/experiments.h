// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on triangulations; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_TRIANGULATION_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_TRIANGULATION_EXPERIMENTS_H

#include <functional>
#include <string>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/part.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

// The fewest scenes of a mean that is compared with that of another program: the spread of a few is no
// measure of their error.
inline constexpr int kSeedsOfMeans = 40;

void add_triangulation_cells(lab::Catalogue& catalogue, lab::Extent extent);
// space_cells.cpp
void add_space_cells(lab::Catalogue& catalogue, lab::Extent extent);
// skew_curves.cpp
void generate_skew_curves(const lab::WorkloadParameters&, Scene&);
// skew_rows.cpp
void generate_skew_rows(const lab::WorkloadParameters&, Scene&);
// sheared_lattices.cpp
void generate_sheared_lattice(const lab::WorkloadParameters&, Scene&);
void generate_twice_sheared_lattice(const lab::WorkloadParameters&, Scene&);
void generate_bipyramid(const lab::WorkloadParameters&, Scene&);
// kds_section_7.cpp
std::vector<lab::SeriesPoint> kds_section_7_delaunay_points(bool quick);
lab::PartReport kds_section_7_delaunay_report(const std::vector<lab::SeriesResult>& results,
                                              const std::string& command);
// weighted_cells.cpp
void add_weighted_cells(lab::Catalogue& catalogue, lab::Extent extent);
// weighted_points.cpp
void generate_show_and_hide(const lab::WorkloadParameters&, Scene&);
void generate_breathing(const lab::WorkloadParameters&, Scene&);
void generate_small_weights(const lab::WorkloadParameters&, Scene&);
void generate_small_moving_weights(const lab::WorkloadParameters&, Scene&);
void generate_random_weights(const lab::WorkloadParameters&, Scene&);
// growth_study.cpp
lab::StudyResult study_triangulation_growth(bool quick, const std::function<bool()>& go_on);
// bench_rows.cpp
std::vector<lab::BenchRow> triangulation_bench_rows(int scale);

}  // namespace kinex::families

#endif

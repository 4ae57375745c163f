// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on the extent of point sets; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_EXTENT_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_EXTENT_EXPERIMENTS_H

#include <functional>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/part.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

// cells.cpp
void add_extent_cells(lab::Catalogue& catalogue, lab::Extent extent);
// circle_cells.cpp
void add_circle_cells(lab::Catalogue& catalogue, lab::Extent extent);
// seesaw.cpp
void generate_seesaw(const lab::WorkloadParameters&, Scene&);
// bench_rows.cpp
std::vector<lab::BenchRow> extent_bench_rows(int scale);
// direction_cells.cpp
void add_direction_cells(lab::Catalogue& catalogue, lab::Extent extent);
// direction_study.cpp
lab::StudyResult study_directions(bool quick, const std::function<bool()>& go_on);
inline constexpr const char* kDirectionsTitle = "Directions: error and events";
std::vector<lab::Figure> direction_figures(const std::vector<lab::CellResult>& cells);
// kds_section_6.cpp
lab::StudyResult study_kds_section_6(bool quick, const std::function<bool()>& go_on);
lab::PartReport kds_section_6_report(const lab::StudyResult& result, const std::string& command);
// obtuse_triangle.cpp
void generate_obtuse_triangle(const lab::WorkloadParameters&, Scene&);
// box_worst.cpp
void generate_box_worst(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif

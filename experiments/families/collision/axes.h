// SPDX-License-Identifier: GPL-3.0-or-later
// Axes: what the counts of two polygons grow with. All bodies have radius 1, so D = 2 is their diameter.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_AXES_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_AXES_H

#include <optional>
#include <string>

#include "experiments/lab/cell.h"

namespace kinex::families {

inline constexpr const char* kVerticesAxis = "vertices n";
inline constexpr const char* kMuAxis = "mu";

// The least separation in scenes with these parameters; nullopt if it is not known.
std::optional<double> known_separation(const std::string& workload,
                                    const lab::WorkloadParameters& parameters);
// mu = min(all vertices, sqrt(D / separation)); nullopt if the separation is not known.
std::optional<double> known_mu(const std::string& workload, const lab::WorkloadParameters& parameters);

// n: the vertices of each body, or of one of them.
lab::Axis vertices_axis(const lab::Cell& cell);
// Requires a workload with a separation, as does the next one.
lab::Axis mu_axis(const lab::Cell& cell);
// 4 / separation: of an approach that halves the distance, 2 to the number of halvings.
lab::Axis nearness_axis(const lab::Cell& cell);

}  // namespace kinex::families

#endif

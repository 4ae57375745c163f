// SPDX-License-Identifier: GPL-3.0-or-later
// Mean numbers of events of points in uniform motion, with or without weights, from simulations in plain
// doubles that share nothing with kinex: tests/oracles/uniform_means.cpp.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_REFERENCE_MEANS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_REFERENCE_MEANS_H

#include <string>
#include <string_view>
#include <vector>

namespace kinex::families {

struct ReferenceMean {
  std::string_view what;  // "hull", "delaunay", "heap": as the simulation names it
  int n;
  int seeds;  // it used the seeds 1 to this
  double mean;
  double error;  // standard error of the mean

  // "uniform_means hull 100 1000 (tests/oracles)": the command that prints it.
  std::string source() const;
};

// In the order of n.
std::vector<ReferenceMean> reference_means(std::string_view what);
// 0 as its seeds: there is none for n.
ReferenceMean reference_mean(std::string_view what, int n);

}  // namespace kinex::families

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/reference_means.h"

namespace kinex::families {

namespace {

// As `uniform_means WHAT N SEEDS` prints them. A test runs the short ones again (tests/oracles).
constexpr ReferenceMean kMeans[] = {
    {"heap", 4096, 200, 4273.31, 4.81},
    {"hull", 10, 2000, 10.5315, 0.065},
    {"hull", 100, 1000, 45.753, 0.241},
    {"hull", 1000, 200, 107.3, 0.986},
    {"hull", 3000, 60, 145.667, 2.18},
    {"hull", 10000, 24, 194.958, 3.38},
    {"delaunay", 10, 1000, 38.311, 0.255},
    {"delaunay", 50, 200, 592.855, 3.09},
    {"delaunay", 100, 60, 1735.25, 11.1},
    {"delaunay", 200, 40, 5026.3, 32.4},
    {"delaunay", 400, 20, 14439.1, 75.3},
    {"delaunay", 800, 10, 41118.8, 169},
    {"delaunay", 1600, 6, 116586, 278},
    {"delaunay_3", 8, 400, 32.34, 0.41},
    {"delaunay_3", 16, 1000, 171.276, 0.746},
    {"delaunay_3", 32, 120, 634.367, 5.21},
    {"regular_2", 16, 1000, 77.377, 0.369},
    {"regular_2", 32, 400, 242.958, 1.22},
    {"regular_2", 64, 60, 722.467, 6.37},
    {"regular_3", 8, 400, 30.2325, 0.349},
    {"regular_3", 16, 1000, 153.624, 0.675},
    {"regular_3", 32, 120, 552.142, 5.07},
};

}  // namespace

std::string ReferenceMean::source() const {
  return "uniform_means " + std::string(what) + " " + std::to_string(n) + " " + std::to_string(seeds) +
         " (tests/oracles)";
}

std::vector<ReferenceMean> reference_means(std::string_view what) {
  std::vector<ReferenceMean> means;
  for (const ReferenceMean& mean : kMeans) {
    if (mean.what == what) means.push_back(mean);
  }
  return means;
}

ReferenceMean reference_mean(std::string_view what, int n) {
  for (const ReferenceMean& mean : kMeans) {
    if (mean.what == what && mean.n == n) return mean;
  }
  return {what, n, 0, 0, 0};
}

}  // namespace kinex::families

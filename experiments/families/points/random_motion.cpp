// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/random_motion.h"

#include <utility>

namespace kinex::families {

namespace {

constexpr int kFewestSeeds = 8;
constexpr int kMostSeeds = 1000;
constexpr double kRelativeError = 0.02;

}  // namespace

lab::Cell uniform_cell(std::string structure, int n, int dimension) {
  lab::Cell cell;
  cell.question = "How many events does random motion cause?";
  cell.structure = std::move(structure);
  cell.workload = "uniform-square";
  cell.parameters.n = n;
  cell.parameters.dimension = dimension;
  cell.family = "uniform";
  cell.bounded = true;
  cell.random = true;
  cell.min_seeds = kFewestSeeds;
  cell.max_seeds = kMostSeeds;
  cell.precise = {{"processed", kRelativeError}};
  return cell;
}

void add_uniform_growth(lab::Catalogue& catalogue, std::string claim, std::string structure,
                        double smallest, double exponent, std::string source) {
  lab::GrowthClaim growth;
  growth.claim = std::move(claim);
  growth.structure = std::move(structure);
  growth.family = "uniform";
  growth.quantity = "processed";
  growth.smallest = smallest;
  growth.exponent = exponent;
  growth.source = std::move(source);
  catalogue.growths.push_back(std::move(growth));
}

}  // namespace kinex::families

// SPDX-License-Identifier: GPL-3.0-or-later
// Cases: the scenes on which arithmetics are compared, and those whose bits are counted over n.
//
// Question: how much correctness does a less exact arithmetic trade for its speed?
// Workloads, for every structure:
//   uniform-square       motions of degree 1, 2 and 3: ordinary scenes
//   the structure's worst case, at sizes that its family gives (lab/trade_plan.h)
//   grid                 integer velocities: simultaneous events
//   near-one-point       all events within 2^-59: nearly degenerate
// Expected: `exact` and `sturm` agree and are valid everywhere; runs in the others finish.
#ifndef KINEX_EXPERIMENTS_TRADE_CASES_H
#define KINEX_EXPERIMENTS_TRADE_CASES_H

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/workload.h"

namespace kinex::trade {

struct TradeCase {
  std::string structure;               // registered name, or a scene's label for it
  std::string name;                    // of the workload with its parameters, or of the scene
  std::string workload;                // empty: `given`
  lab::WorkloadParameters parameters;       // of the workload
  std::shared_ptr<const Scene> given;  // maintains one structure
  double cost = 0.1;                   // expected seconds, for progress
  // CPU seconds of all rounds of an arithmetic after which it is timed no more.
  double enough_seconds = 0.05;

  // With one structure to maintain.
  Scene scene() const;
};

// Scenes of one size of a family, for which only the exact run is made.
struct BitsCase {
  std::string structure, workload;
  lab::WorkloadParameters parameters;  // seeds from 1
  int seeds = 1;
  std::string family;  // "uniform-square, degree 2"
  double cost = 0.1;
};

struct TradeCatalogue {
  std::vector<TradeCase> cases;
  std::vector<BitsCase> bits;  // families consecutive, sizes ascending
};

// `what`: names of structures, "all", or files of scenes, mixed; empty means "all". Every structure
// that a scene maintains is a case. Throws InputError.
TradeCatalogue make_trade_catalogue(const std::vector<std::string>& what, lab::Extent extent);

// exact, sturm, double, gsl, mpfr:24, 53, 64, 100, 200, 400.
const std::vector<std::string>& trade_arithmetics();
// Bits of the numbers of an inexact arithmetic; 0 for an exact one.
long bits_of_arithmetic(std::string_view name);

}  // namespace kinex::trade

#endif

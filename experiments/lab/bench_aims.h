// SPDX-License-Identifier: GPL-3.0-or-later
// Aims of a benchmark: figures that a structure is to reach, beside what this run measured. They are
// reported and never asserted: times differ from machine to machine.
#ifndef KINEX_EXPERIMENTS_LAB_BENCH_AIMS_H
#define KINEX_EXPERIMENTS_LAB_BENCH_AIMS_H

#include <string>
#include <vector>

#include "experiments/lab/bench_options.h"

namespace kinex::lab {

struct Aim {
  std::string what;
  double wanted, measured;
  bool at_most;  // the measured figure is to be at most, or at least, the wanted one
  std::string unmeasured = {};  // why there is no measured figure; empty: there is one

  bool met() const {
    if (!unmeasured.empty()) return false;
    return at_most ? measured <= wanted : measured >= wanted;
  }
};

// A table of the aims, named `name` in JSON. Of an aim without a measured figure the reason stands in
// the place of yes and no. Writes nothing without aims.
void report_aims(const std::string& name, const std::vector<Aim>& aims,
                 const BenchOptions& options);

}  // namespace kinex::lab

#endif

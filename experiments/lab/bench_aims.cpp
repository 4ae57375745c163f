// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/bench_aims.h"

#include "experiments/lab/result_table.h"

namespace kinex::lab {

void report_aims(const std::string& name, const std::vector<Aim>& aims,
                 const BenchOptions& options) {
  if (aims.empty()) return;
  ResultTable table(options, name, "Aims.",
                    {{"aim", ResultTable::kText, 62},
                     {"wanted", 2, 10},
                     {"measured", 2, 10},
                     {"met", ResultTable::kText, 4}});
  for (const Aim& aim : aims)
    table.row({aim.what, aim.wanted, aim.measured, aim.met() ? "yes" : "no"});
}

}  // namespace kinex::lab

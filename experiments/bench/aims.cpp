// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bench/aims.h"

#include "experiments/lab/result_table.h"

namespace kinex::bench {

void report_aims(const std::string& name, const std::vector<Aim>& aims,
                 const lab::BenchOptions& options) {
  if (aims.empty()) return;
  lab::ResultTable table(options, name, "Aims.",
                         {{"aim", lab::ResultTable::kText, 62},
                          {"wanted", 2, 10},
                          {"measured", 2, 10},
                          {"met", lab::ResultTable::kText, 4}});
  for (const Aim& aim : aims)
    table.row({aim.what, aim.wanted, aim.measured, aim.met() ? "yes" : "no"});
}

}  // namespace kinex::bench

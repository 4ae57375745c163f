// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/bench_aims.h"

#include <algorithm>

#include "experiments/lab/result_table.h"

namespace kinex::lab {

void report_aims(const std::string& name, const std::vector<Aim>& aims,
                 const BenchOptions& options) {
  if (aims.empty()) return;
  const bool all_measured =
      std::ranges::all_of(aims, [](const Aim& aim) { return aim.unmeasured.empty(); });
  ResultTable table(options, name,
                    all_measured
                        ? "Aims."
                        : "Aims. Where the measured figure is 0, nothing could be measured, "
                          "for the reason in the last column.",
                    {{"aim", ResultTable::kText, 62},
                     {"wanted", 2, 10},
                     {"measured", 2, 10},
                     {"met", ResultTable::kText, 4}});
  for (const Aim& aim : aims) {
    const std::string answer = aim.met() ? "yes" : "no";
    table.row({aim.what, aim.wanted, aim.unmeasured.empty() ? aim.measured : 0,
               aim.unmeasured.empty() ? answer : aim.unmeasured});
  }
}

}  // namespace kinex::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/study_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace kinex::lab {

void check_run(Simulator& simulator, std::string_view run, StudyResult& study) {
  std::string trouble;
  if (!simulator.audit()) trouble = "the audit failed";
  if (!simulator.violations().empty()) trouble = simulator.violations().front();
  for (std::size_t s = 0; s < simulator.structures(); ++s) {
    for (const BoundCheck& bound : simulator.bounds(static_cast<StructureId>(s))) {
      if (!bound.holds) trouble = "the bound " + bound.id + " does not hold";
    }
  }
  if (trouble.empty()) return;
  study.checks.push_back({study.name + ".runs", "audit", "", "0 violations",
                          fmt::format("{}: {}", run, trouble), "", Verdict::kRefuted,
                          std::nullopt});
}

void refute_by_checks(const StudyResult& study, PaperClaim& claim) {
  const auto is_refuted = [](const Check& check) { return check.verdict == Verdict::kRefuted; };
  const auto first = std::find_if(study.checks.begin(), study.checks.end(), is_refuted);
  if (first == study.checks.end()) return;
  const auto count = std::count_if(study.checks.begin(), study.checks.end(), is_refuted);
  claim.verdict = Verdict::kRefuted;
  claim.observed += fmt::format("; {} of the runs failed, the first: {}: {}, expected {}",
                                count == 1 ? "a check" : fmt::format("{} checks", count),
                                first->claim, first->observed, first->expected);
}

}  // namespace kinex::lab

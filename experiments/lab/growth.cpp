// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "experiments/lab/law_verdict.h"
#include "experiments/lab/power_verdict.h"

namespace kinex::lab {

namespace {

void leave_open(Check& check, const std::string& why) {
  check.observed += why;
  if (check.verdict == Verdict::kConfirmed) check.verdict = Verdict::kOpen;
}

void judge_exponent(GrowthResult& result, const std::string& x) {
  const GrowthClaim& claim = result.claim;
  Check& check = result.check;
  check.expected = x + (claim.at_most ? "^(<= " : "^(") + number_text(claim.exponent, 4) + " +-" +
                   number_text(claim.tolerance, 3) + ")";
  PowerVerdict power = judge_power(
      result.points, {claim.exponent, claim.tolerance, claim.at_most, claim.lower_order}, x);
  check.observed = std::move(power.observed);
  check.verdict = power.verdict;
  result.corrected = std::move(power.corrected);
  if (!claim.at_most) result.neighbours = neighbours_of(result.points, {claim.exponent, 0}, x);
}

void judge_logs(GrowthResult& result, const std::string& x) {
  const GrowthClaim& claim = result.claim;
  LawVerdict law =
      judge_law(result.points, {{claim.exponent, claim.logs}, claim.tolerance, claim.at_most}, x);
  result.check.expected = std::move(law.expected);
  result.check.observed = std::move(law.observed);
  result.check.verdict = law.verdict;
  result.neighbours = std::move(law.neighbours);
}

// The cells of the claim's family, as points; what is missing from them is noted in the check.
struct Gathered {
  std::size_t cells = 0;  // with runs
  int seeds_needed = 0;   // of the cell that needs most; 0: all have enough
};

Gathered gather(GrowthResult& result, const std::vector<CellResult>& cells) {
  const GrowthClaim& claim = result.claim;
  Gathered gathered;
  for (const CellResult& cell : cells) {
    if (cell.cell.structure != claim.structure || cell.cell.family != claim.family) continue;
    if (cell.trials.empty()) continue;
    ++gathered.cells;
    result.axis = cell.cell.axis.name;
    const double x = cell.cell.axis.is_objects()
                         ? static_cast<double>(cell.trials.front().measurement.objects)
                         : cell.cell.axis.value;
    if (x < claim.smallest) continue;
    if (!precise_enough(cell.cell, cell.trials)) {
      gathered.seeds_needed = std::max(gathered.seeds_needed, seeds_needed(cell.cell, cell.trials));
    }
    const RunningMean mean = mean_of(cell.trials, claim.quantity);
    result.points.push_back({x, mean.mean(), mean.standard_error()});
  }
  std::sort(result.points.begin(), result.points.end(),
            [](const FitPoint& a, const FitPoint& b) { return a.n < b.n; });
  return gathered;
}

}  // namespace

GrowthResult judge_growth(const GrowthClaim& claim, const std::vector<CellResult>& cells) {
  GrowthResult result;
  result.claim = claim;
  Check& check = result.check;
  check.claim = claim.claim;
  check.kind = "growth";
  check.quantity = claim.quantity;
  check.source = claim.source;
  const Gathered gathered = gather(result, cells);
  result.fit = fit_power(result.points);
  const std::string base = result.axis.empty() ? "n" : "(" + result.axis + ")";
  if (claim.logs > 0) {
    judge_logs(result, base);
  } else {
    judge_exponent(result, base);
  }
  if (gathered.cells < claim.sizes) {
    leave_open(check, fmt::format(", {} of {} cells", gathered.cells, claim.sizes));
  }
  if (gathered.seeds_needed > 0) {
    check.verdict = Verdict::kOpen;
    check.seeds_needed = gathered.seeds_needed;
    check.observed += fmt::format(" (too few scenes: about {} needed)", gathered.seeds_needed);
  }
  return result;
}

}  // namespace kinex::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/lab/power_verdict.h"

namespace kinex::lab {

namespace {

constexpr std::size_t kFewestForLogs = 6;  // of a law with logarithms

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
  const Law law{claim.exponent, claim.logs};
  Check& check = result.check;
  check.expected = fmt::format("a + b {}{}, bent by {}{:.3g} % at most", law.text(x),
                               claim.at_most ? " or slower" : "", claim.at_most ? "" : "+-",
                               100 * claim.tolerance);
  const std::optional<Bend> bend = bend_of(result.points, law);
  if (!bend || result.points.size() < kFewestForLogs) {
    check.observed = "too few sizes";
    check.verdict = Verdict::kOpen;
    return;
  }
  check.observed = fmt::format("bent by {:.2g} %, 95% in [{:.2g}, {:.2g}] %", 100 * bend->value,
                               100 * bend->lower, 100 * bend->upper);
  check.verdict = compare_with_claim(bend->lower, bend->upper, 0, claim.tolerance, claim.at_most);
  result.neighbours = neighbours_of(result.points, law, x);
  if (!result.neighbours) {
    leave_open(check, ", no neighbours to compare with");
  } else if (result.neighbours->is_beaten()) {
    leave_open(check, ", and a neighbour fits better");
  } else if (!claim.at_most && !result.neighbours->beats_all()) {
    leave_open(check, ", and a neighbour fits as well");
  }
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
    const double x = claim.variable == Variable::kObjects
                         ? static_cast<double>(cell.trials.front().measurement.objects)
                         : variable_of(cell.cell, claim.variable);
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

std::optional<Bend> bend_of(const std::vector<FitPoint>& points, const Law& law) {
  double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0;
  for (const FitPoint& point : points) {
    least = std::min(least, law.at(point.n));
    most = std::max(most, law.at(point.n));
    sum += point.count;
  }
  if (points.empty() || !(sum > 0)) return std::nullopt;
  const double mean = sum / static_cast<double>(points.size());
  // From the middle of the range, in halves of it: -1 to 1.
  const double middle = (least + most) / 2, half = (most - least) / 2;
  const auto g = [=](double n) { return (law.at(n) - middle) / half; };
  const std::optional<Fit> fit =
      fit_law_with("a + b g + c g^2", points, g, [=](double n) { return g(n) * g(n); });
  if (!fit) return std::nullopt;
  return Bend{fit->c / mean, fit->c_lower / mean, fit->c_upper / mean};
}

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
  const bool objects = claim.variable == Variable::kObjects;
  const std::string base = objects ? "n" : "(" + variable_name(claim.variable) + ")";
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

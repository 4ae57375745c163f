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

void judge(GrowthResult& result, const std::string& x) {
  result.fit = fit_power(result.points);
  result.claim.logs > 0 ? judge_logs(result, x) : judge_exponent(result, x);
}

FitPoint point_at(double x, const std::vector<Trial>& trials, const Quantity& quantity) {
  const RunningMean mean = mean_of(trials, quantity);
  return {x, mean.mean(), mean.standard_error()};
}

void sort_by_size(std::vector<FitPoint>& points) {
  std::sort(points.begin(), points.end(),
            [](const FitPoint& a, const FitPoint& b) { return a.n < b.n; });
}

struct Gathered {
  std::size_t cells = 0;         // with runs
  int seeds_needed = 0;          // of the cell that needs most; 0: all have enough
  bool more = false;             // some have more scenes than they ask for
  std::vector<FitPoint> of_all;  // the points of all scenes
};

// The cells of the claim's family, as points, of the scenes that they ask for.
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
    gathered.of_all.push_back(point_at(x, cell.trials, claim.quantity));
    const std::size_t scenes = scenes_asked_for(cell.cell, cell.trials);
    if (scenes == 0) {
      gathered.seeds_needed = std::max(gathered.seeds_needed, seeds_needed(cell.cell, cell.trials));
    }
    if (scenes == 0 || scenes == cell.trials.size()) {
      result.points.push_back(gathered.of_all.back());
      continue;
    }
    gathered.more = true;
    const auto begin = cell.trials.begin();
    result.points.push_back(
        point_at(x, {begin, begin + static_cast<std::ptrdiff_t>(scenes)}, claim.quantity));
  }
  sort_by_size(result.points);
  sort_by_size(gathered.of_all);
  return gathered;
}

// What more scenes than the claim asks for would make of it, if that is another verdict.
void note_all_scenes(GrowthResult& result, std::vector<FitPoint> points, const std::string& x) {
  GrowthResult whole;
  whole.claim = result.claim;
  whole.points = std::move(points);
  judge(whole, x);
  if (whole.check.verdict == result.check.verdict) return;
  result.check.observed +=
      fmt::format("; of the scenes that the claim asks for. All scenes: {} ({})",
                  whole.check.observed, claim_word(whole.check.verdict));
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
  Gathered gathered = gather(result, cells);
  const std::string base = result.axis.empty() ? "n" : "(" + result.axis + ")";
  judge(result, base);
  if (gathered.more) note_all_scenes(result, std::move(gathered.of_all), base);
  if (gathered.cells < claim.sizes) {
    leave_open(check, fmt::format(", {} of {} cells", gathered.cells, claim.sizes));
  } else if (gathered.cells < claim.full_sizes) {
    check.observed += fmt::format(", {} of the {} cells of the full experiments", gathered.cells,
                                  claim.full_sizes);
    if (check.verdict == Verdict::kConfirmed) check.verdict = Verdict::kAgrees;
  }
  if (gathered.seeds_needed > 0) {
    check.verdict = Verdict::kOpen;
    check.seeds_needed = gathered.seeds_needed;
    check.observed += fmt::format(" (too few scenes: about {} needed)", gathered.seeds_needed);
  }
  return result;
}

}  // namespace kinex::lab

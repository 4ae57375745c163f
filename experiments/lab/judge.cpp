// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <utility>

#include "experiments/lab/scene_run.h"

namespace kinex {

namespace {

Integer whole(std::uint64_t count) { return Integer(static_cast<std::int64_t>(count)); }

std::string of_all(std::size_t good, std::size_t all) {
  return "in " + std::to_string(good) + " of " + std::to_string(all);
}

// Every run must count `expected(trial)`.
Check check_counts(const Expectation& expectation, std::size_t index,
                   const std::vector<Trial>& trials) {
  const bool witness = expectation.kind == ExpectationKind::kWitness;
  const char* const kind = witness                                         ? "witness"
                           : expectation.kind == ExpectationKind::kAtLeast ? "at least"
                           : expectation.kind == ExpectationKind::kAtMost  ? "at most"
                                                                           : "exact";
  Check check{expectation.claim,   kind,        expectation.quantity, "", "", expectation.source,
              Verdict::kConfirmed, std::nullopt};
  const auto expected = [&](std::size_t i) {
    return witness ? trials[i].witnessed[index] : expectation.exact;
  };
  const auto observed = [&](std::size_t i) {
    return whole(trials[i].measurement.count_of(expectation.quantity));
  };
  const auto is_right = [&](std::size_t i) {
    if (expectation.kind == ExpectationKind::kAtLeast) return !(observed(i) < expected(i));
    if (expectation.kind == ExpectationKind::kAtMost) return !(expected(i) < observed(i));
    return observed(i) == expected(i);
  };
  std::size_t good = 0;
  std::optional<std::size_t> shown;  // the first wrong one, or else the first
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i].measurement.status != RunStatus::kDone) {
      check.verdict = std::max(check.verdict, Verdict::kGaveUp);
    } else if (is_right(i)) {
      ++good;
      if (!shown) shown = i;
    } else if (check.verdict != Verdict::kRefuted) {
      check.verdict = Verdict::kRefuted;
      check.trial = shown = i;
    }
  }
  const bool each_its_own = witness && trials.size() > 1 && check.verdict != Verdict::kRefuted;
  const std::string limit = expectation.kind == ExpectationKind::kAtLeast  ? ">= "
                            : expectation.kind == ExpectationKind::kAtMost ? "<= "
                                                                           : "";
  check.expected = each_its_own ? "as the scenes say"
                   : shown      ? limit + expected(*shown).to_string()
                                : "-";
  check.observed = each_its_own ? "equal" : shown ? observed(*shown).to_string() : "-";
  if (trials.size() > 1) check.observed += " (right " + of_all(good, trials.size()) + ")";
  return check;
}

std::string needs_text(int seeds, std::size_t have) {
  return " (" + std::to_string(have) + (have == 1 ? " scene" : " scenes") + " cannot tell: about " +
         std::to_string(seeds) + " needed)";
}

Check check_mean(const Cell& cell, const Expectation& expectation,
                 const std::vector<Trial>& trials) {
  const RunningMean mean = mean_of(trials, expectation.quantity);
  Check check{expectation.claim,   "mean",      expectation.quantity, "", "", expectation.source,
              Verdict::kConfirmed, std::nullopt};
  check.expected = expectation.reference_error > 0
                       ? mean_text(expectation.reference, expectation.reference_error)
                       : number_text(expectation.reference, 6);
  if (expectation.tolerance > 0)
    check.expected += " (to " + number_text(expectation.tolerance, 3) + ")";
  check.observed = mean_text(mean.mean(), mean.standard_error());
  if (std::any_of(trials.begin(), trials.end(), [](const Trial& trial) {
        return trial.measurement.status != RunStatus::kDone;
      })) {
    check.verdict = Verdict::kGaveUp;
    return check;
  }
  // With fewer scenes than it takes to know their spread there is no distance.
  if (static_cast<int>(trials.size()) < cell.min_seeds) {
    check.verdict = Verdict::kOpen;
    check.seeds_needed = seeds_needed(cell, trials);
    check.observed += needs_text(check.seeds_needed, trials.size());
    return check;
  }
  const double distance =
      distance_in_errors(mean.mean(), mean.standard_error(), expectation.reference,
                         expectation.reference_error, expectation.tolerance);
  char text[48];
  std::snprintf(text, sizeof text, " (%.1f se)", distance);
  check.observed += text;
  if (distance > allowed_errors(expectation.comparisons)) {
    check.verdict = Verdict::kRefuted;
  } else if (!precise_enough(cell, trials)) {
    check.verdict = Verdict::kOpen;
    check.seeds_needed = seeds_needed(cell, trials);
    check.observed += needs_text(check.seeds_needed, trials.size());
  }
  return check;
}

// Exact comparison of observed / bound; a bound of 0 counts as reached.
bool nearer(const BoundCheck& a, const BoundCheck& b) {
  return a.observed * b.bound > b.observed * a.bound;
}

void add_bounds(const std::vector<Trial>& trials, std::vector<Check>& checks) {
  std::vector<std::string> order;
  std::map<std::string, std::pair<BoundCheck, std::size_t>> worst;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    for (const BoundCheck& bound : trials[i].measurement.bounds) {
      const auto found = worst.find(bound.id);
      if (found == worst.end()) {
        order.push_back(bound.id);
        worst.emplace(bound.id, std::pair(bound, i));
      } else if (found->second.first.holds &&
                 (!bound.holds || nearer(bound, found->second.first))) {
        found->second = {bound, i};
      }
    }
  }
  for (const std::string& id : order) {
    const auto& [bound, trial] = worst.at(id);
    checks.push_back({id, "bound", "", "<= " + bound.bound.to_string(), bound.observed.to_string(),
                      bound.source, bound.holds ? Verdict::kConfirmed : Verdict::kRefuted, trial});
  }
}

// Fails if a bound was not checked: a structure may have ceased to register it.
void add_missing_bound(const std::vector<Trial>& trials, std::vector<Check>& checks) {
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (event_bound(trials[i].measurement) != nullptr) continue;
    checks.push_back({"bounded", "bound", "", "a hard bound on the events", "none is checked", "",
                      Verdict::kRefuted, i});
    return;
  }
}

void add_runs(const std::vector<Trial>& trials, std::vector<Check>& checks) {
  Check audit{"audit", "audit", "", "0 violations", "", "", Verdict::kConfirmed, std::nullopt};
  std::optional<Check> stopped;
  std::uint64_t checked = 0, violations = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const Measurement& run = trials[i].measurement;
    checked += run.costs.audit_checks;
    violations += run.costs.audit_violations;
    if (run.status != RunStatus::kDone && !stopped) {
      stopped = Check{"run", "run", "", "runs to the end", "stopped: ", "", Verdict::kGaveUp, i};
      stopped->observed += status_name(run.status);
    }
    if (!run.clean() && !audit.trial) {
      audit.trial = i;
      audit.verdict = Verdict::kRefuted;
      audit.source = run.violations.empty() ? run.ledger.corruption : run.violations.front();
    }
  }
  audit.observed =
      std::to_string(violations) + " violations in " + std::to_string(checked) + " checks";
  checks.push_back(std::move(audit));
  if (stopped) checks.push_back(*std::move(stopped));
}

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

Verdict CellResult::verdict() const {
  Verdict worst = Verdict::kConfirmed;
  for (const Check& check : checks) worst = std::max(worst, check.verdict);
  return worst;
}

Verdict StudyResult::verdict() const {
  Verdict worst = Verdict::kConfirmed;
  for (const Check& check : checks) worst = std::max(worst, check.verdict);
  return worst;
}

RunningMean mean_of(const std::vector<Trial>& trials, const Quantity& quantity) {
  RunningMean mean;
  for (const Trial& trial : trials) {
    mean.add(static_cast<double>(trial.measurement.count_of(quantity)));
  }
  return mean;
}

bool precise_enough(const Cell& cell, const std::vector<Trial>& trials) {
  if (static_cast<int>(trials.size()) < cell.min_seeds) return false;
  return std::all_of(cell.precise.begin(), cell.precise.end(), [&](const Cell::Precise& precise) {
    const RunningMean mean = mean_of(trials, precise.quantity);
    return mean.standard_error() <= precise.relative_error * mean.mean();
  });
}

int seeds_needed(const Cell& cell, const std::vector<Trial>& trials) {
  constexpr double kMost = 1e6;  // as --seeds takes
  double needed = cell.min_seeds;
  for (const Cell::Precise& precise : cell.precise) {
    const RunningMean mean = mean_of(trials, precise.quantity);
    if (!(mean.mean() > 0)) continue;
    const double errors = mean.standard_error() / (precise.relative_error * mean.mean());
    needed = std::max(needed, std::ceil(static_cast<double>(trials.size()) * errors * errors));
  }
  return static_cast<int>(std::min(needed, kMost));
}

std::vector<Check> judge(const Cell& cell, const std::vector<Trial>& trials) {
  std::vector<Check> checks;
  for (std::size_t i = 0; i < cell.expectations.size(); ++i) {
    const Expectation& expectation = cell.expectations[i];
    checks.push_back(expectation.kind == ExpectationKind::kMean
                         ? check_mean(cell, expectation, trials)
                         : check_counts(expectation, i, trials));
  }
  add_bounds(trials, checks);
  if (cell.bounded) add_missing_bound(trials, checks);
  add_runs(trials, checks);
  return checks;
}

const BoundCheck* event_bound(const Measurement& measurement) {
  for (const BoundCheck& bound : measurement.bounds) {
    if (ends_with(bound.id, ".events") || ends_with(bound.id, ".swaps") ||
        ends_with(bound.id, ".passes") || ends_with(bound.id, ".line")) {
      return &bound;
    }
  }
  return nullptr;
}

namespace {

// Fits a + b log2 x and a + b x to the points of the result.
void judge_logarithm(GrowthResult& result, const std::string& x) {
  constexpr std::size_t kFewestSizes = 6;
  constexpr double kHardlyDiffer = 0.03;  // of the mean: both fits follow the noise
  const GrowthClaim& claim = result.claim;
  Check& check = result.check;
  char text[160];
  std::snprintf(text, sizeof text,
                "a + b log2 %s within %.3g %%, twice as near as a line, %s^(<= %.3g)", x.c_str(),
                100 * claim.tolerance, x.c_str(), claim.exponent);
  check.expected = text;
  RunningMean counts;
  for (const FitPoint& point : result.points) counts.add(point.count);
  const double mean = counts.mean();
  const auto unweighted = [&](std::string law, std::function<double(double)> g) {
    std::vector<FitPoint> points = result.points;
    for (FitPoint& point : points) point.error = 0;
    return fit_law(std::move(law), points, std::move(g));
  };
  const std::optional<Fit> logarithm =
      unweighted("a + b log2 x", [](double n) { return std::log2(n); });
  const std::optional<Fit> line = unweighted("a + b x", [](double n) { return n; });
  if (!logarithm || !line || !result.fit || result.points.size() < kFewestSizes) {
    check.observed = "too few sizes";
    check.verdict = Verdict::kOpen;
    return;
  }
  std::snprintf(text, sizeof text, "%.3g + %.3g log2 %s within %.2g %%, a line %.2g %%, %s^%.3f",
                logarithm->a, logarithm->b, x.c_str(), 100 * logarithm->scatter / mean,
                100 * line->scatter / mean, x.c_str(), result.fit->b);
  check.observed = text;
  const bool nearer =
      counts.deviation() <= kHardlyDiffer * mean || 2 * logarithm->scatter <= line->scatter;
  if (!nearer || logarithm->scatter > claim.tolerance * mean || result.fit->b > claim.exponent) {
    check.verdict = Verdict::kRefuted;
  }
}

void judge_exponent(GrowthResult& result, const std::string& x) {
  constexpr int kFewestExactSizes = 4;  // three may lie on a power by chance
  const GrowthClaim& claim = result.claim;
  Check& check = result.check;
  check.expected = x + (claim.at_most ? "^(<= " : "^(") + number_text(claim.exponent, 4) + " +-" +
                   number_text(claim.tolerance, 3) + ")";
  if (!result.fit) {
    check.observed = "too few sizes";
    check.verdict = Verdict::kOpen;
    return;
  }
  const Fit& fit = *result.fit;
  char text[96];
  std::snprintf(text, sizeof text, "^%.4f, 95%% in [%.4f, %.4f]", fit.b, fit.lower, fit.upper);
  check.observed = x + text;
  check.verdict =
      compare_with_claim(fit.lower, fit.upper, claim.exponent, claim.tolerance, claim.at_most);
  if (check.verdict == Verdict::kConfirmed && !fit.weighted &&
      fit.degrees + 2 < kFewestExactSizes) {
    check.observed += ", too few sizes";
    check.verdict = Verdict::kOpen;
  }
}

}  // namespace

GrowthResult judge_growth(const GrowthClaim& claim, const std::vector<CellResult>& cells) {
  GrowthResult result{claim, {}, std::nullopt, {}};
  int too_few = 0;  // seeds needed where a cell has fewer than it needs at least
  for (const CellResult& cell : cells) {
    if (cell.cell.structure != claim.structure || cell.cell.family != claim.family) continue;
    if (cell.trials.empty()) continue;
    const double x = claim.variable == Variable::kObjects
                         ? static_cast<double>(cell.trials.front().measurement.objects)
                         : variable_of(cell.cell, claim.variable);
    if (x < claim.smallest) continue;
    if (static_cast<int>(cell.trials.size()) < cell.cell.min_seeds) {
      too_few = std::max(too_few, seeds_needed(cell.cell, cell.trials));
    }
    const RunningMean mean = mean_of(cell.trials, claim.quantity);
    result.points.push_back({x, mean.mean(), mean.standard_error()});
  }
  std::sort(result.points.begin(), result.points.end(),
            [](const FitPoint& a, const FitPoint& b) { return a.n < b.n; });
  result.fit = fit_power(result.points);
  Check& check = result.check;
  check.claim = claim.claim;
  check.kind = "growth";
  check.quantity = claim.quantity;
  check.source = claim.source;
  const bool objects = claim.variable == Variable::kObjects;
  const std::string base = objects ? "n" : "(" + variable_name(claim.variable) + ")";
  if (claim.logarithm) {
    judge_logarithm(result, base);
  } else {
    judge_exponent(result, base);
  }
  if (too_few > 0) {
    check.verdict = Verdict::kOpen;
    check.seeds_needed = too_few;
    check.observed += " (too few scenes: about " + std::to_string(too_few) + " needed)";
  }
  return result;
}

std::string number_text(double value, int digits) {
  char text[64];
  if (value == std::floor(value) && std::fabs(value) < 1e15) {
    std::snprintf(text, sizeof text, "%.0f", value);
  } else {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
  }
  return text;
}

std::string mean_text(double mean, double error) {
  if (!(error > 0)) return number_text(mean, 6);
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 9);
  char text[96];
  std::snprintf(text, sizeof text, "%.*f +-%.*f", places, mean, places, error);
  return text;
}

}  // namespace kinex

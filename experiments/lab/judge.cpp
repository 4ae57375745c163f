// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "experiments/formats/counted.h"
#include "experiments/lab/family.h"
#include "experiments/lab/scene_run.h"

namespace kinex::lab {

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
      stopped->observed += formats::status_name(run.status);
    }
    if (!run.clean() && !audit.trial) {
      audit.trial = i;
      audit.verdict = Verdict::kRefuted;
      audit.source = run.violations.empty() ? run.ledger.corruption : run.violations.front();
    }
  }
  audit.observed = formats::counted(violations, "violation", "violations") + " in " +
                   formats::counted(checked, "check", "checks");
  checks.push_back(std::move(audit));
  if (stopped) checks.push_back(*std::move(stopped));
}

// The id is STRUCTURE.NAME.
bool is_of_events(const std::string& id) {
  const std::size_t dot = id.rfind('.');
  if (dot == id.npos) return false;
  const std::string_view name = std::string_view(id).substr(dot + 1);
  if (name == "events") return true;
  const FamilyExperiments* family = experiments_on(std::string_view(id).substr(0, dot));
  if (family == nullptr) return false;
  return std::find(family->event_bounds.begin(), family->event_bounds.end(), name) !=
         family->event_bounds.end();
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

namespace {

bool is_precise(const RunningMean& mean, const Cell::Precise& asked) {
  return mean.standard_error() <= asked.relative_error * mean.mean();
}

}  // namespace

bool precise_enough(const Cell& cell, const std::vector<Trial>& trials) {
  if (static_cast<int>(trials.size()) < cell.min_seeds) return false;
  return std::all_of(cell.precise.begin(), cell.precise.end(), [&](const Cell::Precise& precise) {
    return is_precise(mean_of(trials, precise.quantity), precise);
  });
}

std::size_t scenes_asked_for(const Cell& cell, const std::vector<Trial>& trials) {
  std::vector<RunningMean> means(cell.precise.size());
  for (std::size_t k = 0; k < trials.size(); ++k) {
    bool precise = static_cast<int>(k) + 1 >= cell.min_seeds;
    for (std::size_t i = 0; i < means.size(); ++i) {
      means[i].add(static_cast<double>(trials[k].measurement.count_of(cell.precise[i].quantity)));
      precise = precise && is_precise(means[i], cell.precise[i]);
    }
    if (precise) return k + 1;
  }
  return 0;
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
    if (is_of_events(bound.id)) return &bound;
  }
  return nullptr;
}

std::optional<Integer> bound_on_processed(const Measurement& measurement) {
  const Integer processed = counted(measurement.count_of("processed"));
  Integer bound(0), observed(0);
  for (const BoundCheck& check : measurement.bounds) {
    if (!is_of_events(check.id)) continue;
    if (check.observed == processed) return check.bound;
    bound += check.bound;
    observed += check.observed;
    if (observed == processed) return bound;
  }
  return std::nullopt;
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

std::optional<std::string> number_text(const std::optional<double>& value, int digits) {
  if (!value) return std::nullopt;
  return number_text(*value, digits);
}

std::optional<std::string> unless_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

std::string mean_text(double mean, double error) {
  if (!(error > 0)) return number_text(mean, 6);
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 9);
  char text[96];
  std::snprintf(text, sizeof text, "%.*f +-%.*f", places, mean, places, error);
  return text;
}

}  // namespace kinex::lab

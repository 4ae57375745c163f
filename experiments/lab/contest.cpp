// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/contest.h"

#include <algorithm>
#include <utility>

#include "experiments/lab/cpu_clock.h"

namespace kinex::lab {

namespace {

constexpr double kLongEnough = 0.02;   // seconds for all rounds of one arithmetic
constexpr double kMeasurable = 10e-6;  // seconds of one round
constexpr int kMostRounds = 40;
constexpr double kPatience = 0.05;  // seconds, set-up included

}  // namespace

std::optional<SpeedContest> compare_with_double(const Scene& scene, const Measurement& exact,
                                                SimulatorOptions options) {
  const bool is_timed = options.audit != AuditLevel::kEvents;  // audits after events are in its time
  options.audit = AuditLevel::kNone;
  SimulatorOptions limited = options;  // rounding errors may cause endless events
  limited.max_events = 4 * exact.run.events + 10000;
  SpeedContest contest;
  const double began = cpu_seconds();
  double best_exact = 0, best_double = 0, total_exact = 0, total_double = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    Measurement rival = measure(scene, "double", limited);
    const Measurement again = round == 0 && is_timed ? exact : measure(scene, "exact", options);
    if (again.status == RunStatus::kInterrupted || rival.status == RunStatus::kInterrupted) {
      return std::nullopt;
    }
    best_double = round == 0 ? rival.seconds : std::min(best_double, rival.seconds);
    best_exact = round == 0 ? again.seconds : std::min(best_exact, again.seconds);
    total_exact += again.seconds;
    total_double += rival.seconds;
    if (round == 0) contest.rival = std::move(rival);
    if (total_exact > kLongEnough && total_double > kLongEnough) break;
    if (contest.rival.status != RunStatus::kDone) break;
    if (cpu_seconds() - began > kPatience) break;
  }
  const Measurement& rival = contest.rival;
  contest.same_counts = rival.status == RunStatus::kDone && !rival.ledger.corrupt &&
                        rival.run.events == exact.run.events &&
                        rival.ledger.external == exact.ledger.external &&
                        rival.attribute == exact.attribute;
  if (rival.status == RunStatus::kDone && best_double >= kMeasurable) {
    contest.ratio = best_exact / best_double;
  }
  contest.rival.seconds = best_double;
  return contest;
}

}  // namespace kinex::lab

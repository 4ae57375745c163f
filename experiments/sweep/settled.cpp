// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/settled.h"

#include <algorithm>
#include <numeric>

#include "experiments/formats/json_document.h"
#include "experiments/formats/run_outcome.h"

namespace kinex::sweep {

namespace {

// Larger ones stand for the cell.
int rank(Outcome outcome) {
  switch (outcome) {
    case Outcome::kDone:
    case Outcome::kFailed:
    case Outcome::kRefused:
      return 4;
    case Outcome::kCrash:
      return 3;
    case Outcome::kMemory:
      return 2;
    case Outcome::kLimit:
      return 1;
    case Outcome::kKilled:
      return 0;
  }
  return 0;
}

// True for a run that the plan's max_events ended: its results are those of a part of the run.
bool ended_at_max_events(const Record& record) {
  if (record.outcome != Outcome::kDone || record.exact.empty()) return false;
  if (record.cell.find("\"max_events\"") == std::string::npos) return false;  // nothing to be read
  const formats::JsonDocument exact = formats::parse_json(record.exact, "the run's counts");
  const formats::JsonValue* const ended = exact->find("ended");
  return ended != nullptr && ended->kind() == formats::JsonValue::Kind::kString &&
         ended->text() == formats::status_name(RunStatus::kLimit);
}

// A limit that is absent is above all others.
bool is_lower(int limit, int other) { return limit != 0 && (other == 0 || limit < other); }

}  // namespace

std::optional<Conflict> find_conflict(const std::vector<Attempt>& attempts) {
  struct Found {
    const Attempt* attempt;
    std::size_t at;
  };
  std::map<std::string_view, Found> verdicts;
  const auto place = [](const Found& found) {
    return found.attempt->path + ", line " + std::to_string(found.at + 2);
  };
  for (const Attempt& attempt : attempts) {
    for (std::size_t at = 0; at < attempt.records.size(); ++at) {
      const Record& record = attempt.records[at];
      if (!is_verdict(record.outcome)) continue;
      const Found here{&attempt, at};
      const auto [known, is_new] = verdicts.try_emplace(record.key, here);
      if (is_new) continue;
      const Record& other = known->second.attempt->records[known->second.at];
      if (agree(other, record)) continue;
      return Conflict{place(known->second), record_line(other), place(here), record_line(record)};
    }
  }
  return std::nullopt;
}

void take(Settled& settled, const Record& record) {
  const auto [known, is_new] = settled.try_emplace(record.key, &record);
  if (!is_new && rank(record.outcome) > rank(known->second->outcome)) known->second = &record;
}

Settled settle(const std::vector<Attempt>& attempts) {
  Settled settled;
  for (const Attempt& attempt : attempts) {
    for (const Record& record : attempt.records) take(settled, record);
  }
  return settled;
}

bool is_settled(const Record& record, const Limits& limits, bool retry) {
  if (is_verdict(record.outcome)) return true;
  if (retry || record.outcome == Outcome::kKilled) return false;
  if (record.outcome == Outcome::kLimit) {
    return !is_lower(record.limits.seconds, limits.seconds);
  }
  if (record.outcome == Outcome::kMemory) {
    return !is_lower(record.limits.megabytes, limits.megabytes);
  }
  return true;
}

std::vector<Plan> plans_of(const std::vector<Attempt>& attempts, const Experiments& experiments) {
  std::map<std::pair<std::string, std::string>, const Attempt*> first;
  for (const Attempt& attempt : attempts) {
    const AttemptProvenance& of = attempt.provenance;
    first.try_emplace({of.plan_name, of.plan_hash}, &attempt);
  }
  std::vector<Plan> plans;
  for (const auto& [name, attempt] : first) {
    plans.push_back(parse_plan(attempt->provenance.plan, attempt->path + ", \"plan\"",
                               PlanCheck::kFormOnly, experiments));
  }
  return plans;
}

std::size_t Tally::cells() const { return std::accumulate(counts.begin(), counts.end(), missing); }

std::string Tally::text() const {
  std::string text;
  const auto add = [&](std::size_t count, std::string_view name) {
    if (count == 0) return;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(name);
  };
  for (const auto& [outcome, name] : kOutcomeNames) {
    add(of(outcome), name);
    if (outcome != Outcome::kDone || at_max_events == 0) continue;
    text += " (" + std::to_string(at_max_events) + " of them ended at max_events)";
  }
  add(missing, "missing");
  return text.empty() ? "no cells" : text;
}

Tally tally(const std::vector<PlanCell>& cells, const Settled& settled) {
  Tally result;
  for (const PlanCell& cell : cells) {
    const auto found = settled.find(cell.key);
    if (found == settled.end()) {
      ++result.missing;
    } else {
      ++result.counts[static_cast<std::size_t>(found->second->outcome)];
      if (ended_at_max_events(*found->second)) ++result.at_max_events;
    }
  }
  return result;
}

std::optional<double> expected_rest(const std::vector<PlanCell>& cells, const Settled& settled) {
  struct Sum {
    double seconds = 0, cost = 0;
  };
  std::map<std::string, Sum> by_kind;
  Sum all;
  for (const PlanCell& cell : cells) {
    const auto found = settled.find(cell.key);
    if (found == settled.end() || found->second->outcome == Outcome::kKilled) continue;
    Sum& sum = by_kind[cell.kind];
    for (Sum* one : {&sum, &all}) {
      one->seconds += found->second->cpu_s;
      one->cost += static_cast<double>(cell.cost);
    }
  }
  if (all.cost == 0) return std::nullopt;
  double rest = 0;
  for (const PlanCell& cell : cells) {
    const auto found = settled.find(cell.key);
    if (found != settled.end() && found->second->outcome != Outcome::kKilled) continue;
    const auto known = by_kind.find(cell.kind);
    const Sum& sum = known == by_kind.end() ? all : known->second;
    rest += static_cast<double>(cell.cost) * sum.seconds / sum.cost;
  }
  return rest;
}

}  // namespace kinex::sweep

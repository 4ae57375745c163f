// SPDX-License-Identifier: GPL-3.0-or-later
// Outcome: the ways in which an attempt at a cell ends, and their names in files.
#ifndef KINEX_EXPERIMENTS_SWEEP_OUTCOME_H
#define KINEX_EXPERIMENTS_SWEEP_OUTCOME_H

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace kinex::sweep {

// The end of one attempt at a cell.
enum class Outcome {
  // Verdicts: every machine comes to the same one.
  kDone,     // ran to its end; bounds and audits hold
  kFailed,   // ran to its end; a bound, an audit or the structure's state failed
  kRefused,  // the scene, or a change on the way, was refused
  // Results without a verdict: they depend on the limits and on the machine.
  kLimit,   // the limit of CPU time
  kMemory,  // the limit of memory
  kCrash,   // a signal of the cell's own, or an internal error
  // No result: the child was ended from outside.
  kKilled,
};

inline constexpr std::array<std::pair<Outcome, std::string_view>, 7> kOutcomeNames{{
    {Outcome::kDone, "done"},
    {Outcome::kFailed, "failed"},
    {Outcome::kRefused, "refused"},
    {Outcome::kLimit, "limit"},
    {Outcome::kMemory, "memory"},
    {Outcome::kCrash, "crash"},
    {Outcome::kKilled, "killed"},
}};

constexpr std::string_view outcome_name(Outcome outcome) {
  for (const auto& [known, name] : kOutcomeNames) {
    if (known == outcome) return name;
  }
  return "";
}

constexpr std::optional<Outcome> outcome_of(std::string_view name) {
  for (const auto& [outcome, known] : kOutcomeNames) {
    if (known == name) return outcome;
  }
  return std::nullopt;
}

constexpr bool is_verdict(Outcome outcome) {
  return outcome == Outcome::kDone || outcome == Outcome::kFailed || outcome == Outcome::kRefused;
}

}  // namespace kinex::sweep

#endif

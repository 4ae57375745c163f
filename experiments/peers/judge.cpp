// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/peers/judge.h"

#include <algorithm>
#include <cstdio>

namespace kinex::peers {

namespace {

// A few units in the last place of coordinates up to 4: rounding of the number format is no error.
constexpr double kRounding = 1e-14, kSingleRounding = 1e-6;

// The part of `late` that the truth's own uncertainty does not explain.
double beyond(double time, const Truth& truth) {
  if (time < truth.earliest) return time - truth.earliest;
  return time > truth.latest ? time - truth.latest : 0;
}

}  // namespace

const PeerQuestion& PeerQuestions::of(const PeerCase& one) {
  const auto [found, is_new] = known_.try_emplace(one.family + " " + one.name);
  PeerQuestion& question = found->second;
  if (!is_new) return question;
  question.exact = one;
  question.single = one.as_float();
  question.truth = find_truth(question.exact);
  question.truth_single = find_truth(question.single);
  return question;
}

Judgement judge(const PeerMethod& method, const PeerQuestion& question, const PeerAnswer& answer) {
  const Truth& truth = method.single ? question.truth_single : question.truth;
  const PeerCase& asked = method.single ? question.single : question.exact;
  Judgement result;
  result.verdict = answer.verdict;
  if (truth.kind == TruthKind::kUnknown) result.outcome = Outcome::kUnknown;
  if (answer.verdict == Verdict::kMiss && truth.kind != TruthKind::kUnknown) {
    result.outcome = truth.kind == TruthKind::kOverlap ? Outcome::kMissed : Outcome::kRight;
  }
  if (answer.verdict != Verdict::kHit || truth.kind == TruthKind::kUnknown) return result;
  result.gap = signed_distance(asked, asked.at(answer.time));
  if (truth.kind == TruthKind::kOverlap) {
    result.outcome = Outcome::kRight;
    result.late = beyond(answer.time, truth);
  } else {
    const double rounding = method.single ? kSingleRounding : kRounding;
    result.outcome =
        result.gap <= method.tolerance + rounding ? Outcome::kTolerated : Outcome::kAlarm;
  }
  return result;
}

void Standing::add(const Judgement& one) {
  ++asked;
  switch (one.outcome) {
    case Outcome::kRight:
      ++right;
      break;
    case Outcome::kMissed:
      ++missed;
      break;
    case Outcome::kAlarm:
      ++alarms;
      break;
    case Outcome::kTolerated:
      ++tolerated;
      break;
    case Outcome::kUnknown:
      ++unknown;
      break;
    case Outcome::kNone:
      failed += one.verdict == Verdict::kFailed ? 1 : 0;
      not_a_number += one.verdict == Verdict::kNotANumber ? 1 : 0;
      no_end += one.verdict == Verdict::kNoEnd ? 1 : 0;
      crashed += one.verdict == Verdict::kCrash ? 1 : 0;
      unsupported += one.verdict == Verdict::kUnsupported ? 1 : 0;
      break;
  }
  if (one.outcome != Outcome::kRight || one.verdict != Verdict::kHit) return;
  widest_gap = std::max(widest_gap, one.gap);
  deepest_overlap = std::max(deepest_overlap, -one.gap);
  earliest = std::max(earliest, -one.late);
  latest = std::max(latest, one.late);
}

std::string in_words(const Judgement& one) {
  switch (one.outcome) {
    case Outcome::kRight: {
      if (one.verdict == Verdict::kMiss) return "right";
      char text[60];
      std::snprintf(text, sizeof text, "right, %+.0e", one.late);
      return one.late == 0 ? "right" : text;
    }
    case Outcome::kMissed:
      return "MISSED";
    case Outcome::kAlarm:
      return "FALSE ALARM";
    case Outcome::kTolerated:
      return "within tolerance";
    case Outcome::kUnknown:
      return "not known";
    case Outcome::kNone:
      break;
  }
  switch (one.verdict) {
    case Verdict::kFailed:
      return "failed";
    case Verdict::kNotANumber:
      return "NaN";
    case Verdict::kNoEnd:
      return "no end";
    case Verdict::kCrash:
      return "crash";
    default:
      return "-";
  }
}

}  // namespace kinex::peers

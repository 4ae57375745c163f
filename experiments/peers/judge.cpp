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
  result.reply = answer.reply;
  if (truth.kind == TruthKind::kUnknown) result.grade = PeerGrade::kUnknown;
  if (answer.reply == PeerReply::kMiss && truth.kind != TruthKind::kUnknown) {
    result.grade = truth.kind == TruthKind::kOverlap ? PeerGrade::kMissed : PeerGrade::kRight;
  }
  if (answer.reply != PeerReply::kHit || truth.kind == TruthKind::kUnknown) return result;
  result.gap = signed_distance(asked, asked.at(answer.time));
  if (truth.kind == TruthKind::kOverlap) {
    result.grade = PeerGrade::kRight;
    result.late = beyond(answer.time, truth);
  } else {
    const double rounding = method.single ? kSingleRounding : kRounding;
    result.grade =
        result.gap <= method.tolerance + rounding ? PeerGrade::kTolerated : PeerGrade::kAlarm;
  }
  return result;
}

void PeerTally::add(const Judgement& one) {
  ++asked;
  switch (one.grade) {
    case PeerGrade::kRight:
      ++right;
      break;
    case PeerGrade::kMissed:
      ++missed;
      break;
    case PeerGrade::kAlarm:
      ++alarms;
      break;
    case PeerGrade::kTolerated:
      ++tolerated;
      break;
    case PeerGrade::kUnknown:
      ++unknown;
      break;
    case PeerGrade::kNone:
      failed += one.reply == PeerReply::kFailed ? 1 : 0;
      not_a_number += one.reply == PeerReply::kNotANumber ? 1 : 0;
      no_end += one.reply == PeerReply::kNoEnd ? 1 : 0;
      crashed += one.reply == PeerReply::kCrash ? 1 : 0;
      unsupported += one.reply == PeerReply::kUnsupported ? 1 : 0;
      break;
  }
  if (one.grade != PeerGrade::kRight || one.reply != PeerReply::kHit) return;
  widest_gap = std::max(widest_gap, one.gap);
  deepest_overlap = std::max(deepest_overlap, -one.gap);
  earliest = std::max(earliest, -one.late);
  latest = std::max(latest, one.late);
}

std::string in_words(const Judgement& one) {
  switch (one.grade) {
    case PeerGrade::kRight: {
      if (one.reply == PeerReply::kMiss) return "right";
      char text[60];
      std::snprintf(text, sizeof text, "right, %+.0e", one.late);
      return one.late == 0 ? "right" : text;
    }
    case PeerGrade::kMissed:
      return "MISSED";
    case PeerGrade::kAlarm:
      return "FALSE ALARM";
    case PeerGrade::kTolerated:
      return "within tolerance";
    case PeerGrade::kUnknown:
      return "not known";
    case PeerGrade::kNone:
      break;
  }
  switch (one.reply) {
    case PeerReply::kFailed:
      return "failed";
    case PeerReply::kNotANumber:
      return "NaN";
    case PeerReply::kNoEnd:
      return "no end";
    case PeerReply::kCrash:
      return "crash";
    default:
      return "-";
  }
}

}  // namespace kinex::peers

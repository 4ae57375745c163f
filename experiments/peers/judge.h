// SPDX-License-Identifier: GPL-3.0-or-later
// Judges an answer against the exact truth for the numbers given to the library.
#ifndef KINEX_EXPERIMENTS_PEERS_JUDGE_H
#define KINEX_EXPERIMENTS_PEERS_JUDGE_H

#include <map>
#include <string>
#include <vector>

#include "experiments/peers/method.h"
#include "experiments/peers/truth.h"

namespace kinex::peers {

// A question in both precisions, with its answers.
struct PeerQuestion {
  PeerCase exact, single;
  Truth truth, truth_single;
};
// Each true answer is computed once.
class PeerQuestions {
 public:
  const PeerQuestion& of(const PeerCase& one);

 private:
  std::map<std::string, PeerQuestion> known_;  // by family and name
};

enum class PeerGrade {
  kRight,
  kMissed,     // they overlap, and the answer is that they never do: a false negative
  kAlarm,      // they never overlap, and it reports a contact at a gap beyond its tolerance
               // (and the rounding of its numbers)
  kTolerated,  // the same within its documented tolerance, or at a mere touch
  kUnknown,    // the truth is not known
  kNone,       // no answer; the reply is the reason
};

struct Judgement {
  PeerGrade grade = PeerGrade::kNone;
  PeerReply reply = PeerReply::kUnsupported;
  // Of a reported contact: the distance of the bodies there, or minus the depth of their overlap;
  // and the delay after the true time.
  double gap = 0, late = 0;
};

Judgement judge(const PeerMethod& method, const PeerQuestion& question, const PeerAnswer& answer);

// Counts over the questions of a family.
struct PeerTally {
  int asked = 0, right = 0, missed = 0, alarms = 0, tolerated = 0, unknown = 0;
  int failed = 0, not_a_number = 0, no_end = 0, crashed = 0, unsupported = 0;
  // Of right contacts.
  double widest_gap = 0, deepest_overlap = 0, earliest = 0, latest = 0;
  void add(const Judgement& one);
};

// One word or two, for a table of single cases.
std::string in_words(const Judgement& one);

}  // namespace kinex::peers

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/upper_envelope.h"

namespace kinex {

namespace {

// Rounding errors may make two keys cross endlessly.
constexpr int kMostInexactCrossings = 1000;

}  // namespace

std::vector<ObjectId> UpperEnvelope::compute(std::span<const ObjectId> members) {
  std::vector<ObjectId> result;
  for (const Piece& piece : envelope(members)) result.push_back(piece.object);
  return result;
}

UpperEnvelope::Pieces UpperEnvelope::envelope(std::span<const ObjectId> members) {
  if (members.empty()) return {};
  if (members.size() == 1) return {{members[0], Foresight::kNever}};
  const std::size_t half = members.size() / 2;
  return merge(envelope(members.first(half)), envelope(members.subspan(half)));
}

// The winner right after `from`, and the end of its lead. The smaller id is a's, and wins a tie.
UpperEnvelope::Duel UpperEnvelope::duel(ObjectId a, ObjectId b, Moment from) {
  Duel result{a, Foresight::kNever};
  Outlook outlook = foresight_.failure(contest_->claim(a, b), from, result.end);
  if (outlook == Outlook::kFailsNow) {
    result.winner = b;
    outlook = foresight_.failure(contest_->claim(b, a), from, result.end);
    // In an inexact arithmetic each may be worse than the other.
    if (outlook == Outlook::kFailsNow) result.end = Foresight::kNever;
  }
  return result;
}

UpperEnvelope::Pieces UpperEnvelope::merge(const Pieces& a, const Pieces& b) {
  Pieces merged;
  std::size_t i = 0, j = 0;
  Moment now = Foresight::kNow;
  for (int crossings = 0;;) {
    Duel top = duel(a[i].object, b[j].object, now);
    if (merged.empty() || merged.back().object != top.winner) {
      if (!merged.empty()) merged.back().end = now;
      merged.push_back({top.winner, Foresight::kNever});
    }
    if (!exact_ && crossings >= kMostInexactCrossings) top.end = Foresight::kNever;
    // The next breakpoint of either envelope, or of both, or the crossing, whichever comes first.
    const bool last_a = a[i].end == Foresight::kNever, last_b = b[j].end == Foresight::kNever;
    Moment next = a[i].end;
    const int order = foresight_.compare(next, b[j].end);
    if (order > 0) next = b[j].end;
    const bool cut = foresight_.compare(top.end, next) < 0;
    if (cut) next = top.end;
    if (next == Foresight::kNever) return merged;
    now = next;
    if (cut) {
      ++crossings;
      continue;
    }
    if (order <= 0 && !last_a) ++i;
    if (order >= 0 && !last_b) ++j;
    crossings = 0;
  }
}

}  // namespace kinex

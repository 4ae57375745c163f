// SPDX-License-Identifier: GPL-3.0-or-later
// Foresight: queries at future instants: the signs right after one, and the next failure after it.
// For algorithms that compute the events of a structure in advance. The motions are those in force;
// future flight plans are not known.
#ifndef KINEX_CORE_ARITHMETIC_FORESIGHT_H
#define KINEX_CORE_ARITHMETIC_FORESIGHT_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/arithmetic/arithmetic.h"

namespace kinex {

// Owns the instants it has found and hands out numbers for them. Short-lived: the arithmetic's
// motions and now must not change during its life.
class Foresight {
 public:
  using Moment = std::uint32_t;
  static constexpr Moment kNow = 0xfffffffeu;
  static constexpr Moment kNever = 0xffffffffu;

  explicit Foresight(Arithmetic& arithmetic) : arithmetic_(&arithmetic) {}
  Foresight(const Foresight&) = delete;
  Foresight& operator=(const Foresight&) = delete;
  ~Foresight() {
    for (Known& known : known_) arithmetic_->release(known.time);
  }

  // The sign of `query` right after `from`, which is not kNever.
  Sign sign_after(const Query& query, Moment from) {
    const Visit visit(*this, from);
    return arithmetic_->sign_after(query);
  }
  // The next failure of `query`. `found`: a moment after `from` for kFails, `from` for kFailsNow,
  // else kNever.
  Outlook failure(const Query& query, Moment from, Moment& found) {
    FailureTime time;
    Outlook outlook;
    {
      const Visit visit(*this, from);
      outlook = arithmetic_->failure(query, time);
    }
    found = kNever;
    if (outlook == Outlook::kFails && time.lo <= time.hi) {
      found = static_cast<Moment>(known_.size());
      known_.push_back({query, time});
      return outlook;
    }
    if (outlook == Outlook::kFailsNow) found = from;
    arithmetic_->release(time);
    return outlook;
  }
  // -1, 0, +1.
  int compare(Moment a, Moment b) {
    if (a == b) return 0;
    if (a == kNow || b == kNever) return -1;
    if (b == kNow || a == kNever) return 1;
    Known& x = known_[a];
    Known& y = known_[b];
    if (x.time.hi < y.time.lo) return -1;
    if (y.time.hi < x.time.lo) return 1;
    return arithmetic_->compare(x.query, x.time, y.query, y.time);
  }
  std::size_t moments() const { return known_.size(); }

 private:
  struct Known {
    Query query;
    FailureTime time;
  };
  class Visit {
   public:
    Visit(Foresight& foresight, Moment at)
        : arithmetic_(at == kNow ? nullptr : foresight.arithmetic_) {
      if (arithmetic_ != nullptr) {
        arithmetic_->visit(foresight.known_[at].query, foresight.known_[at].time);
      }
    }
    ~Visit() {
      if (arithmetic_ != nullptr) arithmetic_->leave();
    }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

   private:
    Arithmetic* arithmetic_;
  };

  Arithmetic* arithmetic_;
  std::vector<Known> known_;
};

}  // namespace kinex

#endif

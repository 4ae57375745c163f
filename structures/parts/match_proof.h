// SPDX-License-Identifier: GPL-3.0-or-later
// MatchProof: the certificates of one match of a tournament: that its winner is in front of its loser,
// or level with it.
//
// Most claims are single polynomials (Claims, structures/parts/claim.h): one certificate. What is
// compared may be no polynomial, such as the gap of two discs, while its comparison is a choice among
// cases, each a conjunction of polynomial claims (CasedClaims): one certificate for each claim of the
// case that holds.
//
//   gap(ab) <= gap(pq)    I   s >= 0, gap_left >= 0          a certificate of case I fails: II or III may
//                         II  s >= 0, gap_product <= 0       hold, with the same winner; else the other
//                         III s <= 0, gap_right >= 0, ..     item wins
#ifndef KINEX_STRUCTURES_PARTS_MATCH_PROOF_H
#define KINEX_STRUCTURES_PARTS_MATCH_PROOF_H

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "structures/parts/claim.h"
#include "structures/parts/slots.h"

namespace kinex {

// Up to kMostClaims claims that hold together, each in a place of its own.
inline constexpr std::size_t kMostClaims = 3;
using Conjunction = std::array<std::optional<Query>, kMostClaims>;

// What holds of two items right after now.
struct CaseChoice {
  std::uint8_t which;  // the case to be certified
  bool holds;          // the front one is in front or level; else a claim of the case is negative
  bool level;          // identically level
};

// For distinct items a and b:
//   choose(kernel, a, b)   a case that proves that a is in front of b or level with it. If they come to be
//                          identically level, a claim of the case fails then, or is identically zero
//   claims_of(case, a, b)  its claims; they do not depend on the time, and name no object twice
//   goes_first(a, b)       as for Claims
template <class C>
concept CasedClaims = requires(const C& claims, Kernel& kernel, Item a, Item b) {
  { claims.choose(kernel, a, b) } -> std::same_as<CaseChoice>;
  { claims.claims_of(std::uint8_t{}, a, b) } -> std::same_as<Conjunction>;
  { claims.goes_first(a, b) } -> std::convertible_to<bool>;
};

template <class C>
concept MatchClaims = Claims<C> || CasedClaims<C>;

// a is in front of b right after now.
template <CasedClaims C>
bool in_front(Kernel& kernel, const C& claims, Item a, Item b) {
  const CaseChoice choice = claims.choose(kernel, a, b);
  return choice.level ? claims.goes_first(a, b) : choice.holds;
}

// One certificate.
template <class C>
class MatchProof {
 public:
  std::span<const CertificateId> slots() const { return {&slot_, 1}; }
  bool there() const { return slot_ != kNoCertificate; }
  void drop(Slots& slots) { slots.drop(slot_); }
  // Certifies that `front` is in front. True: they are identically level.
  bool set(Slots& slots, const C& claims, Item front, Item back, std::uint32_t tag) {
    return slots.set(slot_, claims.claim(front, back), tag) == Outlook::kIdenticallyZero;
  }
  // It has failed, and what it proves holds all the same: false, for a single claim.
  bool renewed(Slots&, const C&, Item, Item, std::uint32_t) { return false; }
  // A certificate of it has become identically zero. True: the items are identically level.
  bool tied(Slots& slots, const C&, Item, Item, std::uint32_t) { return slots.is_tie(slot_); }
  // It is a proof about these two items.
  bool is_about(const Slots& slots, const C& claims, Item a, Item b) const {
    const Query& query = slots.kernel().query(slot_);
    return query == claims.claim(a, b) || query == claims.claim(b, a);
  }
  // For audits.
  bool holds(const Slots& slots, const C& claims, Item front, Item back, std::uint32_t tag) const {
    return slots.holds(slot_, claims.claim(front, back), tag);
  }
  bool is_tie(const Slots& slots) const { return slots.is_tie(slot_); }

 private:
  CertificateId slot_ = kNoCertificate;
};

// One for each claim of a case.
template <CasedClaims C>
class MatchProof<C> {
 public:
  MatchProof() { slots_.fill(kNoCertificate); }

  std::span<const CertificateId> slots() const { return slots_; }
  bool there() const { return which_ != kNone; }
  void drop(Slots& slots) {
    for (CertificateId& slot : slots_) slots.drop(slot);
    which_ = kNone;
  }
  bool set(Slots& slots, const C& claims, Item front, Item back, std::uint32_t tag) {
    return set(slots, claims, front, back, tag, claims.choose(slots.kernel(), front, back));
  }
  bool renewed(Slots& slots, const C& claims, Item front, Item back, std::uint32_t tag) {
    const CaseChoice choice = claims.choose(slots.kernel(), front, back);
    if (!choice.holds || (choice.level && claims.goes_first(back, front))) return false;
    set(slots, claims, front, back, tag, choice);
    return true;
  }
  // Another case may have to be certified.
  bool tied(Slots& slots, const C& claims, Item front, Item back, std::uint32_t tag) {
    const CaseChoice choice = claims.choose(slots.kernel(), front, back);
    if (choice.holds && choice.which != which_) set(slots, claims, front, back, tag, choice);
    return choice.level;
  }
  bool is_about(const Slots& slots, const C& claims, Item a, Item b) const {
    return states(slots, claims.claims_of(which_, a, b)) ||
           states(slots, claims.claims_of(which_, b, a));
  }
  bool holds(const Slots& slots, const C& claims, Item front, Item back, std::uint32_t tag) const {
    if (which_ == kNone) return false;
    const Conjunction wanted = claims.claims_of(which_, front, back);
    for (std::size_t i = 0; i < kMostClaims; ++i) {
      if (wanted[i] ? !slots.holds(slots_[i], *wanted[i], tag) : slots_[i] != kNoCertificate) {
        return false;
      }
    }
    return true;
  }
  // All its claims are identically zero.
  bool is_tie(const Slots& slots) const {
    for (const CertificateId slot : slots_) {
      if (slot != kNoCertificate && !slots.is_tie(slot)) return false;
    }
    return there();
  }

 private:
  static constexpr std::uint8_t kNone = 255;

  bool set(Slots& slots, const C& claims, Item front, Item back, std::uint32_t tag,
           const CaseChoice& choice) {
    which_ = choice.which;
    const Conjunction wanted = claims.claims_of(which_, front, back);
    for (std::size_t i = 0; i < kMostClaims; ++i) {
      if (wanted[i]) {
        slots.set(slots_[i], *wanted[i], tag);
      } else {
        slots.drop(slots_[i]);
      }
    }
    return choice.level;
  }
  bool states(const Slots& slots, const Conjunction& claims) const {
    for (std::size_t i = 0; i < kMostClaims; ++i) {
      if (claims[i] ? slots_[i] == kNoCertificate || !slots.kernel().claims(slots_[i], *claims[i])
                    : slots_[i] != kNoCertificate) {
        return false;
      }
    }
    return true;
  }

  std::array<CertificateId, kMostClaims> slots_;
  std::uint8_t which_ = kNone;
};

}  // namespace kinex

#endif

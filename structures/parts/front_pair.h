// SPDX-License-Identifier: GPL-3.0-or-later
// FrontPair: the common base class of structures for the front one of a changing set of pairs, such as
// the closest pair: the pair by a ChangingExtremum, and its changes by AttributeEvents. The owner says
// which pairs there are.
//
//   the set of pairs changes   pairs_.go(..), pairs_.come(..) or pairs_.assign(..), and then
//     at a failure             pairs_.apply(tied()), repaired(..)
//     otherwise                begin() in build, insert, erase; pairs_.apply(tied()) elsewhere
//   another certificate fails  certificate_failed of this class, if no part of the owner has it
//
// Claims: those of a ChangingExtremum. If a value is not the pair itself, ids ascending, then
//   static array of two ids pair_of(value)    its pair
#ifndef KINEX_STRUCTURES_PARTS_FRONT_PAIR_H
#define KINEX_STRUCTURES_PARTS_FRONT_PAIR_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/bound.h"
#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"
#include "structures/parts/tournament_proof.h"

namespace kinex {

template <class Claims>
class FrontPair : public Structure {
 public:
  // kReplace: another winner of a duel: the old pair and the new one. kTie: the same, because the two
  // have become identically level. An owner's other kinds come next.
  enum Kind : std::uint8_t { kReplace, kTie };

  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie"});
  }
  void rebuild() override {
    pairs_.rebuild(tied());
    events_.begin(ids(front()));
  }
  void certificate_failed(CertificateId failed) override {
    replaced(pairs_.failed(failed, tied()));
  }
  void motions_changed(std::span<const ObjectId> objects) override {
    pairs_.motions_changed(objects, tied());
  }
  void instant_over() override { events_.over(ids(front())); }
  Attribute attribute() const override {
    const std::optional<Pair> pair = front();
    return {Attribute::Shape::kTuples, {ids(pair).begin(), ids(pair).end()}};
  }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override {
    visit_tournament(visitor, pairs_, 0, text_, [](const Value& winner) {
      const Pair pair = pair_of(winner);
      return std::vector<ObjectId>(pair.begin(), pair.end());
    });
  }
  void check_invariants(AuditReport& report) const override {
    pairs_.check(report, part_);
    report.check(is_told(), [] { return "a change of the pair was not reported"; });
  }
  std::size_t bytes() const override { return pairs_.bytes() + events_.bytes(); }

 protected:
  using Value = typename Claims::Value;
  using Pair = std::array<ObjectId, 2>;
  using Duel = typename ChangingExtremum<Claims>::Duel;

  // `part`: the name of the tournament in the ledger. `text`: what it is about, for viewers.
  // `watched`: a structure that says which pairs there are.
  FrontPair(Kernel& kernel, StructureId id, std::string part, std::string text, Claims claims,
            std::optional<StructureId> watched = {})
      : kernel_(&kernel),
        id_(id),
        pairs_(kernel, id, part, std::move(claims)),
        part_(std::move(part)),
        text_(std::move(text)),
        watched_(watched),
        events_(kernel, id, Attribute::Shape::kTuples) {}

  auto tied() {
    return [this](const Value& a, const Value& b) {
      const Pair old = pair_of(a), fresh = pair_of(b);
      kernel_->report(id_, kTie, {old[0], old[1], fresh[0], fresh[1]}, false);
    };
  }
  // The changes of the set are applied; the pair is not to be reported.
  void begin() {
    pairs_.apply(tied());
    events_.begin(ids(front()));
  }
  // A failure was repaired: reports it, and the change of the pair if the instant is over.
  void repaired(std::uint8_t kind, std::initializer_list<ObjectId> objects) {
    events_.repaired(kind, objects, ids(front()), watched_);
  }
  void replaced(const Duel& duel) {
    const Pair old = pair_of(duel.before), fresh = pair_of(duel.after);
    repaired(kReplace, {old[0], old[1], fresh[0], fresh[1]});
  }
  // The bounds of a structure that has a tournament and nothing else. `most`: pairs in it, because of
  // `why`. `degree`: of the claims. `all`: the pairs that can be in front. `envelope`: of their
  // distances, the lower one or the upper one.
  std::vector<BoundCheck> tournament_bounds(const BoundContext& context, const Integer& most,
                                            const std::string& why, int degree, const Integer& all,
                                            const std::string& envelope = "lower") const {
    const StructureLedger& ledger = *context.ledger;
    const std::string own(name());
    std::vector<BoundCheck> result{
        at_most(own + ".certificates", why, std::max(Integer(0), most - Integer(1)),
                counted(ledger.max_live)),
        at_most(own + ".events", "the epochs of the nodes of the tournament",
                pairs_.most_failures(degree), counted(ledger.failures))};
    if (context.plain() && all.sign() > 0) {
      result.push_back(
          at_most(own + ".external",
                  "pieces of the " + envelope + " envelope of the distances of all pairs",
                  davenport_schinzel_bound(degree, all) - Integer(1), counted(ledger.external)));
    }
    return result;
  }
  // The pair is as last reported.
  bool is_told() const { return std::ranges::equal(ids(front()), events_.told().ids); }

  Kernel* kernel_;
  StructureId id_;
  ChangingExtremum<Claims> pairs_;

 private:
  static Pair pair_of(const Value& value) {
    if constexpr (requires { Claims::pair_of(value); }) {
      return Claims::pair_of(value);
    } else {
      return value;
    }
  }
  std::optional<Pair> front() const {
    const Value* value = pairs_.front();
    return value == nullptr ? std::nullopt : std::optional(pair_of(*value));
  }
  // A view of the argument.
  static std::span<const ObjectId> ids(const std::optional<Pair>& pair) {
    return pair ? std::span<const ObjectId>(*pair) : std::span<const ObjectId>();
  }

  std::string part_, text_;
  std::optional<StructureId> watched_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif

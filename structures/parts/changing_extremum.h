// SPDX-License-Identifier: GPL-3.0-or-later
// ChangingExtremum: the front one of a set of values, whose members come and go while the owner
// repairs itself.
//
// A value names the objects that it is made of: an edge its two ends, a strip its three points.
// Inside, values are numbered; the numbers are the items of a tournament and are never seen by the
// owner. Changes of the set are collected until apply(). A value that comes and goes in between, or
// goes and comes back, costs nothing. A value that goes and one that comes share a leaf of the
// tree, so a flip (one edge for another) renews one path.
//
//   owner's repair:  go(ab)  come(cd)  go(ef)  come(ef)      no sign is computed
//   apply():         cd takes the leaf of ab                 one path is decided, bottom up
//
// Claims are about values:
//   using Value;                      an array of ids, totally ordered by <=>
//   Query claim(front, back)          >= 0 iff `front` is in front of `back` or level with it; or
//                                     choose and claims_of (CasedClaims, parts/match_proof.h)
//   bool goes_first(front, back)      of two that are level identically: a strict total order
//
// Cost: n - 1 certificates for n values; k changes O(k log n) certificates and time; a failure
// O(log n). Deterministic: the tree depends on the order of the calls alone.
// Before an object disappears, all values made of it must have gone, and apply() must have been
// called.
#ifndef KINEX_STRUCTURES_PARTS_CHANGING_EXTREMUM_H
#define KINEX_STRUCTURES_PARTS_CHANGING_EXTREMUM_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "structures/parts/kinetic_tournament.h"
#include "structures/parts/value_numbers.h"

namespace kinex {

template <class ValueClaims>
class ChangingExtremum {
 public:
  using Value = typename ValueClaims::Value;
  struct Duel {  // two values whose order is to change
    Value before, after;
  };

  ChangingExtremum(Kernel& kernel, StructureId structure, std::string name, ValueClaims claims)
      : tournament_(kernel, structure, std::move(name), Numbered{std::move(claims), {}}) {}

  const ValueClaims& claims() const { return tournament_.claims().claims; }
  const Slots& slots() const { return tournament_.slots(); }
  // The number of values in the set, applied or not.
  std::size_t size() const { return size_; }
  bool has(const Value& value) const {
    const Item item = numbers().find(value);
    return item != kNoItem && states_[item] != State::kGoing;
  }
  // In ascending order. O(n log n).
  std::vector<Value> values() const {
    std::vector<Value> result;
    numbers().each([&](Item item) {
      if (states_[item] != State::kGoing) result.push_back(value(item));
    });
    std::sort(result.begin(), result.end());
    return result;
  }

  // Prefetches what come() and go() of the value read first. No effect on results.
  void prefetch(const Value& value) const { numbers().prefetch(value); }
  // False, with nothing changed, if it is there already. O(1), by hashing.
  bool come(const Value& value) {
    Item item = numbers().find(value);
    if (item != kNoItem && states_[item] != State::kGoing) return false;
    ++size_;
    if (item == kNoItem) {
      item = numbers().add(value);
      if (states_.size() <= item) states_.resize(item + std::size_t{1});
      states_[item] = State::kComing;
      coming_.push_back(item);
    } else {
      states_[item] = State::kThere;
    }
    return true;
  }
  // False, with nothing changed, if it is not there. O(1), by hashing.
  bool go(const Value& value) {
    const Item item = numbers().find(value);
    if (item == kNoItem || states_[item] == State::kGoing) return false;
    --size_;
    if (states_[item] == State::kComing) {
      numbers().remove(item);
      numbers().release(item);
      states_[item] = State::kThere;  // of no value, or of one that comes
    } else {
      states_[item] = State::kGoing;
      tournament_.prefetch(item);
      going_.push_back({value, item});
    }
    return true;
  }
  // The set is this one, in ascending order and without repetitions: calls go and come for the
  // difference. O(n log n).
  void assign(std::span<const Value> values) {
    const std::vector<Value> there = this->values();
    std::vector<Value> gone, came;
    std::set_difference(there.begin(), there.end(), values.begin(), values.end(),
                        std::back_inserter(gone));
    std::set_difference(values.begin(), values.end(), there.begin(), there.end(),
                        std::back_inserter(came));
    for (const Value& value : gone) go(value);
    for (const Value& value : came) come(value);
  }
  // Makes the collected changes effective, right after now. tied(old, fresh) gets values.
  template <class Tied>
  void apply(const Tied& tied) {
    take_changes();
    if (!gone_.empty() || !came_.empty()) tournament_.update(gone_, came_, by_value(tied));
    for (auto item = gone_.rbegin(); item != gone_.rend(); ++item) numbers().release(*item);
  }
  // Applies what has changed and makes the whole proof anew. O(n log n).
  template <class Tied>
  void rebuild(const Tied& tied) {
    take_changes();
    for (const Item item : gone_) numbers().release(item);
    std::vector<Item> items;
    for (const Value& value : values()) items.push_back(numbers().find(value));
    tournament_.build(std::move(items), by_value(tied));
  }

  // The front one; nullptr if there is none. As applied.
  const Value* front() const {
    return tournament_.size() == 0 ? nullptr : &value(tournament_.winner());
  }
  // A certificate of this part has failed. Returns the winner of its duel until now, and from now
  // on.
  template <class Tied>
  Duel failed(CertificateId failed, const Tied& tied) {
    const auto duel = tournament_.failed(failed, by_value(tied));
    return {value(duel.before), value(duel.after)};
  }
  template <class Tied>
  void motions_changed(std::span<const ObjectId> objects, const Tied& tied) {
    tournament_.motions_changed(objects, by_value(tied));
  }

  // Calls visit(node, value of the winner, certificates), as KineticTournament::each_node.
  template <class Visit>
  void each_node(const Visit& visit) const {
    tournament_.each_node(
        [&](std::uint32_t node, Item item, std::span<const CertificateId> certificates) {
          visit(node, value(item), certificates);
        });
  }

  Integer most_failures(int degree) const { return tournament_.most_failures(degree); }
  Integer most_failures_of_pairs(int failures) const {
    return tournament_.most_failures_of_pairs(failures);
  }
  void check(AuditReport& report, const std::string& name) const {
    report.check(going_.empty() && coming_.empty(),
                 [&] { return "changes of " + name + " were not applied"; });
    report.check(tournament_.size() == size_ && numbers().size() == size_,
                 [&] { return "a wrong number of values in " + name; });
    for (const Value& value : values()) {
      const Item item = numbers().find(value);
      report.check(tournament_.has(item) && this->value(item) == value,
                   [&] { return "a lost value in " + name; });
    }
    tournament_.check(report, name);
  }
  std::size_t bytes() const {
    return tournament_.bytes() + numbers().bytes() + states_.capacity() * sizeof(State) +
           going_.capacity() * sizeof(going_[0]) +
           (gone_.capacity() + came_.capacity() + coming_.capacity()) * sizeof(Item);
  }

 private:
  enum class State : std::uint8_t { kThere, kComing, kGoing };  // as applied, and as collected
  // The claims of the tournament: about the values of items.
  struct Numbered {
    ValueClaims claims;
    ValueNumbers<Value> values;

    Query claim(Item a, Item b) const
      requires requires(const ValueClaims& c, const Value& v) { c.claim(v, v); }
    {
      return claims.claim(values[a], values[b]);
    }
    CaseChoice choose(Kernel& kernel, Item a, Item b) const
      requires requires(const ValueClaims& c, const Value& v) { c.choose(kernel, v, v); }
    {
      return claims.choose(kernel, values[a], values[b]);
    }
    Conjunction claims_of(std::uint8_t which, Item a, Item b) const
      requires requires(const ValueClaims& c, const Value& v) { c.claims_of(which, v, v); }
    {
      return claims.claims_of(which, values[a], values[b]);
    }
    bool goes_first(Item a, Item b) const { return claims.goes_first(values[a], values[b]); }
  };

  const ValueNumbers<Value>& numbers() const { return tournament_.claims().values; }
  ValueNumbers<Value>& numbers() { return tournament_.claims().values; }
  const Value& value(Item item) const { return numbers()[item]; }
  template <class Tied>
  auto by_value(const Tied& tied) const {
    return [this, &tied](Item a, Item b) { tied(value(a), value(b)); };
  }
  // Into gone_, ascending by value, and came_, ascending by number. What was collected may be out of date.
  void take_changes() {
    gone_.clear();
    came_.clear();
    std::sort(going_.begin(), going_.end());
    going_.erase(std::unique(going_.begin(), going_.end()), going_.end());
    for (const auto& [value, item] : going_) {
      if (states_[item] != State::kGoing) continue;  // it has come back
      gone_.push_back(item);
      numbers().remove(item);
    }
    std::sort(coming_.begin(), coming_.end());
    coming_.erase(std::unique(coming_.begin(), coming_.end()), coming_.end());
    for (const Item item : coming_) {
      if (states_[item] != State::kComing) continue;  // it has gone
      states_[item] = State::kThere;
      came_.push_back(item);
    }
    going_.clear();
    coming_.clear();
  }

  KineticTournament<Numbered> tournament_;
  std::vector<State> states_;  // by item
  std::size_t size_ = 0;       // of the values, without those that go
  // With its number, which is its own until the changes are taken.
  std::vector<std::pair<Value, Item>> going_;
  std::vector<Item> coming_;
  std::vector<Item> gone_, came_;  // scratch
};

}  // namespace kinex

#endif

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
//   using Value;                      totally ordered by <=>
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

#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "structures/parts/kinetic_tournament.h"

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
  std::size_t size() const { return number_.size(); }
  bool has(const Value& value) const { return number_.contains(value); }
  // In ascending order.
  std::vector<Value> values() const {
    std::vector<Value> result;
    for (const auto& [value, item] : number_) result.push_back(value);
    return result;
  }

  // False, with nothing changed, if it is there already. O(log n).
  bool come(const Value& value) {
    const auto [place, fresh] = number_.try_emplace(value, kNoItem);
    if (!fresh) return false;
    const auto back = going_.find(value);
    if (back != going_.end()) {
      place->second = back->second;
      going_.erase(back);
      return true;
    }
    place->second = new_item(value);
    coming_.emplace(place->second);
    return true;
  }
  // False, with nothing changed, if it is not there. O(log n).
  bool go(const Value& value) {
    const auto place = number_.find(value);
    if (place == number_.end()) return false;
    const Item item = place->second;
    number_.erase(place);
    if (coming_.erase(item) != 0) {
      free_.push_back(item);
    } else {
      going_.emplace(value, item);
    }
    return true;
  }
  // The set is this one, in ascending order and without repetitions: calls go and come for the
  // difference. O(n).
  void assign(std::span<const Value> values) {
    std::vector<Value> gone, came;
    auto there = number_.begin();
    for (const Value& value : values) {
      for (; there != number_.end() && there->first < value; ++there) gone.push_back(there->first);
      if (there != number_.end() && there->first == value) {
        ++there;
      } else {
        came.push_back(value);
      }
    }
    for (; there != number_.end(); ++there) gone.push_back(there->first);
    for (const Value& value : gone) go(value);
    for (const Value& value : came) come(value);
  }
  // Makes the collected changes effective, right after now. tied(old, fresh) gets values.
  template <class Tied>
  void apply(const Tied& tied) {
    gone_.clear();
    for (const auto& [value, item] : going_) gone_.push_back(item);
    came_.assign(coming_.begin(), coming_.end());
    going_.clear();
    coming_.clear();
    if (!gone_.empty() || !came_.empty()) tournament_.update(gone_, came_, by_value(tied));
    free_.insert(free_.end(), gone_.rbegin(), gone_.rend());
  }
  // Applies what has changed and makes the whole proof anew. O(n).
  template <class Tied>
  void rebuild(const Tied& tied) {
    std::vector<Item> items;
    for (const auto& [value, item] : number_) items.push_back(item);
    for (const auto& [value, item] : going_) free_.push_back(item);
    going_.clear();
    coming_.clear();
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
    report.check(tournament_.size() == number_.size(),
                 [&] { return "a wrong number of values in " + name; });
    for (const auto& [value, item] : number_) {
      report.check(tournament_.has(item) && this->value(item) == value,
                   [&] { return "a lost value in " + name; });
    }
    tournament_.check(report, name);
  }
  std::size_t bytes() const {
    return tournament_.bytes() + number_.size() * (sizeof(Value) + 48) +
           tournament_.claims().values.capacity() * sizeof(Value) +
           (free_.capacity() + gone_.capacity() + came_.capacity()) * sizeof(Item);
  }

 private:
  // The claims of the tournament: about the values of items.
  struct Numbered {
    ValueClaims claims;
    std::vector<Value> values;  // by item

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

  const Value& value(Item item) const { return tournament_.claims().values[item]; }
  template <class Tied>
  auto by_value(const Tied& tied) const {
    return [this, &tied](Item a, Item b) { tied(value(a), value(b)); };
  }
  Item new_item(const Value& value) {
    std::vector<Value>& values = tournament_.claims().values;
    if (free_.empty()) {
      values.push_back(value);
      return static_cast<Item>(values.size() - 1);
    }
    const Item item = free_.back();
    free_.pop_back();
    values[item] = value;
    return item;
  }

  KineticTournament<Numbered> tournament_;
  std::map<Value, Item> number_;
  std::map<Value, Item> going_;
  std::set<Item> coming_;
  std::vector<Item> free_;
  std::vector<Item> gone_, came_;  // scratch
};

}  // namespace kinex

#endif

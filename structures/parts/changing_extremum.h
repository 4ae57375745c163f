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
#include <unordered_map>
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
  std::size_t size() const { return size_; }
  bool has(const Value& value) const {
    const auto place = number_.find(value);
    return place != number_.end() && place->second.state != State::kGoing;
  }
  // In ascending order. O(n log n).
  std::vector<Value> values() const {
    std::vector<Value> result;
    for (const auto& [value, entry] : number_) {
      if (entry.state != State::kGoing) result.push_back(value);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // False, with nothing changed, if it is there already. O(1), by hashing.
  bool come(const Value& value) {
    const auto [place, fresh] = number_.try_emplace(value);
    Entry& entry = place->second;
    if (!fresh && entry.state != State::kGoing) return false;
    ++size_;
    if (fresh) {
      entry = {new_item(value), State::kComing};
      coming_.push_back(entry.item);
    } else {
      entry.state = State::kThere;
    }
    return true;
  }
  // False, with nothing changed, if it is not there. O(1), by hashing.
  bool go(const Value& value) {
    const auto place = number_.find(value);
    if (place == number_.end() || place->second.state == State::kGoing) return false;
    --size_;
    if (place->second.state == State::kComing) {
      free_.push_back(place->second.item);
      number_.erase(place);
    } else {
      place->second.state = State::kGoing;
      going_.push_back(value);
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
    free_.insert(free_.end(), gone_.rbegin(), gone_.rend());
  }
  // Applies what has changed and makes the whole proof anew. O(n log n).
  template <class Tied>
  void rebuild(const Tied& tied) {
    take_changes();
    free_.insert(free_.end(), gone_.begin(), gone_.end());
    std::vector<Item> items;
    for (const Value& value : values()) items.push_back(number_.at(value).item);
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
    report.check(tournament_.size() == size_ && number_.size() == size_,
                 [&] { return "a wrong number of values in " + name; });
    for (const Value& value : values()) {
      const Item item = number_.at(value).item;
      report.check(tournament_.has(item) && this->value(item) == value,
                   [&] { return "a lost value in " + name; });
    }
    tournament_.check(report, name);
  }
  std::size_t bytes() const {
    return tournament_.bytes() + number_.size() * (sizeof(Value) + 40) +
           tournament_.claims().values.capacity() * sizeof(Value) +
           going_.capacity() * sizeof(Value) +
           (free_.capacity() + gone_.capacity() + came_.capacity() + coming_.capacity()) *
               sizeof(Item);
  }

 private:
  enum class State : std::uint8_t { kThere, kComing, kGoing };  // as applied, and as collected
  struct Entry {
    Item item = kNoItem;
    State state = State::kComing;
  };
  // For lookups only: no order depends on it.
  struct Hash {
    std::size_t operator()(const Value& value) const {
      std::uint64_t h = 0;
      for (const auto part : value) {
        h = (h ^ part) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
      }
      return static_cast<std::size_t>(h);
    }
  };

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
  // Into gone_, ascending by value, and came_, ascending by number. What was collected may be out of date.
  void take_changes() {
    gone_.clear();
    came_.clear();
    std::sort(going_.begin(), going_.end());
    going_.erase(std::unique(going_.begin(), going_.end()), going_.end());
    for (const Value& value : going_) {
      const auto place = number_.find(value);
      if (place == number_.end() || place->second.state != State::kGoing) continue;
      gone_.push_back(place->second.item);
      number_.erase(place);
    }
    std::sort(coming_.begin(), coming_.end());
    coming_.erase(std::unique(coming_.begin(), coming_.end()), coming_.end());
    for (const Item item : coming_) {
      const auto place = number_.find(value(item));
      if (place == number_.end() || place->second.item != item) continue;
      place->second.state = State::kThere;
      came_.push_back(item);
    }
    going_.clear();
    coming_.clear();
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
  std::unordered_map<Value, Entry, Hash> number_;
  std::size_t size_ = 0;  // of these, without those that go
  std::vector<Value> going_;
  std::vector<Item> coming_;
  std::vector<Item> free_;
  std::vector<Item> gone_, came_;  // scratch
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// ValueNumbers: numbers for values that come and go, found by hashing.
//
// A value is an array of ids. Its number is its place in an array; values with one hash are chained by
// their numbers, so that a value is found in its own memory:
//
//   first_   by hash    [ 2 | - | 0 | - ]       "ab" is number 2: the chain of its hash is 2, 1
//   entries_ by number  [ cd | ef | ab ]
//            next       [ -  | -  | 1  ]
//
// Numbers depend on the calls alone, not on hashes.
//
// Cost: O(1) a call, by hashing. With std::unordered_map in its place a run of closest_pair_local on
// 10,000 points takes a sixth more: each value is then in memory of its own.
#ifndef KINEX_STRUCTURES_PARTS_VALUE_NUMBERS_H
#define KINEX_STRUCTURES_PARTS_VALUE_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "structures/parts/claim.h"

namespace kinex {

template <class Value>
class ValueNumbers {
 public:
  const Value& operator[](Item number) const { return entries_[number].value; }
  // The number of values that are there.
  std::size_t size() const { return size_; }
  // kNoItem if the value is not there.
  Item find(const Value& value) const {
    if (first_.empty()) return kNoItem;
    Item number = first_[bucket(value)];
    while (number != kNoItem && !is_same(entries_[number].value, value)) {
      number = entries_[number].next;
    }
    return number;
  }
  // Prefetches what find() reads first.
  void prefetch(const Value& value) const {
    if (!first_.empty()) __builtin_prefetch(first_.data() + bucket(value), 1);
  }
  // Numbers a value that is not there.
  Item add(const Value& value) {
    if (size_ == first_.size()) grow();
    Item number;
    if (free_.empty()) {
      number = static_cast<Item>(entries_.size());
      entries_.push_back({value, kNoItem});
    } else {
      number = free_.back();
      free_.pop_back();
      entries_[number].value = value;
    }
    link(number);
    ++size_;
    return number;
  }
  // The value is there no longer. Its number still has it, until release().
  void remove(Item number) {
    Item* link = &first_[bucket(entries_[number].value)];
    while (*link != number) link = &entries_[*link].next;
    *link = entries_[number].next;
    --size_;
  }
  // The number of a value that was removed may be given to another one; the last one first.
  void release(Item number) { free_.push_back(number); }

  // Calls visit(number) for all values that are there, in no particular order.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const Item first : first_) {
      for (Item number = first; number != kNoItem; number = entries_[number].next) {
        visit(number);
      }
    }
  }
  std::size_t bytes() const {
    return entries_.capacity() * sizeof(Entry) +
           (first_.capacity() + free_.capacity()) * sizeof(Item);
  }

 private:
  struct Entry {
    Value value;
    Item next;  // with the same hash
  };

  // Part by part: the comparison of arrays is a call of memcmp.
  static bool is_same(const Value& a, const Value& b) {
    bool same = true;
    for (std::size_t i = 0; i < a.size(); ++i) same = same && a[i] == b[i];
    return same;
  }
  std::size_t bucket(const Value& value) const {
    std::uint64_t hash = 0;
    for (const auto part : value) {
      hash = (hash ^ part) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash) & (first_.size() - 1);
  }
  void link(Item number) {
    Item& first = first_[bucket(entries_[number].value)];
    entries_[number].next = first;
    first = number;
  }
  void grow() {
    std::vector<Item> there;
    there.reserve(size_);
    each([&](Item number) { there.push_back(number); });
    first_.assign(first_.empty() ? 8 : 2 * first_.size(), kNoItem);
    for (const Item number : there) link(number);
  }

  std::vector<Entry> entries_;  // by number
  std::vector<Item> first_;     // by hash; their number is a power of 2
  std::vector<Item> free_;
  std::size_t size_ = 0;
};

}  // namespace kinex

#endif

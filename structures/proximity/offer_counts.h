// SPDX-License-Identifier: GPL-3.0-or-later
// OfferCounts: how many nodes of range trees offer a value (cone_offers.h), so that it comes to a
// tournament (structures/parts/changing_extremum.h) with the first offer and goes with the last.
#ifndef KINEX_STRUCTURES_PROXIMITY_OFFER_COUNTS_H
#define KINEX_STRUCTURES_PROXIMITY_OFFER_COUNTS_H

#include <cstddef>
#include <map>
#include <vector>

namespace kinex {

template <class Value>
class OfferCounts {
 public:
  // `change`: one more, +1, or one fewer, -1.
  template <class Extremum>
  void count(const Value& value, int change, Extremum& values) {
    int& count = counts_[value];
    count += change;
    if (count == 0) {
      counts_.erase(value);
      values.go(value);
    } else if (change > 0 && count == 1) {
      values.come(value);
    }
  }
  // Those that are offered, ascending.
  std::vector<Value> values() const {
    std::vector<Value> result;
    for (const auto& [value, count] : counts_) result.push_back(value);
    return result;
  }
  std::size_t bytes() const { return counts_.size() * (sizeof(Value) + 56); }

 private:
  std::map<Value, int> counts_;
};

}  // namespace kinex

#endif

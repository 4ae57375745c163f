// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/order_changes.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace kinex {
namespace {

using Ids = std::vector<ObjectId>;
using Pair = std::array<ObjectId, 2>;
using Triple = std::array<ObjectId, 3>;

bool contains(const std::vector<Pair>& sorted, ObjectId a, ObjectId b) {
  return std::binary_search(sorted.begin(), sorted.end(), Pair{std::min(a, b), std::max(a, b)});
}

// By id: the place in the list, of those that are in it.
std::vector<std::size_t> places_in(const Ids& row) {
  std::vector<std::size_t> places;
  if (!row.empty()) places.resize(*std::max_element(row.begin(), row.end()) + std::size_t{1});
  for (std::size_t i = 0; i < row.size(); ++i) places[row[i]] = i;
  return places;
}

// Calls visit(a, b) for the pairs with a before b in one list, and behind it in the other, which has
// the same members.
template <class Visit>
void each_inversion(const Ids& before, const Ids& after, const Visit& visit) {
  std::size_t first = 0, last = before.size();
  while (first < last && before[first] == after[first]) ++first;
  while (first < last && before[last - 1] == after[last - 1]) --last;
  if (first == last) return;
  const std::vector<std::size_t> now = places_in(after);
  for (std::size_t i = first; i < last; ++i) {
    for (std::size_t k = i + 1; k < last; ++k) {
      if (now[before[i]] > now[before[k]]) visit(before[i], before[k]);
    }
  }
}

std::ptrdiff_t place(const Ids& row, ObjectId id) {
  return std::find(row.begin(), row.end(), id) - row.begin();
}

// What one line sees of an instant.
class View {
 public:
  // `others`: those whose slope has passed that of the line.
  View(ObjectId line, const Ids& before, const Ids& after, Ids others)
      : line_(line), before_(before), after_(after), others_(std::move(others)) {}

  bool is_consistent() const {
    const auto crossings = place(before_, line_);
    return place(after_, line_) == crossings && crossings < std::ssize(before_) &&
           std::equal(before_.begin(), before_.begin() + crossings, after_.begin()) &&
           std::is_permutation(before_.begin(), before_.end(), after_.begin(), after_.end());
  }
  // The triples with the line, ids ascending.
  void collect(std::vector<Triple>& triples) const {
    const auto add = [&](ObjectId m, ObjectId k) {
      Triple triple{line_, m, k};
      std::sort(triple.begin(), triple.end());
      triples.push_back(triple);
    };
    each_inversion(without_others(before_), without_others(after_), add);
    if (others_.empty()) return;
    const std::vector<std::size_t> was = places_in(before_), is = places_in(after_);
    for (const ObjectId m : others_) {
      for (std::size_t i = was[line_] + 1; i < before_.size(); ++i) {
        const ObjectId k = before_[i];
        const bool both = is_other(k);
        if (k == m || (both && k < m)) continue;
        const bool inverted = (was[m] < was[k]) != (is[m] < is[k]);
        if (inverted == both) add(m, k);
      }
    }
  }

 private:
  bool is_other(ObjectId k) const {
    return std::find(others_.begin(), others_.end(), k) != others_.end();
  }
  Ids without_others(Ids row) const {
    std::erase_if(row, [this](ObjectId k) { return is_other(k); });
    return row;
  }

  ObjectId line_;
  const Ids& before_;
  const Ids& after_;
  Ids others_;
};

// Of two lines of a triple that has turned over. They are parallel identically iff each stands before
// the other one in the list of the other one. Lists that have not changed are missing; if those of both
// are, the two are parallel iff they have passed through each other.
bool are_parallel(const LineOrders& orders, const std::vector<Pair>& equals, ObjectId a,
                  ObjectId b) {
  const auto stands_before = [&orders](ObjectId line, ObjectId other) {
    const auto own = orders.find(line);
    return own != orders.end() && place(own->second, other) < place(own->second, line);
  };
  return contains(equals, a, b) || stands_before(a, b) || stands_before(b, a);
}

// Every triple is seen from all three lines; if two of them are parallel, from the third alone.
bool are_seen(const std::vector<Triple>& sorted, const LineOrders& orders,
              const std::vector<Pair>& equals) {
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t end = i;
    while (end < sorted.size() && sorted[end] == sorted[i]) ++end;
    const auto& [a, b, c] = sorted[i];
    const bool parallel = are_parallel(orders, equals, a, b) ||
                          are_parallel(orders, equals, b, c) || are_parallel(orders, equals, a, c);
    if (end - i != (parallel ? 1 : 3)) return false;
    i = end;
  }
  return true;
}

}  // namespace

std::optional<ArrangementChange> change_between(const LineOrders& before, const LineOrders& after) {
  ArrangementChange change;
  const auto slopes = before.find(kNoObject);
  if (slopes != before.end()) {
    each_inversion(slopes->second, after.at(kNoObject), [&](ObjectId a, ObjectId b) {
      const auto own = after.find(a);
      const bool parallel =
          own == after.end() || place(own->second, b) < place(own->second, a);
      (parallel ? change.equals : change.parallels).push_back({std::min(a, b), std::max(a, b)});
    });
    std::sort(change.parallels.begin(), change.parallels.end());
    std::sort(change.equals.begin(), change.equals.end());
  }
  for (const auto& [line, row] : before) {
    if (line == kNoObject) continue;
    Ids others;
    for (const auto& [a, b] : change.parallels) {
      if (a == line) others.push_back(b);
      if (b == line) others.push_back(a);
    }
    const View view(line, row, after.at(line), std::move(others));
    if (!view.is_consistent()) return std::nullopt;
    view.collect(change.triples);
  }
  std::sort(change.triples.begin(), change.triples.end());
  if (!are_seen(change.triples, after, change.equals)) return std::nullopt;
  change.triples.erase(std::unique(change.triples.begin(), change.triples.end()),
                       change.triples.end());
  return change;
}

}  // namespace kinex

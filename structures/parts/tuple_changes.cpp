// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/tuple_changes.h"

#include <iterator>
#include <utility>

namespace kinex {
namespace {

template <std::size_t kWidth>
std::vector<std::array<ObjectId, kWidth>> tuples_of(const std::vector<ObjectId>& ids) {
  std::vector<std::array<ObjectId, kWidth>> result(ids.size() / kWidth);
  for (std::size_t i = 0; i < kWidth * result.size(); ++i) result[i / kWidth][i % kWidth] = ids[i];
  return result;
}

}  // namespace

template <std::size_t kWidth>
void TupleChanges<kWidth>::add(const AttributeDifference& difference) {
  for (const Tuple& tuple : tuples_of<kWidth>(difference.gone)) gone(tuple);
  for (const Tuple& tuple : tuples_of<kWidth>(difference.came)) came(tuple);
}

template <std::size_t kWidth>
AttributeDifference TupleChanges<kWidth>::net() const {
  std::vector<Change> sorted = changes_;
  std::sort(sorted.begin(), sorted.end(),
            [](const Change& a, const Change& b) { return a.tuple < b.tuple; });
  AttributeDifference result;
  for (std::size_t i = 0; i < sorted.size();) {
    const Tuple tuple = sorted[i].tuple;
    int more = 0;
    for (; i < sorted.size() && sorted[i].tuple == tuple; ++i) more += sorted[i].came ? 1 : -1;
    std::vector<ObjectId>& ids = more > 0 ? result.came : result.gone;
    for (; more != 0; more -= more > 0 ? 1 : -1) ids.insert(ids.end(), tuple.begin(), tuple.end());
  }
  return result;
}

template <std::size_t kWidth>
AttributeDifference TupleChanges<kWidth>::take() {
  AttributeDifference result = net();
  clear();
  return result;
}

template <std::size_t kWidth>
Attribute TupleChanges<kWidth>::undone(Attribute after) const {
  if (changes_.empty()) return after;
  const AttributeDifference change = net();
  const auto now = tuples_of<kWidth>(after.ids), gone = tuples_of<kWidth>(change.gone),
             came = tuples_of<kWidth>(change.came);
  std::vector<Tuple> kept, before;
  std::set_difference(now.begin(), now.end(), came.begin(), came.end(), std::back_inserter(kept));
  std::merge(kept.begin(), kept.end(), gone.begin(), gone.end(), std::back_inserter(before));
  after.ids.clear();
  for (const Tuple& tuple : before) after.ids.insert(after.ids.end(), tuple.begin(), tuple.end());
  return after;
}

template class TupleChanges<2>;
template class TupleChanges<3>;
template class TupleChanges<4>;

}  // namespace kinex

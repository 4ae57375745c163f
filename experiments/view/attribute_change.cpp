// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/attribute_change.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/numbers/check.h"

namespace kinex::view {

namespace {

// The tuples of a set, in their order.
using Tuple = std::vector<ObjectId>;
std::vector<Tuple> tuples_of(const std::vector<ObjectId>& ids, std::size_t width) {
  std::vector<Tuple> tuples;
  for (std::size_t i = 0; i + width <= ids.size(); i += width) {
    const auto first = ids.begin() + static_cast<std::ptrdiff_t>(i);
    tuples.emplace_back(first, first + static_cast<std::ptrdiff_t>(width));
  }
  return tuples;
}

AttributeChange splice(const std::vector<ObjectId>& before, const std::vector<ObjectId>& after) {
  const auto [b, a] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  auto before_end = before.end();
  auto after_end = after.end();
  while (before_end != b && after_end != a && *(before_end - 1) == *(after_end - 1)) {
    --before_end;
    --after_end;
  }
  AttributeChange change;
  change.at = static_cast<std::size_t>(b - before.begin());
  change.removed.assign(b, before_end);
  change.added.assign(a, after_end);
  return change;
}

}  // namespace

AttributeChange difference(const Attribute& before, const Attribute& after) {
  require(before.shape == after.shape, "an attribute changed its shape");
  require(before.width == after.width, "an attribute changed the width of its tuples");
  if (before.shape != Attribute::Shape::kTuples) return splice(before.ids, after.ids);
  AttributeDifference both = difference_between(before, after);
  AttributeChange change;
  change.removed = std::move(both.gone);
  change.added = std::move(both.came);
  return change;
}

void apply(const AttributeChange& change, Attribute& attribute) {
  std::vector<ObjectId>& ids = attribute.ids;
  if (attribute.shape != Attribute::Shape::kTuples) {
    const std::size_t end = change.at + change.removed.size();
    require(end <= ids.size(), "a change beyond the end of an attribute");
    const auto first = ids.begin() + static_cast<std::ptrdiff_t>(change.at);
    require(std::equal(change.removed.begin(), change.removed.end(), first),
            "a change of something else");
    const auto place = ids.erase(first, ids.begin() + static_cast<std::ptrdiff_t>(end));
    ids.insert(place, change.added.begin(), change.added.end());
    return;
  }
  const std::vector<Tuple> all = tuples_of(ids, attribute.width);
  const std::vector<Tuple> removed = tuples_of(change.removed, attribute.width);
  require(std::includes(all.begin(), all.end(), removed.begin(), removed.end()),
          "a change removes a tuple that is not there");
  const std::vector<Tuple> added = tuples_of(change.added, attribute.width);
  std::vector<Tuple> kept, result;
  std::set_difference(all.begin(), all.end(), removed.begin(), removed.end(),
                      std::back_inserter(kept));
  std::merge(kept.begin(), kept.end(), added.begin(), added.end(), std::back_inserter(result));
  ids.clear();
  for (const Tuple& tuple : result) ids.insert(ids.end(), tuple.begin(), tuple.end());
}

}  // namespace kinex::view

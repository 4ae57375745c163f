// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/pairs_by_object.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/numbers/check.h"

namespace kinex::view {

namespace {

using Pair = std::pair<ObjectId, ObjectId>;

std::vector<ObjectId> flat(const std::vector<Pair>& pairs) {
  std::vector<ObjectId> ids;
  ids.reserve(2 * pairs.size());
  for (const auto& [a, b] : pairs) ids.insert(ids.end(), {a, b});
  return ids;
}

// The pairs of these objects, ascending; one of two of them once, as a pair of the smaller.
template <class NeighboursOf>
std::vector<Pair> pairs_of(const std::vector<ObjectId>& objects,
                           const NeighboursOf& neighbours_of) {
  std::vector<Pair> pairs;
  for (const ObjectId a : objects) {
    for (const ObjectId b : neighbours_of(a)) {
      if (b > a || !std::binary_search(objects.begin(), objects.end(), b))
        pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

PairsByObject::PairsByObject(const Attribute& attribute) {
  require(attribute.shape == Attribute::Shape::kTuples && attribute.width == 2,
          "an attribute of pairs");
  for (std::size_t i = 0; i + 2 <= attribute.ids.size(); i += 2) {
    of(attribute.ids[i]).push_back(attribute.ids[i + 1]);
    of(attribute.ids[i + 1]).push_back(attribute.ids[i]);
  }
  for (std::vector<ObjectId>& one : neighbours_) std::sort(one.begin(), one.end());
}

std::vector<ObjectId>& PairsByObject::of(ObjectId object) {
  if (neighbours_.size() <= object) neighbours_.resize(object + std::size_t{1});
  return neighbours_[object];
}

void PairsByObject::erase(ObjectId a, ObjectId b) {
  std::vector<ObjectId>& one = of(a);
  one.erase(std::lower_bound(one.begin(), one.end(), b));
}

void PairsByObject::insert(ObjectId a, ObjectId b) {
  std::vector<ObjectId>& one = of(a);
  one.insert(std::lower_bound(one.begin(), one.end(), b), b);
}

AttributeChange PairsByObject::update(const LocalPairs& structure, std::vector<ObjectId> objects) {
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  const std::vector<Pair> before =
      pairs_of(objects, [this](ObjectId a) -> const std::vector<ObjectId>& { return of(a); });
  const std::vector<Pair> after =
      pairs_of(objects, [&](ObjectId a) { return structure.neighbours(a); });
  std::vector<Pair> gone, came;
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                      std::back_inserter(gone));
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::back_inserter(came));
  for (const auto& [a, b] : gone) {
    erase(a, b);
    erase(b, a);
  }
  for (const auto& [a, b] : came) {
    insert(a, b);
    insert(b, a);
  }
  AttributeChange change;
  change.removed = flat(gone);
  change.added = flat(came);
  return change;
}

Attribute PairsByObject::attribute() const {
  Attribute result;
  result.shape = Attribute::Shape::kTuples;
  for (ObjectId a = 0; a < neighbours_.size(); ++a) {
    for (const ObjectId b : neighbours_[a]) {
      if (b > a) result.ids.insert(result.ids.end(), {a, b});
    }
  }
  return result;
}

}  // namespace kinex::view

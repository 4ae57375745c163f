// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/static_closest_pair_audit.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace kinex {
namespace {

using Pair = std::array<ObjectId, 2>;
using Counts = std::function<bool(ObjectId, ObjectId)>;

// Calls found(pair, closer) for pairs, ids ascending, that are as close as all before, or closer. Those after the
// last closer one, and that one, are the closest pairs.
template <class Found>
void find_closest(const Snapshot& snapshot, const Counts& counts, const Found& found) {
  std::vector<ObjectId> along;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) along.push_back(id);
  }
  std::sort(along.begin(), along.end(), [&](ObjectId a, ObjectId b) {
    return snapshot.position(a, 0) < snapshot.position(b, 0);
  });
  bool any = false;
  Rational best;
  for (std::size_t i = 0; i < along.size(); ++i) {
    for (std::size_t j = i + 1; j < along.size(); ++j) {
      const auto squared = [&](int axis) {
        const Rational d = snapshot.position(along[j], axis) - snapshot.position(along[i], axis);
        return d * d;
      };
      Rational distance = squared(0);
      if (any && best < distance) break;
      if (counts && !counts(along[i], along[j])) continue;
      for (int axis = 1; axis < snapshot.dimension(); ++axis) distance += squared(axis);
      if (any && best < distance) continue;
      const bool closer = !any || distance < best;
      any = true;
      best = distance;
      found(Pair{std::min(along[i], along[j]), std::max(along[i], along[j])}, closer);
    }
  }
}

// True for two points at one place.
bool coincide(const Snapshot& snapshot, const Pair& pair) {
  for (int axis = 0; axis < snapshot.dimension(); ++axis) {
    if (snapshot.position(pair[0], axis) != snapshot.position(pair[1], axis)) return false;
  }
  return true;
}

}  // namespace

std::vector<ObjectId> static_closest_pair(const Snapshot& snapshot, const Counts& counts) {
  std::vector<ObjectId> closest;
  find_closest(snapshot, counts, [&closest](const Pair& pair, bool closer) {
    if (closer ||
        std::lexicographical_compare(pair.begin(), pair.end(), closest.begin(), closest.end())) {
      closest.assign(pair.begin(), pair.end());
    }
  });
  return closest;
}

std::vector<Pair> static_closest_pairs(const Snapshot& snapshot) {
  std::vector<Pair> closest;
  find_closest(snapshot, {}, [&closest](const Pair& pair, bool closer) {
    if (closer) closest.clear();
    closest.push_back(pair);
  });
  std::sort(closest.begin(), closest.end());
  if (closest.empty() || !coincide(snapshot, closest[0])) return closest;
  // All pairs of each place are there, so the first one of a point is that with the next id.
  const auto end = std::unique(closest.begin(), closest.end(),
                               [](const Pair& p, const Pair& q) { return p[0] == q[0]; });
  closest.erase(end, closest.end());
  return closest;
}

void check_closest_pairs(const Snapshot& snapshot, const std::vector<ObjectId>& attribute,
                         const std::function<bool(const Pair&)>& is_item, AuditReport& report) {
  const std::vector<Pair> closest = static_closest_pairs(snapshot);
  std::vector<ObjectId> first;
  if (!closest.empty()) first.assign(closest[0].begin(), closest[0].end());
  report.check(first == attribute, [] { return "another pair is the closest"; });
  for (const Pair& pair : closest) {
    report.check(is_item(pair), [&pair] {
      return "closest pair " + std::to_string(pair[0]) + ", " + std::to_string(pair[1]) +
             " is no candidate";
    });
  }
}

}  // namespace kinex

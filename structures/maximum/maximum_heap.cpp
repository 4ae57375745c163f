// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_heap.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/maximum/maximum_bounds.h"

namespace kinex {

MaximumHeap::MaximumHeap(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                         Extremum extremum)
    : MaximumStructure(kernel, id, scene, Contest(extremum, kernel, key, scene), "maximum_heap",
                       "minimum_heap", kReplace),
      heap_(kernel, id, "heap", contest_, scene.objects.size()) {}

std::vector<std::string_view> MaximumHeap::event_kinds() const {
  return common_event_kinds({"swap", "tie", "replace"});
}

void MaximumHeap::build(std::span<const ObjectId> objects) {
  heap_.build(contest_.order().members(objects), tied());
  events_.begin(winner());
}

void MaximumHeap::rebuild() {
  std::vector<ObjectId> members = heap_.items();
  std::sort(members.begin(), members.end());
  heap_.build(std::move(members), tied());
  events_.begin(winner());
}

void MaximumHeap::certificate_failed(CertificateId failed) {
  const auto [down, up] = heap_.failed(failed, tied());
  events_.repaired(kSwap, {down, up}, winner());
}

// A new motion of the reference of the distances is one of every key.
void MaximumHeap::motions_changed(std::span<const ObjectId> objects) {
  std::vector<ObjectId> moved;
  for (const ObjectId object : objects) {
    if (heap_.has(object)) {
      moved.push_back(object);
    } else {
      moved.insert(moved.end(), heap_.items().begin(), heap_.items().end());
    }
  }
  heap_.motions_changed(objects, moved, tied());
}

void MaximumHeap::insert(ObjectId object) {
  heap_.insert(object, tied());
  events_.begin(winner());
}

void MaximumHeap::erase(ObjectId object) {
  contest_.order().check_erasure(object);
  heap_.erase(object, tied());
  events_.begin(winner());
}

std::vector<BoundCheck> MaximumHeap::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = maximum_bounds(name(), contest_.order(), context);
  if (contest_.order().reference() == kNoObject) {
    result.push_back(at_most(std::string(name()) + ".locality", "a parent and two children",
                             Integer(3), counted(context.ledger->max_per_object)));
  }
  if (contest_.order().degree(context.degree) <= 1) {
    result.push_back(at_most(std::string(name()) + ".events",
                             "affine motions: pairs of an ancestor and a descendant in the heap; "
                             "Basch, Guibas, Ramkumar 1996; and those that a change makes anew",
                             counted(heap_.most_failures()), counted(context.ledger->failures)));
  } else {
    result.push_back(crossing_bound(name(), contest_.order(), context));
  }
  return result;
}

void MaximumHeap::check_invariants(AuditReport& report) const {
  check_told(report);
  heap_.check(report, "the heap");
}

}  // namespace kinex

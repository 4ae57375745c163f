// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/box_overlaps.h"

#include <algorithm>

#include "predicates/points/extent_predicates.h"

namespace kinex {

// ---- claims

EndClaims::EndClaims(Kernel& kernel, const Scene& scene, int axis) {
  const bool discs = scene.extents == Extents::kRadius;
  const EndAxes axes{axis, scene.dimension + (discs ? 0 : axis), scene.dimension};
  lower_ends_ = kernel.bind(make_end_order(EndClaim::kLowerEnds, axes));
  upper_ends_ = kernel.bind(make_end_order(EndClaim::kUpperEnds, axes));
  meeting_ = kernel.bind(make_end_order(EndClaim::kMeeting, axes));
  apart_ = kernel.bind(make_end_order(EndClaim::kApart, axes));
  width_ = kernel.bind(make_half_width(axes));
  no_width_ = kernel.bind(make_no_width(axes));
}

Query EndClaims::claim(Item a, Item b) const {
  const ObjectId one = object_of(a), other = object_of(b);
  if (one == other) return {is_upper(b) ? width_ : no_width_, {one}};
  if (is_upper(a) == is_upper(b)) return {is_upper(a) ? upper_ends_ : lower_ends_, {one, other}};
  if (is_upper(b)) return {meeting_, {one, other}};
  return {apart_, {other, one}};
}

// ---- boxes

BoxOverlaps::BoxOverlaps(Kernel& kernel, StructureId id, const Scene& scene)
    : there_(scene.objects.size()) {
  const std::size_t ends = 2 * scene.objects.size();
  for (int axis = 0; axis < scene.dimension; ++axis) {
    lists_.emplace_back(kernel, id, std::string("ends along ") + "xyz"[axis],
                        EndClaims(kernel, scene, axis), ends);
  }
  rank_.assign(lists_.size(), std::vector<std::uint32_t>(ends));
}

const BoxOverlaps::List* BoxOverlaps::list_of(CertificateId c) const {
  for (const List& list : lists_) {
    if (list.slots().owns(c)) return &list;
  }
  return nullptr;
}

void BoxOverlaps::number(std::size_t axis) {
  std::uint32_t place = 0;
  for (const Item end : lists_[axis].items()) rank_[axis][end] = place++;
}

bool BoxOverlaps::meet(ObjectId a, ObjectId b) const {
  return std::all_of(rank_.begin(), rank_.end(), [a, b](const std::vector<std::uint32_t>& rank) {
    return rank[EndClaims::lower(a)] < rank[EndClaims::upper(b)] &&
           rank[EndClaims::lower(b)] < rank[EndClaims::upper(a)];
  });
}

std::vector<ObjectId> BoxOverlaps::objects() const {
  std::vector<ObjectId> result;
  for (ObjectId object = 0; object < there_.size(); ++object) {
    if (there_[object]) result.push_back(object);
  }
  return result;
}

std::vector<BoxOverlaps::Pair> BoxOverlaps::pairs() const {
  std::vector<Pair> result;
  std::vector<ObjectId> open;  // their lower ends are behind the sweep, their upper ends before it
  for (const Item end : lists_.front().items()) {
    const ObjectId object = EndClaims::object_of(end);
    if (EndClaims::is_upper(end)) {
      std::erase(open, object);
      continue;
    }
    for (const ObjectId other : open) {
      if (meet(object, other)) result.push_back({std::min(object, other), std::max(object, other)});
    }
    open.push_back(object);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<ObjectId> BoxOverlaps::partners(ObjectId object) const {
  std::vector<ObjectId> result;
  for (ObjectId other = 0; other < there_.size(); ++other) {
    if (there_[other] && other != object && meet(object, other)) result.push_back(other);
  }
  return result;
}

std::uint64_t BoxOverlaps::swaps() const {
  std::uint64_t sum = 0;
  for (const List& list : lists_) sum += list.slots().line().failures;
  return sum;
}

std::uint64_t BoxOverlaps::max_live() const {
  std::uint64_t sum = 0;
  for (const List& list : lists_) sum += list.slots().line().max_live;
  return sum;
}

// ---- checks

void BoxOverlaps::visit_proof(ProofVisitor& visitor) const {
  // A group for each axis and two neighbours: two boxes may be neighbours along every axis.
  ProofGroup group;
  group.kind = "neighbouring ends";
  std::uint64_t place = 0;
  for (std::size_t axis = 0; axis < lists_.size(); ++axis) {
    lists_[axis].each_link([&](Item end, Item next, CertificateId certificate) {
      group.about = {EndClaims::object_of(end)};
      if (EndClaims::object_of(next) != EndClaims::object_of(end)) {
        group.about.push_back(EndClaims::object_of(next));
      }
      group.place = place++;
      group.text = std::string("along ") + "xyz"[axis];
      visitor.group(group);
      visitor.certificate(certificate, EndClaims::is_upper(end) ? "upper end, next" : "lower end, next");
    });
  }
}

void BoxOverlaps::check(AuditReport& report) const {
  for (std::size_t axis = 0; axis < lists_.size(); ++axis) {
    const std::string name = std::string("the ends along ") + "xyz"[axis];
    lists_[axis].check(report, name);
    std::uint32_t place = 0;
    for (const Item end : lists_[axis].items()) {
      report.check(has(EndClaims::object_of(end)), [&] { return "an end of no box in " + name; });
      report.check(rank_[axis][end] == place++, [&] { return "a wrong place in " + name; });
    }
    report.check(place == 2 * size_, [&] { return "an end is missing in " + name; });
  }
}

std::size_t BoxOverlaps::bytes() const {
  std::size_t sum = there_.capacity() / 8;
  for (std::size_t axis = 0; axis < lists_.size(); ++axis) {
    sum += lists_[axis].bytes() + rank_[axis].capacity() * sizeof(std::uint32_t);
  }
  return sum;
}

}  // namespace kinex

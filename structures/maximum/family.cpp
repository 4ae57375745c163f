// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/family.h"

#include "structures/maximum/maximum_dual_hull.h"
#include "structures/maximum/maximum_envelope.h"
#include "structures/maximum/maximum_hanger.h"
#include "structures/maximum/maximum_heap.h"
#include "structures/maximum/maximum_of_list.h"
#include "structures/maximum/maximum_tournament.h"

namespace kinex {
namespace {

template <class S, Extremum kExtremum>
std::unique_ptr<Structure> make_extremum(const MakerInput& in) {
  return std::make_unique<S>(in.kernel, in.id, in.request.key, in.scene, kExtremum);
}

template <Extremum kExtremum>
std::unique_ptr<Structure> make_of_list(const MakerInput& in) {
  return std::make_unique<MaximumOfList>(in.kernel, in.id,
                                         dynamic_cast<const SortedList&>(*in.watched[0]), kExtremum);
}

using Maker = std::unique_ptr<Structure> (*)(const MakerInput&);

// Each structure for the maximum, and its mirror image for the minimum.
class Family {
 public:
  StructureInfo base() const {
    StructureInfo info;
    info.any_dimension = true;
    info.uses_key = true;
    info.shape = Attribute::Shape::kObject;
    info.ties = "of objects with identically equal keys the smallest id wins";
    info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 5";
    return info;
  }
  void add(StructureInfo info, std::string_view maximum, std::string_view of_largest,
           Maker make_maximum, std::string_view minimum, std::string_view of_smallest,
           Maker make_minimum) {
    info.name = maximum;
    info.summary = of_largest;
    info.group = "maximum";
    if (info.linear()) info.instead = "maximum_tournament";
    info.make = make_maximum;
    structures.push_back(info);
    info.name = minimum;
    info.summary = of_smallest;
    info.group = "minimum";
    if (info.linear()) info.instead = "minimum_tournament";
    info.make = make_minimum;
    structures.push_back(info);
  }
  template <class S>
  void add(StructureInfo info, std::string_view maximum, std::string_view of_largest,
           std::string_view minimum, std::string_view of_smallest) {
    add(info, maximum, of_largest, make_extremum<S, Extremum::kMaximum>, minimum, of_smallest,
        make_extremum<S, Extremum::kMinimum>);
  }

  std::vector<StructureInfo> structures;
};

}  // namespace

StructureFamily maximum_family() {
  Family family;
  const StructureInfo base = family.base();
  StructureInfo tournament = base;
  tournament.kinds = {
      {"replace", Effect::kSometimes, "another object wins a match"},
      {"tie", Effect::kNever, "another object wins a match: the keys are identically equal"}};
  tournament.certificates = "n - 1, one for each match";
  family.add<MaximumTournament>(
      tournament, "maximum_tournament", "the object with the largest key, by a tournament tree",
      "minimum_tournament", "the object with the smallest key, by a tournament tree");
  StructureInfo heap = base;
  heap.certificates = "n - 1, every parent against its child";
  heap.kinds = {{"swap", Effect::kSometimes, "a parent and its child change places"},
                {"tie", Effect::kNever,
                 "a parent and its child change places: their keys are identically equal"},
                {"replace", Effect::kAlways, "another object is at the root after the instant"}};
  family.add<MaximumHeap>(heap, "maximum_heap", "the object with the largest key, by a binary heap",
                          "minimum_heap", "the object with the smallest key, by a binary heap");
  StructureInfo hanger = heap;
  hanger.source = "da Fonseca, de Figueiredo, Carvalho, Kinetic hanger (2004)";
  family.add<MaximumHanger>(
      hanger, "maximum_hanger", "the object with the largest key, by a randomised hanger",
      "minimum_hanger", "the object with the smallest key, by a randomised hanger");
  StructureInfo envelope = base;
  envelope.certificates = "1, the winner against the next one of the envelope";
  envelope.kinds = {
      {"replace", Effect::kAlways, "another object has the extreme key"},
      {"tie", Effect::kAlways, "an object of smaller id has the extreme key, too, identically"}};
  family.add<MaximumEnvelope>(
      envelope, "maximum_envelope", "the object with the largest key, by the upper envelope ahead",
      "minimum_envelope", "the object with the smallest key, by the lower envelope ahead");
  StructureInfo linear = envelope;
  linear.largest_degree = 1;
  linear.certificates = "1, the winner against the next vertex of the dual hull";
  family.add<MaximumDualHull>(
      linear, "maximum_dual_hull",
      "the object with the largest key, by the dual hull of linear motions", "minimum_dual_hull",
      "the object with the smallest key, by the dual hull of linear motions");
  StructureInfo reader = base;
  reader.reads = {{"sorted_list"}};
  reader.certificates = "none of its own, it reads the n - 1 of sorted_list";
  reader.kinds = {{"replace", Effect::kAlways, "another object has the extreme key"}};
  family.add(
      reader, "maximum_sorted_list", "the object with the largest key, read off a sorted list",
      make_of_list<Extremum::kMaximum>, "minimum_sorted_list",
      "the object with the smallest key, read off a sorted list", make_of_list<Extremum::kMinimum>);
  return {"maximum", std::move(family.structures)};
}

}  // namespace kinex

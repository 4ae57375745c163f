// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/registry.h"

#include <stdexcept>

#include "structures/bounding_volumes.h"
#include "structures/closest_features.h"
#include "structures/convex_hull_2.h"
#include "structures/convex_hull_2_brute_force.h"
#include "structures/convex_hull_2_delaunay.h"
#include "structures/delaunay_2.h"
#include "structures/inner_tangents.h"
#include "structures/maximum_dual_hull.h"
#include "structures/maximum_envelope.h"
#include "structures/maximum_hanger.h"
#include "structures/maximum_heap.h"
#include "structures/maximum_of_list.h"
#include "structures/maximum_tournament.h"
#include "structures/outer_hierarchies.h"
#include "structures/separation_hysteresis.h"
#include "structures/separation_minkowski.h"
#include "structures/separation_mixed.h"
#include "structures/sorted_list.h"

namespace kinex {
namespace {

using Maker = std::unique_ptr<Structure> (*)(const Request&, const Scene&, Kernel&, StructureId,
                                             const Structure*);

std::unique_ptr<Structure> make_sorted_list(const Request& request, const Scene& scene,
                                            Kernel& kernel, StructureId id, const Structure*) {
  return std::make_unique<SortedList>(kernel, id, request.key, scene);
}

template <class S, Extremum kExtremum>
std::unique_ptr<Structure> make_extremum(const Request& request, const Scene& scene, Kernel& kernel,
                                         StructureId id, const Structure*) {
  return std::make_unique<S>(kernel, id, request.key, scene, kExtremum);
}

std::unique_ptr<Structure> make_delaunay_2(const Request&, const Scene& scene, Kernel& kernel,
                                           StructureId id, const Structure*) {
  return std::make_unique<Delaunay2>(kernel, id, scene);
}

template <ConvexHull2::Variant kVariant>
std::unique_ptr<Structure> make_convex_hull_2(const Request&, const Scene& scene, Kernel& kernel,
                                              StructureId id, const Structure*) {
  return std::make_unique<ConvexHull2>(kernel, id, scene, kVariant);
}

std::unique_ptr<Structure> make_convex_hull_2_brute_force(const Request&, const Scene& scene,
                                                          Kernel& kernel, StructureId id,
                                                          const Structure*) {
  return std::make_unique<ConvexHull2BruteForce>(kernel, id, scene);
}

std::unique_ptr<Structure> make_convex_hull_2_delaunay(const Request&, const Scene& scene,
                                                       Kernel& kernel, StructureId id,
                                                       const Structure* triangulation) {
  return std::make_unique<ConvexHull2Delaunay>(kernel, id, scene,
                                               dynamic_cast<const Delaunay2&>(*triangulation));
}

template <Extremum kExtremum>
std::unique_ptr<Structure> make_of_list(const Request&, const Scene&, Kernel& kernel,
                                        StructureId id, const Structure* list) {
  return std::make_unique<MaximumOfList>(kernel, id, dynamic_cast<const SortedList&>(*list),
                                         kExtremum);
}

template <class S>
std::unique_ptr<Structure> make_of_bodies(const Request&, const Scene& scene, Kernel& kernel,
                                          StructureId id, const Structure*) {
  return std::make_unique<S>(kernel, id, scene);
}

struct Entry {
  StructureInfo info;
  Maker make;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> kEntries{
      {{"sorted_list", "objects in the order of a key, by certificates between neighbours", 1, true,
        ""},
       make_sorted_list},
      {{"maximum_tournament", "the object with the largest key, by a tournament tree", 1, true, ""},
       make_extremum<MaximumTournament, Extremum::kMaximum>},
      {{"minimum_tournament", "the object with the smallest key, by a tournament tree", 1, true,
        ""},
       make_extremum<MaximumTournament, Extremum::kMinimum>},
      {{"maximum_heap", "the object with the largest key, by a binary heap", 1, true, ""},
       make_extremum<MaximumHeap, Extremum::kMaximum>},
      {{"minimum_heap", "the object with the smallest key, by a binary heap", 1, true, ""},
       make_extremum<MaximumHeap, Extremum::kMinimum>},
      {{"maximum_hanger", "the object with the largest key, by a randomised hanger", 1, true, ""},
       make_extremum<MaximumHanger, Extremum::kMaximum>},
      {{"minimum_hanger", "the object with the smallest key, by a randomised hanger", 1, true, ""},
       make_extremum<MaximumHanger, Extremum::kMinimum>},
      {{"maximum_envelope", "the object with the largest key, by the upper envelope ahead", 1, true,
        ""},
       make_extremum<MaximumEnvelope, Extremum::kMaximum>},
      {{"minimum_envelope", "the object with the smallest key, by the lower envelope ahead", 1,
        true, ""},
       make_extremum<MaximumEnvelope, Extremum::kMinimum>},
      {{"maximum_dual_hull", "the object with the largest key, by the dual hull of linear motions",
        1, true, "", true},
       make_extremum<MaximumDualHull, Extremum::kMaximum>},
      {{"minimum_dual_hull", "the object with the smallest key, by the dual hull of linear motions",
        1, true, "", true},
       make_extremum<MaximumDualHull, Extremum::kMinimum>},
      {{"maximum_sorted_list", "the object with the largest key, read off a sorted list", 1, true,
        "sorted_list"},
       make_of_list<Extremum::kMaximum>},
      {{"minimum_sorted_list", "the object with the smallest key, read off a sorted list", 1, true,
        "sorted_list"},
       make_of_list<Extremum::kMinimum>},
      {{"delaunay_2", "the Delaunay triangulation of points in the plane", 2, false, ""},
       make_delaunay_2},
      {{"convex_hull_2", "the convex hull of points in the plane, by divide and conquer", 2, false,
        ""},
       make_convex_hull_2<ConvexHull2::Variant::kLocal>},
      {{"convex_hull_2_naive", "the same with certificates that are not local", 2, false, ""},
       make_convex_hull_2<ConvexHull2::Variant::kNaive>},
      {{"convex_hull_2_brute_force", "the convex hull, every point against every hull edge", 2,
        false, ""},
       make_convex_hull_2_brute_force},
      {{"convex_hull_2_delaunay", "the convex hull, read off the Delaunay triangulation", 2, false,
        "delaunay_2"},
       make_convex_hull_2_delaunay},
      {{"separation_mixed", "collisions of convex polygons, by the mixed hierarchy", 2, false, "",
        false, true, true},
       make_of_bodies<SeparationMixed>},
      {{"separation_minkowski",
        "collisions of convex polygons that do not turn, by the hierarchy of their Minkowski sum",
        2, false, "", false, true, true, true},
       make_of_bodies<SeparationMinkowski>},
      {{"separation_hysteresis", "collisions of convex polygons, by wedges that last", 2, false, "",
        false, true, true},
       make_of_bodies<SeparationHysteresis>},
      {{"closest_features", "collisions of convex polygons, by the closest features", 2, false, "",
        false, true, true},
       make_of_bodies<ClosestFeatures>},
      {{"inner_tangents", "collisions of convex polygons, by the inner common tangents", 2, false,
        "", false, true, true},
       make_of_bodies<InnerTangents>},
      {{"bounding_volumes", "collisions of convex polygons, by boxes, discs and closest features",
        2, false, "", false, true, true},
       make_of_bodies<BoundingVolumes>},
      {{"outer_hierarchy",
        "the hierarchies of the bodies' polygons under every policy of cuts, held to their bounds",
        2, false, "", false, true},
       make_of_bodies<OuterHierarchies>},
  };
  return kEntries;
}

const Entry* find_entry(std::string_view name) {
  for (const Entry& entry : entries()) {
    if (entry.info.name == name) return &entry;
  }
  return nullptr;
}

}  // namespace

Attribute::Shape StructureInfo::attribute_shape() const {
  if (name == "sorted_list" || name == "outer_hierarchy") return Attribute::Shape::kSequence;
  if (uses_key) return Attribute::Shape::kObject;
  if (bodies || name == "delaunay_2") return Attribute::Shape::kEdges;
  return Attribute::Shape::kCycle;
}

const std::vector<StructureInfo>& structure_infos() {
  static const std::vector<StructureInfo> kInfos = [] {
    std::vector<StructureInfo> infos;
    for (const Entry& entry : entries()) infos.push_back(entry.info);
    return infos;
  }();
  return kInfos;
}

const StructureInfo* find_structure_info(std::string_view name) {
  const Entry* entry = find_entry(name);
  return entry == nullptr ? nullptr : &entry->info;
}

std::unique_ptr<Structure> make_structure(const Request& request, const Scene& scene,
                                          Kernel& kernel, StructureId id,
                                          const Structure* watched) {
  const Entry* entry = find_entry(request.structure);
  if (entry == nullptr) {
    std::string names;
    for (const StructureInfo& info : structure_infos()) {
      names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
    throw std::invalid_argument("unknown structure \"" + request.structure + "\"; choose one of " +
                                names);
  }
  if (scene.has_bodies() != entry->info.bodies && !scene.objects.empty()) {
    throw std::invalid_argument(request.structure + (entry->info.bodies
                                                         ? " is for rigid bodies, not for points"
                                                         : " is for points, not for rigid bodies"));
  }
  if (scene.dimension < entry->info.min_dimension) {
    throw std::invalid_argument(request.structure + " needs a scene of dimension " +
                                std::to_string(entry->info.min_dimension) + " or more, not " +
                                std::to_string(scene.dimension));
  }
  if (!entry->info.any_dimension() && scene.dimension > entry->info.min_dimension) {
    throw std::invalid_argument(request.structure + " is for scenes of dimension " +
                                std::to_string(entry->info.min_dimension) + ", not " +
                                std::to_string(scene.dimension));
  }
  if (!entry->info.reads.empty() && (watched == nullptr || watched->name() != entry->info.reads)) {
    throw std::invalid_argument(request.structure + " has to watch a " +
                                std::string(entry->info.reads));
  }
  return entry->make(request, scene, kernel, id, watched);
}

}  // namespace kinex

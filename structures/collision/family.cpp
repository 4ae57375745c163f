// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/family.h"

#include <initializer_list>

#include "core/motion/turning.h"
#include "core/numbers/show_text.h"
#include "predicates/bodies/pose_2.h"
#include "structures/collision/bounding_volumes.h"
#include "structures/collision/closest_features.h"
#include "structures/collision/inner_tangents.h"
#include "structures/collision/outer_hierarchies.h"
#include "structures/collision/separation_hysteresis.h"
#include "structures/collision/separation_minkowski.h"
#include "structures/collision/separation_mixed.h"

namespace kinex {
namespace {

std::optional<Refusal> refuse_turning(const Scene& scene) {
  const auto pair = find_turning_pair(scene);
  if (!pair) return std::nullopt;
  const auto id_of = [&](ObjectId object) { return show_text(scene.objects[object].id); };
  return Refusal{"is for bodies that do not turn against each other, " + id_of(pair->first) +
                     " and " + id_of(pair->second) + " do",
                 "maintain separation_mixed, which takes every motion"};
}

// Those of every collision pair, then kinds of certificates that change nothing.
std::vector<KindRule> kinds(std::initializer_list<std::string_view> silent) {
  std::vector<KindRule> all{{"contact", Effect::kAlways},    {"graze", Effect::kAlways},
                            {"separation", Effect::kAlways}, {"inside", Effect::kNever},
                            {"volume", Effect::kNever},      {"grid", Effect::kNever},
                            {"overlap", Effect::kAlways}};
  for (const std::string_view kind : silent) all.push_back({kind, Effect::kNever});
  return all;
}

void derive_poses(const Scene& scene, NumberNeeds& needs) { needs.add(pose_2_kind(scene)); }

}  // namespace

StructureFamily collision_family() {
  StructureInfo base;
  base.group = "collision";
  base.min_dimension = 2;
  base.bodies = true;
  base.shape = Attribute::Shape::kTuples;
  base.derives = derive_poses;
  base.ties =
      "a touch without penetration is one graze and no contact (exact arithmetics); bodies that "
      "touch when they appear do not graze";
  base.source =
      "Erickson, Guibas, Stolfi, Zhang, Separation-sensitive collision detection for convex "
      "objects (1999)";

  std::vector<StructureInfo> structures;
  const auto add = [&](StructureInfo info, std::string_view name, std::string_view summary,
                       std::unique_ptr<Structure> (*make)(const MakerInput&)) {
    info.name = name;
    info.summary = summary;
    info.make = make;
    structures.push_back(info);
  };
  StructureInfo tiles = base;
  tiles.kinds = kinds({"side", "flip", "cell"});
  tiles.certificates =
      "at most 6 for a pair apart, the sides of its tile and two orders of normals; 5 for "
      "a pair in contact";
  add(tiles, "separation_mixed", "collisions of convex polygons, by the mixed hierarchy",
      make_plain<SeparationMixed>);
  StructureInfo unturned = tiles;
  unturned.refuse = refuse_turning;
  unturned.certificates =
      "at most 3 for a pair apart, the sides of its tile; 5 for a pair in contact";
  unturned.instead = "separation_mixed";
  add(unturned, "separation_minkowski",
      "collisions of convex polygons that do not turn, by the hierarchy of their Minkowski sum",
      make_plain<SeparationMinkowski>);
  StructureInfo wedges = base;
  wedges.certificates =
      "3 for a pair apart, a line and two tangents; 5 where the bodies are too near for "
      "wedges, and for a pair in contact";
  wedges.kinds = kinds({"change", "wedge"});
  add(wedges, "separation_hysteresis", "collisions of convex polygons, by wedges that last",
      make_plain<SeparationHysteresis>);
  StructureInfo features = base;
  features.kinds = kinds({"change"});
  features.certificates = "4 or 5 for a pair apart; 5 for a pair in contact";
  features.source = "Lin, Canny, A fast algorithm for incremental distance calculation (1991)";
  add(features, "closest_features", "collisions of convex polygons, by the closest features",
      make_plain<ClosestFeatures>);
  StructureInfo tangents = features;
  tangents.certificates =
      "8 for a pair apart, four for each inner tangent; 5 for a pair in contact";
  tangents.source = "the classic proof of separation by tangents";
  add(tangents, "inner_tangents", "collisions of convex polygons, by the inner common tangents",
      make_plain<InnerTangents>);
  features.certificates = "1 for a pair far apart, 6 for one that is near; 5 for a pair in contact";
  add(features, "bounding_volumes",
      "collisions of convex polygons, by boxes, discs and closest features",
      make_plain<BoundingVolumes>);
  StructureInfo hierarchies = base;
  hierarchies.group = {};
  hierarchies.has_events = false;
  hierarchies.derives = nullptr;
  hierarchies.certificates = "none, it follows no motion";
  hierarchies.ties = "none arise, a polygon is constant in its own frame";
  hierarchies.shape = Attribute::Shape::kSequence;
  add(hierarchies, "outer_hierarchy",
      "the hierarchies of the bodies' polygons under every policy of cuts, held to their bounds",
      make_plain<OuterHierarchies>);
  return {"collision", std::move(structures)};
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/family.h"

#include <array>
#include <span>

#include "core/motion/turning.h"
#include "core/numbers/show_text.h"
#include "predicates/bodies/pose_2.h"
#include "structures/collision/bounding_volumes.h"
#include "structures/collision/closest_features.h"
#include "structures/collision/collision_pairs.h"
#include "structures/collision/inner_tangents.h"
#include "structures/collision/outer_hierarchies.h"
#include "structures/collision/separation_hysteresis.h"
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

// The kinds of events of the proofs.
constexpr std::array<std::string_view, 3> kTileKinds{"side", "flip", "cell"};
constexpr std::array<std::string_view, 2> kWedgeKinds{"change", "wedge"};
constexpr std::array<std::string_view, 1> kFeatureKinds{"change"};

// Those of every collision pair, then kinds of certificates that change nothing.
std::vector<KindRule> kinds(std::initializer_list<KindRule> silent) {
  std::vector<KindRule> all{
      {"contact", Effect::kAlways, "two bodies touch and begin to overlap"},
      {"graze", Effect::kAlways, "two bodies touch without overlapping"},
      {"separation", Effect::kAlways, "two bodies cease to overlap"},
      {"inside", Effect::kNever, "the proof of an overlap goes to another edge"},
      {"volume", Effect::kNever, "a proof by enclosing volumes begins or ends"},
      {"grid", Effect::kNever, "a body enters another cell of the grid"},
      {"overlap", Effect::kAlways, "two bodies overlap without having come into contact"}};
  all.insert(all.end(), silent);
  return all;
}

// The features, or the vertices of tangents, that prove a pair to be apart.
constexpr KindRule kChange{kFeatureKinds[0], Effect::kNever,
                           "other features prove that bodies are apart"};

template <class Proof>
std::unique_ptr<SeparationProof> make_proof(PairTable& pairs) {
  return std::make_unique<Proof>(pairs);
}
std::unique_ptr<SeparationProof> make_proof_by_sums(PairTable& pairs) {
  return std::make_unique<SeparationMixed>(pairs, true);
}

std::unique_ptr<Structure> make_pairs(const MakerInput& input, const CollisionMethod& method) {
  return std::make_unique<CollisionPairs>(input.kernel, input.id, input.scene, method);
}
std::unique_ptr<Structure> make_mixed(const MakerInput& input) {
  return make_pairs(input, {"separation_mixed", kTileKinds, CutPolicy::kBalancedDudley,
                            make_proof<SeparationMixed>, true});
}
std::unique_ptr<Structure> make_minkowski(const MakerInput& input) {
  return make_pairs(input, {"separation_minkowski", kTileKinds, CutPolicy::kBalancedDudley,
                            make_proof_by_sums, true});
}
std::unique_ptr<Structure> make_hysteresis(const MakerInput& input) {
  return make_pairs(input, {"separation_hysteresis", kWedgeKinds, CutPolicy::kMedian,
                            make_proof<SeparationHysteresis>});
}
std::unique_ptr<Structure> make_features(const MakerInput& input) {
  return make_pairs(
      input, {"closest_features", kFeatureKinds, CutPolicy::kMedian, make_proof<ClosestFeatures>});
}
std::unique_ptr<Structure> make_tangents(const MakerInput& input) {
  return make_pairs(
      input, {"inner_tangents", kFeatureKinds, CutPolicy::kMedian, make_proof<InnerTangents>});
}
std::unique_ptr<Structure> make_volumes(const MakerInput& input) {
  return make_pairs(
      input, {"bounding_volumes", kFeatureKinds, CutPolicy::kMedian, make_proof<BoundingVolumes>});
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
  tiles.kinds = kinds(
      {{kTileKinds[0], Effect::kNever, "the proof goes to the tile beyond a side"},
       {kTileKinds[1], Effect::kNever, "an order of normals changes: two tiles are divided anew"},
       {kTileKinds[2], Effect::kNever, "the proof goes to another half-plane, or to a tile or back"}});
  tiles.certificates =
      "at most 6 for a pair apart, the sides of its tile and two orders of normals, 8 while it "
      "slides along the sum; 5 for a pair in contact";
  add(tiles, "separation_mixed", "collisions of convex polygons, by the mixed hierarchy",
      make_mixed);
  StructureInfo unturned = tiles;
  unturned.refuse = refuse_turning;
  unturned.certificates =
      "at most 3 for a pair apart, the sides of its tile, 5 while it slides along the sum; 5 for a "
      "pair in contact";
  unturned.instead = "separation_mixed";
  add(unturned, "separation_minkowski",
      "collisions of convex polygons that do not turn, by the hierarchy of their Minkowski sum",
      make_minkowski);
  StructureInfo wedges = base;
  wedges.certificates =
      "3 for a pair apart, a line and two tangents; 5 where the bodies are too near for "
      "wedges, and for a pair in contact";
  wedges.kinds =
      kinds({kChange, {kWedgeKinds[1], Effect::kNever, "another wedge proves that bodies are apart"}});
  add(wedges, "separation_hysteresis", "collisions of convex polygons, by wedges that last",
      make_hysteresis);
  StructureInfo features = base;
  features.kinds = kinds({kChange});
  features.certificates = "4 or 5 for a pair apart; 5 for a pair in contact";
  features.source = "Lin, Canny, A fast algorithm for incremental distance calculation (1991)";
  add(features, "closest_features", "collisions of convex polygons, by the closest features",
      make_features);
  StructureInfo tangents = features;
  tangents.certificates =
      "8 for a pair apart, four for each inner tangent; 5 for a pair in contact";
  tangents.source = "the classic proof of separation by tangents";
  add(tangents, "inner_tangents", "collisions of convex polygons, by the inner common tangents",
      make_tangents);
  features.certificates = "1 for a pair far apart, 6 for one that is near; 5 for a pair in contact";
  add(features, "bounding_volumes",
      "collisions of convex polygons, by boxes, discs and closest features", make_volumes);
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

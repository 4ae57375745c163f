// SPDX-License-Identifier: GPL-3.0-or-later
// The proofs of the structures for collisions, as data: a group for each pair of bodies that is
// followed, and for each body in the grid.
#include <algorithm>
#include <string>

#include "structures/collision/bounding_volumes.h"
#include "structures/collision/inner_tangents.h"
#include "structures/collision/separation_hysteresis.h"
#include "structures/collision/separation_minkowski.h"

namespace kinex {
namespace {

ProofMark line_mark(std::string_view name, ObjectId line, std::uint8_t body) {
  ProofMark mark;
  mark.shape = ProofMark::Shape::kLine;
  mark.name = name;
  mark.objects = {line};
  mark.body = body;
  return mark;
}

}  // namespace

void CollisionPairs::visit_proof(ProofVisitor& visitor) const {
  if (grid_) grid_->visit_proof(visitor);
  for (PairId p = 0; p < pairs_.size(); ++p) {
    const Pair& pair = pairs_[p];
    if (pair.a == kNoObject) continue;
    ProofGroup group;
    group.about = {pair.a, pair.b};
    const Roles roles = pair.touching ? describe_overlap(p, group)
                        : pair.apart  ? describe_volumes(p, group)
                                      : describe(p, group);
    visitor.group(group);
    for (std::size_t i = 0; i < pair.certificates; ++i) {
      visitor.certificate(pair.certificate[i], roles[i]);
    }
  }
}

PolygonFeature CollisionPairs::polygon_feature(PairId p, std::uint8_t z,
                                               const Feature& feature) const {
  const ObjectId body = z == 0 ? pairs_[p].a : pairs_[p].b;
  return {body, feature.edge, frames_.place(body, z == 1, feature.i)};
}

std::string CollisionPairs::feature_name(const PolygonFeature& feature) const {
  return scene_.objects[feature.body].id + (feature.edge ? ".e" : ".v") +
         std::to_string(feature.place);
}

CollisionPairs::Roles CollisionPairs::describe_overlap(PairId p, ProofGroup& group) const {
  const Pair& pair = pairs_[p];
  group.kind = "overlap";
  if (pair.certificates == 0) {
    group.text = "they overlap, without a proof";
    return {};
  }
  if (pair.certificates == 1) return describe_volumes(p, group);
  const SumBoundary::Edge& ahead = pair.ahead;
  const PolygonFeature edge = polygon_feature(p, ahead.z, {true, ahead.edge});
  const PolygonFeature vertex =
      polygon_feature(p, SumBoundary::other(ahead.z), {false, ahead.vertex});
  group.text = "they overlap; ahead is " + feature_name(edge) + " + " + feature_name(vertex);
  return {"within the edge ahead", "left of the ray to its first end",
          "right of the ray to its last end", "the edge belongs to the sum: after",
          "the edge belongs to the sum: before"};
}

CollisionPairs::Roles CollisionPairs::describe_volumes(PairId p, ProofGroup& group) const {
  const std::string_view says = volumes_.describe(kernel_.query(pairs_[p].certificate[0]));
  if (group.kind.empty()) group.kind = "volumes";
  group.text = says;
  Roles roles{};
  roles[0] = says;
  return roles;
}

CollisionPairs::Roles ClosestFeatures::describe(PairId p, ProofGroup& group) const {
  const State& state = state_[p];
  const Feature own{state.edge, state.e}, other{false, state.v};
  const bool swapped = state.edge && state.z == 1;
  ProofMark& join = group.marks.emplace_back();
  join.shape = ProofMark::Shape::kJoin;
  join.name = "closest features";
  join.features = {polygon_feature(p, 0, swapped ? other : own),
                   polygon_feature(p, 1, swapped ? own : other)};
  group.kind = "closest features";
  group.text = feature_name(join.features[0]) + " \u2013 " + feature_name(join.features[1]);
  Roles roles{};
  if (state.edge) {
    roles = {"past the edge's first end", "short of its last end",
             "after the edge before the vertex", "before the edge after the vertex",
             "outside the edge"};
  } else {
    roles = {"in the cone of the first vertex", "in the cone of the first vertex",
             "in the cone of the second vertex", "in the cone of the second vertex"};
  }
  roles[extra_slot(p)] = "discs about the bodies overlap";
  return roles;
}

CollisionPairs::Roles BoundingVolumes::describe(PairId p, ProofGroup& group) const {
  return near_[p] != 0 ? ClosestFeatures::describe(p, group) : describe_volumes(p, group);
}

CollisionPairs::Roles SeparationHysteresis::describe(PairId p, ProofGroup& group) const {
  const Wedge& wedge = wedges_[p];
  if (!wedge.in_use) return ClosestFeatures::describe(p, group);
  const std::uint8_t line_of = wedge.line_of == Frame::kA ? 0 : 1;
  const std::uint8_t other = SumBoundary::other(line_of);
  const std::array<ObjectId, 4>& ids = wedge.objects[wedge.turn];
  const bool turns = pair(p).certificates > 1;
  group.kind = turns ? "wedge" : "line";
  group.text = "a line of " + body_name(p, line_of) +
               (turns ? " and two tangents of " : " and a point beyond ") + body_name(p, other);
  group.marks.push_back(line_mark("line", ids[0], line_of));
  if (turns) {
    group.marks.push_back(line_mark("tangent", ids[1], other));
    group.marks.push_back(line_mark("tangent", ids[2], other));
  }
  return {"the tangents' common point is beyond the line", "the first tangent's normal",
          "the second tangent's normal"};
}

CollisionPairs::Roles InnerTangents::describe(PairId p, ProofGroup& group) const {
  static constexpr std::array<std::string_view, 8> kRoles{
      "first tangent, at the first body: edge after",
      "first tangent, at the first body: edge before",
      "first tangent, at the second body: edge after",
      "first tangent, at the second body: edge before",
      "second tangent, at the first body: edge after",
      "second tangent, at the first body: edge before",
      "second tangent, at the second body: edge after",
      "second tangent, at the second body: edge before"};
  group.kind = "inner tangents";
  for (const Touch& touch : tangents_[p]) {
    ProofMark& mark = group.marks.emplace_back();
    mark.shape = ProofMark::Shape::kThrough;
    mark.name = "inner tangent";
    mark.features = {polygon_feature(p, 0, {false, touch[0]}),
                     polygon_feature(p, 1, {false, touch[1]})};
    group.text += (group.text.empty() ? "" : "; ") + feature_name(mark.features[0]) + " \u2013 " +
                  feature_name(mark.features[1]);
  }
  return kRoles;
}

CollisionPairs::Roles SeparationMixed::describe(PairId p, ProofGroup& group) const {
  const PosePredicates& known = predicates_;
  group.kind = "tile";
  group.text = tile_text(p, tile_[p]);
  Roles roles{};
  for (std::uint32_t i = 0; i < pair(p).certificates; ++i) {
    const PredicateId predicate = kernel_.query(pair(p).certificate[i]).predicate;
    const auto is = [=](const std::array<PredicateId, 2>& ids) {
      return ids[0] == predicate || ids[1] == predicate;
    };
    roles[i] = is(known.side) || is(known.inside) || is(known.touch) || is(known.touch_inside)
                   ? "side of the tile"
               : is(known.along_touch) || is(known.against_touch) ? "end of the side of the sum"
                                                                  : "order of two normals";
  }
  return roles;
}

std::string SeparationMixed::tile_text(PairId p, const Tile& tile) const {
  const std::string& own = body_name(p, tile.x);
  const std::string& other = body_name(p, SumBoundary::other(tile.x));
  const std::string v = std::to_string(tile.v), w = std::to_string(tile.other);
  switch (tile.kind) {
    case Tile::Kind::kTriangle:
      return "triangle: node " + v + " of " + own + " is cut, at node " + w + " of " + other;
    case Tile::Kind::kHalf:
      return "half-plane: beyond edge " + v + " of " + own + "'s box, at corner " + w + " of " +
             other + "'s";
    default:
      return "parallelogram: edge " + w + " of " + other + " along the " +
             (tile.kind == Tile::Kind::kLeft ? "left" : "right") + " side of node " + v + " of " +
             own;
  }
}

CollisionPairs::Roles SeparationMinkowski::describe(PairId p, ProofGroup& group) const {
  group.of_sum = true;
  return SeparationMixed::describe(p, group);
}

std::string SeparationMinkowski::tile_text(PairId, const Tile& tile) const {
  const std::string v = std::to_string(tile.v);
  return tile.kind == Tile::Kind::kHalf ? "half-plane beyond edge " + v + " of the sum's box"
                                        : "triangle of node " + v + " of the sum";
}

}  // namespace kinex

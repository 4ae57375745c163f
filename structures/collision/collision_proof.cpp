// SPDX-License-Identifier: GPL-3.0-or-later
// The proofs of the structures for collisions, as data: a group for each pair of bodies that is
// followed, and for each body in the grid.
#include <algorithm>
#include <string>

#include "structures/collision/collision_pairs.h"
#include "structures/collision/inner_tangents.h"
#include "structures/collision/separation_hysteresis.h"
#include "structures/collision/separation_mixed.h"

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
    const BodyPair& pair = pairs_[p];
    if (!pair.in_use()) continue;
    ProofGroup group;
    group.about = {pair.a, pair.b};
    const PairTable::Roles roles = pair.in_contact() ? describe_overlap(p, group)
                                   : pair.is_apart() ? proof_->describe(p, group)
                                                     : pairs_.describe_volumes(p, group);
    visitor.group(group);
    for (std::size_t i = 0; i < pair.certificates; ++i) {
      visitor.certificate(pair.slots[i], roles[i]);
    }
  }
}

PairTable::Roles CollisionPairs::describe_overlap(PairId p, ProofGroup& group) const {
  group.kind = "overlap";
  if (pairs_[p].state == State::kUnproved) {
    group.text = "they overlap, without a proof";
    return {};
  }
  if (pairs_[p].state == State::kInner) return pairs_.describe_volumes(p, group);
  const SumBoundary::Edge& ahead = pairs_[p].ahead;
  const PolygonFeature edge = pairs_.feature(p, ahead.z, {true, ahead.edge});
  const PolygonFeature vertex =
      pairs_.feature(p, SumBoundary::other(ahead.z), {false, ahead.vertex});
  group.text =
      "they overlap; ahead is " + pairs_.feature_name(edge) + " + " + pairs_.feature_name(vertex);
  return {"within the edge ahead", "left of the ray to its first end",
          "right of the ray to its last end", "the edge belongs to the sum: after",
          "the edge belongs to the sum: before"};
}

PairTable::Roles ClosestFeatures::describe(PairId p, ProofGroup& group) const {
  const State& state = state_[p];
  const Features closest =
      state.edge ? state.as_edge().features() : Features{{false, state.e}, {false, state.v}};
  ProofMark& join = group.marks.emplace_back();
  join.shape = ProofMark::Shape::kJoin;
  join.name = "closest features";
  join.features = {pairs_.feature(p, 0, closest.of_a), pairs_.feature(p, 1, closest.of_b)};
  group.kind = "closest features";
  group.text =
      pairs_.feature_name(join.features[0]) + " \u2013 " + pairs_.feature_name(join.features[1]);
  Roles roles{};
  if (state.edge) {
    roles = {"past the edge's first end", "short of its last end",
             "after the edge before the vertex", "before the edge after the vertex",
             "outside the edge"};
  } else {
    roles = {"in the cone of the first vertex", "in the cone of the first vertex",
             "in the cone of the second vertex", "in the cone of the second vertex"};
  }
  roles[state.edge ? 5 : 4] = "discs about the bodies overlap";
  return roles;
}

PairTable::Roles SeparationHysteresis::describe(PairId p, ProofGroup& group) const {
  if (!has_wedge(p)) return near_.describe(p, group);
  const std::uint8_t line_of = wedges_[p].line_is_of_b() ? 1 : 0;
  const std::uint8_t other = SumBoundary::other(line_of);
  const std::array<ObjectId, 4>& ids = wedges_[p].objects();
  const bool turns = pairs_[p].certificates > 1;
  group.kind = turns ? "wedge" : "line";
  group.text = "a line of " + pairs_.name(p, line_of) +
               (turns ? " and two tangents of " : " and a point beyond ") + pairs_.name(p, other);
  group.marks.push_back(line_mark("line", ids[0], line_of));
  if (turns) {
    group.marks.push_back(line_mark("tangent", ids[1], other));
    group.marks.push_back(line_mark("tangent", ids[2], other));
  }
  return {"the tangents' common point is beyond the line", "the first tangent's normal",
          "the second tangent's normal"};
}

PairTable::Roles InnerTangents::describe(PairId p, ProofGroup& group) const {
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
    mark.features = {pairs_.feature(p, 0, {false, touch[0]}),
                     pairs_.feature(p, 1, {false, touch[1]})};
    group.text += (group.text.empty() ? "" : "; ") + pairs_.feature_name(mark.features[0]) +
                  " \u2013 " + pairs_.feature_name(mark.features[1]);
  }
  return kRoles;
}

PairTable::Roles SeparationMixed::describe(PairId p, ProofGroup& group) const {
  const PosePredicates& predicates = pairs_.predicates();
  group.kind = "tile";
  group.text = tile_text(p, tile_[p]);
  group.of_sum = sums_.has_value();
  Roles roles{};
  for (std::uint32_t i = 0; i < pairs_[p].certificates; ++i) {
    const Query query = pairs_.kernel().query(pairs_[p].slots[i]);
    roles[i] = predicates.is_about_side(query)  ? "side of the tile"
               : predicates.is_about_end(query) ? "end of the side of the sum"
                                                : "order of two normals";
  }
  return roles;
}

std::string SeparationMixed::tile_text(PairId p, const Tile& tile) const {
  const std::string& own = pairs_.name(p, tile.x);
  const std::string& other = pairs_.name(p, SumBoundary::other(tile.x));
  const std::string v = std::to_string(tile.v), w = std::to_string(tile.other);
  const bool half = tile.kind == Tile::Kind::kHalf;
  if (sums_) {
    return half ? "half-plane beyond edge " + v + " of the sum's box"
                : "triangle of node " + v + " of the sum";
  }
  if (half) {
    return "half-plane: beyond edge " + v + " of " + own + "'s box, at corner " + w + " of " +
           other + "'s";
  }
  if (tile.kind == Tile::Kind::kTriangle) {
    return "triangle: node " + v + " of " + own + " is cut, at node " + w + " of " + other;
  }
  return "parallelogram: edge " + w + " of " + other + " along the " +
         (tile.kind == Tile::Kind::kLeft ? "left" : "right") + " side of node " + v + " of " + own;
}

}  // namespace kinex

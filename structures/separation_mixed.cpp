// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/separation_mixed.h"

#include <algorithm>
#include <utility>

namespace kinex {

SeparationMixed::SeparationMixed(Kernel& kernel, StructureId id, const Scene& scene,
                                 CutPolicy policy)
    : CollisionPairs(kernel, id, scene, policy), predicates_(kernel) {}

std::vector<std::string_view> SeparationMixed::event_kinds() const {
  return collision_kinds({"side", "flip", "cell"});
}

std::array<BodyFrame*, 2> SeparationMixed::frames_of(PairId p) {
  return {&frames_.frame(pair(p).a, false), &frames_.frame(pair(p).b, true)};
}

MixedTiles SeparationMixed::tiles(PairId p) {
  return MixedTiles(kernel_, predicates_, pair(p).pose, frames_of(p));
}

void SeparationMixed::enter(PairId p, const MixedTiles& about, const Tile& tile) {
  tile_[p] = tile;
  const MixedTiles::Certificates proof = about.certificates(tile);
  if (now_ == nullptr) {
    set_certificates(p, {proof.query.data(), proof.count});
    return;
  }
  std::array<Query, kMostCertificates> queries;
  const auto end = std::copy_n(proof.query.begin(), proof.count, queries.begin());
  const MixedTiles::Certificates slide = about.slide(tile);
  slides_ = slides_ || slide.count > 0;
  std::copy_n(slide.query.begin(), slide.count, end);
  set_certificates(p, {queries.data(), proof.count + slide.count});
}

// It may begin to slide, or end.
void SeparationMixed::moved(PairId p) {
  if (now_ == nullptr) return;
  const MixedTiles about = tiles(p);
  const std::uint32_t count = about.certificates(tile_[p]).count + about.slide(tile_[p]).count;
  if (count != pair(p).certificates) enter(p, about, tile_[p]);
}

bool SeparationMixed::start(PairId p) {
  if (tile_.size() <= p) tile_.resize(p + std::size_t{1});
  const MixedTiles about = tiles(p);
  const std::optional<Tile> found = about.locate();
  if (!found) return false;
  enter(p, about, *found);
  return true;
}

void SeparationMixed::fail(PairId p, std::uint32_t slot) {
  const MixedTiles about = tiles(p);
  const Tile from = tile_[p];
  const MixedTiles::Certificates proof = about.certificates(from);
  if (slot >= proof.count) {  // it comes to a side of M, or leaves it, along the side's line
    enter(p, about, from);
    report(p, kSide);
    return;
  }
  const bool is_side = slot < proof.sides;
  const std::optional<MixedTiles::Move> move = about.next(from, slot);
  if (!move) {
    report_rebuild("a tile has folded up");
    if (const auto found = about.locate()) enter(p, about, *found);
    return;
  }
  if (!move->tile) {
    contact(p, features(p, *move));
    return;
  }
  const bool half = from.kind == Tile::Kind::kHalf || move->tile->kind == Tile::Kind::kHalf;
  enter(p, about, *move->tile);
  report(p, half ? kCell : is_side ? kSide : kFlip);
}

std::optional<CollisionPairs::Features> SeparationMixed::touch(PairId p, SignNow* now) {
  const auto move = tiles(p).touch(tile_[p], now);
  if (!move) return std::nullopt;
  return features(p, *move);
}

CollisionPairs::Features SeparationMixed::features(PairId p, const MixedTiles::Move& move) {
  const std::array<BodyFrame*, 2> frames = frames_of(p);
  const OuterHierarchy& own = frames[move.x]->hierarchy();
  const OuterHierarchy& other = frames[1 - move.x]->hierarchy();
  const auto vertex_at = [](const OuterHierarchy& tree, std::uint32_t leaf) {
    return Feature{false,
                   tree.node(leaf).begin % static_cast<std::uint32_t>(tree.polygon().size())};
  };
  const OuterHierarchy::Edge& edge = own.edge(move.edge);
  // A line that only touches the polygon touches it at a vertex.
  std::uint32_t end = edge.first;
  while (own.node(end).right != OuterHierarchy::kNone) end = own.node(end).right;
  const Feature line = edge.polygon_edge == OuterHierarchy::kNone
                           ? vertex_at(own, end)
                           : Feature{true, edge.polygon_edge};
  const Feature vertex = vertex_at(other, move.node);
  return move.x == 0 ? Features{line, vertex} : Features{vertex, line};
}

std::optional<Tile> SeparationMixed::tile(ObjectId a, ObjectId b) const {
  for (PairId p = 0; p < pairs(); ++p) {
    if (pair(p).a == a && pair(p).b == b && !pair(p).touching) return tile_[p];
  }
  return std::nullopt;
}

void SeparationMixed::add_hierarchies(HierarchyBounds& bounds) const {
  frames_.each_hierarchy([&](const OuterHierarchy& tree) { bounds.add(tree); });
}

std::vector<BoundCheck> SeparationMixed::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks = CollisionPairs::bounds(context);
  HierarchyBounds hierarchies(frames_.policy());
  add_hierarchies(hierarchies);
  for (BoundCheck& check : hierarchies.checks(std::string(name()) + ".hierarchy")) {
    checks.push_back(std::move(check));
  }
  return checks;
}

std::size_t SeparationMixed::bytes() const {
  return CollisionPairs::bytes() + tile_.capacity() * sizeof(Tile);
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/separation_mixed.h"

#include <utility>

namespace kinex {

SeparationMixed::SeparationMixed(Kernel& kernel, StructureId id, const Scene& scene,
                                 CutPolicy policy)
    : CollisionPairs(kernel, id, scene, policy), predicates_(kernel) {}

std::vector<std::string_view> SeparationMixed::event_kinds() const {
  return common_event_kinds({"contact", "side", "flip", "cell"});
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
  set_certificates(p, {proof.query.data(), proof.count});
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
  const bool is_side = slot < about.certificates(from).sides;
  const std::optional<MixedTiles::Move> move = about.next(from, slot);
  if (!move) {
    report_rebuild("a tile has folded up");
    if (const auto found = about.locate()) enter(p, about, *found);
    return;
  }
  if (!move->tile) {
    const std::array<BodyFrame*, 2> frames = frames_of(p);
    const OuterHierarchy& own = frames[move->x]->hierarchy();
    const OuterHierarchy& other = frames[1 - move->x]->hierarchy();
    const OuterHierarchy::Edge& edge = own.edge(move->edge);
    const OuterHierarchy::Node& leaf = other.node(move->node);
    Feature line, vertex;
    line.edge = edge.polygon_edge != OuterHierarchy::kNone;
    if (line.edge) {
      line.i = edge.polygon_edge;
    } else {
      line.i = own.node(edge.first).begin % static_cast<std::uint32_t>(own.polygon().size());
    }
    vertex.i = leaf.begin % static_cast<std::uint32_t>(other.polygon().size());
    contact(p, move->x == 0 ? line : vertex, move->x == 0 ? vertex : line);
    return;
  }
  const bool half = from.kind == Tile::Kind::kHalf || move->tile->kind == Tile::Kind::kHalf;
  enter(p, about, *move->tile);
  report(p, half ? kCell : is_side ? kSide : kFlip);
}

std::optional<Tile> SeparationMixed::tile(ObjectId a, ObjectId b) const {
  for (PairId p = 0; p < pairs(); ++p) {
    if (pair(p).a == a && pair(p).b == b && !pair(p).touching) return tile_[p];
  }
  return std::nullopt;
}

std::size_t SeparationMixed::bytes() const {
  return CollisionPairs::bytes() + tile_.capacity() * sizeof(Tile);
}

}  // namespace kinex

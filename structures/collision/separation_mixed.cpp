// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/separation_mixed.h"

#include <algorithm>
#include <utility>

namespace kinex {

SeparationMixed::SeparationMixed(Kernel& kernel, StructureId id, const Scene& scene,
                                 CutPolicy policy)
    : CollisionPairs(kernel, id, scene, policy) {}

std::vector<std::string_view> SeparationMixed::event_kinds() const {
  return collision_kinds({"side", "flip", "cell"});
}

std::array<BodyFrame*, 2> SeparationMixed::frames_of(PairId p) {
  return {&frames_.frame(pair(p).a, false), &frames_.frame(pair(p).b, true)};
}

MixedTiles SeparationMixed::tiles(PairId p) {
  return MixedTiles(kernel_, predicates_, pair(p).pose, frames_of(p));
}

std::uint32_t SeparationMixed::prove(const MixedTiles& about, const Tile& tile, Proof& queries) {
  const MixedTiles::Certificates proof = about.certificates(tile);
  std::copy_n(proof.query.begin(), proof.count, queries.begin());
  if (!kernel_.tells_sign_now()) return proof.count;
  const MixedTiles::Certificates slide = about.slide(tile);
  if (slide.count == 0) return proof.count;
  slides_ = true;
  for (std::uint32_t i = proof.sides; i < proof.count; ++i) {
    queries[i] = about.order_at_touch(queries[i]);
  }
  std::copy_n(slide.query.begin(), slide.count, queries.begin() + proof.count);
  return proof.count + slide.count;
}

void SeparationMixed::enter(PairId p, const MixedTiles& about, const Tile& tile) {
  tile_[p] = tile;
  Proof queries;
  const std::uint32_t count = prove(about, tile, queries);
  set_certificates(p, {queries.data(), count});
}

// The point may begin to slide, stop, or slide along a side of M that is longer now.
void SeparationMixed::moved(PairId p) {
  if (!kernel_.tells_sign_now()) return;
  Proof queries;
  const std::uint32_t count = prove(tiles(p), tile_[p], queries);
  bool same = count == pair(p).certificates;
  for (std::uint32_t i = 0; same && i < count; ++i) {
    same = kernel_.claims(pair(p).certificate[i], queries[i]);
  }
  if (!same) set_certificates(p, {queries.data(), count});
}

bool SeparationMixed::start(PairId p) {
  if (tile_.size() <= p) tile_.resize(p + std::size_t{1});
  const MixedTiles about = tiles(p);
  const std::optional<Tile> found = about.locate();
  if (!found) return false;
  enter(p, about, *found);
  return true;
}

bool SeparationMixed::leave(PairId p, const SumBoundary::Edge& edge) {
  const MixedTiles about = tiles(p);
  const std::optional<Tile> found = about.leave(edge.z, edge.edge, edge.vertex);
  if (!found) return false;
  enter(p, about, *found);
  return true;
}

std::uint64_t SeparationMixed::signs_asked() const {
  std::uint64_t sum = 0;
  const auto add = [&](PredicateId id) { sum += kernel_.signs_asked(id); };
  for (const auto& ids :
       {predicates_.side, predicates_.inside, predicates_.along, predicates_.touch,
        predicates_.touch_inside, predicates_.along_touch, predicates_.against_touch}) {
    for (const PredicateId id : ids) add(id);
  }
  add(predicates_.normal_order);
  add(predicates_.normal_order_reversed);
  add(predicates_.order_touch);
  add(predicates_.order_touch_reversed);
  return sum;
}

void SeparationMixed::certificate_failed(CertificateId failed) {
  level_.reset();
  touches_ = false;
  const std::uint64_t before = signs_asked();
  CollisionPairs::certificate_failed(failed);
  if (!level_) return;
  const std::uint64_t asked = signs_asked() - before;
  const std::uint64_t bound = kSignsPerLevel * static_cast<std::uint64_t>(*level_ + 1) + kSigns +
                              (touches_ ? kSignsOfTouch : 0);
  if (most_signs_ > signs_bound_ || (asked <= bound && asked * signs_bound_ <= most_signs_ * bound))
    return;
  most_signs_ = asked;
  signs_bound_ = bound;
}

void SeparationMixed::fail(PairId p, std::uint32_t slot) {
  const MixedTiles about = tiles(p);
  const Tile from = tile_[p];
  level_ = about.level(from);
  const MixedTiles::Certificates proof = about.certificates(from);
  if (slot >= proof.count) {  // the point reaches a side of M, or leaves it, along the side's line
    enter(p, about, from);
    report(p, kSide);
    return;
  }
  const bool is_side = slot < proof.sides;
  const std::optional<MixedTiles::Move> move = about.next(from, slot);
  if (!move || move->searched) level_.reset();
  if (!move) {
    report_rebuild("a tile has folded up");
    if (const auto found = about.locate()) enter(p, about, *found);
    return;
  }
  if (!move->tile) {
    if (level_) level_ = about.levels();
    touches_ = true;
    contact(p, features(p, *move));
    return;
  }
  if (level_) level_ = std::max(*level_, about.level(*move->tile));
  const bool half = from.kind == Tile::Kind::kHalf || move->tile->kind == Tile::Kind::kHalf;
  enter(p, about, *move->tile);
  report(p, half ? kCell : is_side ? kSide : kFlip);
}

std::optional<CollisionPairs::Features> SeparationMixed::touch(PairId p, When when) {
  const auto move = tiles(p).touch(tile_[p], when);
  touches_ = touches_ || move || pair(p).resting;
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
  // A line that touches the polygon only at a vertex.
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
  checks.push_back(at_most(std::string(name()) + ".signs",
                           "signs of one failure: 2 for each level of the tile left or entered, "
                           "and a constant",
                           Integer(static_cast<std::int64_t>(signs_bound_)),
                           Integer(static_cast<std::int64_t>(most_signs_))));
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

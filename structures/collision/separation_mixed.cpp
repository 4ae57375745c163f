// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/separation_mixed.h"

#include <algorithm>
#include <utility>

namespace kinex {

SeparationMixed::SeparationMixed(PairTable& pairs, bool of_sums)
    : pairs_(pairs), slots_(pairs.kernel(), pairs.id(), "tiles") {
  if (of_sums) sums_.emplace(pairs);
}

std::array<BodyFrame*, 2> SeparationMixed::frames_of(PairId p) {
  if (sums_) return sums_->frames(p);
  return {&pairs_.frames().frame(pairs_[p].a, false), &pairs_.frames().frame(pairs_[p].b, true)};
}

MixedTiles SeparationMixed::tiles(PairId p) {
  return MixedTiles(pairs_.kernel(), pairs_.predicates(), pairs_[p].pose, frames_of(p));
}

// While the point slides along a side of M, orders of normals fail at touches too: at an instant at
// which the normals are parallel the side is longer, and may reach the point on its line.
std::uint32_t SeparationMixed::prove(const MixedTiles& about, const Tile& tile, Proof& queries) {
  const MixedTiles::Certificates proof = about.certificates(tile);
  std::copy_n(proof.query.begin(), proof.count, queries.begin());
  if (!pairs_.kernel().tells_sign_now()) return proof.count;
  const MixedTiles::Certificates slide = about.slide(tile);
  if (slide.count == 0) return proof.count;
  slides_ = true;
  for (std::uint32_t i = proof.sides; i < proof.count; ++i) {
    queries[i] = pairs_.predicates().at_touch(queries[i]);
  }
  std::copy_n(slide.query.begin(), slide.count, queries.begin() + proof.count);
  return proof.count + slide.count;
}

void SeparationMixed::enter(PairId p, const MixedTiles& about, const Tile& tile) {
  tile_[p] = tile;
  Proof queries;
  const std::uint32_t count = prove(about, tile, queries);
  pairs_.set(p, slots_, {queries.data(), count});
}

// The point may begin to slide, stop, or slide along a side of M that is longer now.
void SeparationMixed::moved(PairId p) {
  if (pairs_.kernel().tells_sign_now()) enter(p, tiles(p), tile_[p]);
}

bool SeparationMixed::start(PairId p, const Edge* left) {
  if (tile_.size() <= p) tile_.resize(p + std::size_t{1});
  if (sums_) sums_->make(p);
  const MixedTiles about = tiles(p);
  const std::optional<Tile> found =
      left && !sums_ ? about.leave(left->z, left->edge, left->vertex) : about.locate();
  if (found) enter(p, about, *found);
  return found.has_value();
}

void SeparationMixed::handled(std::uint64_t signs) {
  if (!level_) return;
  signs_.note(kSignsPerLevel * (*level_ + 1) + kSigns + (touches_ ? kSignsOfTouch : 0),
              static_cast<std::int64_t>(signs));
  level_.reset();
}

SeparationProof::Repair SeparationMixed::repair(PairId p, std::uint32_t slot) {
  if (sums_) sums_->failed(p);
  touches_ = false;
  const MixedTiles about = tiles(p);
  const Tile from = tile_[p];
  level_ = about.level(from);
  const MixedTiles::Certificates proof = about.certificates(from);
  if (slot >= proof.count) {  // the point reaches a side of M, or leaves it, along the side's line
    enter(p, about, from);
    return Repair::changed(kSide);
  }
  const std::optional<MixedTiles::Move> move = about.next(from, slot);
  if (!move || move->searched) level_.reset();
  if (!move) {
    pairs_.kernel().count_rebuild(pairs_.id(), "a tile has folded up");
    const std::optional<Tile> found = about.locate();
    if (!found) return Repair::met({});
    enter(p, about, *found);
    return {};
  }
  if (!move->tile) {
    if (level_) level_ = about.levels();
    touches_ = true;
    return Repair::met(features(p, *move));
  }
  if (level_) level_ = std::max(*level_, about.level(*move->tile));
  const bool half = from.kind == Tile::Kind::kHalf || move->tile->kind == Tile::Kind::kHalf;
  enter(p, about, *move->tile);
  return Repair::changed(half ? kCell : slot < proof.sides ? kSide : kFlip);
}

std::optional<Features> SeparationMixed::touch(PairId p, When when) {
  const auto move = tiles(p).touch(tile_[p], when);
  touches_ = touches_ || move || pairs_[p].state == BodyPair::State::kResting;
  if (!move) return std::nullopt;
  return features(p, *move);
}

Features SeparationMixed::features(PairId p, const MixedTiles::Move& move) {
  if (sums_) return sums_->features(p, move.edge);
  const std::array<BodyFrame*, 2> frames = frames_of(p);
  const OuterHierarchy& own = frames[move.x]->hierarchy();
  const std::uint32_t edge = own.edge(move.edge).polygon_edge;
  // A line without an edge touches the polygon only at a vertex.
  const Feature line = edge == OuterHierarchy::kNone
                           ? Feature{false, own.vertex_of(own.first_leaf(move.edge))}
                           : Feature{true, edge};
  const Feature vertex{false, frames[1 - move.x]->hierarchy().vertex_of(move.node)};
  return move.x == 0 ? Features{line, vertex} : Features{vertex, line};
}

std::optional<Tile> SeparationMixed::tile(ObjectId a, ObjectId b) const {
  const PairId p = pairs_.find(a, b);
  if (p == kNoPair || !pairs_[p].is_apart()) return std::nullopt;
  return tile_[p];
}

void SeparationMixed::add_bounds(const BoundContext& context,
                                 std::vector<BoundCheck>& checks) const {
  checks.push_back(at_most(name() + ".signs",
                           "signs of one failure: 2 for each level of the tile left or entered, "
                           "and a constant",
                           Integer(signs_.bound), Integer(signs_.observed)));
  HierarchyBounds hierarchies(pairs_.frames().policy());
  if (sums_) hierarchies = sums_->hierarchies();
  pairs_.frames().each_hierarchy([&](const OuterHierarchy& tree) { hierarchies.add(tree); });
  for (BoundCheck& check : hierarchies.checks(name() + ".hierarchy")) {
    checks.push_back(std::move(check));
  }
  if (sums_) sums_->add_bounds(context, checks);
}

std::size_t SeparationMixed::bytes() const {
  return tile_.capacity() * sizeof(Tile) + (sums_ ? sums_->bytes() : 0);
}

}  // namespace kinex

// SPDX-License-Identifier: GPL-3.0-or-later
// The names of a tile and its certificates. Moves are in mixed_tiles_moves.cpp.
#include "structures/mixed_tiles.h"

#include "predicates/pose_2.h"

namespace kinex {

PosePredicates::PosePredicates(Kernel& kernel)
    : side{kernel.bind(make_pose_side(Frame::kA, false)),
           kernel.bind(make_pose_side(Frame::kB, false))},
      inside{kernel.bind(make_pose_side(Frame::kA, true)),
             kernel.bind(make_pose_side(Frame::kB, true))},
      along{kernel.bind(make_pose_along(Frame::kA)), kernel.bind(make_pose_along(Frame::kB))},
      touch{kernel.bind(make_pose_touch(Frame::kA)), kernel.bind(make_pose_touch(Frame::kB))},
      normal_order(kernel.bind(make_pose_normal_order(false))),
      normal_order_reversed(kernel.bind(make_pose_normal_order(true))) {}

MixedTiles::MixedTiles(Kernel& kernel, const PosePredicates& predicates, ObjectId pose,
                       std::array<BodyFrame*, 2> frames)
    : kernel_(kernel), predicates_(predicates), pose_(pose), frames_(frames) {
  const Trajectory& motion = kernel.derived().trajectory(pose);
  turns_ = motion.coordinates[5].size() > 1 || motion.coordinates[6].size() > 1;
  if (tree(0).is_point() || tree(1).is_point()) return;
  // The error at equal levels is a quarter per two levels of the radius: the smaller polygon waits.
  const std::uint8_t small = tree(1).radius() < tree(0).radius() ? 1 : 0;
  Rational reach = Rational(2) * tree(small).radius();
  for (int& offset = offset_[small]; reach <= tree(other(small)).radius(); offset += 2) {
    reach *= Rational(4);
  }
}

int MixedTiles::cut_time(std::uint8_t z, Id node) const {
  const int level = tree(z).node(node).cut_level;
  return level == kNever ? kNever : 2 * (level + offset_[z]) + z;
}

int MixedTiles::birth_of_edge(std::uint8_t z, Id edge) const {
  const int level = tree(z).edge(edge).level;
  return level < 0 ? -1 : 2 * (level + offset_[z]) + z;
}

int MixedTiles::birth_of_node(std::uint8_t z, Id node) const {
  const Id parent = tree(z).node(node).parent;
  return parent == OuterHierarchy::kNone ? -1 : cut_time(z, parent);
}

MixedTiles::Id MixedTiles::first_end(std::uint8_t z, Id edge, int time) const {
  Id node = tree(z).edge(edge).first;
  while (cut_time(z, node) < time) node = tree(z).node(node).right;
  return node;
}

MixedTiles::Id MixedTiles::last_end(std::uint8_t z, Id edge, int time) const {
  Id node = tree(z).edge(edge).last;
  while (cut_time(z, node) < time) node = tree(z).node(node).left;
  return node;
}

bool MixedTiles::has_length(std::uint8_t z, Id edge, int time) const {
  return tree(z).node(first_end(z, edge, time)).point !=
         tree(z).node(last_end(z, edge, time)).point;
}

MixedTiles::Id MixedTiles::edge_before(std::uint8_t z, Id node, int time) const {
  if (tree(z).is_point()) return OuterHierarchy::kNone;
  Id edge = tree(z).node(node).left_edge;
  while (!has_length(z, edge, time)) edge = tree(z).node(first_end(z, edge, time)).left_edge;
  return edge;
}

MixedTiles::Id MixedTiles::edge_after(std::uint8_t z, Id node, int time) const {
  if (tree(z).is_point()) return OuterHierarchy::kNone;
  Id edge = tree(z).node(node).right_edge;
  while (!has_length(z, edge, time)) edge = tree(z).node(last_end(z, edge, time)).right_edge;
  return edge;
}

MixedTiles::Id MixedTiles::facing(std::uint8_t w, Id node, std::uint8_t z, Id e, int time) const {
  if (tree(w).is_point()) return node;
  for (;;) {
    const Id edge = tree(w).node(node).left_edge;
    if (has_length(w, edge, time) || !before(z, e, edge)) break;
    node = first_end(w, edge, time);
  }
  for (;;) {
    const Id edge = tree(w).node(node).right_edge;
    if (has_length(w, edge, time) || before(z, e, edge)) break;
    node = last_end(w, edge, time);
  }
  return node;
}

// ---- signs

Query MixedTiles::order(std::uint8_t z, Id e, Id f) const {
  const ObjectId own = frames_[z]->line(e), foreign = frames_[other(z)]->line(f);
  if (z == 0) return Query(predicates_.normal_order_reversed, {pose_, own, foreign});
  return Query(predicates_.normal_order, {pose_, foreign, own});
}

Query MixedTiles::order_after(std::uint8_t z, Id e, Id f) const {
  const ObjectId own = frames_[z]->line(e), foreign = frames_[other(z)]->line(f);
  if (z == 0) return Query(predicates_.normal_order, {pose_, own, foreign});
  return Query(predicates_.normal_order_reversed, {pose_, foreign, own});
}

bool MixedTiles::before(std::uint8_t z, Id e, Id f) const {
  const Query query = order(z, e, f);
  const Sign sign = kernel_.arithmetic().sign_after(query);
  // Parallel for ever: A's normal comes first.
  return sign == Sign::kPositive || (sign == Sign::kZero && z == 0);
}

Query MixedTiles::side(std::uint8_t z, Id edge, Id node, bool inward) const {
  const PredicateId predicate = inward ? predicates_.inside[z] : predicates_.side[z];
  return Query(predicate, {pose_, frames_[z]->line(edge), frames_[other(z)]->apex(node)});
}

bool MixedTiles::beyond(std::uint8_t z, Id edge, Id node) const {
  return kernel_.arithmetic().sign_after(side(z, edge, node, false)) != Sign::kNegative;
}

Query MixedTiles::along_query(std::uint8_t z, Id edge, Id own_node, Id node) const {
  const ObjectId own = frames_[z]->apex(own_node), foreign = frames_[other(z)]->apex(node);
  return Query(predicates_.along[z],
               {pose_, frames_[z]->line(edge), z == 0 ? own : foreign, z == 0 ? foreign : own});
}

Sign MixedTiles::along(std::uint8_t z, Id edge, Id own_node, Id node) const {
  return kernel_.arithmetic().sign_after(along_query(z, edge, own_node, node));
}

MixedTiles::Move MixedTiles::inner_side(const Tile& tile) const {
  if (tile.kind == Tile::Kind::kHalf) return {std::nullopt, tile.x, tile.v, tile.other};
  const OuterHierarchy::Node& v = tree(tile.x).node(tile.v);
  if (tile.kind == Tile::Kind::kTriangle) return {std::nullopt, tile.x, v.cut, tile.other};
  const Id own = tile.kind == Tile::Kind::kLeft ? v.left : v.right;
  return {std::nullopt, other(tile.x), tile.other, own};
}

// The line of edge e of Z at this node of W supports M: the node is at a vertex, or one of its
// edges is parallel to e.
bool MixedTiles::supports(std::uint8_t z, Id e, Id node, SignNow* now) const {
  const std::uint8_t w = other(z);
  if (cut_time(w, node) == kNever) return true;
  if (now == nullptr && turns_) return false;
  return is_parallel(z, e, tree(w).node(node).left_edge, now) ||
         is_parallel(z, e, tree(w).node(node).right_edge, now);
}

bool MixedTiles::is_parallel(std::uint8_t z, Id e, Id f, SignNow* now) const {
  return sign(order(z, e, f), now) == Sign::kZero;
}

Query MixedTiles::inner(const Tile& tile) const {
  const Move at = inner_side(tile);
  Query query = side(at.x, at.edge, at.node, false);
  if (supports(at.x, at.edge, at.node, nullptr)) query.predicate = predicates_.touch[at.x];
  return query;
}

std::optional<MixedTiles::Move> MixedTiles::touch(const Tile& tile, SignNow* now) const {
  const Move at = inner_side(tile);
  const std::uint8_t z = at.x, w = other(z);
  if (sign(side(z, at.edge, at.node, false), now) != Sign::kZero) return std::nullopt;
  if (!supports(z, at.edge, at.node, now)) return std::nullopt;
  // There M has the side [l, r] + [first, last].
  const Id l = first_end(z, at.edge, kNever), r = last_end(z, at.edge, kNever);
  Id first = at.node, last = at.node, parallel = OuterHierarchy::kNone;
  if (!tree(w).is_point()) {
    const bool leaf = cut_time(w, at.node) == kNever;
    for (const bool left : {true, false}) {
      Id f = left ? tree(w).node(at.node).left_edge : tree(w).node(at.node).right_edge;
      if (leaf) f = left ? edge_before(w, at.node, kNever) : edge_after(w, at.node, kNever);
      if (!is_parallel(z, at.edge, f, now)) continue;
      parallel = f;
      first = first_end(w, f, kNever);
      last = last_end(w, f, kNever);
    }
  }
  if (sign(along_query(z, at.edge, l, first), now) == Sign::kNegative) return std::nullopt;
  if (sign(along_query(z, at.edge, r, last), now) == Sign::kPositive) return std::nullopt;
  if (parallel == OuterHierarchy::kNone ||
      sign(along_query(z, at.edge, r, first), now) != Sign::kPositive) {
    return Move{std::nullopt, z, at.edge, first};
  }
  return Move{std::nullopt, w, parallel, r};
}

// ---- certificates

MixedTiles::Certificates MixedTiles::certificates(const Tile& tile) const {
  Certificates result;
  const auto add = [&result](const Query& query) { result.query[result.count++] = query; };
  const std::uint8_t x = tile.x, y = other(x);
  if (tile.kind == Tile::Kind::kHalf) {
    add(inner(tile));
    result.sides = 1;
    if (!tree(y).is_point()) {
      const OuterHierarchy::Node& u = tree(y).node(tile.other);
      add(order_after(x, tile.v, u.left_edge));
      add(order(x, tile.v, u.right_edge));
    }
    return result;
  }
  const OuterHierarchy::Node& v = tree(x).node(tile.v);
  const int time = cut_time(x, tile.v);
  if (tile.kind == Tile::Kind::kTriangle) {
    const Id w = tile.other;
    add(inner(tile));
    add(side(x, v.left_edge, w, true));
    add(side(x, v.right_edge, w, true));
    result.sides = 3;
    if (!tree(y).is_point()) {
      add(order_after(x, v.cut, edge_before(y, w, time)));
      add(order(x, v.cut, edge_after(y, w, time)));
    }
    return result;
  }
  const Id f = tile.other;
  const Id y1 = first_end(y, f, time), y2 = last_end(y, f, time);
  const bool left = tile.kind == Tile::Kind::kLeft;
  add(inner(tile));
  add(side(y, f, tile.v, true));
  const Id edge = left ? v.left_edge : v.right_edge;
  add(side(x, edge, y1, left));
  add(side(x, edge, y2, !left));
  result.sides = 4;
  // The flip, then the fold.
  add(left ? order_after(x, v.cut, f) : order(x, v.cut, f));
  add(left ? order(x, v.left_edge, f) : order_after(x, v.right_edge, f));
  return result;
}

int MixedTiles::level(const Tile& tile) const {
  if (tile.kind == Tile::Kind::kHalf) return 0;
  return tree(tile.x).node(tile.v).cut_level + offset_[tile.x] + 1;
}

}  // namespace kinex

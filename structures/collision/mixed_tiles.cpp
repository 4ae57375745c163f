// SPDX-License-Identifier: GPL-3.0-or-later
// The names of a tile and its certificates. Moves are in mixed_tiles_moves.cpp.
#include "structures/collision/mixed_tiles.h"

#include <algorithm>

namespace kinex {

MixedTiles::MixedTiles(Kernel& kernel, const PosePredicates& predicates, ObjectId pose,
                       std::array<BodyFrame*, 2> frames)
    : kernel_(kernel), predicates_(predicates), pose_(pose), frames_(frames) {
  turns_ = kernel.motion_degree(pose, 5, 7) > 0;
  if (tree(0).is_point() || tree(1).is_point()) return;
  if (tree(0).radius() == tree(1).radius()) return;
  // The error at equal levels is a quarter of the radius per two levels: the smaller polygon starts
  // later.
  const std::uint8_t small = tree(1).radius() < tree(0).radius() ? 1 : 0;
  offset_[small] = 2 * tree(small).quarterings_below(tree(other(small)));
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

bool MixedTiles::before(std::uint8_t z, Id e, Id f) const {
  const Query query = order(z, e, f);
  const Sign sign = kernel_.sign_after(query);
  // Identically parallel: A's normal comes first.
  return sign == Sign::kPositive || (sign == Sign::kZero && z == 0);
}

bool MixedTiles::beyond(std::uint8_t z, Id edge, Id node) const {
  return kernel_.sign_after(side(z, edge, node, false)) != Sign::kNegative;
}

Query MixedTiles::along_query(std::uint8_t z, Id edge, Id own_node, Id node) const {
  const ObjectId own = frames_[z]->apex(own_node), foreign = frames_[other(z)]->apex(node);
  return predicates_.along(z, pose_, frames_[z]->line(edge), z == 0 ? own : foreign,
                           z == 0 ? foreign : own);
}

Sign MixedTiles::along(std::uint8_t z, Id edge, Id own_node, Id node) const {
  return kernel_.sign_after(along_query(z, edge, own_node, node));
}

MixedTiles::Move MixedTiles::inner_side(const Tile& tile) const {
  if (tile.kind == Tile::Kind::kHalf) return {std::nullopt, tile.x, tile.v, tile.other};
  const OuterHierarchy::Node& v = tree(tile.x).node(tile.v);
  if (tile.kind == Tile::Kind::kTriangle) return {std::nullopt, tile.x, v.cut, tile.other};
  const Id own = tile.kind == Tile::Kind::kLeft ? v.left : v.right;
  return {std::nullopt, other(tile.x), tile.other, own};
}

// The line of edge e of Z at this node of W supports M if the node is at a vertex, or one of its
// edges is parallel to e.
bool MixedTiles::supports(std::uint8_t z, Id e, Id node, When when) const {
  const std::uint8_t w = other(z);
  if (cut_time(w, node) == kNever) return true;
  if (when == When::kRightAfter && turns_) return false;
  return is_parallel(z, e, tree(w).node(node).left_edge, when) ||
         is_parallel(z, e, tree(w).node(node).right_edge, when);
}

bool MixedTiles::is_parallel(std::uint8_t z, Id e, Id f, When when) const {
  return sign(order(z, e, f), when) == Sign::kZero;
}

// A line that does not support M may do so at an instant at which normals are parallel: the point
// may touch it there.
Query MixedTiles::inner(const Tile& tile) const {
  const Move at = inner_side(tile);
  return predicates_.at_touch(side(at.x, at.edge, at.node, false));
}

MixedTiles::Face MixedTiles::face(const Move& at, When when) const {
  const std::uint8_t z = at.x, w = other(z);
  Face face{{first_end(z, at.edge, kNever), last_end(z, at.edge, kNever)}, {at.node, at.node}};
  if (tree(w).is_point()) return face;
  const bool leaf = cut_time(w, at.node) == kNever;
  for (const bool left : {true, false}) {
    Id f = left ? tree(w).node(at.node).left_edge : tree(w).node(at.node).right_edge;
    if (leaf) f = left ? edge_before(w, at.node, kNever) : edge_after(w, at.node, kNever);
    if (!is_parallel(z, at.edge, f, when)) continue;
    face.parallel = f;
    face.others = {first_end(w, f, kNever), last_end(w, f, kNever)};
  }
  return face;
}

std::optional<MixedTiles::Move> MixedTiles::touch(const Tile& tile, When when) const {
  const Move at = inner_side(tile);
  const std::uint8_t z = at.x;
  if (sign(side(z, at.edge, at.node, false), when) != Sign::kZero) return std::nullopt;
  if (!supports(z, at.edge, at.node, when)) return std::nullopt;
  const Face m = face(at, when);
  const auto place = [&](std::size_t own, std::size_t foreign) {
    return sign(along_query(z, at.edge, m.own[own], m.others[foreign]), when);
  };
  if (place(0, 0) == Sign::kNegative || place(1, 1) == Sign::kPositive) return std::nullopt;
  if (m.parallel == OuterHierarchy::kNone || place(1, 0) != Sign::kPositive) {
    return Move{std::nullopt, z, at.edge, m.others[0]};
  }
  return Move{std::nullopt, other(z), m.parallel, m.own[1]};
}

MixedTiles::Certificates MixedTiles::slide(const Tile& tile) const {
  Certificates result;
  const Move at = inner_side(tile);
  if (!supports(at.x, at.edge, at.node, When::kRightAfter) ||
      sign(inner(tile), When::kRightAfter) != Sign::kZero) {
    return result;
  }
  const Face m = face(at, When::kRightAfter);
  const auto add = [&](std::size_t end, bool against) {
    result.query[result.count++] =
        predicates_.along_at_touch(along_query(at.x, at.edge, m.own[end], m.others[end]), against);
  };
  if (along(at.x, at.edge, m.own[0], m.others[0]) == Sign::kNegative) {
    add(0, true);
  } else if (along(at.x, at.edge, m.own[1], m.others[1]) == Sign::kPositive) {
    add(1, false);
  } else {
    add(0, false);
    add(1, true);
  }
  return result;
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

int MixedTiles::levels() const {
  return std::max(tree(0).levels() + offset_[0], tree(1).levels() + offset_[1]);
}

}  // namespace kinex

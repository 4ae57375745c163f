// SPDX-License-Identifier: GPL-3.0-or-later
// MixedTiles: moves from tile to tile.
#include <algorithm>
#include <span>

#include "structures/collision/mixed_tiles.h"

namespace kinex {

// Outwards across the side edge + node, at operation `time`.
Tile MixedTiles::ascend(std::uint8_t z, Id edge, Id node, int time) const {
  const std::uint8_t w = other(z);
  node = facing(w, node, z, edge, time);
  const int te = birth_of_edge(z, edge), tn = birth_of_node(w, node);
  if (te < 0 && tn < 0) return {Tile::Kind::kHalf, z, edge, node};
  if (te > tn) return {Tile::Kind::kTriangle, z, tree(z).edge(edge).creator, node};
  const OuterHierarchy::Node& n = tree(w).node(node);
  return {n.is_left ? Tile::Kind::kLeft : Tile::Kind::kRight, w, n.parent, edge};
}

// Inwards across the side edge + node, which is on the boundary after operation `time`.
MixedTiles::Move MixedTiles::descend(std::uint8_t z, Id edge, Id node, int time) const {
  const std::uint8_t w = other(z);
  node = facing(w, node, z, edge, time + 1);
  Id l = first_end(z, edge, time + 1), r = last_end(z, edge, time + 1);
  for (;;) {
    const int tu = cut_time(w, node), tl = cut_time(z, l), tr = cut_time(z, r);
    const int first = std::min({tu, tl, tr});
    if (first == kNever) return at_boundary(z, edge, node);
    if (tu == first) {
      const bool left = before(z, edge, tree(w).node(node).cut);
      return {Tile{left ? Tile::Kind::kLeft : Tile::Kind::kRight, w, node, edge}, 0, 0, 0};
    }
    if (tl == first) {
      const OuterHierarchy::Node& cut = tree(z).node(l);
      if (along(z, edge, cut.right, node) == Sign::kNegative) {
        const Id g = edge_before(w, node, first);
        if (g != OuterHierarchy::kNone && before(z, cut.cut, g)) {
          return {Tile{Tile::Kind::kRight, z, l, g}, 0, 0, 0};
        }
        return {Tile{Tile::Kind::kTriangle, z, l, node}, 0, 0, 0};
      }
    }
    if (tr == first) {
      const OuterHierarchy::Node& cut = tree(z).node(r);
      if (along(z, edge, cut.left, node) == Sign::kPositive) {
        const Id g = edge_after(w, node, first);
        if (g != OuterHierarchy::kNone && !before(z, cut.cut, g)) {
          return {Tile{Tile::Kind::kLeft, z, r, g}, 0, 0, 0};
        }
        return {Tile{Tile::Kind::kTriangle, z, r, node}, 0, 0, 0};
      }
      r = cut.left;
    }
    if (tl == first) l = tree(z).node(l).right;
  }
}

// A side is a segment, its certificate a line. Where sides fail together, at a corner or because a
// tile is flat, the point may have crossed the line beside the segment. If it is then in M, it has
// crossed the next edge of M, which may continue along the same line. At a sharp corner of M it may
// cross one side and slide along the other: at a corner, the search decides whether it is in M.
MixedTiles::Move MixedTiles::at_boundary(std::uint8_t z, Id edge, Id node) const {
  const Id l = first_end(z, edge, kNever), r = last_end(z, edge, kNever);
  const Move here{std::nullopt, z, edge, node};
  if (kernel_.tells_sign_now()) {
    const Sign to_first = kernel_.sign(along_query(z, edge, l, node), When::kNow);
    const Sign to_last = kernel_.sign(along_query(z, edge, r, node), When::kNow);
    if (to_first == Sign::kPositive && to_last == Sign::kNegative) return here;
  }
  const Move searched{std::nullopt, z, edge, node, true};
  const Sign at_first = along(z, edge, l, node), at_last = along(z, edge, r, node);
  if (const auto tile = locate()) return {tile, 0, 0, 0, true};
  if (at_first == Sign::kPositive && at_last == Sign::kNegative) return searched;
  const bool back = at_first == Sign::kNegative;
  if (!back && at_last != Sign::kPositive) return searched;
  const std::uint8_t w = other(z);
  const Id own = back ? l : r;
  const Id e = back ? edge_before(z, own, kNever) : edge_after(z, own, kNever);
  const Id f = back ? edge_before(w, node, kNever) : edge_after(w, node, kNever);
  // The one whose normal is nearer.
  if (f == OuterHierarchy::kNone || before(z, e, f) != back) {
    return {std::nullopt, z, e, facing(w, node, z, e, kNever), true};
  }
  return {std::nullopt, w, f, facing(z, own, w, f, kNever), true};
}

// Of the two inner (or the two outer) sides of a parallelogram that both fail: the one that the
// point has crossed. They lie on one line while f is parallel to the other sides.
std::uint32_t MixedTiles::choose_side(const Tile& tile, std::uint32_t slot) const {
  const std::uint8_t x = tile.x, y = other(x);
  const bool left = tile.kind == Tile::Kind::kLeft;
  const std::uint32_t inner = left ? 3 : 2, outer = left ? 2 : 3;  // beside f's own, slots 0 and 1
  const bool is_inner = slot == 0 || slot == inner;
  const std::uint32_t own = is_inner ? 0 : 1, lateral = is_inner ? inner : outer;
  const Certificates proof = certificates(tile);
  const std::uint32_t partner = slot == own ? lateral : own;
  if (kernel_.sign_after(proof.query[partner]) != Sign::kNegative) return slot;
  const OuterHierarchy::Node& v = tree(x).node(tile.v);
  const int time = cut_time(x, tile.v);
  const Id f = tile.other;
  // The corner between them, seen along f.
  const bool at_last = left == is_inner;
  const Id corner = at_last ? last_end(y, f, time) : first_end(y, f, time);
  const Sign sign = along(y, f, corner, is_inner ? (left ? v.left : v.right) : tile.v);
  const bool on_own = at_last ? sign != Sign::kPositive : sign != Sign::kNegative;
  return on_own ? own : lateral;
}

MixedTiles::Move MixedTiles::cross(const Tile& tile, std::uint32_t slot) const {
  const std::uint8_t x = tile.x, y = other(x);
  if (tile.kind == Tile::Kind::kHalf) return descend(x, tile.v, tile.other, -1);
  const OuterHierarchy::Node& v = tree(x).node(tile.v);
  const int time = cut_time(x, tile.v);
  const auto to = [](const Tile& next) { return Move{next, 0, 0, 0}; };
  const auto is_edge = [](Id edge) { return edge != OuterHierarchy::kNone; };
  if (tile.kind == Tile::Kind::kTriangle) {
    const Id w = tile.other;
    if (slot == 0) return descend(x, v.cut, w, time);
    if (slot == 1) {
      const Id g = edge_before(y, w, time);
      if (is_edge(g) && before(x, v.left_edge, g)) return to({Tile::Kind::kLeft, x, tile.v, g});
      return to(ascend(x, v.left_edge, w, time));
    }
    const Id g = edge_after(y, w, time);
    if (is_edge(g) && !before(x, v.right_edge, g)) return to({Tile::Kind::kRight, x, tile.v, g});
    return to(ascend(x, v.right_edge, w, time));
  }
  const Id f = tile.other;
  const bool left = tile.kind == Tile::Kind::kLeft;
  slot = choose_side(tile, slot);
  if (slot == 0) return descend(y, f, left ? v.left : v.right, time);
  if (slot == 1) return to(ascend(y, f, tile.v, time));
  if (slot == 2) {
    const Id y1 = first_end(y, f, time), g = edge_before(y, y1, time);
    if (left) {
      if (before(x, v.left_edge, g)) return to({Tile::Kind::kLeft, x, tile.v, g});
      return to(ascend(x, v.left_edge, y1, time));
    }
    if (before(x, v.cut, g)) return to({Tile::Kind::kRight, x, tile.v, g});
    return to({Tile::Kind::kTriangle, x, tile.v, y1});
  }
  const Id y2 = last_end(y, f, time), g = edge_after(y, y2, time);
  if (left) {
    if (!before(x, v.cut, g)) return to({Tile::Kind::kLeft, x, tile.v, g});
    return to({Tile::Kind::kTriangle, x, tile.v, y2});
  }
  if (!before(x, v.right_edge, g)) return to({Tile::Kind::kRight, x, tile.v, g});
  return to(ascend(x, v.right_edge, y2, time));
}

// While the base of the triangle is parallel to f, two tiles make one trapezoid; before and after
// that it is divided in two different ways. The point is in one of the two new tiles; the side
// between them decides:
//
//      ____f____ __c__              __c__ ____f____
//      \        \    /              \    /        /
//       \        \  /      --->      \  /        /
//        \________\/                  \/________/
std::optional<MixedTiles::Move> MixedTiles::flip(const Tile& tile, std::uint32_t slot) const {
  const std::uint8_t x = tile.x, y = other(x);
  const auto to = [](const Tile& next) { return Move{next, 0, 0, 0}; };
  if (tile.kind == Tile::Kind::kHalf) {
    const Id corner = slot == 1 ? (tile.other + 3) % 4 : (tile.other + 1) % 4;
    return to({Tile::Kind::kHalf, x, tile.v, corner});
  }
  const OuterHierarchy::Node& v = tree(x).node(tile.v);
  const int time = cut_time(x, tile.v);
  // m is now before f: the triangle at f's first end, or the right parallelogram.
  const auto before_f = [&](Id f) {
    const Id y1 = first_end(y, f, time);
    if (beyond(x, v.right_edge, y1)) return to({Tile::Kind::kRight, x, tile.v, f});
    return to({Tile::Kind::kTriangle, x, tile.v, y1});
  };
  const auto after_f = [&](Id f) {
    const Id y2 = last_end(y, f, time);
    if (beyond(x, v.left_edge, y2)) return to({Tile::Kind::kLeft, x, tile.v, f});
    return to({Tile::Kind::kTriangle, x, tile.v, y2});
  };
  switch (tile.kind) {
    case Tile::Kind::kTriangle:
      return slot == 3 ? before_f(edge_before(y, tile.other, time))
                       : after_f(edge_after(y, tile.other, time));
    case Tile::Kind::kLeft:
      if (slot == 4) return before_f(tile.other);
      break;
    case Tile::Kind::kRight:
      if (slot == 4) return after_f(tile.other);
      break;
    case Tile::Kind::kHalf:
      break;
  }
  return std::nullopt;
}

std::optional<MixedTiles::Move> MixedTiles::next(const Tile& tile, std::uint32_t slot) const {
  const std::uint32_t sides = tile.kind == Tile::Kind::kHalf       ? 1
                              : tile.kind == Tile::Kind::kTriangle ? 3
                                                                   : 4;
  if (slot < sides) return cross(tile, slot);
  return flip(tile, slot);
}

// ---- where the point is

// True if the tile exists at this angle, that is, its normals are in order.
bool MixedTiles::holds(const Tile& tile) const {
  const Certificates proof = certificates(tile);
  for (std::uint32_t i = 0; i < proof.sides; ++i) {
    if (kernel_.sign_after(proof.query[i]) == Sign::kNegative) return false;
  }
  return true;
}

std::optional<Tile> MixedTiles::locate_half() const {
  for (std::uint8_t z = 0; z < 2; ++z) {
    if (tree(z).is_point()) continue;
    for (Id e = 0; e < 4; ++e) {
      for (Id u = 0; u < tree(other(z)).roots(); ++u) {
        if (!tree(other(z)).is_point()) {
          const OuterHierarchy::Node& corner = tree(other(z)).node(u);
          if (before(z, e, corner.left_edge) || !before(z, e, corner.right_edge)) continue;
        }
        const Tile tile{Tile::Kind::kHalf, z, e, u};
        if (beyond(z, e, u)) return tile;
        break;
      }
    }
  }
  return std::nullopt;
}

// Searches the tiles of one cut.
std::optional<Tile> MixedTiles::locate_at(std::uint8_t x, Id node) const {
  const std::uint8_t y = other(x);
  const OuterHierarchy::Node& v = tree(x).node(node);
  const int time = cut_time(x, node);
  Id w = 0;
  if (!tree(y).is_point()) {
    // From the corner whose cone holds the new normal downwards.
    while (w < 3 && !(!before(x, v.cut, tree(y).node(w).left_edge) &&
                      before(x, v.cut, tree(y).node(w).right_edge))) {
      ++w;
    }
    while (cut_time(y, w) < time) {
      const OuterHierarchy::Node& cut = tree(y).node(w);
      w = before(x, v.cut, cut.cut) ? cut.left : cut.right;
    }
  }
  // The point is beyond neither old edge.
  const Tile triangle{Tile::Kind::kTriangle, x, node, w};
  if (holds(triangle)) return triangle;
  if (tree(y).is_point()) return std::nullopt;
  // At most once around: in an inexact arithmetic the walk may not end.
  const Id last = edge_after(y, w, time);
  for (Id f = edge_before(y, w, time); before(x, v.left_edge, f);) {
    const Tile tile{Tile::Kind::kLeft, x, node, f};
    if (holds(tile)) return tile;
    if (f == last) break;
    f = edge_before(y, first_end(y, f, time), time);
  }
  const Id first = edge_before(y, w, time);
  for (Id f = last; !before(x, v.right_edge, f);) {
    const Tile tile{Tile::Kind::kRight, x, node, f};
    if (holds(tile)) return tile;
    if (f == first) break;
    f = edge_after(y, last_end(y, f, time), time);
  }
  return std::nullopt;
}

std::optional<Tile> MixedTiles::leave(std::uint8_t z, std::uint32_t edge,
                                      std::uint32_t vertex) const {
  const std::uint8_t w = other(z);
  const Id node = first_end(w, tree(w).edge_on(vertex), kNever);
  const Tile tile = ascend(z, tree(z).edge_on(edge), node, kNever);
  const Certificates proof = certificates(tile);
  for (std::uint32_t i = 0; i < proof.count; ++i) {
    if (kernel_.sign_after(proof.query[i]) == Sign::kNegative) return locate();
  }
  return tile;
}

std::optional<Tile> MixedTiles::locate() const {
  if (auto half = locate_half()) return half;
  // All cuts in the order of their operations.
  const std::array<std::span<const Id>, 2> nodes{tree(0).cuts(), tree(1).cuts()};
  std::array<std::size_t, 2> at{};
  while (at[0] < nodes[0].size() || at[1] < nodes[1].size()) {
    const bool second =
        at[0] == nodes[0].size() ||
        (at[1] < nodes[1].size() && cut_time(1, nodes[1][at[1]]) < cut_time(0, nodes[0][at[0]]));
    const std::uint8_t z = second ? 1 : 0;
    if (auto tile = locate_at(z, nodes[z][at[z]])) return tile;
    ++at[z];
  }
  return std::nullopt;
}

}  // namespace kinex

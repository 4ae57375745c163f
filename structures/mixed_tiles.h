// SPDX-License-Identifier: GPL-3.0-or-later
// MixedTiles: the mixed hierarchy of two convex polygons A and B', never built whole.
//
// The cuts of the hierarchies of A and of B' (turned by R) are interleaved by level, operations (A,
// 0), (B, 0), (A, 1), ... What one cut removes from the Minkowski sum of the two outer polygons is
// tiled by a triangle and parallelograms; all tiles together tile the sum of the boxes minus M = A
// + R B', and eight half-planes cover the rest. A tile is named by nodes and edges of the two
// trees; this class computes its certificates and its neighbours from the names and from signs
// right after now.
//
// Let X be the polygon whose node v is cut (new edge c with normal m, children a on the left edge,
// b on the right one) and Y the other polygon in its state before the cut.
//   triangle (v, w)        (v, a, b) + w; w the node of Y whose cone holds m
//   left (v, f)            f + [v, a], f an edge of Y with normal between that of v's left edge and
//   m right (v, f)           f + [v, b], f with normal between m and that of v's right edge half
//   (e, u)            beyond box edge e of Z at corner u of the other box, whose cone holds e's
//   normal
// Every side of a tile is a translate of an edge of one polygon by a node of the other.
//
// Certificates, all "non-negative inside": 3 sides and 2 orders of normals for a triangle, 4 and 2
// for a parallelogram, 1 and 2 for a half-plane. Sides come first.
//
// Ties. Normals that are parallel for ever: those of B' count as turned a little further. A point
// that stays on a side is inside.
//
// Cost: O(depth) signs for a neighbour; O(tiles) for locate().
// Source: the mixed hierarchy is that of Erickson, Guibas, Stolfi, Zhang (1999); tiles, moves and
// flips are worked out here.
#ifndef KINEX_STRUCTURES_MIXED_TILES_H
#define KINEX_STRUCTURES_MIXED_TILES_H

#include <array>
#include <cstdint>
#include <optional>

#include "core/kernel.h"
#include "core/touch.h"
#include "structures/body_frames.h"

namespace kinex {

// The predicates on poses, bound once per structure.
struct PosePredicates {
  explicit PosePredicates(Kernel& kernel);
  // [frame]: the frame of the line
  std::array<PredicateId, 2> side, inside, along, touch, touch_inside, along_touch, against_touch;
  PredicateId normal_order, normal_order_reversed, order_touch, order_touch_reversed;
};

struct Tile {
  enum class Kind : std::uint8_t { kTriangle, kLeft, kRight, kHalf };
  Kind kind = Kind::kHalf;
  std::uint8_t x = 0;   // 0: A, 1: B'. The polygon that is cut, or whose edge bounds the half-plane
  std::uint32_t v = 0;  // node of X; edge of X for a half-plane
  std::uint32_t other = 0;  // node w, edge f or corner u of the other polygon
  friend bool operator==(const Tile&, const Tile&) = default;
};

class MixedTiles {
 public:
  static constexpr std::uint32_t kMost = 6;
  struct Certificates {
    std::array<Query, kMost> query;
    std::uint32_t count = 0, sides = 0;
  };
  // Where a move leads: another tile, or, for none, the boundary of M: edge `edge` of polygon `x`
  // meets node `node` of the other.
  struct Move {
    std::optional<Tile> tile;
    std::uint8_t x = 0;
    std::uint32_t edge = 0, node = 0;
    bool searched = false;  // locate() was asked
  };

  // `frames[1]` is B'. The references must live as long as this object; it is cheap to make.
  MixedTiles(Kernel& kernel, const PosePredicates& predicates, ObjectId pose,
             std::array<BodyFrame*, 2> frames);

  Certificates certificates(const Tile& tile) const;
  // Certificate `slot` of the tile is negative right after now: the tile on its other side, or the
  // one that takes over after a flip. nullopt: a parallelogram has folded up (which no moving point
  // can ride through): locate the point anew.
  std::optional<Move> next(const Tile& tile, std::uint32_t slot) const;
  // A tile that holds the point right after now; nullopt: it lies in M.
  std::optional<Tile> locate() const;
  // The same where the point has just left M across edge `edge` of polygon z at vertex `vertex` of
  // the other: O(1) signs.
  std::optional<Tile> leave(std::uint8_t z, std::uint32_t edge, std::uint32_t vertex) const;
  // The side where the tile touches M, if the point is on M there (Move::tile is nullopt): right
  // after now, or at now (`now` is not nullptr). The certificates hold right after now.
  std::optional<Move> touch(const Tile& tile, SignNow* now) const;
  // While the point stays on the line of that side: certificates that fail where it comes to M or
  // leaves it; at most two.
  Certificates slide(const Tile& tile) const;
  // An order of normals that fails at a touch too: for an instant the side of M may reach the point
  // on its line.
  Query order_at_touch(Query order) const;
  // Levels of the operation that made the tile; 0 for half-planes.
  int level(const Tile& tile) const;
  // The largest there are.
  int levels() const;

 private:
  static constexpr int kNever = OuterHierarchy::kNever;
  using Id = std::uint32_t;

  const OuterHierarchy& tree(std::uint8_t z) const { return frames_[z]->hierarchy(); }
  static std::uint8_t other(std::uint8_t z) { return static_cast<std::uint8_t>(1 - z); }
  // Operations are numbered; kNever for a node that is not cut, -1 for what the boxes have.
  int cut_time(std::uint8_t z, Id node) const;
  int birth_of_edge(std::uint8_t z, Id edge) const;
  int birth_of_node(std::uint8_t z, Id node) const;
  // In the state in which the cuts before operation `time` have been done:
  Id first_end(std::uint8_t z, Id edge, int time) const;
  Id last_end(std::uint8_t z, Id edge, int time) const;
  bool has_length(std::uint8_t z, Id edge, int time) const;
  // The edge that comes before or after a node, edges without length skipped; kNone for a point.
  Id edge_before(std::uint8_t z, Id node, int time) const;
  Id edge_after(std::uint8_t z, Id node, int time) const;
  // Of the nodes at the same place as `node`, the one whose cone holds the normal of edge e of Z.
  Id facing(std::uint8_t w, Id node, std::uint8_t z, Id e, int time) const;
  // Is the normal of edge e of Z before (clockwise from) that of edge f of the other polygon?
  bool before(std::uint8_t z, Id e, Id f) const;
  Query order(std::uint8_t z, Id e, Id f) const;  // non-negative iff before(z, e, f) or parallel
  Query order_after(std::uint8_t z, Id e, Id f) const;
  Query side(std::uint8_t z, Id edge, Id node, bool inward) const;
  Sign sign(const Query& query, SignNow* now) const {
    return now != nullptr ? now->sign_now(query) : kernel_.arithmetic().sign_after(query);
  }
  // Side 0 of a tile, the inner one: the only one that can touch M, and only if its line supports
  // M.
  Move inner_side(const Tile& tile) const;
  // The side of M on this line: from [0] to [1], each a node of Z and one of W.
  struct Face {
    std::array<Id, 2> own, others;
    Id parallel = 0xffffffffu;  // the edge of W that is parallel, if there is one
  };
  Face face(const Move& at, SignNow* now) const;
  bool supports(std::uint8_t z, Id e, Id node, SignNow* now) const;
  bool is_parallel(std::uint8_t z, Id e, Id f, SignNow* now) const;
  Query inner(const Tile& tile) const;
  bool beyond(std::uint8_t z, Id edge, Id node) const;  // right after now
  Query along_query(std::uint8_t z, Id edge, Id own_node, Id node) const;
  Sign along(std::uint8_t z, Id edge, Id own_node, Id node) const;

  Tile ascend(std::uint8_t z, Id edge, Id node, int time) const;
  Move descend(std::uint8_t z, Id edge, Id node, int time) const;
  // The point has passed the line of edge + node, both of the last state: contact, unless it has
  // passed it beyond the side's ends and is not in M.
  Move at_boundary(std::uint8_t z, Id edge, Id node) const;
  std::uint32_t choose_side(const Tile& tile, std::uint32_t slot) const;
  Move cross(const Tile& tile, std::uint32_t slot) const;
  std::optional<Move> flip(const Tile& tile, std::uint32_t slot) const;
  bool holds(const Tile& tile) const;
  std::optional<Tile> locate_half() const;
  std::optional<Tile> locate_at(std::uint8_t x, Id node) const;

  Kernel& kernel_;
  const PosePredicates& predicates_;
  ObjectId pose_;
  std::array<BodyFrame*, 2> frames_;
  bool turns_ = false;           // one body against the other
  std::array<int, 2> offset_{};  // empty levels before those of the smaller polygon
};

}  // namespace kinex

#endif

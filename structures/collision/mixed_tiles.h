// SPDX-License-Identifier: GPL-3.0-or-later
// MixedTiles: the mixed hierarchy of two convex polygons A and B', never built as a whole.
//
// In the frame of A (predicates/bodies/pose_2.h), body B is turned by R, and its position is a
// moving point. With B' = -B, the bodies meet iff the point lies in M = A + R B'. While they are
// apart, the tile that holds the point is the proof.
//
// The cuts of the hierarchies of A and of B' (outer_hierarchy.h) are interleaved by level:
// operations (A, 0), (B, 0), (A, 1), ... (the smaller polygon starts some levels later). One cut
// removes a strip from the Minkowski sum of the two outer polygons; the strip is tiled by one
// triangle and parallelograms. All tiles together tile the sum of the boxes minus M; eight
// half-planes cover the rest. A tile is named by nodes and edges of the two trees; its certificates
// and neighbours are computed from these names and from signs right after now.
//
// Let X be the polygon whose node v is cut (new edge c with normal m, children a on the left edge,
// b on the right one), and Y the other polygon in its state before the cut. Tiles:
//   triangle (v, w)  (v, a, b) + w         w: the node of Y whose cone holds m
//   left (v, f)      f + [v, a]            f: an edge of Y, normal between that of v's left edge
//                                             and m
//   right (v, f)     f + [v, b]            f: an edge of Y, normal between m and that of v's
//                                             right edge
//   half (e, u)      beyond box edge e     u: the corner of the other box whose cone holds e's
//                    of Z, at corner u        normal
// The strip of one cut, for one edge f on the left and one edge f' on the right:
//
//     ______f______ ____c____ ______f'_____    the sum after the cut; M lies above
//     \            \         /            /
//      \   left     \  tri  /   right    /
//       \            \     /            /
//        \______f_____\v+w/_____f'_____/       the sum before the cut
//
// Every side of a tile is a translate of an edge of one polygon by a node of the other.
//
// Certificates, all non-negative while the point is inside, sides first:
//   triangle        3 sides, 2 orders of normals
//   parallelogram   4 sides, 2 orders of normals
//   half-plane      1 side,  2 orders of normals
//
// Ties. Of identically parallel normals those of B' count as turned a little further. A point that
// stays on a side is inside.
//
// Cost: O(depth) signs for a neighbour; O(tiles) for locate(), which next() calls where several
// sides fail together.
// Source: the mixed hierarchy of Erickson, Guibas, Stolfi, Zhang (1999); tiles, moves and flips are
// worked out here.
#ifndef KINEX_STRUCTURES_COLLISION_MIXED_TILES_H
#define KINEX_STRUCTURES_COLLISION_MIXED_TILES_H

#include <array>
#include <cstdint>
#include <optional>

#include "core/arithmetic/touch.h"
#include "core/engine/kernel.h"
#include "predicates/bodies/body_frames.h"
#include "predicates/bodies/pose_predicates.h"

namespace kinex {

struct Tile {  // the name of a tile of the hierarchy, or of a half-plane
  enum class Kind : std::uint8_t { kTriangle, kLeft, kRight, kHalf };
  Kind kind = Kind::kHalf;
  std::uint8_t x = 0;   // 0: A, 1: B'; the polygon that is cut, or whose edge bounds the half-plane
  std::uint32_t v = 0;  // node of X; edge of X for a half-plane
  std::uint32_t other = 0;  // node w, edge f or corner u of the other polygon
  friend bool operator==(const Tile&, const Tile&) = default;
};

class MixedTiles {
 public:
  static constexpr std::uint32_t kMost = 6;
  struct Certificates {  // those of a tile; the first `sides` are about its sides
    std::array<Query, kMost> query;
    std::uint32_t count = 0, sides = 0;
  };
  // Where a move leads: to a tile, or (no tile) to the boundary of M, where edge `edge` of polygon
  // `x` meets node `node` of the other.
  struct Move {
    std::optional<Tile> tile;
    std::uint8_t x = 0;
    std::uint32_t edge = 0, node = 0;
    bool searched = false;  // found by locate()
  };

  // `frames[1]` is B'. The references must live as long as this object; it is cheap to make.
  MixedTiles(Kernel& kernel, const PosePredicates& predicates, ObjectId pose,
             std::array<BodyFrame*, 2> frames);

  Certificates certificates(const Tile& tile) const;
  // Requires that certificate `slot` of the tile is negative right after now. Returns the tile
  // across that side or, for an order of normals, the new tile that holds the point; nullopt if a
  // parallelogram has collapsed: the point must be located anew.
  std::optional<Move> next(const Tile& tile, std::uint32_t slot) const;
  // A tile that holds the point right after now; nullopt: it lies in M.
  std::optional<Tile> locate() const;
  // As locate(), for a point that has just left M across edge `edge` of polygon z at vertex
  // `vertex` of the other. O(1) signs.
  std::optional<Tile> leave(std::uint8_t z, std::uint32_t edge, std::uint32_t vertex) const;
  // Where the point is on the boundary of M, at `when`: the side of the tile there, as a Move
  // without a tile; nullopt: it is not on M. Requires that the certificates hold right after now.
  std::optional<Move> touch(const Tile& tile, When when) const;
  // For a point that stays on the line of that side: at most two certificates, which fail when it
  // comes to M or leaves it along the line. None if it is not on the line right after now.
  Certificates slide(const Tile& tile) const;
  // The level of the operation that made the tile; 0 for half-planes.
  int level(const Tile& tile) const;
  // The number of levels: an upper bound on level().
  int levels() const;

 private:
  static constexpr int kNever = OuterHierarchy::kNever;
  using Id = std::uint32_t;

  const OuterHierarchy& tree(std::uint8_t z) const { return frames_[z]->hierarchy(); }
  static std::uint8_t other(std::uint8_t z) { return static_cast<std::uint8_t>(1 - z); }
  // Numbers of operations; kNever for a node that is not cut, -1 for what belongs to a box.
  int cut_time(std::uint8_t z, Id node) const;
  int birth_of_edge(std::uint8_t z, Id edge) const;
  int birth_of_node(std::uint8_t z, Id node) const;
  // In the state after the cuts before operation `time`:
  Id first_end(std::uint8_t z, Id edge, int time) const;
  Id last_end(std::uint8_t z, Id edge, int time) const;
  bool has_length(std::uint8_t z, Id edge, int time) const;
  // The edge that comes before or after a node, edges without length skipped; kNone for a point.
  Id edge_before(std::uint8_t z, Id node, int time) const;
  Id edge_after(std::uint8_t z, Id node, int time) const;
  // Among the nodes at the place of `node`, the one whose cone holds the normal of edge e of Z.
  Id facing(std::uint8_t w, Id node, std::uint8_t z, Id e, int time) const;
  // Is the normal of edge e of Z before (clockwise from) that of edge f of the other polygon?
  bool before(std::uint8_t z, Id e, Id f) const;
  PosePredicates::Lines lines(std::uint8_t z, Id e, Id f) const {
    return {pose_, frames_[z]->line(e), frames_[other(z)]->line(f)};
  }
  // Non-negative iff before(z, e, f) or parallel.
  Query order(std::uint8_t z, Id e, Id f) const {
    return predicates_.order_before(z, lines(z, e, f));
  }
  Query order_after(std::uint8_t z, Id e, Id f) const {
    return predicates_.order_after(z, lines(z, e, f));
  }
  // The point is on the outer side of edge + node, a line (or, inward, on its inner side).
  Query side(std::uint8_t z, Id edge, Id node, bool inward) const {
    const PosePredicates::AtPoint at{pose_, frames_[z]->line(edge), frames_[other(z)]->apex(node)};
    return inward ? predicates_.inside(z, at) : predicates_.side(z, at);
  }
  Sign sign(const Query& query, When when) const { return kernel_.sign(query, when); }
  // Side 0 of a tile, the inner one. No other side can touch M, and this one only if its line
  // supports M.
  Move inner_side(const Tile& tile) const;
  // The side of M on this line, from [0] to [1]: each end is a node of Z and one of W.
  struct Face {
    std::array<Id, 2> own, others;
    Id parallel = 0xffffffffu;  // the edge of W that is parallel, if there is one
  };
  Face face(const Move& at, When when) const;
  bool supports(std::uint8_t z, Id e, Id node, When when) const;
  bool is_parallel(std::uint8_t z, Id e, Id f, When when) const;
  Query inner(const Tile& tile) const;
  bool beyond(std::uint8_t z, Id edge, Id node) const;  // right after now
  Query along_query(std::uint8_t z, Id edge, Id own_node, Id node) const;
  Sign along(std::uint8_t z, Id edge, Id own_node, Id node) const;

  Tile ascend(std::uint8_t z, Id edge, Id node, int time) const;
  Move descend(std::uint8_t z, Id edge, Id node, int time) const;
  // The point has crossed the line of edge + node, both of the last state. This is a contact unless
  // it crossed beyond the ends of the side and is not in M.
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

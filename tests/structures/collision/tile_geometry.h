// SPDX-License-Identifier: GPL-3.0-or-later
// The witness of MixedTiles: all tiles of two polygons at one rational pose, by their definition:
// stages of both hierarchies as plain lists of points, no certificates and no moves.
#ifndef KINEX_TESTS_STRUCTURES_COLLISION_TILE_GEOMETRY_H
#define KINEX_TESTS_STRUCTURES_COLLISION_TILE_GEOMETRY_H

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "structures/collision/mixed_tiles.h"
#include "tests/structures/collision/body_polygons.h"

namespace kinex::test {

inline Rational cross(const Vertex2& a, const Vertex2& b) { return a[0] * b[1] - a[1] * b[0]; }
inline Rational dot(const Vertex2& a, const Vertex2& b) { return a[0] * b[0] + a[1] * b[1]; }
inline Vertex2 operator+(const Vertex2& a, const Vertex2& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Vertex2 operator-(const Vertex2& a, const Vertex2& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Vertex2 operator*(const Rational& k, const Vertex2& a) { return {k * a[0], k * a[1]}; }

inline Rational double_area(const Polygon& polygon) {
  Rational area;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    area += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return area;
}

// Counter-clockwise and without points between others; all points of a convex polygon are given.
inline Polygon convex_hull(Polygon points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t floor = hull.size();
    for (const Vertex2& v : points) {
      while (hull.size() >= floor + 2 &&
             cross(hull.back() - hull[hull.size() - 2], v - hull.back()).sign() <= 0) {
        hull.pop_back();
      }
      hull.push_back(v);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

inline Polygon minkowski_sum(const Polygon& a, const Polygon& b) {
  Polygon all;
  for (const Vertex2& v : a) {
    for (const Vertex2& w : b) all.push_back(v + w);
  }
  return convex_hull(std::move(all));
}

// 1: strictly inside, 0: on the boundary, -1: outside. Counter-clockwise polygons.
inline int where(const Vertex2& p, const Polygon& polygon) {
  int result = 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex2& a = polygon[i];
    const int sign = cross(polygon[(i + 1) % polygon.size()] - a, p - a).sign();
    if (sign < 0) return -1;
    if (sign == 0) result = 0;
  }
  return polygon.size() < 3 ? std::min(result, 0) : result;
}

// The place of a tile; empty for half-planes.
struct PlacedTile {
  Tile tile;
  Polygon outline;                                // counter-clockwise
  std::array<std::array<Vertex2, 2>, 4> sides{};  // in the order of the certificates
  std::size_t count = 0;                          // of sides
};

class TileGeometry {
 public:
  // `offset`: empty levels before those of either polygon. Of parallel normals those of A come
  // first, or (`b_first`) those of B'.
  TileGeometry(const OuterHierarchy& a, const OuterHierarchy& b, std::array<int, 2> offset,
               Vertex2 rotor, bool b_first = false)
      : trees_{&a, &b}, offset_(offset), b_first_(b_first) {
    const Rational &p = rotor[0], &q = rotor[1], n = p * p + q * q;
    c_ = (p * p - q * q) / n;
    s_ = Rational(2) * p * q / n;
  }

  Vertex2 turned(int z, const Vertex2& v) const {
    if (z == 0) return v;
    return {c_ * v[0] - s_ * v[1], s_ * v[0] + c_ * v[1]};
  }
  Vertex2 apex(int z, std::uint32_t v) const {
    const FramePoint& p = trees_[std::size_t(z)]->node(v).apex;
    return turned(z, {Rational(p.x, p.w), Rational(p.y, p.w)});
  }
  Vertex2 normal(int z, std::uint32_t edge) const {
    const FrameLine& l = trees_[std::size_t(z)]->edge(edge).line;
    return turned(z, {Rational(l.nx), Rational(l.ny)});
  }
  const OuterHierarchy& tree(int z) const { return *trees_[std::size_t(z)]; }
  int cut_time(int z, std::uint32_t v) const {
    const int level = tree(z).node(v).cut_level;
    return level == OuterHierarchy::kNever ? level : 2 * (level + offset_[std::size_t(z)]) + z;
  }
  bool before(int z, std::uint32_t e, std::uint32_t f) const {
    const int sign = cross(normal(z, e), normal(1 - z, f)).sign();
    return sign > 0 || (sign == 0 && (z == 0) != b_first_);
  }

  // The nodes of a stage, before the operation at `time`.
  std::vector<std::uint32_t> stage(int z, int time) const {
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t root = 0; root < 4; ++root) collect(z, root, time, nodes);
    return nodes;
  }
  Polygon outline(int z, int time) const {
    Polygon points;
    for (const std::uint32_t v : stage(z, time)) points.push_back(apex(z, v));
    return points;
  }
  Polygon sum(int time) const {
    return minkowski_sum(convex_hull(outline(0, time)), convex_hull(outline(1, time)));
  }

  // The place of the tile of this name.
  PlacedTile placed(const Tile& tile) const {
    PlacedTile result;
    result.tile = tile;
    if (tile.kind == Tile::Kind::kHalf) return result;
    const int x = tile.x, y = 1 - x;
    const OuterHierarchy::Node& node = tree(x).node(tile.v);
    const Vertex2 v = apex(x, tile.v), a = apex(x, node.left), b = apex(x, node.right);
    if (tile.kind == Tile::Kind::kTriangle) {
      const Vertex2 w = apex(y, tile.other);
      result.outline = {v + w, a + w, b + w};
      result.sides = {{{a + w, b + w}, {v + w, a + w}, {v + w, b + w}}};
      result.count = 3;
    } else {
      const Vertex2 c = tile.kind == Tile::Kind::kLeft ? a : b;
      const auto [y1, y2] = ends(y, tile.other, cut_time(x, tile.v));
      result.outline = {y1 + v, y2 + v, y2 + c, y1 + c};
      result.sides = {{{y1 + c, y2 + c}, {y1 + v, y2 + v}, {y1 + v, y1 + c}, {y2 + v, y2 + c}}};
      result.count = 4;
    }
    if (double_area(result.outline).sign() < 0) {
      std::reverse(result.outline.begin(), result.outline.end());
    }
    return result;
  }

  // All tiles that have an area, half-planes aside.
  std::vector<PlacedTile> all() const {
    std::vector<PlacedTile> tiles;
    for (int x = 0; x < 2; ++x) {
      for (std::uint32_t v = 0; v < tree(x).nodes().size(); ++v) {
        if (tree(x).node(v).cut != OuterHierarchy::kNone) tiles_of(x, v, tiles);
      }
    }
    return tiles;
  }

  // True if an edge of one hierarchy is parallel to one of the other.
  bool has_parallels() const {
    for (std::uint32_t e = 0; e < tree(0).edges().size(); ++e) {
      for (std::uint32_t f = 0; f < tree(1).edges().size(); ++f) {
        if (cross(normal(0, e), normal(1, f)).is_zero()) return true;
      }
    }
    return false;
  }

  // The outline of the tile that holds p in its inside; nullopt if none does.
  std::optional<Polygon> holder(const Vertex2& p) const {
    for (const PlacedTile& tile : all()) {
      if (where(p, tile.outline) > 0) return convex_hull(tile.outline);
    }
    return std::nullopt;
  }

 private:
  void collect(int z, std::uint32_t v, int time, std::vector<std::uint32_t>& nodes) const {
    const OuterHierarchy::Node& node = tree(z).node(v);
    if (cut_time(z, v) >= time) {
      nodes.push_back(v);
      return;
    }
    collect(z, node.left, time, nodes);
    collect(z, node.right, time, nodes);
  }

  // Of an edge in a stage.
  std::array<Vertex2, 2> ends(int z, std::uint32_t edge, int time) const {
    std::array<Vertex2, 2> result;
    for (const std::uint32_t v : stage(z, time)) {
      if (tree(z).node(v).right_edge == edge) result[0] = apex(z, v);
      if (tree(z).node(v).left_edge == edge) result[1] = apex(z, v);
    }
    return result;
  }

  void tiles_of(int x, std::uint32_t v, std::vector<PlacedTile>& tiles) const {
    const int y = 1 - x, time = cut_time(x, v);
    const OuterHierarchy::Node& node = tree(x).node(v);
    const auto add = [&](Tile::Kind kind, std::uint32_t other) {
      PlacedTile tile = placed({kind, static_cast<std::uint8_t>(x), v, other});
      if (!double_area(tile.outline).is_zero()) tiles.push_back(std::move(tile));
    };
    for (const std::uint32_t w : stage(y, time)) {
      const OuterHierarchy::Node& corner = tree(y).node(w);
      const auto inside = [&](std::uint32_t f, std::uint32_t from, std::uint32_t to) {
        // The normals of one node are within a right angle.
        const Vertex2 m = normal(x, node.cut);
        return before(x, from, f) && !before(x, to, f) && dot(m, normal(y, f)).sign() > 0;
      };
      const Vertex2 m = normal(x, node.cut);
      const Vertex2 l = normal(y, corner.left_edge), r = normal(y, corner.right_edge);
      // A cone of normals spans a right angle at most.
      if (!before(x, node.cut, corner.left_edge) && before(x, node.cut, corner.right_edge) &&
          dot(m, l + r).sign() > 0) {
        add(Tile::Kind::kTriangle, w);
      }
      const std::uint32_t f = corner.right_edge;  // every edge of the stage once
      if (inside(f, node.left_edge, node.cut)) add(Tile::Kind::kLeft, f);
      if (inside(f, node.cut, node.right_edge)) add(Tile::Kind::kRight, f);
    }
  }

  std::array<const OuterHierarchy*, 2> trees_;
  std::array<int, 2> offset_;
  bool b_first_;
  Rational c_, s_;
};

}  // namespace kinex::test

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulation2: the combinatorial part of a planar triangulation, closed to a sphere by a vertex
// at infinity. It knows vertices and neighbours, never a coordinate.
//
// Triangle t has the half-edges 3t, 3t + 1, 3t + 2, counter-clockwise; half-edge h runs from
// origin(h) to origin(next(h)) with its triangle on the left:
//
//             apex(h)
//              /   '.
//   previous(h)      ' next(h)
//            / triangle'.
//    origin(h) ---h---> target(h)
//              <-twin(h)-
//
// A triangle with the vertex at infinity is a ghost: (x, y, infinity) lies beyond the hull edge
// from y to x. Each edge carries a label, 32 bits of the owner's, the same from both sides.
#ifndef KINEX_STRUCTURES_TRIANGULATION_TRIANGULATION_2_H
#define KINEX_STRUCTURES_TRIANGULATION_TRIANGULATION_2_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/big_array.h"
#include "structures/triangulation/edge_journal.h"

namespace kinex {

class Triangulation2 {
 public:
  using HalfEdge = std::uint32_t;
  using Triangle = std::uint32_t;
  using Corners = std::array<ObjectId, 3>;  // the vertices of a triangle, counter-clockwise
  static constexpr std::uint32_t kNone = 0xffffffffu;

  // Vertices are the ids 0 .. objects - 1; `objects` itself stands for infinity.
  explicit Triangulation2(std::size_t objects);

  ObjectId infinity() const { return infinity_; }
  // The finite edges that changes have touched.
  const EdgeJournal& journal() const { return journal_; }
  void clear();
  // The triangle a, b, c, counter-clockwise, alone on the sphere. Requires an empty triangulation.
  void start(ObjectId a, ObjectId b, ObjectId c);

  // Prefetches the triangle of a half-edge that will be visited soon.
  void prefetch(HalfEdge h) const {
    const Record* const first = half_edges_.data() + 3 * triangle(h);
    __builtin_prefetch(first, 1);
    __builtin_prefetch(first + 2, 1);  // a triangle may be on two cache lines
  }
  void prefetch_point(ObjectId v) const { __builtin_prefetch(out_.data() + v, 1); }

  static HalfEdge next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static HalfEdge previous(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
  static Triangle triangle(HalfEdge h) { return h / 3; }

  ObjectId origin(HalfEdge h) const { return half_edges_[h].origin; }
  ObjectId target(HalfEdge h) const { return half_edges_[next(h)].origin; }
  // The vertex opposite h in its own triangle.
  ObjectId apex(HalfEdge h) const { return half_edges_[previous(h)].origin; }
  HalfEdge twin(HalfEdge h) const { return half_edges_[h].twin; }
  // From the origin of 3t.
  Corners corners(Triangle t) const { return {origin(3 * t), origin(3 * t + 1), origin(3 * t + 2)}; }
  // The half-edge from a to b, or kNone; a may be no vertex. O(degree of a).
  HalfEdge between(ObjectId a, ObjectId b) const;
  std::uint32_t label(HalfEdge h) const { return half_edges_[h].label; }
  void set_label(HalfEdge h, std::uint32_t label) {
    half_edges_[h].label = label;
    half_edges_[half_edges_[h].twin].label = label;
  }
  // Some half-edge that starts at v; kNone if v is no vertex.
  HalfEdge out(ObjectId v) const { return out_[v]; }
  bool has(ObjectId v) const { return out_[v] != kNone; }
  // The next half-edge with the same origin, counter-clockwise.
  HalfEdge around(HalfEdge h) const { return half_edges_[previous(h)].twin; }
  // O(degree of a).
  bool adjacent(ObjectId a, ObjectId b) const;
  bool live(Triangle t) const { return half_edges_[3 * t].twin != kNone; }
  bool ghost(Triangle t) const {
    return half_edges_[3 * t].origin == infinity_ || half_edges_[3 * t + 1].origin == infinity_ ||
           half_edges_[3 * t + 2].origin == infinity_;
  }
  // Vertices, not counting the one at infinity; triangles, counting ghosts.
  std::size_t vertices() const { return vertices_; }
  std::size_t triangles() const { return half_edges_.size() / 3 - free_.size(); }
  // One past the largest triangle (half-edge) ever used; not all below it are live.
  Triangle triangle_capacity() const { return static_cast<Triangle>(half_edges_.size() / 3); }
  HalfEdge half_edge_capacity() const { return static_cast<HalfEdge>(half_edges_.size()); }

  // Replaces the edge of h, with opposite vertices p and q, by the edge between p and q. The new
  // edge keeps the label. Returns the new half-edge from p to q; the other sides of its triangle
  // are q -> v and v -> p, where v was the target of h.
  HalfEdge flip(HalfEdge h);

  // Replaces the disc `cavity` (its triangles, no vertex inside) by the star of the new vertex v.
  // Labels on the rim are kept; those of the spokes are kNone. `rim` receives the half-edges of the
  // new triangles on the rim. Returns false, with nothing changed, if the cavity is not such a
  // disc.
  bool star(ObjectId v, const std::vector<Triangle>& cavity, std::vector<HalfEdge>& rim);

  // The link of v counter-clockwise: half-edges of v's triangles that face v.
  void link(ObjectId v, std::vector<HalfEdge>& out) const;

  // Removes v and fills its link, whose corners are 0 .. k - 1 in the order of link(), with
  // triangles. Each ear names the corners before, at and after the one that is cut off; the last
  // ear is the remaining triangle: k - 2 ears in all. `filled` receives the new triangles. Labels
  // on the link are kept; those of new edges are kNone.
  using Ear = std::array<std::uint32_t, 3>;
  void fill(ObjectId v, const std::vector<Ear>& ears, std::vector<Triangle>& filled);

  // Replaces `cells` by triangles with the corners `fresh_corners`, which fill the same place.
  // Vertices may go and come. Labels on the rim are kept; those inside are kNone. False, with nothing
  // changed, if they do not fit, or no ghost would be left. `fresh` receives the new triangles.
  // O(k log k).
  bool replace(std::span<const Triangle> cells, std::span<const Corners> fresh_corners,
               std::vector<Triangle>& fresh);

  // Describes what is wrong with the links and counts; empty if nothing is.
  std::string defect() const;
  std::size_t bytes() const;

 private:
  struct Record {
    ObjectId origin;
    HalfEdge twin;
    std::uint32_t label;
  };
  struct Side {
    ObjectId from, to;
    HalfEdge outer;
    std::uint32_t label;
  };

  void touch(ObjectId a, ObjectId b) {
    if (std::max(a, b) != infinity_) journal_.touch(a, b);
  }
  Triangle allocate();
  void release(Triangle t);
  void put(HalfEdge h, ObjectId from, HalfEdge twin, std::uint32_t label) {
    half_edges_[h] = {from, twin, label};
    half_edges_[twin].twin = h;
    out_[from] = h;
  }

  ObjectId infinity_;
  BigArray<Record> half_edges_;
  std::vector<HalfEdge> out_;
  std::vector<Triangle> free_;
  std::size_t vertices_ = 0;
  EdgeJournal journal_;
  // scratch
  std::vector<std::uint32_t> triangle_mark_;
  std::vector<std::uint32_t> vertex_mark_;
  BigArray<Triangle> vertex_triangle_;
  std::uint32_t epoch_ = 0;
  std::vector<Side> sides_;
  std::vector<Triangle> slots_;
  std::vector<HalfEdge> link_;
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// FarthestDelaunay2: the farthest-point Delaunay triangulation of moving points: the triangulation
// of their convex hull in which the circle through the corners of every triangle contains all
// points.
//
// Certificates. It watches a hull (any HullSource) and keeps one certificate per diagonal uv with
// opposite vertices p and q: q is in the circle through u, v, p; in_circle_2, degree 4d for motions
// of degree d. The lifted points over the two triangles are then concave along the diagonal; a
// surface over a convex polygon that is concave along every diagonal is concave. The hull proves
// that the polygon is convex, so any triangulation of its cycle has upright triangles.
//
// Flips end, wherever the points are: at an instant at which the hull is yet to change the cycle may
// be that of a polygon which crosses itself, and triangles may be inverted. The signed volume below
// the lifted triangles is larger after a flip of a failing diagonal than before it, by the signed
// volume of the tetrahedron of its four points, which is in_circle_2 but for a factor. So no
// triangulation of a cycle comes back, and no failure has to wait for the hull.
//
//          p                  p
//        1/ \4              1/|\4        The certificate of uv fails: uv is flipped to pq, and up
//        /   \              / | \        to 5 certificates are renewed.
//       u-----v    --->    u  |  v
//        \   /              \ | /        A new vertex p between a and b is the ear a p b; its
//        2\ /3              2\|/3        diagonal is ab. A vertex that leaves is an ear by then;
//          q                  q          in degenerate cases its diagonals are flipped away first.
//
// Quality, for h hull vertices: h - 3 certificates; not local (a fan has h - 3 of one point). A
// failure, or a vertex that comes or goes, is O(1) certificates outside degenerate instants. Two or
// more hull changes at one instant, an insertion or an erasure that changes two or more vertices:
// built anew in expected O(h), keeping certificates that are the same. Every event is external.
// Events, beside those of the hull: at most 4d C(n,4) flips.
//
// Ties. The diagonal of four identically cocircular points contains the smallest id, so k such
// points are a fan. The hull decides on points that are identically equal or on a line.
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 6.9; static
// construction: Chew, "Building Voronoi diagrams for convex polygons in linear expected time"
// (1990).
#ifndef KINEX_STRUCTURES_EXTENT_FARTHEST_DELAUNAY_2_H
#define KINEX_STRUCTURES_EXTENT_FARTHEST_DELAUNAY_2_H

#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/hull/hull_source.h"
#include "structures/parts/repeat_guard.h"
#include "structures/parts/ties.h"
#include "structures/parts/tuple_changes.h"
#include "structures/triangulation/triangulation_2.h"

namespace kinex {

class FarthestDelaunay2 final : public Structure {
 public:
  // kFlip: the diagonal that goes, the one that comes, smaller id first. Changes with the hull are
  // reported as "settled".
  enum Kind : std::uint8_t { kFlip };
  using HalfEdge = Triangulation2::HalfEdge;
  using Triangle = Triangulation2::Triangle;
  static constexpr std::uint32_t kNone = Triangulation2::kNone;

  // `hull` outlives this structure and is watched by it.
  FarthestDelaunay2(Kernel& kernel, StructureId id, const Scene& scene,
                    const HullSource& hull);

  std::string_view name() const override { return "farthest_delaunay_2"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"flip"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  // Points come and go in the hull.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void instant_over() override;
  void watched_changed(const Event* event) override;
  // The edges, those of the hull included.
  Attribute attribute() const override;
  Attribute told() const override { return untold_.undone(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t) const override { return 0; }
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  StructureId id() const { return id_; }
  // The hull and the triangulation may change again at this instant. A reader whose certificate
  // fails at it has them settled first: settle_below().
  bool instant_may_go_on() const;
  void settle_below() const;
  // The number of the scene's objects, present or not.
  std::size_t objects() const { return store_.infinity(); }
  // For readers: the triangles, if there are three vertices or more. A diagonal whose four points
  // are identically cocircular is a tie.
  const Triangulation2& triangles() const { return store_; }
  bool is_tie(HalfEdge h) const { return slots_.is_tie(store_.label(h)); }
  const HullSource& hull() const { return *hull_; }
  // The vertices if there are fewer than three.
  const std::vector<ObjectId>& few() const { return few_; }

 private:
  // ---- farthest_delaunay_2.cpp: certificates and flips
  bool on_hull(HalfEdge h) const {
    return store_.ghost(Triangulation2::triangle(h)) ||
           store_.ghost(Triangulation2::triangle(store_.twin(h)));
  }
  bool to_infinity(HalfEdge h) const {
    return store_.origin(h) == store_.infinity() || store_.target(h) == store_.infinity();
  }
  bool is_diagonal(HalfEdge h) const { return !to_infinity(h) && !on_hull(h); }
  Query query_of(HalfEdge h) const;
  // The half-edge that names the edge: from the smaller to the larger id.
  HalfEdge named(HalfEdge h) const {
    return store_.origin(h) < store_.target(h) ? h : store_.twin(h);
  }
  void set_certificate(HalfEdge h);
  void note_outlook(HalfEdge h, Outlook outlook);
  void drop_certificate(HalfEdge h);
  HalfEdge flip(HalfEdge h);
  bool wants_other_diagonal(HalfEdge h) const;
  void settle_ties();
  void finish();
  bool repeats(const Query& failed);
  void give_up(const char* what);

  // ---- farthest_delaunay_2_build.cpp: the cycle of vertices changes
  std::vector<ObjectId> cycle() const;
  HalfEdge hull_edge(ObjectId from, ObjectId to) const;
  bool can_enter(ObjectId p, ObjectId a, ObjectId b) const;
  bool can_leave(ObjectId p) const;
  void enter(ObjectId p, ObjectId a, ObjectId b);
  void leave(ObjectId p);
  bool follow(const Event& event);
  void synchronise();
  bool change_one(const std::vector<ObjectId>& before, const std::vector<ObjectId>& after);
  void construct(const std::vector<ObjectId>& cycle, bool keep);
  void triangulate(const std::vector<ObjectId>& cycle);
  void legalise(HalfEdge opposite);
  void begin();
  // ---- farthest_delaunay_2_audit.cpp
  void audit_circles(const Snapshot& snapshot, AuditReport& report) const;

  Kernel* kernel_;
  StructureId id_;
  const HullSource* hull_;
  PredicateId in_circle_;
  Slots slots_;
  Ties ties_;                      // half-edges whose diagonals may be tied the other way
  std::vector<HalfEdge> failing_;  // of diagonals whose certificates were made negative
  Triangulation2 store_;
  std::vector<ObjectId> few_;

  // The present instant.
  EdgeChanges untold_;   // of the attribute, not reported
  bool corrupt_ = false;
  RepeatGuard repeats_;
  // scratch
  std::vector<HalfEdge> rim_, stack_;
  std::vector<Triangle> filled_;
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3: the Delaunay triangulation of moving points in space.
//
// Certificates. The triangulation is closed to a sphere by a vertex at infinity, so changes of the
// hull are flips like all others. One certificate for each facet, between two cells with the apices
// p and q, for motions of degree d:
//   all five points finite  q is not inside the sphere of the other cell   in_sphere_3,   degree 5d
//                           identically on it: the ties                    orientation_3, degree 3d
//   p or q infinite         the finite cell is upright                     orientation_3, degree 3d
//   the facet is infinite   the hull is convex at its finite edge          orientation_3, degree 3d
//                           identically in one plane: it is not folded     unfolded_3,    degree 4d
// Locally Delaunay everywhere is globally Delaunay.
//
//           p                      p             X, the three points of the facet with p and q, has
//          /|\                    /|\            two cells (then 2-3: the facet abc goes, the edge pq
//         / | \                  / | \           comes) or three, around an edge (3-2). A 2-3 flip
//        a--+--c    2-3 -->     a- | -c          renews 9 certificates: 3 at the new edge, 6 around.
//         \ b /     <-- 3-2      \ b /           A 3-2 flip renews 7. The three certificates at the
//          \|/                    \|/            edge of a 3-2 flip claim the same of the same five
//           q                      q             points: they fail together, as one.
//
// Quality, for n points and E edges, V = n + 1 vertices counted with infinity:
//   compactness     2 (E - V) certificates (Euler's formula on the 3-sphere), at most (n+1)(n-2)
//   locality        not local
//   responsiveness  a flip, 9 or 7 certificates
//   efficiency      every event changes cells, but for `blocked`, `touch` and some `retile` of degenerate
//                   instants
//   in one plane    3n - 3 certificates, 5 for a flip; at most 4d C(n,4) + 2d C(n,3) flips
// Events: each in_sphere_3 changes sign at most 5d times, each orientation_3 3d times: at most
// 5d C(n,5) + 3d C(n,4) instants; with ties that last at most 15d C(n,5) + 24d C(n,4). Growth
// O(n^3 lambda_s(n)).
//
// Ties. The triangulation right after an instant depends on the points' motions and ids alone: see
// lifted_geometry.h. Of identically equal points the smallest id is the vertex; the others are hidden
// behind it. Points that are all identically in one plane, or fewer than four, have no cells.
//
// In one plane. While all points are, identically, readers of edges get those of the Delaunay triangulation of
// the plane, which may turn, and of points on one line those of neighbours: flat_triangulation.h. The events are
// internal, since there are no cells.
//
// Degenerate instants: sewn_triangulation.h. What is wrong is cut out, and filled with the static
// triangulation of its vertices.
//
// Reported events name finite points: the edge or the point first. Each states the change of cells.
//   flip_2_3   p q a b c: the edge p q joins, the facet abc leaves; three cells for two
//   flip_3_2   p q a b c: the edge p q leaves, the facet abc joins; two cells for three
//   enter      q a b c: the cell leaves; q, behind abc, has reached the hull
//   leave      q a b c: the cell joins; q has sunk below the hull facet abc
//   hull_2_3   p q a b: the cell joins; the hull edge p q joins and goes in front of ab
//   hull_3_2   p q a b: the cell leaves; the hull edge p q leaves
//   retile     a part was sewn: no ids; the difference of cells, if there is one
//   blocked    internal
//   touch      internal; u v w p: p is in the plane of the hull facet u v w, or that is flat;
//              a b c d e: five points are on one sphere
//   plane_flip, plane_enter, plane_leave, plane_retile, plane_blocked, plane_touch
//              internal; all points are in one plane: as flip u v p q, enter p u v, leave p u v, retile, blocked
//              and touch of regular_2
//   line_pass  internal; a b: all points are on one line, and two neighbours change places
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Joe,
// Construction of three-dimensional Delaunay triangulations using local transformations (1991);
// Devillers, Teillaud (2011) for ties.
#ifndef KINEX_STRUCTURES_TRIANGULATION_DELAUNAY_3_H
#define KINEX_STRUCTURES_TRIANGULATION_DELAUNAY_3_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "structures/triangulation/equal_points.h"
#include "structures/triangulation/flat_triangulation.h"
#include "structures/triangulation/sewn_triangulation.h"
#include "structures/triangulation/space_flips.h"
#include "structures/triangulation/static_delaunay_3.h"

namespace kinex {

class Delaunay3 final : public SpaceFlips<SewnTriangulation<RegularGeometry<SpaceComplex>>> {
 public:
  // Kinds of events and their ids: see above. First those of space_flips.h.
  enum Kind : std::uint8_t {
    kRetile = kSpaceFlips,
    kBlocked,
    kTouch,
    kPlaneFlip,
    kPlaneEnter,
    kPlaneLeave,
    kPlaneRetile,
    kPlaneBlocked,
    kPlaneTouch,
    kLinePass
  };

  Delaunay3(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "delaunay_3"; }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  bool holds_at(const Snapshot& snapshot) const override;
  std::size_t bytes() const override;

  // The number of the scene's objects, alive or not.
  std::size_t objects() const { return points_.objects(); }
  // The vertex for `object`: itself, or the one it is hidden behind; kNoObject: not present.
  ObjectId representative(ObjectId object) const { return points_.vertex_of(object); }
  // The edges, smaller id first, ascending; while all points are in one plane those of its triangulation, or on
  // one line those of neighbours there. Of fewer than four points all pairs of vertices.
  std::vector<std::array<ObjectId, 2>> edges() const;
  // The other ends of the edges at a vertex, ascending. O(k log k) for k of them.
  std::vector<ObjectId> neighbours(ObjectId vertex) const;
  // Which edges may have come or gone; nullptr: all may have, for the points are in one plane.
  const EdgeJournal* journal() const { return flat_ ? nullptr : &store_.journal(); }
  std::uint64_t hidden_changes() const { return points_.hidden_changes(); }
  // Requires that the points are not in one plane. O(degree of a).
  bool has_edge(ObjectId a, ObjectId b) const { return store_.adjacent(a, b); }
  // All points, four or more, are in one plane, or on one line.
  bool planar() const { return flat_ && plane_ != nullptr && !plane_->empty(); }
  // The edges that have changed since readers were told the last time, if that is one flip in the plane of
  // all points, which is no event of the attribute.
  std::optional<EdgeChange> change_within() const {
    return planar() ? plane_->change() : std::nullopt;
  }

 private:
  using Quad = Triangulation3::Quad;

  // ---- delaunay_3.cpp: certificates
  void set_certificate(Facet f) override;
  void set_certificates(std::span<const Facet> facets) override;
  void set_tie(Facet f);

  // ---- delaunay_3_update.cpp: the static algorithm, and changes from outside
  void construct() override;
  StaticResult build_patch(std::span<const ObjectId> vertices) override;
  void filled(const std::vector<Quad>&, const std::vector<Quad>&) override {}
  void sewn() override;
  void add_windings(const std::vector<Cell>& near, std::vector<Cell>& wrong) override;
  void settle_hidden() override;
  void sort_out_flat() override;
  void construct_plane();
  void put_in(ObjectId object);
  void take_out(ObjectId vertex);

  EqualPoints points_;
  std::vector<std::pair<ObjectId, ObjectId>>
      hidden_in_patch_;  // and the vertices they are equal to
  std::uint64_t ties_ = 0;  // certificates of ties that were made
  std::unique_ptr<FlatTriangulation>
      plane_;  // made when all points are in one plane for the first time
};

}  // namespace kinex

#endif

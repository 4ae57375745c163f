// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3: the Delaunay triangulation of moving points in space.
//
// Certificates. The triangulation is closed to a sphere by a vertex at infinity, so changes of the
// hull are flips like all others. One certificate for each facet, between two cells with the apices
// p and q, for motions of degree d:
//   all five points finite  q is not inside the sphere of the other cell   in_sphere_3,   degree 5d
//   p or q infinite         the finite cell is upright                     orientation_3, degree 3d
//   the facet is infinite   the hull is convex at its finite edge          orientation_3, degree 3d
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
//   efficiency      every event changes cells (ratio 1)
// Events: each in_sphere_3 changes sign at most 5d times, each orientation_3 3d times: at most
// 5d C(n,5) + 3d C(n,4) instants. Growth O(n^3 lambda_s(n)).
//
// Ties. The triangulation right after an instant depends on the points' motions and ids alone: see
// space_geometry.h. Of identically equal points the smallest id is the vertex; the others are hidden
// behind it. Points that are all identically in one plane, or fewer than four, have no cells.
//
// Degenerate instants. Where certificates on several sets of five points fail at one instant, or a
// flip would make a flat cell, flips do not suffice. A flip is made only if its new cells are upright
// right after now and its new edge or facet is not there yet; otherwise the facet has no certificate
// for the moment ("blocked"). When the instant is settled, the part that is wrong is sewn
// (delaunay_3_sew.cpp): it is cut out, and filled with the static triangulation of its vertices.
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
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Joe,
// Construction of three-dimensional Delaunay triangulations using local transformations (1991);
// Devillers, Teillaud (2011) for ties.
#ifndef KINEX_STRUCTURES_TRIANGULATION_DELAUNAY_3_H
#define KINEX_STRUCTURES_TRIANGULATION_DELAUNAY_3_H

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/parts/slots.h"
#include "structures/parts/tuple_changes.h"
#include "structures/triangulation/equal_points.h"
#include "structures/triangulation/space_geometry.h"
#include "structures/triangulation/static_delaunay_3.h"
#include "structures/triangulation/triangulation_3.h"

namespace kinex {

class Delaunay3 final : public Structure {
 public:
  // Kinds of events and their ids: see above.
  enum Kind : std::uint8_t {
    kFlip23,
    kFlip32,
    kEnter,
    kLeave,
    kHull23,
    kHull32,
    kRetile,
    kBlocked,
  };

  Delaunay3(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "delaunay_3"; }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  // The finite cells.
  Attribute attribute() const override;
  Attribute told() const override { return untold_.undone(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t) const override { return 0; }
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  StructureId id() const { return id_; }
  // The number of the scene's objects, alive or not.
  std::size_t objects() const { return points_.objects(); }
  // The vertex for `object`: itself, or the one it is hidden behind; kNoObject: not present.
  ObjectId representative(ObjectId object) const { return points_.vertex_of(object); }
  // All points are in one plane, or there are fewer than four: there are no cells.
  bool flat() const { return flat_; }
  // The edges, smaller id first, ascending; if it is flat all pairs of vertices, which contain every
  // edge that a triangulation of the plane could have.
  std::vector<std::array<ObjectId, 2>> edges() const;
  // Parts that were sewn, and the number of cells of the largest.
  std::uint64_t sews() const { return sews_; }
  std::size_t largest_sew() const { return largest_sew_; }
  const Triangulation3& triangulation() const { return store_; }

 private:
  using Cell = Triangulation3::Cell;
  using Facet = Triangulation3::Facet;
  using Quad = Triangulation3::Quad;
  static constexpr std::uint32_t kNone = Triangulation3::kNone;
  static constexpr std::uint32_t kMostSews = 100;  // at an instant of an inexact arithmetic

  // ---- delaunay_3.cpp: certificates and flips
  Query claim_of(Facet f) const {
    return geometry_.claim(store_.quad(Triangulation3::cell(f)), store_.apex(store_.mate(f)));
  }
  bool is_bad(Facet f) const {
    return geometry_.is_bad(store_.quad(Triangulation3::cell(f)), f % 4,
                            store_.apex(store_.mate(f)));
  }
  void set_certificate(Facet f);
  void set_certificates(std::span<const Facet> facets);
  void note_outlook(Facet f, Outlook outlook);
  void drop_certificate(Facet f);
  bool rim_vanishes(std::span<const Facet> rim) const;
  bool allowed(Facet f, const Triangulation3::Around& around) const;
  void flip_2_3(Facet f);
  void flip_3_2(Facet f, Facet out);
  void after_flip(std::span<const Facet> rim, std::uint64_t zeros);
  void blocked(Facet f);
  void suspect(ObjectId v) {
    if (v != store_.infinity()) suspects_.push_back(v);
  }
  void suspect_all(const std::array<ObjectId, 5>& points) {
    for (const ObjectId v : points) suspect(v);
  }
  std::array<ObjectId, 5> points_of(Facet f) const;
  void give_up(const std::string& what);

  // ---- delaunay_3_update.cpp: the static algorithm, and changes from outside
  void construct();
  void rebuild_because(const std::string& reason);
  void retract_all();
  void put_in(ObjectId object);
  void take_out(ObjectId vertex);
  void part_hidden();
  void sort_out_plane();

  // ---- delaunay_3_sew.cpp: degenerate instants
  // What a sew takes away and brings besides the vertices of its cells.
  struct Guests {
    std::vector<ObjectId> gone, came;
  };
  bool sew(std::vector<Cell> cells, const Guests& guests);
  bool find_patch(const std::vector<Facet>& rim, const std::vector<ObjectId>& vertices,
                  const std::vector<std::pair<ObjectId, ObjectId>>& hidden,
                  std::vector<Quad>& quads, std::vector<Cell>& more) const;
  std::vector<Cell> wrong_cells();
  void add_cells_at_meetings(std::vector<Cell>& cells);
  bool fill(const std::vector<Cell>& cells, const std::vector<Quad>& quads);
  void mend();

  Kernel* kernel_;
  StructureId id_;
  SpaceGeometry geometry_;
  Slots facets_;  // tag: a facet; the slot is its label
  Triangulation3 store_;
  Triangulation3 patch_;  // of sews
  EqualPoints points_;
  bool flat_ = true;
  bool corrupt_ = false;
  bool comes_or_goes_ = false;  // its changes of cells are not reported
  CellChanges untold_;

  // the present instant
  std::vector<ObjectId> suspects_;  // vertices whose cells are examined when it is settled
  std::vector<ObjectId> moved_;
  std::array<ObjectId, 5> last_flip_{};
  bool has_last_flip_ = false;
  std::uint64_t instant_ = 0;
  std::uint32_t sews_at_instant_ = 0;

  // counts
  std::uint64_t sews_ = 0;
  std::uint64_t blocks_ = 0;
  std::size_t largest_sew_ = 0;

  // scratch
  Cell hint_ = kNone;
  Conflicts conflicts_;
  std::vector<Cell> fresh_;
};

}  // namespace kinex

#endif

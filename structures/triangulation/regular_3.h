// SPDX-License-Identifier: GPL-3.0-or-later
// Regular3: the regular triangulation (weighted Delaunay triangulation) of moving points in space with
// weights that move, too: the lower hull of the points lifted to x^2 + y^2 + z^2 - w. Points above the hull
// are hidden. Balls are points of weight r^2; without weights it is the Delaunay triangulation.
// Hidden points, ties, degenerate instants: regular_triangulation.h. Flips 2-3 and 3-2: delaunay_3.h.
//
// Certificates. The triangulation is closed to a sphere by a vertex at infinity. One certificate for each
// facet, between two cells with the apices p and q, for motions and weights of degree D:
//   all five finite      q is not below the plane of the other cell       power_3,       degree 5D
//                        identically in it: the ties                      orientation_3, degree 3D
//   p or q infinite      the finite cell is upright                       orientation_3, degree 3D
//   the facet infinite   the hull is convex at its finite edge            orientation_3, degree 3D
//                        identically in one plane: it is not folded       unfolded_3,    degree 4D
// Five for each hidden point: four orientations and a power.
//
//          d                      d             A point h inside the cell shows: four cells for one. The six
//         /|\                    /|\            certificates of the facets at h claim the same of the same
//        / | \       show       / | \           five points: they fail together, as one. At the hull d is
//       /  |  \      --->      /  h  \          infinite: h passes the facet abc, and the cell habc joins.
//      a---|---c     <---     a--/|\--c
//       \  |  /      hide      \/ | \/
//          b                      b
//
// Quality, for n objects, n' of them vertices, E edges and V = n' + 1 vertices counted with infinity:
//   compactness     2 (E - V) + 5 (n - n') certificates, at most (n + 1)(n - 2) for n > 3
//   locality        not local
//   responsiveness  9 certificates for a flip 2-3, 7 for one 3-2, 10 for a point that shows, 9 for one that
//                   hides, 5 for a new witness, with any number of hidden points
//   efficiency      every event changes cells, but for `witness`, and for `blocked`, `touch` and some `retile`
//                   of degenerate instants
//   in one plane    3n' - 3 + 4 (n - n') certificates; those of regular_2 for each change
// Events: each power changes sign at most 5D times, each orientation 3D times: at most
// 5D C(n,5) + 3D C(n,4) changes of the triangulation, and as many failures of witnesses. With ties that
// last at most 15D C(n,5) + 24D C(n,4) changes.
//
// Objects that are all identically in one plane, or fewer than four, have no cells.
//
// In one plane. While all objects are, identically, readers of edges get those of the regular triangulation of
// the plane, which may turn: flat_regular.h. Its vertices, and the objects that it hides, are those of the
// structure. Its events are internal, since the attribute is the set of cells, of which there are none. Of objects
// that are all on one line all pairs are edges, without certificates.
//
// Reported events name finite points. Each states the change of cells.
//   flip_2_3   p q a b c: the edge p q joins, the facet abc leaves; three cells for two
//   flip_3_2   p q a b c: the edge p q leaves, the facet abc joins; two cells for three
//   enter      q a b c: the cell leaves; q, behind abc, has reached the hull
//   leave      q a b c: the cell joins; q has sunk below the hull facet abc
//   hull_2_3   p q a b: the cell joins; the hull edge p q joins and goes in front of ab
//   hull_3_2   p q a b: the cell leaves; the hull edge p q leaves
//   show       h a b c d: the cell a b c d is replaced by four; h a b c: the cell joins, h has passed the
//              hull facet a b c
//   hide       h a b c d, or h a b c: the reverse
//   witness    h: internal; it has, or waits for, another witness
//   retile     a part was sewn, or a point shows in several cells: the difference, if there is one
//   blocked    internal
//   touch      internal; u v w p: p is in the plane of the hull facet u v w, or that is flat;
//              a b c d e: five lifted points are in one plane
//   plane_flip, plane_enter, plane_leave, plane_show, plane_hide, plane_witness, plane_retile, plane_blocked,
//   plane_touch  internal; all objects are in one plane: as the events of regular_2
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Edelsbrunner,
// Shah, Incremental topological flipping works for regular triangulations (1996); Devillers, Teillaud
// (2011) for ties.
#ifndef KINEX_STRUCTURES_TRIANGULATION_REGULAR_3_H
#define KINEX_STRUCTURES_TRIANGULATION_REGULAR_3_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"
#include "structures/triangulation/flat_regular.h"
#include "structures/triangulation/regular_triangulation.h"
#include "structures/triangulation/space_flips.h"

namespace kinex {

class Regular3 final : public SpaceFlips<RegularTriangulation<SpaceComplex>> {
 public:
  // Kinds of events and their ids: see above. First those of space_flips.h.
  enum Kind : std::uint8_t {
    kShow = kSpaceFlips,
    kHide,
    kWitness,
    kRetile,
    kBlocked,
    kTouch,
    kPlaneFlip,
    kPlaneEnter,
    kPlaneLeave,
    kPlaneShow,
    kPlaneHide,
    kPlaneWitness,
    kPlaneRetile,
    kPlaneBlocked,
    kPlaneTouch
  };

  Regular3(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "regular_3"; }
  std::vector<std::string_view> event_kinds() const override;
  void certificate_failed(CertificateId failed) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  bool holds_at(const Snapshot& snapshot) const override;
  std::size_t bytes() const override;

  // All objects, four or more, are in one plane, or on one line.
  bool planar() const { return flat_ && plane_ != nullptr && !plane_->empty(); }
  // There are no cells, nor triangles of a common plane: all pairs are edges.
  bool has_all_pairs() const { return flat_ && (!planar() || plane_->flat()); }
  // While all objects are in one plane: as of its triangulation.
  bool is_vertex(ObjectId object) const override;
  std::vector<ObjectId> hidden() const override;
  std::vector<std::array<ObjectId, 2>> edges() const override;
  // The edges that have changed since readers were told the last time, if that is one flip in the plane of
  // all objects, which is no event of the attribute.
  std::optional<EdgeChange> change_within() const {
    return planar() ? plane_->change() : std::nullopt;
  }

 private:
  void construct() override;
  void construct_plane();
  void sort_out_flat() override;
  bool repair(Facet f) override;
  void add_windings(const std::vector<Cell>& near, std::vector<Cell>& wrong) override;

  Extents extents_;
  // Made when all objects are in one plane for the first time.
  std::unique_ptr<FlatRegular> plane_;
};

}  // namespace kinex

#endif

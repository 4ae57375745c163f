// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: the regular triangulation (weighted Delaunay triangulation) of moving points in the plane
// with weights that move, too: the lower hull of the points lifted to x^2 + y^2 - w. Points above the
// hull are hidden. Discs are points of weight r^2; without weights it is the Delaunay triangulation.
//
// Certificates. The triangulation is closed to a sphere by a vertex at infinity. One certificate for
// each edge, between two triangles with the apices p and q, for motions and weights of degree D:
//   all four finite     q is not below the plane of the other triangle   power_2,       degree 4D
//                       identically in it: the ties (plane_geometry.h)   orientation_2, degree 2D
//   p or q infinite     the finite triangle is upright                   orientation_2, degree 2D
//   the edge infinite   the hull turns left                              orientation_2, degree 2D
//                       identically on a line: its end is between        obtuse_angle_2, degree 2D
// Four for each hidden point h: a witness of three objects, whose triangle contains h (three
// orientations) and whose plane is not above h (a power). The witness need not be a triangle of the
// triangulation, nor need its corners be vertices: the lower hull is nowhere above its plane. So flips
// around a hidden point cost it nothing.
//
//          p                 p                    c                        c
//         / \               /|\                  / \                      /|\       A certificate of
//        u---v    flip     u | v                /   \        show        / h \      the edge uh fails:
//         \ /     --->      \|/                /  h  \       --->       / /   \ \   those of vh, wh
//          q                 q                a-------b      <---      a-----------b  claim the same.
//                                                            hide
//
// Quality, for n objects, n' of them vertices:
//   compactness     3n' - 3 + 4 (n - n') certificates, at most 4n - 6 for n > 2
//   locality        not local
//   responsiveness  5 certificates for a flip, 6 for a point that shows, 7 for one that hides, 4 for a
//                   new witness, with any number of hidden points
//   efficiency      every event but that of a new witness changes triangles
// Events: each power changes sign at most 4D times, each orientation 2D times: at most
// 4D C(n,4) + 2D C(n,3) changes of the triangulation, and as many failures of witnesses.
//
// Ties. The triangulation right after an instant depends on motions, weights and ids alone: see
// plane_geometry.h. What decides a tie may change, too: a point that is identically in one lifted plane
// with others shows or not as it crosses lines; points that are identically on one line of the hull can
// pass each other there, while the orientation of all triangles at them touches zero only. So a claim
// that is identically zero is replaced by the orientation that decides, or by the order on the line.
// Objects that are all identically on one line, or fewer than three, have no triangles and no
// certificates.
//
// Degenerate instants. As in delaunay_3.h: a flip is made only if its new triangles are upright right
// after now and its new edge is not there yet; otherwise the edge has no certificate for the moment
// ("blocked"). A hidden point whose witness fails when others fail, too, waits. When the instant is
// settled, what is wrong is sewn (regular_2_sew.cpp), then hidden points are located anew.
//
// The hull may come to wind around twice without a failure: where the ends of a hull edge meet and the
// edge turns around, the orientations at it touch zero only if its neighbours cross its line just then.
// (A star of any other vertex winds around twice only if the hull does.) So the certificates of hull
// edges fail at touches, too, and where the ends meet the hull is examined.
//
//            v  u           x             Before, after: u and v on the hull meet at height 0 and pass, x
//    .   x         y   .        v  u   y  and y cross that height. All turns are left turns, before
//                                         and after; after they add up to two full turns.
//
// Reported events name finite points. Each states the change of triangles.
//   flip     u v p q: the edge u v leaves, p q joins
//   enter    p u v: the triangle leaves; p, behind u v, has reached the hull
//   leave    p u v: the triangle joins; p has sunk below the hull edge u v
//   show     h a b c: the triangle a b c is replaced by three; h a b: the triangle joins, h has passed
//            the hull edge a b
//   hide     h a b c, or h a b: the reverse
//   witness  h: internal; it has, or waits for, another witness
//   retile   a part was sewn, or a point shows in several triangles: the difference, if there is one
//   blocked  internal
//   touch    u v p: internal; p, or a vertex that meets u or v, is on the line of the hull edge u v
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Edelsbrunner,
// Shah, Incremental topological flipping works for regular triangulations (1996); Devillers, Teillaud
// (2011) for ties.
#ifndef KINEX_STRUCTURES_TRIANGULATION_REGULAR_2_H
#define KINEX_STRUCTURES_TRIANGULATION_REGULAR_2_H

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"
#include "structures/parts/tuple_changes.h"
#include "structures/triangulation/plane_geometry.h"
#include "structures/triangulation/static_regular_2.h"
#include "structures/triangulation/triangulation_2.h"

namespace kinex {

class Regular2 final : public Structure {
 public:
  // Kinds of events and their ids: see above.
  enum Kind : std::uint8_t { kFlip, kEnter, kLeave, kShow, kHide, kWitness, kRetile, kBlocked, kTouch };

  Regular2(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "regular_2"; }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  // The finite triangles. A present object that is in none of them is hidden, unless it is flat.
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
  std::size_t objects() const { return present_.size(); }
  bool is_vertex(ObjectId object) const { return store_.has(object); }
  // The present objects that are no vertices, ascending; if it is flat all of them.
  std::vector<ObjectId> hidden() const;
  // All objects are on one line, or there are fewer than three: there are no triangles.
  bool flat() const { return flat_; }
  // The edges, smaller id first, ascending; if it is flat all pairs of objects.
  std::vector<std::array<ObjectId, 2>> edges() const;
  // Parts that were sewn, and the number of triangles of the largest.
  std::uint64_t sews() const { return sews_; }
  std::size_t largest_sew() const { return largest_sew_; }
  const Triangulation2& triangulation() const { return store_; }

 private:
  using HalfEdge = Triangulation2::HalfEdge;
  using Triangle = Triangulation2::Triangle;
  using Corners = Triangulation2::Corners;
  static constexpr std::uint32_t kNone = Triangulation2::kNone;
  static constexpr std::uint32_t kMostSews = 100;  // at an instant of an inexact arithmetic

  // Of a hidden point: objects and certificates; the last claims the power, the others that the point
  // is on the left of the side from a corner to the next.
  struct Witness {
    Corners corners{kNoObject, kNoObject, kNoObject};
    std::array<CertificateId, 4> certificates{kNoCertificate, kNoCertificate, kNoCertificate,
                                              kNoCertificate};
    bool names(ObjectId v) const { return corners[0] == v || corners[1] == v || corners[2] == v; }
  };

  // ---- regular_2.cpp: certificates and flips
  static unsigned opposite(HalfEdge h) { return (h + 2) % 3; }  // the place of the apex
  Query claim_of(HalfEdge h) const {
    return geometry_.claim(store_.corners(Triangulation2::triangle(h)), opposite(h),
                           store_.apex(store_.twin(h)));
  }
  // What decides if claim_of(h) is identically zero.
  Query tie_claim_of(HalfEdge h) const {
    return geometry_.tie_claim(store_.corners(Triangulation2::triangle(h)), opposite(h),
                               store_.apex(store_.twin(h)));
  }
  void set_certificate(HalfEdge h);
  void renew_about(ObjectId v);
  void drop_certificate(HalfEdge h);
  void give_up(const std::string& what);
  bool flippable(HalfEdge h) const;
  bool has_degree_3(ObjectId v) const;
  bool can_hide(ObjectId v) const;
  void flip(HalfEdge h);
  void hide(ObjectId v);
  template <class Rim>
  void after_change(const Rim& rim, std::uint64_t zeros);
  void blocked(HalfEdge h);
  void touched(HalfEdge h);
  std::array<ObjectId, 4> points_of(HalfEdge h) const;
  void suspect(ObjectId v) {
    if (v != store_.infinity()) suspects_.push_back(v);
  }
  template <class Points>
  void suspect_all(const Points& points) {
    for (const ObjectId v : points) suspect(v);
  }
  void note_change(const std::array<ObjectId, 4>& points);

  // ---- regular_2_hidden.cpp: hidden points
  Query witness_query(ObjectId h, unsigned i) const;
  void set_witness(ObjectId h, Triangle t);
  void drop_witness(ObjectId h);
  void witness_failed(ObjectId h);
  void wait(ObjectId h);
  Triangle hint() const;
  Triangle locate_hidden(ObjectId h) const;
  bool show(ObjectId h, Triangle t);
  void settle_hidden();

  // ---- regular_2_update.cpp: the static algorithm, and changes from outside
  void construct();
  void rebuild_because(const std::string& reason);
  void retract_all();
  void put_in(ObjectId object);
  void sort_out_line();

  // ---- regular_2_sew.cpp: degenerate instants
  // What a sew takes away and brings besides the vertices of its triangles.
  struct Guests {
    std::vector<ObjectId> gone, came;
  };
  bool sew(std::vector<Triangle> cells, const Guests& guests);
  bool find_patch(const std::vector<HalfEdge>& rim, const std::vector<ObjectId>& vertices,
                  std::vector<Corners>& filling, std::vector<Triangle>& more) const;
  bool fill(const std::vector<Triangle>& cells, const std::vector<Corners>& filling);
  void star_of(ObjectId v, std::vector<Triangle>& out) const;
  std::vector<Triangle> wrong_cells(bool& hull);
  void add_cells_at_meetings(std::vector<Triangle>& cells);
  bool hull_turns_once() const;
  void mend();

  Kernel* kernel_;
  StructureId id_;
  PlaneGeometry geometry_;
  Triangulation2 store_;
  Triangulation2 patch_;  // of sews
  std::vector<bool> present_;
  Slots edges_;
  Slots witnesses_;
  Ties witness_ties_;
  std::vector<Witness> witness_;  // by object
  bool flat_ = true;
  bool corrupt_ = false;
  bool comes_or_goes_ = false;  // its changes of triangles are not reported
  TriangleChanges untold_;

  // the present instant
  std::vector<ObjectId> suspects_;  // vertices whose triangles are examined when it is settled
  std::vector<ObjectId> moved_;
  std::vector<ObjectId> waiting_;  // hidden, without a witness
  std::array<ObjectId, 4> last_change_{};
  bool has_last_change_ = false;
  std::uint64_t instant_ = 0;
  std::uint32_t sews_at_instant_ = 0;

  // counts
  std::uint64_t sews_ = 0;
  std::uint64_t blocks_ = 0;
  std::uint64_t waits_ = 0;
  std::uint64_t ties_ = 0;
  std::uint64_t changes_ = 0;  // failures that were repaired by a flip, or by hiding a vertex
  std::size_t largest_sew_ = 0;

  // scratch
  Triangle hint_ = kNone;
  PlaneConflicts conflicts_;
  std::vector<Triangle> fresh_, filled_;
  std::vector<HalfEdge> link_;
};

}  // namespace kinex

#endif

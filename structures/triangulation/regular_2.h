// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: the regular triangulation (weighted Delaunay triangulation) of moving points in the plane
// with weights that move, too: the lower hull of the points lifted to x^2 + y^2 - w. Points above the
// hull are hidden. Discs are points of weight r^2; without weights it is the Delaunay triangulation.
// Hidden points, ties, degenerate instants: regular_triangulation.h.
//
// Certificates. The triangulation is closed to a sphere by a vertex at infinity. One certificate for
// each edge, between two triangles with the apices p and q, for motions and weights of degree D:
//   all four finite     q is not below the plane of the other triangle   power_2,       degree 4D
//                       identically in it: the ties                      orientation_2, degree 2D
//   p or q infinite     the finite triangle is upright                   orientation_2, degree 2D
//   the edge infinite   the hull turns left                              orientation_2, degree 2D
//                       identically on a line: its end is between        obtuse_angle_2, degree 2D
// Four for each hidden point: three orientations and a power.
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
//   efficiency      every event changes triangles, but for `witness`, and for `blocked`, `touch` and some
//                   `retile` of degenerate instants
// Events: each power changes sign at most 4D times, each orientation 2D times: at most
// 4D C(n,4) + 2D C(n,3) changes of the triangulation, and as many failures of witnesses. With ties that
// last at most 8D C(n,4) + 6D C(n,3) changes.
//
// Objects that are all identically on one line, or fewer than three, have no triangles and no
// certificates.
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
//   touch    internal; u v p: p, or a vertex that meets u or v, is on the line of the hull edge u v;
//            a b c d: four lifted points are in one plane
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Edelsbrunner,
// Shah, Incremental topological flipping works for regular triangulations (1996); Devillers, Teillaud
// (2011) for ties.
#ifndef KINEX_STRUCTURES_TRIANGULATION_REGULAR_2_H
#define KINEX_STRUCTURES_TRIANGULATION_REGULAR_2_H

#include <cstdint>
#include <string_view>
#include <vector>

#include "structures/triangulation/plane_regular.h"

namespace kinex {

class Regular2 final : public PlaneRegular {
 public:
  // Kinds of events and their ids: see above.
  enum Kind : std::uint8_t {
    kFlip,
    kEnter,
    kLeave,
    kShow,
    kHide,
    kWitness,
    kRetile,
    kBlocked,
    kTouch
  };

  Regular2(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "regular_2"; }
  std::vector<std::string_view> event_kinds() const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  bool holds_at(const Snapshot& snapshot) const override;

 private:
  using Triangle = Triangulation2::Triangle;
  using Corners = Triangulation2::Corners;

  void flipped(ObjectId u, ObjectId v, ObjectId p, ObjectId q) override;
};

}  // namespace kinex

#endif

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
//   efficiency      every event but that of a new witness changes cells
// Events: each power changes sign at most 5D times, each orientation 3D times: at most
// 5D C(n,5) + 3D C(n,4) changes of the triangulation, and as many failures of witnesses. With ties that
// last at most 15D C(n,5) + 24D C(n,4) changes.
//
// Objects that are all identically in one plane, or fewer than four, have no cells and no certificates.
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
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Edelsbrunner,
// Shah, Incremental topological flipping works for regular triangulations (1996); Devillers, Teillaud
// (2011) for ties.
#ifndef KINEX_STRUCTURES_TRIANGULATION_REGULAR_3_H
#define KINEX_STRUCTURES_TRIANGULATION_REGULAR_3_H

#include <cstdint>
#include <string_view>
#include <vector>

#include "structures/triangulation/regular_triangulation.h"
#include "structures/triangulation/space_flips.h"

namespace kinex {

class Regular3 final : public SpaceFlips<RegularTriangulation<SpaceComplex>> {
 public:
  // Kinds of events and their ids: see above. First those of space_flips.h.
  enum Kind : std::uint8_t { kShow = kSpaceFlips, kHide, kWitness, kRetile, kBlocked, kTouch };

  Regular3(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "regular_3"; }
  std::vector<std::string_view> event_kinds() const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  bool holds_at(const Snapshot& snapshot) const override;

 private:
  bool repair(Facet f) override;
  void add_windings(const std::vector<Cell>& near, std::vector<Cell>& wrong) override;
};

}  // namespace kinex

#endif

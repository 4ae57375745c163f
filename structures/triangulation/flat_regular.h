// SPDX-License-Identifier: GPL-3.0-or-later
// FlatRegular: the regular triangulation of points of space while all of them are identically in one plane, which
// may turn. A part of regular_3 (in_plane.h): regular_2 in projection on two axes. One certificate for each edge,
// motions and weights of degree D:
//   all four finite     q is not below the plane of the other triangle     power_..,        degree 4D
//                       identically in it: the ties                        orientation_..,  degree 2D
//   p or q infinite     the finite triangle is upright                     orientation_..,  degree 2D
//   the edge infinite   the hull turns left                                orientation_..,  degree 2D
//                       identically on a line: its end is between          obtuse_angle_3,  degree 2D
// and four for each hidden point: three orientations and a power. power_.. is that of power_predicates.h (of balls
// disc_power_.., without weights in_circle_..): its sign, times that of an orientation, is that of the power in the
// plane.
//
// Cost: O(n log n) for points that come or go, and for new motions: everything is built anew. Else that of
// regular_2: 5 certificates for a flip, 6 for a point that shows, 7 for one that hides, 4 for another witness;
// 3n' - 3 + 4 (n - n') certificates for n' vertices; 4D C(n,4) + 2D C(n,3) changes at most, 8D C(n,4) + 6D C(n,3)
// with ties that last.
//
// Points that are all identically on one line have no triangles and no certificates, and all pairs for edges, as
// of regular_2.
#ifndef KINEX_STRUCTURES_TRIANGULATION_FLAT_REGULAR_H
#define KINEX_STRUCTURES_TRIANGULATION_FLAT_REGULAR_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/triangulation/in_plane.h"
#include "structures/triangulation/plane_regular.h"

namespace kinex {

class FlatRegular final : public InPlane<PlaneRegular> {
 public:
  // The ranks of its kinds of events.
  struct FlatKinds {
    std::uint8_t flip, enter, leave, show, hide, witness, retile, blocked, touch;
  };

  // Parts "edges" and "hidden" of the structure `id`; `objects`: the number of the scene's; `extents`: of the
  // scene.
  FlatRegular(Kernel& kernel, StructureId id, std::size_t objects, Extents extents,
              const FlatKinds& kinds);

  std::string_view name() const override { return "regular_3"; }
  // Triangulates these points, ascending.
  void build(std::span<const ObjectId> objects) override;
  // New motions: it is to be built anew when the instant is settled.
  void let_go();
  void certificate_failed(CertificateId failed) override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;

  // The number of certificates that it should have.
  std::size_t wanted() const;
  bool empty() const { return empty_; }
  // Adds to `checks` the bounds of what has happened so far.
  void add_bounds_of_events(const BoundContext& context, std::vector<BoundCheck>& checks) const {
    bounds_of_events(context, "plane_", checks);
  }

 private:
  void construct() override;
  void report_change(std::uint8_t kind, const Points& points) override;

  bool empty_ = true;
};

}  // namespace kinex

#endif

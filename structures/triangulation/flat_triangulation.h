// SPDX-License-Identifier: GPL-3.0-or-later
// FlatTriangulation: the Delaunay triangulation of points of space while all of them are identically in one
// plane, which may turn. A part of delaunay_3, whose cells it has none of: all of its events are internal, and
// it tells readers of edges that the structure has changed within.
//
// It is that of regular_2 without weights, in projection on two axes: the first of xy, xz, yz on which the
// plane is not identically upright. One certificate for each edge, motions of degree d:
//   all four finite     q is not inside the circle of the other triangle   in_circle_..,    degree 4d
//                       identically on it: the ties                        orientation_..,  degree 2d
//   p or q infinite     the finite triangle is upright                     orientation_..,  degree 2d
//   the edge infinite   the hull turns left                                orientation_..,  degree 2d
//                       identically on a line: its end is between          obtuse_angle_3,  degree 2d
// with in_circle_.. of space_predicates.h: its sign, times that of an orientation, is that of the circle in
// the plane.
//
// The plane stands upright on its two axes at an instant: all orientations and circles are zero then. If they
// change their signs, the projections of all triangles turn over, and the triangulation stays. It is built
// anew right after the instant, which is a rebuild with a reason, and needs no other axes. Likewise where all
// points meet on a line.
//
//      y          y           y
//      | 0  1     | 0,1       | 1  0      in projection, before, at and after the instant: the plane turns
//      | 2  3     | 2,3       | 3  2      about an axis that is parallel to y
//      '----- x   '----- x    '----- x
//
// Cost: O(n log n) for points that come or go, and for new motions: everything is built anew. A flip makes 5
// certificates. 3n - 3 certificates; 4d C(n,4) + 2d C(n,3) instants at most, 8d C(n,4) + 6d C(n,3) with ties
// that last.
//
// Points that are all identically on one line are a chain along it (KineticList), by the order on the first axis
// that is not identically at right angles to the line: n - 1 certificates of degree d, d C(n,2) passes at most.
// A pass makes 3 certificates. Where the line is at right angles to that axis at an instant, or all points
// meet, the chain is built anew, as the triangulation is.
#ifndef KINEX_STRUCTURES_TRIANGULATION_FLAT_TRIANGULATION_H
#define KINEX_STRUCTURES_TRIANGULATION_FLAT_TRIANGULATION_H

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "structures/parts/kinetic_list.h"
#include "structures/triangulation/plane_flips.h"
#include "structures/triangulation/regular_geometry.h"
#include "structures/triangulation/sewn_triangulation.h"

namespace kinex {

// A change of one or two edges, smaller id first, or of none.
struct EdgeChange {
  std::optional<std::array<ObjectId, 2>> gone, came;
};

class FlatTriangulation final
    : public PlaneFlips<SewnTriangulation<RegularGeometry<PlaneComplex>>> {
 public:
  // The ranks of its kinds of events.
  struct FlatKinds {
    std::uint8_t flip, enter, leave, retile, blocked, touch, pass;
  };

  // A part "edges" of the structure `id`; `objects`: the number of the scene's.
  FlatTriangulation(Kernel& kernel, StructureId id, std::size_t objects, const FlatKinds& kinds);

  std::string_view name() const override { return "delaunay_3"; }
  std::vector<std::string_view> event_kinds() const override { return {}; }
  // Triangulates these points, ascending, no two of them identically equal.
  void build(std::span<const ObjectId> vertices) override;
  // No points.
  void clear() { build({}); }
  // New motions: it is to be built anew when the instant is settled.
  void let_go();
  bool owns(CertificateId certificate) const {
    return facets_.owns(certificate) || line_.slots().owns(certificate);
  }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  bool holds_at(const Snapshot& snapshot) const override;
  std::size_t bytes() const override;

  bool corrupt() const { return corrupt_; }
  // The number of certificates that it should have.
  std::size_t wanted() const {
    return 3 * store_.triangles() / 2 + (line_.size() == 0 ? 0 : line_.size() - 1);
  }
  bool empty() const { return vertices_.empty(); }
  // What it has changed in its last call, if that was one flip.
  const std::optional<EdgeChange>& change() const { return change_; }
  void forget_change() { change_.reset(); }
  // The edges, smaller id first, ascending.
  std::vector<std::array<ObjectId, 2>> edges() const;
  // The other ends of the edges at a vertex, ascending.
  std::vector<ObjectId> neighbours(ObjectId vertex) const;

 private:
  struct AlongLine {
    PredicateId order = 0;
    Query claim(ObjectId a, ObjectId b) const { return Query(order, {a, b}); }
    bool goes_first(ObjectId a, ObjectId b) const { return a < b; }
  };
  // Of distinct points there are no ties, but while motions change.
  static constexpr auto kNoReport = [](ObjectId, ObjectId) {};

  const RegularGeometry<PlaneComplex>& on_axes(std::size_t pair);
  bool stands_upright();

  void set_certificate(Facet f) override;
  void construct() override;
  void construct_line();
  void pass(CertificateId failed);
  StaticResult build_patch(std::span<const ObjectId> vertices) override;
  void filled(const std::vector<Simplex>&, const std::vector<Simplex>&) override {}
  void settle_hidden() override {}
  void flipped(ObjectId u, ObjectId v, ObjectId p, ObjectId q) override;
  void tell_sewn(const AttributeDifference& change) override;
  void tell_rebuilt(const std::string& reason, const AttributeDifference& change) override;

  FlatKinds kinds_;
  std::vector<ObjectId> vertices_;
  std::array<std::optional<RegularGeometry<PlaneComplex>>, 3>
      geometries_;        // that were needed so far
  std::size_t pair_ = 0;  // the axes in use, of kAxisPairs
  KineticList<AlongLine> line_;
  bool stale_ = false;  // motions have changed: let_go()
  std::optional<EdgeChange> change_;
  std::uint64_t looked_at_ =
      0;                    // the number of the last instant at which it could have been upright
  std::uint64_t ties_ = 0;  // certificates of ties that were made
  std::uint64_t flips_ = 0, passes_ = 0;
};

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// FlatTriangulation: the Delaunay triangulation of points of space while all of them are identically in one
// plane, which may turn. A part of delaunay_3 (in_plane.h): regular_2 without weights, in projection on two axes.
// One certificate for each edge, motions of degree d:
//   all four finite     q is not inside the circle of the other triangle   in_circle_..,    degree 4d
//                       identically on it: the ties                        orientation_..,  degree 2d
//   p or q infinite     the finite triangle is upright                     orientation_..,  degree 2d
//   the edge infinite   the hull turns left                                orientation_..,  degree 2d
//                       identically on a line: its end is between          obtuse_angle_3,  degree 2d
// with in_circle_.. of space_predicates.h: its sign, times that of an orientation, is that of the circle in
// the plane.
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
#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/kinetic_list.h"
#include "structures/triangulation/in_plane.h"
#include "structures/triangulation/sewn_triangulation.h"

namespace kinex {

class FlatTriangulation final
    : public InPlane<PlaneFlips<SewnTriangulation<RegularGeometry<PlaneComplex>>>> {
 public:
  // The ranks of its kinds of events.
  struct FlatKinds {
    std::uint8_t flip, enter, leave, retile, blocked, touch, pass;
  };

  // A part "edges" of the structure `id`; `objects`: the number of the scene's.
  FlatTriangulation(Kernel& kernel, StructureId id, std::size_t objects, const FlatKinds& kinds);

  std::string_view name() const override { return "delaunay_3"; }
  // Triangulates these points, ascending, no two of them identically equal.
  void build(std::span<const ObjectId> vertices) override;
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
  std::size_t bytes() const override;

  // The number of certificates that it should have.
  std::size_t wanted() const {
    return 3 * store_.triangles() / 2 + (line_.size() == 0 ? 0 : line_.size() - 1);
  }
  bool empty() const { return vertices_.empty(); }
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

  bool stands_upright() override;
  void set_certificate(Facet f) override;
  void construct() override;
  void construct_line();
  void pass(CertificateId failed);
  StaticResult build_patch(std::span<const ObjectId> vertices) override;
  void filled(const std::vector<Simplex>&, const std::vector<Simplex>&) override {}
  void settle_hidden() override {}

  FlatKinds kinds_;
  std::vector<ObjectId> vertices_;
  KineticList<AlongLine> line_;
  bool stale_ = false;      // motions have changed: let_go()
  std::uint64_t ties_ = 0;  // certificates of ties that were made
  std::uint64_t passes_ = 0;
};

}  // namespace kinex

#endif

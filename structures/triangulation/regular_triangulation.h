// SPDX-License-Identifier: GPL-3.0-or-later
// RegularTriangulation: what regular_2 and regular_3 have in common: the regular triangulation (weighted
// Delaunay triangulation) of moving points with weights that move, too: the lower hull of the points lifted
// by the sum of the squares of their coordinates, less their weights. Points above the hull are hidden. d is
// the number of axes.
//
// Hidden points. Each hidden point h keeps a witness: d + 1 objects, whose simplex contains h (d + 1
// orientations) and whose plane is not above h (a power). The witness need not be a cell of the
// triangulation, nor need its corners be vertices: the lower hull is nowhere above its plane. So flips
// around a hidden point cost it nothing. When a certificate of it fails h is located: it shows, or the cell
// that contains it is the new witness.
//
// Ties. The triangulation right after an instant depends on motions, weights and ids alone: see
// lifted_geometry.h. What decides a tie may change, too: a point that is identically in one lifted plane
// with others shows or not as it crosses planes (lines) through them; points that are identically in one
// plane (on one line) of the hull can pass each other there, while the orientation of all cells at them
// touches zero only. So a claim that is identically zero is replaced by the orientation that decides, or by
// the order in the plane.
//
// Degenerate instants, and hulls that would wind around twice: sewn_triangulation.h. A hidden point whose
// witness fails when others fail, too, waits until all is sewn; then hidden points are located anew.
#ifndef KINEX_STRUCTURES_TRIANGULATION_REGULAR_TRIANGULATION_H
#define KINEX_STRUCTURES_TRIANGULATION_REGULAR_TRIANGULATION_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "structures/parts/ties.h"
#include "structures/triangulation/sewn_triangulation.h"
#include "structures/triangulation/static_regular.h"

namespace kinex {

template <class Complex>
class RegularTriangulation : public SewnTriangulation<RegularGeometry<Complex>> {
 public:
  using Base = SewnTriangulation<RegularGeometry<Complex>>;
  using typename Base::Cell;
  using typename Base::Facet;
  using typename Base::Simplex;

  void build(std::span<const ObjectId> objects) override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  std::size_t bytes() const override;

  // The number of the scene's objects, alive or not.
  std::size_t objects() const { return present_.size(); }
  virtual bool is_vertex(ObjectId object) const { return this->store_.has(object); }
  // The present objects that are no vertices, ascending; if it is flat all of them.
  virtual std::vector<ObjectId> hidden() const;
  // The edges, smaller id first, ascending; if it is flat all pairs of objects.
  virtual std::vector<std::array<ObjectId, 2>> edges() const;
  // A live certificate is one of its own.
  bool owns(CertificateId certificate) const {
    return this->facets_.owns(certificate) || witnesses_.owns(certificate);
  }

 protected:
  using typename Base::Points;
  static constexpr std::size_t kClaims = Complex::kCorners + 1;  // of a witness
  // The ranks of kinds of events.
  struct Kinds {
    std::uint8_t show, hide, witness, retile, blocked, touch;
  };
  // The names of the parts of its certificates.
  struct PartNames {
    std::string facets, witnesses;
  };
  // `facets`: the name of the part of its facets' certificates.
  RegularTriangulation(Kernel& kernel, StructureId id, const Scene& scene,
                       const std::string& facets, Kinds kinds);
  // `objects`: the number of the scene's.
  RegularTriangulation(Kernel& kernel, StructureId id, std::size_t objects,
                       RegularGeometry<Complex> geometry, const PartNames& parts, Kinds kinds);

  // ---- what its structures add
  // Makes the flip of the facet, or hides a vertex, and reports it; false, with nothing changed: no flip is
  // possible.
  virtual bool repair(Facet f) = 0;
  // Reports that the first point shows or hides, in a cell of the others, which ascend.
  virtual void report_change(std::uint8_t kind, const Points& points) {
    this->report_points(kind, points, true);
  }
  void set_certificate(Facet f) override;
  void construct() override;
  StaticResult build_patch(std::span<const ObjectId> vertices) override;
  void filled(const std::vector<Simplex>& old, const std::vector<Simplex>& filling) override;
  void settle_hidden() override;

  // The vertex, of degree d + 1, sinks below the cell of its neighbours, which may be a ghost. False, with
  // nothing changed: it does not.
  bool hide(ObjectId v);
  void drop_all_witnesses();
  // A certificate has failed, for nothing but the counts.
  void count_failure(CertificateId failed);
  // Appends the bounds of what there is and of what has happened. `more`: certificates besides its own;
  // `prefix`: of names.
  void bounds_of_state(const BoundContext& context, std::size_t more,
                       std::vector<BoundCheck>& checks) const;
  void bounds_of_events(const BoundContext& context, const std::string& prefix,
                        std::vector<BoundCheck>& checks) const;

  std::vector<bool> present_;

 private:
  // Of a hidden point: objects and certificates; the last claims the power, the others that the point is on
  // the inner side of the facet opposite a corner.
  struct Witness {
    Simplex corners;
    std::array<CertificateId, kClaims> certificates;
    Witness() {
      corners.fill(kNoObject);
      certificates.fill(kNoCertificate);
    }
    bool there() const { return corners[0] != kNoObject; }
    bool names(ObjectId v) const {
      return std::find(corners.begin(), corners.end(), v) != corners.end();
    }
  };

  // ---- regular_triangulation.cpp: certificates

  // ---- regular_hidden.cpp: hidden points
  Query witness_query(ObjectId h, std::size_t i) const;
  void set_witness(ObjectId h, Cell c);
  void drop_witness(ObjectId h);
  void witness_failed(ObjectId h);
  void wait(ObjectId h);
  Cell locate_hidden(ObjectId h) const;
  // A point that was located in c is in conflict with it. It is strictly beyond a ghost, where an inexact
  // arithmetic may say otherwise when asked again.
  bool shows_in(Cell c, ObjectId h) const {
    return this->store_.ghost(c) || this->geometry_.conflict(this->store_, c, h);
  }
  bool show(ObjectId h, Cell c);
  void put_in(ObjectId object);
  void certify_inside();
  void certify_rim();

  Kinds kinds_;
  Slots witnesses_;
  Ties witness_ties_;
  std::vector<Witness> witness_;   // by object
  std::vector<ObjectId> waiting_;  // hidden, without a witness

  // counts
  std::uint64_t waits_ = 0;
  std::uint64_t ties_ = 0;
  std::uint64_t changes_ = 0;  // flips, points that showed or hid

  std::vector<Facet> rim_;  // scratch
};

}  // namespace kinex

#endif

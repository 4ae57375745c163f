// SPDX-License-Identifier: GPL-3.0-or-later
// SewnTriangulation: what delaunay_3, regular_2 and regular_3 have in common: cells, closed to a sphere by a
// vertex at infinity, one certificate for each facet, and the repair of degenerate instants.
//
// Where several certificates fail at one instant, or a flip would make a flat cell, flips do not suffice. A
// flip is made only if its new cells are upright right after now and what they share is not there yet;
// otherwise the facet has no certificate for the moment ("blocked"). When the instant is settled, the cells
// about the points that took part are examined, and those that cannot stay are sewn. Some cells are wrong:
// S. They are cut out, and the hole is filled with cells C of the static triangulation R of their vertices:
//   1. Every facet on the rim of S must be a facet of R, with a cell of R on its inner side. Else the
//      cell outside it joins S.
//   2. C: the cells of R that are reached from there without crossing the rim. Every vertex of R must be in
//      C. Else all cells across the rim join S.
//   3. No facet on the rim may be in conflict with the cell outside. Else that cell joins S.
//   4. No face inside C may exist outside of it. Else the cells there join S.
// In the plane, with the rim drawn; v: a vertex of S; x: a cell of R beyond the rim, left out:
//
//    v-----v             v-----v             v-----v
//    |     |             |  \ C|x\           |  \  |
//    |  S  v---v         | C   v---v         |     v---v
//    |         |         |  / C  \C|         |  /    \ |
//    v---------v         v---------v         v---------v
//    S, cut out          R                   the hole filled with C
//
// All else is right by itself: the cells of C are upright, and the facets between them regular. A
// triangulation that is locally regular everywhere, and goes round everywhere once, is regular, and the one
// with the ties of lifted_geometry.h is unique. It ends, because S grows. If S has become everything, the
// static algorithm builds all of it.
#ifndef KINEX_STRUCTURES_TRIANGULATION_SEWN_TRIANGULATION_H
#define KINEX_STRUCTURES_TRIANGULATION_SEWN_TRIANGULATION_H

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/parts/slots.h"
#include "structures/triangulation/point_location.h"
#include "structures/triangulation/static_result.h"

namespace kinex {

// Geometry: a LiftedGeometry with claim(simplex, place, apex), claim_of_tie and is_bad of a facet: a
// RegularGeometry.
//
// Touches. Two things can go wrong without a failure, so the certificates of facets fail at touches, too:
//   - A cell turns over. It is flat at an instant at which its sphere is finite: all its powers are zero
//     then, and each may touch zero only.
//   - Cells wind around twice. Where vertices of a facet of the hull come to be on one line (in the plane:
//     at one place) the orientations at it touch zero only if its neighbours cross it just then. The star
//     of any other vertex winds around twice only if the hull does.
//
//            v  u           x             In the plane. Before, after: u and v on the hull meet at height
//    .   x         y   .        v  u   y  0 and pass, x and y cross that height. All turns are left turns,
//                                         before and after; after they add up to two full turns.
template <class Geometry>
class SewnTriangulation : public Structure {
 public:
  using Complex = typename Geometry::Complex;
  using Store = typename Complex::Store;
  using Cell = typename Complex::Cell;
  using Facet = typename Complex::Facet;
  using Simplex = typename Complex::Simplex;

  void rebuild() override;
  void instant_settled() override;
  // The finite cells.
  Attribute attribute() const override;
  Attribute told() const override { return untold_.undone(attribute()); }
  std::uint64_t most_repairs(std::uint64_t) const override { return 0; }

  StructureId id() const { return id_; }
  // All points are in one plane (on one line), or there are too few: there are no cells.
  bool flat() const { return flat_; }
  // Parts that were sewn, and the number of cells of the largest.
  std::uint64_t sews() const { return sews_; }
  std::size_t largest_sew() const { return largest_sew_; }
  const Store& triangulation() const { return store_; }

 protected:
  static constexpr std::uint32_t kNone = Complex::kNone;
  static constexpr std::uint32_t kMostSews = 100;  // at an instant of an inexact arithmetic
  static constexpr std::size_t kPoints = Complex::kCorners + 1;
  // The points of two cells that share a facet.
  using Points = std::array<ObjectId, kPoints>;
  // The ranks of two kinds of events.
  struct Kinds {
    std::uint8_t retile, blocked, touch;
  };
  // What a sew takes away and brings besides the vertices of its cells.
  struct Guests {
    std::vector<ObjectId> gone, came;
  };

  // `part`: the name of the part of its facets' certificates.
  SewnTriangulation(Kernel& kernel, StructureId id, std::size_t objects, Geometry geometry,
                    const std::string& part, Kinds kinds);

  // ---- what its structures add
  // Certifies the facet: its claim, or that of its tie. If that is identically zero, too, a cell is flat or
  // the hull is folded, which is mended when the instant is settled.
  virtual void set_certificate(Facet f) = 0;
  // Builds everything by the static algorithm.
  virtual void construct() = 0;
  // Triangulates the vertices, ascending, in `patch_`.
  virtual StaticResult build_patch(std::span<const ObjectId> vertices) = 0;
  // Cells `old` have been replaced by `filling`.
  virtual void filled(const std::vector<Simplex>& old, const std::vector<Simplex>& filling) = 0;
  // A part has been sewn: filled() with what build_patch() made.
  virtual void sewn() {}
  // Adds to `wrong` cells of `near`, those about the points that took part, which wind around twice.
  virtual void add_windings(const std::vector<Cell>& near, std::vector<Cell>& wrong) = 0;
  // All cells are mended.
  virtual void settle_hull() {}
  // All vertices are in order; hidden points follow.
  virtual void settle_hidden() = 0;
  // Parts were sewn at the instant, or everything was built anew: reports the change of the cells.
  virtual void tell_sewn(const AttributeDifference& change);
  virtual void tell_rebuilt(const std::string& reason, const AttributeDifference& change);
  // New motions while all points are in one plane (on one line).
  virtual void sort_out_flat();

  // ---- certificates
  Query claim_of(Facet f) const {
    return geometry_.claim(Complex::simplex(store_, Complex::cell(f)), Complex::place(f),
                           store_.apex(Complex::mate(store_, f)));
  }
  // What has to hold where claim_of(f) is identically zero.
  Query tie_claim_of(Facet f) const {
    return geometry_.claim_of_tie(Complex::simplex(store_, Complex::cell(f)), Complex::place(f),
                                  store_.apex(Complex::mate(store_, f)));
  }
  // New motions of v: which of its claims are identically zero may have changed.
  void renew_about(ObjectId v);
  void drop_certificate(Facet f);
  void drop_all_certificates();
  void certify_everything();
  // The vertices of the cell of f, in its order, and the apex on the other side.
  Points points_of(Facet f) const;
  void give_up(const std::string& what);

  // ---- the present instant
  void suspect(ObjectId v) {
    if (v != store_.infinity()) suspects_.push_back(v);
  }
  template <class Some>
  void suspect_all(const Some& points) {
    for (const ObjectId v : points) suspect(v);
  }
  // A change of these points. The only one at an instant is examined if another one follows.
  void note_change(const Points& points);
  // A change has renewed the certificates of `rim`; `zeros`: possible_zeros() before.
  void after_change(std::span<const Facet> rim, std::uint64_t zeros);
  // True if the failed certificate is zero at now only, and positive right after: it is certified again, and
  // a touch is reported. Never so in an inexact arithmetic.
  bool touched(Facet f);
  // No flip is possible yet: the facet goes without a certificate until the instant is settled.
  void blocked(Facet f);
  // Reports an event of these points, without the last one if that is infinity.
  template <std::size_t kCount>
  void report_points(std::uint8_t kind, const std::array<ObjectId, kCount>& ids, bool external);

  // ---- sewing
  // False: everything is to be built anew.
  bool sew(std::vector<Cell> cells, const Guests& guests);
  // Replaces cells, with their certificates. False, with nothing changed, if the new ones do not fit.
  bool fill(const std::vector<Cell>& cells, const std::vector<Simplex>& filling);
  void rebuild_because(const std::string& reason);
  Cell hint() const;
  std::size_t common_bytes() const;

  Kernel* kernel_;
  StructureId id_;
  Geometry geometry_;
  Slots facets_;  // tag: a facet; the slot is its label
  Store store_;
  Store patch_;  // of sews
  bool flat_ = true;
  bool corrupt_ = false;
  bool comes_or_goes_ = false;  // its changes of cells are not reported
  typename Complex::Changes untold_;

  std::vector<ObjectId> suspects_;  // vertices whose cells are examined when the instant is settled
  std::vector<ObjectId> moved_;
  std::uint64_t sews_ = 0;
  std::uint64_t blocks_ = 0;
  Cell hint_ = kNone;
  Conflicts<Complex> conflicts_;
  std::vector<Cell> fresh_;

 private:
  static constexpr int kMostWindings = 8;  // sews in a row, each because of the one before
  bool sew_once(std::vector<Cell> cells, const Guests& guests);
  bool find_patch(const std::vector<Facet>& rim, const std::vector<ObjectId>& vertices,
                  std::vector<Simplex>& filling, std::vector<Cell>& more) const;
  bool is_degenerate_now(const Points& ids) const;
  std::vector<Cell> wrong_cells();
  void add_cells_at_meetings(std::vector<Cell>& cells) const;
  void mend();

  Kinds kinds_;
  Points last_change_{};
  bool has_last_change_ = false;
  std::uint64_t instant_ = 0;
  std::uint32_t sews_at_instant_ = 0;
  std::size_t largest_sew_ = 0;

 protected:
  void forget_instant() {
    suspects_.clear();
    has_last_change_ = false;
  }
};

template <class Geometry>
template <std::size_t kCount>
void SewnTriangulation<Geometry>::report_points(std::uint8_t kind,
                                                const std::array<ObjectId, kCount>& ids,
                                                bool external) {
  [&]<std::size_t... kPlaces>(std::index_sequence<kPlaces...>) {
    if (ids.back() == store_.infinity()) {
      kernel_->report(id_, kind, {ids[kPlaces]...}, external);
    } else {
      kernel_->report(id_, kind, {ids[kPlaces]..., ids.back()}, external);
    }
  }
  (std::make_index_sequence<kCount - 1>());
}

}  // namespace kinex

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Calipers: the vertices that rotating calipers touch when they are flush with an edge of a convex
// hull: the antipodal vertex of every edge, or the three vertices that a rectangle on it touches.
//
// `folds` is 2 (parallel calipers) or 4 (two pairs at right angles). An edge is named by its tail.
// The directions of all edges are kept in one cyclic list by their angle modulo 360/folds degrees.
// For each two neighbours of the list, `turn` folds rotate the first to just before the second.
//
//     folds = 2            c                   list, modulo 180 degrees:  a, c, b, a ..
//                        /   \                 turns                       1  1  1
//                      /       \               contact(a, 1) = c: the tail of the first edge at or
//                    a --------- b             after the direction of edge a, rotated half a turn
//
// Certificates. For neighbours e, f of the list whose turn k is not 0: rot_k(e) is not after f.
// k = folds/2: e, f are antiparallel or before (an orientation, or slope_order_2); a quarter turn:
// perpendicular or before (edge_dot_2). Degree 2d. With turn 0, f is the hull's next edge after e,
// and the hull proves their order.
//
// Why it is a proof. All turns of the list together are one fold less than a whole number of
// rotations. If every two neighbours are in order, the list is sorted, provided that it winds once;
// the number of windings changes only where all points are on one line. So the list is changed by
// single vertices that come or go between two neighbours, and built anew after all other changes.
//
// Quality, for h vertices: at most h certificates, a vertex is in 4 of them at most; a failure
// renews 3. A vertex that comes or goes between its neighbours renews 3, and causes a failure for
// each edge that its direction has to pass. build() computes O(h log h) signs and keeps the
// certificates that stay the same.
//
// Ties. Directions that are identically equal modulo the fold stand in the order of their tails.
// Where an edge is identically tangent, contact() is one of its ends, and least_contact() the
// smaller one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 6.7;
// Agarwal, Guibas, Hershberger, Veach, "Maintaining the extent of a moving point set" (2001).
#ifndef KINEX_STRUCTURES_EXTENT_CALIPERS_H
#define KINEX_STRUCTURES_EXTENT_CALIPERS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "structures/hull/hull_source.h"
#include "structures/parts/shared_queries.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"

namespace kinex {

class Calipers {
 public:
  struct Swap {  // two edges that have changed places in the list
    ObjectId first, second;
    int turn;
  };

  Calipers(Kernel& kernel, StructureId structure, int folds);

  int folds() const { return folds_; }
  // As last built or changed. There is a list if it has 3 vertices or more.
  const HullRing& ring() const { return ring_; }
  bool has_list() const { return ring_.size() >= 3; }
  // The vertex that the direction of `edge`, rotated by k folds, touches; 0 < k < folds. Requires a
  // list.
  ObjectId contact(ObjectId edge, int k) const { return state_[edge].contact[index(k)]; }
  ObjectId least_contact(ObjectId edge, int k) const;
  // The edges by angle modulo the fold, from the smallest tail on; for tests and drawings. O(h).
  std::vector<ObjectId> list() const;
  CertificateId certificate(ObjectId edge) const { return state_[edge].certificate; }

  // The list of this ring, right after now.
  void build(const HullRing& ring);
  // `vertex` comes between `from` and `to`, or leaves. False if that contradicts the ring or the
  // list: the caller has to build().
  bool enter(ObjectId vertex, ObjectId from, ObjectId to);
  bool leave(ObjectId vertex);
  bool owns(CertificateId certificate) const { return slots_.owns(certificate); }
  // A certificate has failed: its two edges change places.
  Swap failed(CertificateId failed);
  // The same, but the list is left as it is: the caller has to build() at this instant.
  Swap dropped(CertificateId failed);
  void motions_changed(std::span<const ObjectId> objects);
  // Drops everything; the next build() makes every certificate anew.
  void clear();

  // The tails of edges that have come, gone, or changed their head or a contact, in some order; a
  // tail may occur twice. They are numbered from 0 on, so that several readers can follow.
  std::uint64_t changes_end() const { return forgotten_ + changes_.size(); }
  // Those from number `from` on; nullopt if some of them have been forgotten. Valid until the next
  // change.
  std::optional<std::span<const ObjectId>> changes_since(std::uint64_t from) const {
    if (from < forgotten_) return std::nullopt;
    return std::span(changes_).subspan(static_cast<std::size_t>(from - forgotten_));
  }
  std::size_t changes_held() const { return changes_.size(); }
  void forget_changes() {
    forgotten_ += changes_.size();
    changes_.clear();
  }

  const Slots& slots() const { return slots_; }
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  struct Edge {  // by its tail
    ObjectId after = kNoObject, before = kNoObject;  // in the list
    std::uint8_t turn = 0;                           // from this edge to `after`
    std::array<ObjectId, 3> contact{kNoObject, kNoObject, kNoObject};
    CertificateId certificate = kNoCertificate;  // of this edge and `after`
  };
  // An edge in a build: its arc is the number of folds from the first edge's direction to its own.
  struct Placed {
    ObjectId edge;
    std::uint8_t arc;
    std::uint32_t place;  // on the hull
  };
  static std::size_t index(int k) { return static_cast<std::size_t>(k - 1); }
  int modulo(int k) const { return ((k % folds_) + folds_) % folds_; }
  int quarters(int k) const { return folds_ == 2 ? 2 * k : k; }
  // "rot_k(e) is not after f".
  Query claim(ObjectId e, ObjectId f, int k) const;
  void make_room(ObjectId vertex);
  void link(ObjectId e, ObjectId f, int turn);
  void certify(ObjectId e);
  void swap(ObjectId e);
  void settle();
  Swap swap_of(ObjectId e) const { return {e, state_[e].after, state_[e].turn}; }
  // ---- calipers_build.cpp
  std::vector<Placed> placed(const std::vector<ObjectId>& cycle) const;
  bool stands_before(const Placed& a, const Placed& b) const;
  void set_contacts(const std::vector<Placed>& sorted, const std::vector<Placed>& placed);

  Kernel* kernel_;
  int folds_;
  Slots slots_;
  PredicateId slope_, turn_, dot_;
  SharedQueries dots_;  // of two edges, which may share a vertex
  HullRing ring_;
  std::vector<Edge> state_;  // by object
  Ties ties_;
  std::vector<ObjectId> changes_;
  std::uint64_t forgotten_ = 0;  // changes before these
};

}  // namespace kinex

#endif

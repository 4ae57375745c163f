// SPDX-License-Identifier: GPL-3.0-or-later
// NearestSite: the site that is nearest to a moving query point. Sites are the other points.
//
// Certificates. It watches the Delaunay triangulation of the sites (delaunay_2, in space delaunay_3)
// and keeps one certificate for each neighbour r of the nearest site s: "s is at most as far from the
// query q as r", degree 2d for motions of degree d.
//
//            r1____r2
//            / \  / \         q is in the Voronoi cell of s iff no Delaunay neighbour of s is
//          r6---s----r3       nearer. When the certificate of r2 fails, q enters the cell of r2,
//            \ / q\ /         and r2 is the nearest site: its neighbours are compared from then on.
//            r5----r4
//
// Quality, for n sites: as many certificates as s has neighbours, at most n - 1, and in the plane fewer
// than 6 on average over the sites; the query is in all of them. A failure makes the certificates of
// another star; a flip renews at most two. None of its own failures is internal, but for several at one
// instant: each changes the nearest site. With the flips of the triangulation, most of which do not, it is
// not efficient. External events: those of minimum_tournament by the squared distance
// to q, at most lambda_2d(n) - 1 without flight-plan changes: 2n - 2 for linear motion. An insertion or
// erasure walks to the nearest site, to ever smaller distances.
//
// Ties. Of sites at identically equal distances the smallest id. Those sites lie on an empty circle or
// sphere, or are equal: the smallest is a neighbour of the others, or their vertex.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_PROXIMITY_NEAREST_SITE_H
#define KINEX_STRUCTURES_PROXIMITY_NEAREST_SITE_H

#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"
#include "structures/proximity/delaunay_edges.h"

namespace kinex {

class NearestSite final : public Structure {
 public:
  // kReplace: another site is nearest: the old one, the new one. kTie: the same, because the
  // distances have become identically equal.
  enum Kind : std::uint8_t { kReplace, kTie };

  // `triangulation`, of the sites, outlives this structure and is watched by it.
  NearestSite(Kernel& kernel, StructureId id, DelaunayGraph triangulation, ObjectId query);

  std::string_view name() const override { return "nearest_site"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  // The triangulation may have changes that it has not reported yet.
  void instant_settled() override {
    if (kernel_->instant_is_shared(triangulation_.id())) follow(std::nullopt);
  }
  void instant_over() override { events_.over(site_); }
  void watched_changed(const Event* event) override { follow(triangulation_.told(event)); }
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return events_.bytes() + ties_.bytes() + rivals_.size() * (sizeof(ObjectId) + 48);
  }

 private:
  Query claim(ObjectId near, ObjectId far) const { return Query(distance_, {near, far, query_}); }
  bool in_front(ObjectId a, ObjectId b) const;
  void walk(ObjectId from);
  void prove();
  void follow(const std::optional<DelaunayEdgeChange>& change);
  void settle_ties();
  void begin();

  Kernel* kernel_;
  StructureId id_;
  DelaunayGraph triangulation_;
  ObjectId query_;
  PredicateId distance_;
  Slots slots_;
  Ties ties_;
  AttributeEvents events_;
  bool asked_ = false;                        // the query is there
  ObjectId site_ = kNoObject;                 // the nearest one; kNoObject: there is none
  std::map<ObjectId, CertificateId> rivals_;  // its neighbours; the tag is the neighbour
};

}  // namespace kinex

#endif

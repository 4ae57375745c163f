// SPDX-License-Identifier: GPL-3.0-or-later
// ConeOffers: the points of the plane in the orders by x, y, x + y and x - y, and range trees over
// these that offer pairs of points in cones: octants or quadrants (cone_pairs.h).
//
//     sorted lists         range trees, one a cone
//     x      ---+          0 < y < x    by y and x - y, first along x   ---+
//     y      ---+------->  0 < x < y    by x and x - y, first along y   ---+---> offers, each of
//     x + y  ---+          0 < -x < y   by x and x + y, first along y   ---+
//     x - y  ---+          0 < y < -x   by y and x + y, first along -x  ---+
//               exchanges  or
//                          0 < x, y     by y and x, first along x + y   ---+---> offers
//                          0 < -x, y    by y and x, first along y - x   ---+
//
// The other cones are those of the pairs read from their other ends. Points that are level are in
// the order after an infinitesimal turn, equal points by id (turned_order.h).
//
// Certificates: the order of two neighbours, n - 1 a list, degree d for motions of degree d. An
// exchange of neighbours makes O(log^2 n) steps in the range trees, an insertion or erasure amortised
// O(log^3 n), and O(n log^2 n) where an inexact arithmetic puts other points in another order at it.
#ifndef KINEX_STRUCTURES_PROXIMITY_CONE_OFFERS_H
#define KINEX_STRUCTURES_PROXIMITY_CONE_OFFERS_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/axis_labels.h"
#include "structures/parts/kinetic_list.h"
#include "structures/proximity/cone_frame.h"
#include "structures/proximity/cone_pairs.h"
#include "structures/proximity/turned_order.h"

namespace kinex {

class ConeOffers {
 public:
  enum class Cones : std::uint8_t { kOctants, kQuadrants };
  // The second point is behind the first along the projection, or, reversed, in front of it.
  struct Offer {
    ObjectId looker = kNoObject, seen = kNoObject;
    OctantAxis projection = kAlongX;
    bool reversed = false;
  };
  // changed(offer, +1) when a node of a tree makes it, changed(offer, -1) when one withdraws it.
  using Changed = std::function<void(const Offer&, int)>;
  // Called with two neighbours of a list that have changed places: the one that was in front first.
  using Exchanged = std::function<void(ObjectId, ObjectId)>;
  struct Exchange {  // two neighbours of a list that have changed places
    std::size_t list;
    ObjectId before, after;
  };

  // `classes`: for KeptPoints::kOneOfEachColour; it outlives this.
  ConeOffers(Kernel& kernel, StructureId id, std::size_t objects, Cones cones, KeptPoints kept,
             const TwoClasses* classes, Changed changed);
  ConeOffers(const ConeOffers&) = delete;  // the range trees know its labels
  ConeOffers& operator=(const ConeOffers&) = delete;

  void build(std::span<const ObjectId> objects);
  void rebuild();
  void insert(ObjectId object);
  void erase(ObjectId object);
  // nullopt: the certificate is not one of these. Otherwise two neighbours have changed places.
  std::optional<Exchange> failed(CertificateId failed);
  // After failed(), when its exchange has been reported.
  void settle(std::size_t list, const Exchanged& exchanged);
  // Two points that were level by a first key may be so no more, or have become it.
  void motions_changed(std::span<const ObjectId> objects, const Exchanged& exchanged);

  // At places from 2^32 on.
  void visit_proof(ProofVisitor& visitor) const;
  // Of n points: the most certificates, and the most offers of all nodes, twice as many if points
  // have come or gone.
  static Integer most_certificates(std::size_t n);
  static Integer most_offers(Cones cones, KeptPoints kept, const BoundContext& context);
  // On events of the kind "order" without flight-plan changes.
  static BoundCheck bound_on_exchanges(std::string_view structure, const BoundContext& context);
  void check(AuditReport& report) const;
  // The lists against the points sorted at exact positions.
  void audit(const Snapshot& snapshot, AuditReport& report) const;
  std::size_t bytes() const;

 private:
  struct Cone;
  using List = KineticList<TurnedOrder>;
  static std::span<const Cone> cones_of(Cones cones);
  void make_trees();
  // Gives a point of all lists a label in each.
  void label(ObjectId object);
  void exchange(std::size_t list, ObjectId before, ObjectId after);

  std::span<const Cone> cones_;
  std::vector<List> lists_;                        // by OctantAxis
  std::vector<AxisLabels> labels_;                 // of the lists; they stay where they are
  std::vector<std::unique_ptr<ConePairs>> trees_;  // by cone
};

}  // namespace kinex

#endif

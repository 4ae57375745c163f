// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cone_offers.h"

#include <string>
#include <utility>

#include "structures/proximity/static_order_audit.h"

namespace kinex {

// A cone by three orders, each along an axis or against it.
struct ConeOffers::Cone {
  OctantAxis alpha, beta, projection;
  bool against_alpha, against_beta, against_projection;
};

// One of each two opposite ones.
std::span<const ConeOffers::Cone> ConeOffers::cones_of(Cones cones) {
  static constexpr Cone kOctants[] = {
      {kAlongY, kAlongDifference, kAlongX, false, false, false},  // 0 < y < x, by x
      {kAlongX, kAlongDifference, kAlongY, false, true, false},   // 0 < x < y, by y
      {kAlongX, kAlongSum, kAlongY, true, false, false},          // 0 < -x < y, by y
      {kAlongY, kAlongSum, kAlongX, false, true, true},           // 0 < y < -x, by -x
  };
  static constexpr Cone kQuadrants[] = {
      {kAlongY, kAlongX, kAlongSum, false, false, false},       // 0 < x, y, by x + y
      {kAlongY, kAlongX, kAlongDifference, false, true, true},  // 0 < -x, y, by y - x
  };
  if (cones == Cones::kOctants) return kOctants;
  return kQuadrants;
}

ConeOffers::ConeOffers(Kernel& kernel, StructureId id, std::size_t objects, Cones cones,
                       KeptPoints kept, const TwoClasses* classes, Changed changed)
    : cones_(cones_of(cones)) {
  labels_.reserve(kOctantAxes);
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_.emplace_back(kernel, id, octant_axis_name(static_cast<OctantAxis>(axis)),
                        TurnedOrder(kernel, octant_axis(static_cast<OctantAxis>(axis))), objects);
    labels_.emplace_back(objects);
  }
  for (const Cone& cone : cones_) {
    trees_.push_back(make_cone_pairs(
        kept,
        {PlacesAlong(labels_[cone.alpha], cone.against_alpha),
         PlacesAlong(labels_[cone.beta], cone.against_beta),
         PlacesAlong(labels_[cone.projection], cone.against_projection)},
        objects, classes, [changed, &cone](ObjectId looker, ObjectId seen, int change) {
          changed({looker, seen, cone.projection, cone.against_projection}, change);
        }));
  }
}

// ---- trees

void ConeOffers::make_trees() {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    const std::vector<ObjectId> order = lists_[axis].items();
    labels_[axis].assign(order, AxisLabels::bits_for(order.size()));
  }
  const std::vector<ObjectId> points = lists_[kAlongX].items();
  for (const auto& tree : trees_) tree->build(points);
}

void ConeOffers::label(ObjectId object) {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    const List& list = lists_[axis];
    AxisLabels& labels = labels_[axis];
    if (const auto moves = labels.room_between(list.previous(object), object, list.next(object))) {
      labels.apply(*moves);
    } else {
      labels.assign(list.items(), AxisLabels::bits_for(list.size()) + 1);
    }
  }
}

// Two neighbours of a list have changed places.
void ConeOffers::exchange(std::size_t list, ObjectId before, ObjectId after) {
  labels_[list].exchange(before, after);
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    if (cones_[i].alpha == list) trees_[i]->alpha_changed(before, after);
    if (cones_[i].beta == list) trees_[i]->beta_changed(before, after);
    if (cones_[i].projection == list) trees_[i]->projection_changed(before, after);
  }
}

// ---- changes

void ConeOffers::build(std::span<const ObjectId> objects) {
  for (List& list : lists_) list.build({objects.begin(), objects.end()}, [](Item, Item) {});
  make_trees();
}

void ConeOffers::rebuild() {
  const std::vector<ObjectId> objects = lists_[kAlongX].items();
  build(objects);
}

// In an inexact arithmetic the lists may put ties in order, too.
void ConeOffers::insert(ObjectId object) {
  bool others_moved = false;
  for (List& list : lists_) list.insert(object, [&](Item, Item) { others_moved = true; });
  if (others_moved) return make_trees();
  label(object);
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const List& list = lists_[cones_[i].alpha];
    const bool against = cones_[i].against_alpha;
    trees_[i]->insert(object, against ? list.next(object) : list.previous(object));
  }
}

void ConeOffers::erase(ObjectId object) {
  for (const auto& tree : trees_) tree->erase(object);
  bool others_moved = false;
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_[axis].erase(object, [&](Item, Item) { others_moved = true; });
    labels_[axis].erase(object);
  }
  if (others_moved) make_trees();
}

std::optional<ConeOffers::Exchange> ConeOffers::failed(CertificateId failed) {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    if (!lists_[axis].slots().owns(failed)) continue;
    const auto [before, after] = lists_[axis].failed(failed);
    exchange(axis, before, after);
    return Exchange{axis, before, after};
  }
  return std::nullopt;
}

void ConeOffers::settle(std::size_t list, const Exchanged& exchanged) {
  lists_[list].settle([&](Item before, Item after) {
    exchanged(before, after);
    exchange(list, before, after);
  });
}

void ConeOffers::motions_changed(std::span<const ObjectId> objects, const Exchanged& exchanged) {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_[axis].renew(objects, [&](Item before, Item after) {
      exchanged(before, after);
      exchange(axis, before, after);
    });
  }
}

// ---- checks

void ConeOffers::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  std::uint64_t place = std::uint64_t{1} << 32;
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    group.kind = "neighbours";
    group.text = std::string("by ") + octant_axis_name(static_cast<OctantAxis>(axis));
    lists_[axis].each_link([&](Item a, Item b, CertificateId certificate) {
      group.about = {a, b};
      group.place = ++place;
      visitor.group(group);
      visitor.certificate(certificate, "in order");
    });
  }
}

Integer ConeOffers::most_certificates(std::size_t n) { return counted(n == 0 ? 0 : 4 * (n - 1)); }

Integer ConeOffers::most_offers(Cones cones, KeptPoints kept, const BoundContext& context) {
  const std::size_t n = context.objects();
  std::size_t depth = 0;
  while ((std::size_t{1} << depth) < n) ++depth;
  if (context.dynamic) depth *= 2;  // place_tree.h
  return counted(cones_of(cones).size() * kinex::most_offers(kept) * n * depth);
}

BoundCheck ConeOffers::bound_on_exchanges(std::string_view structure, const BoundContext& context) {
  const auto orders = context.ledger->by_kind.find("order");
  return at_most(std::string(structure) + ".order",
                 "each two points change their order in each list at most d times",
                 Integer(4 * context.degree) * pairs(counted(context.objects())),
                 counted(orders == context.ledger->by_kind.end() ? 0 : orders->second));
}

void ConeOffers::check(AuditReport& report) const {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_[axis].check(report, octant_axis_name(static_cast<OctantAxis>(axis)));
    report.check(labels_[axis].consistent() && labels_[axis].in_order() == lists_[axis].items(),
                 [] { return "labels that are out of date"; });
  }
  for (const auto& tree : trees_) tree->check(report);
}

void ConeOffers::audit(const Snapshot& snapshot, AuditReport& report) const {
  for (std::size_t i = 0; i < kOctantAxes; ++i) {
    check_order(snapshot, static_cast<OctantAxis>(i), lists_[i].items(), report);
  }
}

std::size_t ConeOffers::bytes() const {
  std::size_t total = 0;
  for (const List& list : lists_) total += list.bytes();
  for (const AxisLabels& labels : labels_) total += labels.bytes();
  for (const auto& tree : trees_) total += tree->bytes();
  return total;
}

}  // namespace kinex

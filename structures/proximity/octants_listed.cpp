// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/octants_listed.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/proximity/static_order_audit.h"

namespace kinex {

OctantsListed::OctantsListed(Kernel& kernel, StructureId id, const Scene& scene)
    : ConeNeighbours(kernel, id, octant_frame(), scene.objects.size(),
                     [this](std::size_t axis, ObjectId a, ObjectId b) {
                       return places_[axis][a] < places_[axis][b];
                     }) {
  const std::size_t objects = scene.objects.size();
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    const auto along = static_cast<OctantAxis>(axis);
    lists_.emplace_back(kernel, id, octant_axis_name(along),
                        TurnedOrder(kernel, octant_axis(along)), objects);
    places_[axis].assign(objects, 0);
  }
}

// ---- the woods

void OctantsListed::number_places() {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    std::uint32_t place = 0;
    for (const ObjectId object : lists_[axis].items()) places_[axis][object] = place++;
  }
}

// Those that wait.
void OctantsListed::make_woods() {
  ConeWoods::Lists points(kOctantAxes);
  for (std::size_t i = 0; i < woods().size(); ++i) {
    if (!waits_[i]) continue;
    for (std::size_t axis = 0; axis < kOctantAxes; ++axis) points[axis] = lists_[axis].items();
    woods().make(i, points);
    waits_[i] = false;
  }
}

// Two neighbours of a list have changed places.
void OctantsListed::exchange(OctantAxis axis, ObjectId before, ObjectId after) {
  std::swap(places_[axis][before], places_[axis][after]);
  for (std::size_t i = 0; i < woods().size(); ++i) {
    const auto& orders = frame().woods[i];
    for (std::size_t order = 0; order < orders.size(); ++order) {
      if (orders[order].axis != axis || waits_[i]) continue;
      const bool reversed = orders[order].reversed;
      const auto swapped =
          woods().wood(i).swap(order, reversed ? after : before, reversed ? before : after);
      waits_[i] = swapped == SchnyderWood::Swap::kImpossible;
    }
  }
}

// ---- calls

void OctantsListed::build(std::span<const ObjectId> objects) {
  for (List& list : lists_) list.build({objects.begin(), objects.end()}, [](Item, Item) {});
  number_places();
  waits_.fill(true);
  make_woods();
  begin();
}

void OctantsListed::rebuild() {
  const std::vector<ObjectId> objects = lists_[kAlongX].items();
  build(objects);
}

// All that failed at this instant is repaired: no wood waits.
void OctantsListed::insert(ObjectId object) {
  for (List& list : lists_) list.insert(object, [](Item, Item) {});
  number_places();
  const std::vector<ObjectId> points = lists_[kAlongX].items();
  for (std::size_t i = 0; i < woods().size(); ++i) woods().wood(i).insert(object, points);
  follow_point();
}

void OctantsListed::erase(ObjectId object) {
  for (List& list : lists_) list.erase(object, [](Item, Item) {});
  number_places();
  for (std::size_t i = 0; i < woods().size(); ++i) waits_[i] = !woods().wood(i).erase(object);
  make_woods();
  follow_point();
}

void OctantsListed::certificate_failed(CertificateId failed) {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    if (!lists_[axis].slots().owns(failed)) continue;
    const auto along = static_cast<OctantAxis>(axis);
    const auto [before, after] = lists_[axis].failed(failed);
    kernel().report(id(), kOrder, {before, after}, false);
    exchange(along, before, after);
    lists_[axis].settle(exchanged(along));
    if (waits_[0] || waits_[1]) kernel().settle_later(id());
    return repaired();
  }
}

// Two points that were level by a first key may be so no more, or have become it.
void OctantsListed::motions_changed(std::span<const ObjectId> objects) {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_[axis].renew(objects, exchanged(static_cast<OctantAxis>(axis)));
  }
}

void OctantsListed::instant_settled() {
  remade_ += static_cast<std::uint64_t>(std::count(waits_.begin(), waits_.end(), true));
  make_woods();
}

// ---- checks

void OctantsListed::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.place = 0;
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    group.kind = "neighbours";
    group.text = std::string("by ") + octant_axis_name(static_cast<OctantAxis>(axis));
    lists_[axis].each_link([&](Item a, Item b, CertificateId certificate) {
      group.about = {a, b};
      ++group.place;
      visitor.group(group);
      visitor.certificate(certificate, "in order");
    });
  }
}

std::vector<BoundCheck> OctantsListed::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::size_t n = context.objects();
  std::vector<BoundCheck> result{
      at_most("octants_listed.certificates", "four lists", counted(n == 0 ? 0 : 4 * (n - 1)),
              counted(ledger.max_live)),
      at_most("octants_listed.per_object", "two neighbours in each list", Integer(8),
              counted(ledger.max_per_object)),
      at_most("octants_listed.events",
              "each two points change their order in each list at every root, and where pieces "
              "meet",
              Integer(4) * pair_sign_changes(context.pieces, context.degree),
              counted(ledger.failures)),
      at_most("octants_listed.remade",
              "woods that are made from the lists: two at the end of an instant with a failure or "
              "a new motion",
              Integer(2) * (counted(ledger.failures) + counted(ledger.motion_updates)),
              counted(remade_))};
  add_bounds(context, result);
  return result;
}

void OctantsListed::check_invariants(AuditReport& report) const {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_[axis].check(report, octant_axis_name(static_cast<OctantAxis>(axis)));
    std::uint32_t place = 0;
    for (const ObjectId object : lists_[axis].items()) {
      report.check(places_[axis][object] == place++, [] { return "a place that is out of date"; });
    }
  }
  report.check(!waits_[0] && !waits_[1], [] { return "a wood still waits"; });
  check_woods(report);
}

void OctantsListed::audit(const Snapshot& snapshot, AuditReport& report) const {
  ConeNeighbours::audit(snapshot, report);
  for (std::size_t i = 0; i < kOctantAxes; ++i) {
    check_order(snapshot, static_cast<OctantAxis>(i), lists_[i].items(), report);
  }
}

std::size_t OctantsListed::bytes() const {
  std::size_t total = bytes_of_woods();
  for (const List& list : lists_) total += list.bytes();
  for (const auto& places : places_) total += places.capacity() * sizeof(std::uint32_t);
  return total;
}

}  // namespace kinex
